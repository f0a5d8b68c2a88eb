"""`Deburr: Expand` for Sublime Text: the program that the control would execute, in a view of its own."""

import sublime
from LSP.plugin.core.url import filename_to_uri
from LSP.plugin.execute_command import LspExecuteCommand


class DeburrExpandCommand(LspExecuteCommand):
    """Asks the server for the expanded program of the current file."""

    session_name = "deburr"

    def run(self, edit):
        """Ask; the answer comes later."""
        name = self.view.file_name()
        if name:
            super().run(edit, "deburr.expand", [{"uri": filename_to_uri(name)}])

    def handle_success_async(self, result, command_name):
        """Show the answer."""
        sublime.set_timeout(lambda: self._show(result))

    def _show(self, result):
        window = self.view.window()
        errors = [each for each in (result or {}).get("findings", ()) if each["severity"] == 1]
        if window is None or result is None:
            return
        if not result["text"] and errors:
            row = errors[0]["range"]["start"]["line"] + 1
            window.status_message("Not expanded: line {}: {}".format(row, errors[0]["message"]))
            return
        view = window.new_file()
        view.set_scratch(True)
        view.set_name("expanded: " + (self.view.name() or self.view.file_name() or ""))
        view.run_command("append", {"characters": result["text"].replace("\r\n", "\n")})
        view.set_read_only(True)
