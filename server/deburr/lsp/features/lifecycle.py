"""The life of a session: its start, its settings, its folders, the files around it, its end."""

from collections.abc import Iterator
from typing import Any

from lsprotocol import types

from deburr import __version__
from deburr.lsp.convert import uri_to_file
from deburr.lsp.server import Server, feature
from deburr.lsp.settings import is_configuration

_WATCHED = "**/*"


@feature(types.INITIALIZED)
async def initialized(server: Server, params: types.InitializedParams) -> None:
    """The client is ready: ask for what is watched and what is set."""
    folders = ", ".join(server.session.folders) or "no folder"
    server.log(f"deburr {__version__}: columns in {server.client.encoding}, {folders}")
    if wishes := list(_wishes(server)):
        wanted = {"registrations": wishes}
        server.protocol.send({"id": "deburr-register", "method": types.CLIENT_REGISTER_CAPABILITY, "params": wanted})
    await _configure(server, None)


@feature(types.WORKSPACE_DID_CHANGE_CONFIGURATION)
async def did_change_configuration(server: Server, params: types.DidChangeConfigurationParams) -> None:
    """The editor's settings have changed."""
    await _configure(server, params.settings)


@feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
def did_change_folders(server: Server, params: types.DidChangeWorkspaceFoldersParams) -> None:
    """Folders came or went."""
    gone = {uri_to_file(each.uri) for each in params.event.removed}
    folders = server.session.folders
    folders[:] = [each for each in folders if each not in gone]
    folders += [file for each in params.event.added if (file := uri_to_file(each.uri)) not in folders]
    server.checks.depended()


@feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
def did_change_files(server: Server, params: types.DidChangeWatchedFilesParams) -> None:
    """Files were written, made or taken away on disk."""
    files = [uri_to_file(each.uri) for each in params.changes]
    if any(is_configuration(file) for file in files):
        server.session.reload()
        _settle_all(server)
    server.checks.touched(*files)


@feature(types.EXIT)
def leave(server: Server, params: Any) -> None:
    """The client wants no server any more."""
    server.ended()


def _wishes(server: Server) -> Iterator[dict[str, Any]]:
    """What the client is to tell of, as far as it can."""
    if server.client.watches:
        options = {"watchers": [{"globPattern": _WATCHED}]}
        yield {"id": "deburr-files", "method": types.WORKSPACE_DID_CHANGE_WATCHED_FILES, "registerOptions": options}
    if server.client.tells_settings:
        section = {"section": "deburr"}
        yield {"id": "deburr-settings", "method": types.WORKSPACE_DID_CHANGE_CONFIGURATION, "registerOptions": section}


async def _configure(server: Server, pushed: Any) -> None:
    """Ask for the settings, or take what was pushed; without either those of `initialize` stand."""
    said = pushed
    if server.client.configures:
        item = types.ConfigurationItem(section="deburr")
        answers = await server.workspace_configuration_async(types.ConfigurationParams(items=[item]))
        said = answers[0] if answers else None
    if said:
        server.session.settings.lay_over(said, server.session.folders)
        _settle_all(server)


def _settle_all(server: Server) -> None:
    for program in list(server.session.open.values()):
        server.session.settle(program)
    server.previews.forget()
    server.checks.everything()
