"""Which files are whose, for the editors in `editors/`: made from the dialects' values. Knows nothing of VS Code, whose manifest is its own."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import NamedTuple

from deburr.detect import SHARED
from deburr_grammar.dialects import NAMES, by_name

OTHER = "gcode"
"""The type of files whose extension many controls share: the server finds out what they are, or leaves them alone."""
TEXTS = (".txt", ".tmp")
"""Shared extensions that are mostly no program: an editor that took them all for one would be a nuisance."""
_MADE = "Written by `python -m deburr.dev.generate`."


class Type(NamedTuple):
    """A type of files. ``extensions`` are without their dots; ``comments`` are pairs of signs, the end of a line as ""."""

    id: str
    title: str
    extensions: tuple[str, ...]
    comments: tuple[tuple[str, str], ...]

    @property
    def line_comment(self) -> str:
        """What starts a comment to the end of the line."""
        return next((start for start, end in self.comments if not end), "")


def filetypes() -> list[Type]:
    """The dialects, and what the server is to look into."""
    found = []
    for name in NAMES:
        dialect = by_name(name)
        bare = tuple(each.removeprefix(".") for each in dialect.extensions)
        found.append(Type(name, dialect.title, bare, dialect.comments))
    shared = tuple(each.removeprefix(".") for each in SHARED if each not in TEXTS)
    return [*found, Type(OTHER, "G-code", shared, ((";", ""), ("(", ")")))]


def files() -> dict[str, str]:
    """The generated files: path from the repository's root, and content."""
    types = filetypes()
    found = {
        "editors/neovim/ftdetect/deburr.vim": _vim(types),
        "editors/neovim/lua/deburr/filetypes.lua": _lua(types),
        "editors/emacs/deburr-modes.el": _emacs(types),
        "editors/helix/languages.toml": _helix(types),
        "editors/kate/settings.json": _kate_settings(types),
        "editors/sublime/LSP.sublime-settings": _sublime_settings(types),
    }
    for each in types:
        found[f"editors/neovim/ftplugin/{each.id}.lua"] = _lua_comments(each)
        found[f"editors/kate/syntax/deburr-{each.id}.xml"] = _kate_syntax(each)
        found[f"editors/sublime/{each.id}.sublime-syntax"] = _sublime_syntax(each)
    return found


def _vim(types: list[Type]) -> str:
    lines = [
        f"autocmd BufNewFile,BufRead {','.join(f'*.{ending}' for ending in each.extensions)} setfiletype {each.id}"
        for each in types
    ]
    return "\n".join([f'" {_MADE}', *lines]) + "\n"


def _lua(types: list[Type]) -> str:
    return f"-- {_MADE}\nreturn {{ {', '.join(repr(each.id) for each in types)} }}\n"


def _lua_comments(each: Type) -> str:
    return f"-- {_MADE}\nvim.bo.commentstring = '{each.line_comment} %s'\n"


def _emacs(types: list[Type]) -> str:
    parts = [
        f";;; deburr-modes.el --- Modes for programs of CNC machines -*- lexical-binding: t -*-\n;; {_MADE}\n\n;;; Code:\n"
    ]
    for each in types:
        mode = f"deburr-{each.id}-mode"
        endings = "\\\\|".join(each.extensions)
        parts.append(
            f'(define-derived-mode {mode} prog-mode "{each.title}"\n'
            f'  "Major mode for {each.title} programs."\n'
            f'  (setq-local comment-start "{each.line_comment} " comment-end ""))\n'
            f"(put '{mode} 'eglot-language-id \"{each.id}\")\n"
            f"(add-to-list 'auto-mode-alist '(\"\\\\.\\\\(?:{endings}\\\\)\\\\'\" . {mode}))\n"
        )
    names = "\n    ".join(f"deburr-{each.id}-mode" for each in types)
    parts.append(f'(defconst deburr-modes\n  \'({names})\n  "The modes in which the server is of use.")\n')
    return "\n".join([*parts, "(provide 'deburr-modes)\n;;; deburr-modes.el ends here\n"])


def _helix(types: list[Type]) -> str:
    parts = [f'# {_MADE}\n[language-server.deburr]\ncommand = "deburr"\nargs = ["server"]\n']
    for each in types:
        blocks = [f"{{ start = {json.dumps(start)}, end = {json.dumps(end)} }}" for start, end in each.comments if end]
        parts.append(
            "[[language]]\n"
            f'name = "{each.id}"\n'
            f'scope = "source.{each.id}"\n'
            f"file-types = {json.dumps(each.extensions)}\n"
            'roots = ["deburr.toml"]\n'
            f"comment-tokens = {json.dumps([start for start, end in each.comments if not end])}\n"
            + (f"block-comment-tokens = [{', '.join(blocks)}]\n" if blocks else "")
            + 'language-servers = ["deburr"]\n'
        )
    return "\n".join(parts)


def _kate_settings(types: list[Type]) -> str:
    servers = {
        each.id: {
            "command": ["deburr", "server"],
            "rootIndicationFileNames": ["deburr.toml"],
            "highlightingModeRegex": f"^{_kate_name(each)}$",
        }
        for each in types
    }
    return json.dumps({"servers": servers}, indent=2) + "\n"


def _kate_name(each: Type) -> str:
    return f"deburr {each.id}"


def _kate_syntax(each: Type) -> str:
    endings = ";".join(f"*.{ending}" for ending in each.extensions)
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE language>
<!-- {_MADE} -->
<language name="{_kate_name(each)}" section="Other" version="1" kateversion="5.0" extensions="{endings}">
  <highlighting>
    <contexts>
      <context name="Program" attribute="Normal Text" lineEndContext="#stay">
{"".join(_kate_rules(each))}      </context>
{"".join(_kate_contexts(each))}    </contexts>
    <itemDatas>
      <itemData name="Normal Text" defStyleNum="dsNormal"/>
      <itemData name="Comment" defStyleNum="dsComment"/>
    </itemDatas>
  </highlighting>
</language>
"""


def _kate_rules(each: Type) -> Iterator[str]:
    for number, (start, _) in enumerate(each.comments):
        yield f'        <StringDetect attribute="Comment" context="Comment{number}" String="{start}"/>\n'


def _kate_contexts(each: Type) -> Iterator[str]:
    for number, (_, end) in enumerate(each.comments):
        closes = f'        <StringDetect attribute="Comment" context="#pop" String="{end}"/>\n' if end else ""
        yield (
            f'      <context name="Comment{number}" attribute="Comment" lineEndContext="#pop">\n{closes}      </context>\n'
        )


def _sublime_settings(types: list[Type]) -> str:
    selector = " | ".join(f"source.{each.id}" for each in types)
    client = {"enabled": True, "command": ["deburr", "server"], "selector": selector}
    return json.dumps({"clients": {"deburr": client}}, indent=2) + "\n"


def _sublime_syntax(each: Type) -> str:
    lines = [
        "%YAML 1.2",
        "---",
        f"# {_MADE}",
        f"name: {each.title}",
        f"scope: source.{each.id}",
        f"file_extensions: [{', '.join(each.extensions)}]",
        "contexts:",
        "  main:",
    ]
    for start, end in each.comments:
        closes = f"{_escaped(end)}|$" if end else "$"
        lines += [
            f"    - match: '{_escaped(start)}'",
            "      push:",
            f"        - meta_scope: comment.{'block' if end else 'line'}.{each.id}",
            f"        - match: '{closes}'",
            "          pop: true",
        ]
    return "\n".join(lines) + "\n"


def _escaped(sign: str) -> str:
    return "".join(f"\\{char}" if char in "()" else char for char in sign)
