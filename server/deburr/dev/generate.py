"""Writes what is derived from the code: rule pages, the JSON schema of the configuration, file types of editors, the VS Code extension's manifest.

`python -m deburr.dev.generate` writes them; a test proves them fresh.
"""

import json
import sys
from pathlib import Path
from typing import Any

from deburr.catalogue import loaded, row, rule_names, rules_of
from deburr.dev import filetypes
from deburr.dev.manifest import FOLDER, files_for_vscode
from deburr.page import kind, markdown
from deburr.schema import LEVELS, TOP, WIDEST, Free, tables
from deburr_grammar.dialect import Kind, Setting
from deburr_grammar.dialects import NAMES, by_name

PAGES = "docs/rules"
SCHEMA = "server/deburr/deburr.schema.json"


def generated(root: Path) -> dict[str, str]:
    """All derived files of a checkout: path from its root, and content."""
    found = {f"{PAGES}/{name}.md": pages(name) for name in NAMES}
    manifest = (root / FOLDER / "package.json").read_text(encoding="utf-8")
    known = schema()
    return {
        f"{PAGES}/README.md": index(),
        **found,
        **{f"server/deburr/rules/{folder}/_index.py": rule_index(folder) for folder in ("common", *NAMES)},
        SCHEMA: json.dumps(known, indent=2) + "\n",
        **filetypes.files(),
        **files_for_vscode(manifest, known),
    }


def rule_index(folder: str) -> str:
    """What is known of the rules of a folder without loading them."""
    rows = [f"    {tuple(row(rule))!r}," for rule in loaded(f"deburr.rules.{folder}")]
    said = '"""What decides whether the rules beside it are asked (deburr/catalogue.py). Written by `python -m deburr.dev.generate`."""'
    return "\n".join(
        [said, "", "from typing import Any", "", "# fmt: off", "ROWS: tuple[tuple[Any, ...], ...] = (", *rows, ")", ""]
    )


def stale(root: Path) -> list[str]:
    """The derived files that are not what they should be."""
    return [name for name, text in generated(root).items() if _content(root / name) != text]


def main() -> int:
    """Write what is stale in the checkout that one works in, and say so; the package itself may be installed elsewhere."""
    root = Path.cwd()
    if not (root / FOLDER).is_dir():
        print(f"{root} is no checkout of deburr: run this in its top folder", file=sys.stderr)
        return 2
    for name, text in generated(root).items():
        path = root / name
        if _content(path) != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")
            print(f"wrote {name}")
    return 0


def pages(dialect: str) -> str:
    """The pages of a dialect's rules."""
    found = [markdown(rule, by_name(dialect)).replace("# ", "## ", 1) for rule in rules_of(dialect)]
    return "\n\n".join([f"# Rules of {by_name(dialect).title}", *found]) + "\n"


def index() -> str:
    """The list of all rules with links to their pages."""
    parts = [
        "# Rules\n\nWritten by `python -m deburr.dev.generate` from the rules' own docstrings; `deburr rule NAME` prints the same pages."
    ]
    for name in NAMES:
        rows = [
            f"| [`{rule.name}`]({name}.md#{_anchor(f'{rule.name} ({kind(rule)})')}) | {kind(rule)} | {rule.summary} |"
            for rule in rules_of(name)
        ]
        parts.append(
            "\n".join([f"## {by_name(name).title}\n", "| rule | severity | meaning |", "|---|---|---|", *rows])
        )
    return "\n\n".join(parts) + "\n"


def schema() -> dict[str, Any]:
    """The JSON schema of `deburr.toml`."""
    root = _object({setting.name: _value(setting) for setting in TOP}, "")
    for path, known in tables().items():
        inside = root
        for name in path[:-1]:
            inside = inside["properties"][name]
        inside["properties"][path[-1]] = _free(path, known) if isinstance(known, Free) else _table(known)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "deburr.toml", **root}


def _table(settings: tuple[Setting, ...]) -> dict[str, Any]:
    return _object({setting.name: _value(setting) for setting in settings}, "")


def _free(path: tuple[str, ...], known: Free) -> dict[str, Any]:
    if path == ("files",):
        values: dict[str, Any] = {"enum": list(NAMES)}
    elif path[-1] == "severity":
        names = [name for dialect in NAMES for name in rule_names(dialect)]
        return _object({name: {"enum": [*LEVELS, "off"]} for name in names}, known.text)
    else:
        values = {"type": "array", "items": {"type": "string"}}
    return {"type": "object", "description": known.text, "additionalProperties": values}


def _object(properties: dict[str, Any], text: str) -> dict[str, Any]:
    said = {"description": text} if text else {}
    return {"type": "object", **said, "additionalProperties": False, "properties": properties}


def _value(setting: Setting) -> dict[str, Any]:
    types: dict[Kind, dict[str, Any]] = {
        Kind.TEXT: {"type": "string"},
        Kind.PATH: {"type": "string"},
        Kind.CHOICE: {"enum": list(setting.choices)},
        Kind.LIST: {"type": "array", "items": {"type": "string"}},
        Kind.PATHS: {"type": "array", "items": {"type": "string"}},
        Kind.TABLE: {"type": "object"},
        Kind.FLAG: {"type": "boolean"},
        Kind.WIDTH: {"type": "integer", "minimum": 0, "maximum": WIDEST},
        Kind.NUMBER: {"type": "number"},
    }
    default = {} if setting.default is None else {"default": _plain(setting.default)}
    return {"description": setting.text, **types[setting.kind], **default}


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else dict(value) if hasattr(value, "items") else value


def _anchor(heading: str) -> str:
    """The anchor that a heading gets: small letters, signs dropped, blanks as hyphens."""
    return "".join(char for char in heading.lower().replace(" ", "-") if char.isalnum() or char in "-_")


def _content(path: Path) -> str | None:
    return path.read_text(encoding="utf-8") if path.is_file() else None


if __name__ == "__main__":
    sys.exit(main())
