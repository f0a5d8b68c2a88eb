"""What the VS Code extension contributes for the dialects: the part of its manifest that is made from their values. Never touches the rest."""

import json
from collections.abc import Iterator
from typing import Any

from deburr.dev.editor import configuration, editor_of, textmate
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name

FOLDER = "vscode-extension"
FLAT = "deburr-flat"
"""The language of flat programs: colours as RS274 has them, and no diagnostics."""

SCOPES = {
    "variable": ["variable.parameter"],
    "function": ["entity.name.function"],
    "label": ["entity.name.label"],
    "namespace": ["entity.name.section"],
    "string": ["string.unquoted.file"],
    "macro": ["keyword.other.gcode"],
    "property": ["storage.type.word"],
    "method": ["support.function"],
    "keyword": ["keyword.control"],
    "comment": ["comment"],
    "number": ["constant.numeric"],
}
"""The server's semantic token types, and the scopes that themes colour."""

DEFAULTS = {
    # `#5420` is a parameter, not a colour.
    "editor.defaultColorDecorators": "never",
    # Behind what opens a block stands its condition, which is no heading.
    "editor.minimap.showRegionSectionHeaders": False,
}
"""What an editor does that makes no sense in these languages."""


def files_for_vscode(manifest: str, schema: dict[str, Any]) -> dict[str, str]:
    """Path and content of all generated files of the extension; ``manifest`` is its `package.json` as it stands."""
    found = {f"{FOLDER}/package.json": _json(_manifest(json.loads(manifest), schema))}
    found[f"{FOLDER}/syntaxes/{FLAT}.tmLanguage.json"] = _json(
        {"scopeName": f"source.{FLAT}", "patterns": [{"include": "source.rs274"}]}
    )
    for name in NAMES:
        dialect = by_name(name)
        found[f"{FOLDER}/syntaxes/{name}.tmLanguage.json"] = _json(textmate(dialect))
        found[f"{FOLDER}/languages/{name}.json"] = _json(configuration(dialect))
    return found


def _manifest(manifest: dict[str, Any], schema: dict[str, Any]) -> dict[str, Any]:
    dialects = [by_name(name) for name in NAMES]
    own = manifest["contributes"]
    made = {
        "languages": [*(_language(each) for each in dialects), _flat()],
        "grammars": [_grammar(name) for name in (*NAMES, FLAT)],
        "semanticTokenScopes": [{"language": name, "scopes": SCOPES} for name in NAMES],
        "configurationDefaults": {f"[{name}]": DEFAULTS for name in (*NAMES, FLAT)},
        "configuration": [own["configuration"][0], *_settings(schema)],
    }
    return {**manifest, "contributes": {**own, **made}}


def _language(dialect: Dialect) -> dict[str, Any]:
    said = editor_of(dialect)
    return {
        "id": dialect.name,
        "aliases": said["aliases"],
        "extensions": list(dialect.extensions),
        "firstLine": said["first-line"],
        "configuration": f"./languages/{dialect.name}.json",
        "icon": _icon(dialect.name),
    }


def _flat() -> dict[str, Any]:
    return {"id": FLAT, "aliases": ["Expanded G-code"], "icon": _icon(FLAT)}


def _icon(name: str) -> dict[str, str]:
    return dict.fromkeys(("light", "dark"), f"./icons/{name}.svg")


def _grammar(name: str) -> dict[str, Any]:
    return {"language": name, "scopeName": f"source.{name}", "path": f"./syntaxes/{name}.tmLanguage.json"}


def _settings(schema: dict[str, Any]) -> list[dict[str, Any]]:
    """One page of settings for each table of `deburr.toml`. Nothing has a default: what is not set is the configuration file's."""
    tables = {name: said for name, said in schema["properties"].items() if said.get("properties")}
    return [
        {"title": _title(table), "properties": dict(_of_table(f"deburr.{table}", said))}
        for table, said in tables.items()
    ]


def _of_table(path: str, said: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """The settings of a table and of those in it; a table whose keys hold dots, as rules do, is one setting."""
    for key, value in said["properties"].items():
        inside = value.get("properties", {})
        if inside and not any("." in name for name in inside):
            yield from _of_table(f"{path}.{key}", value)
        else:
            yield f"{path}.{key}", _setting(value)


def _title(table: str) -> str:
    return by_name(table).title if table in NAMES else table.capitalize()


def _setting(said: dict[str, Any]) -> dict[str, Any]:
    kind: dict[str, Any] = {key: said[key] for key in ("items", "additionalProperties") if key in said}
    if said.get("properties"):
        # One line for each rule would be most of the manifest; which names there are, the server says.
        kind["additionalProperties"] = next(iter(said["properties"].values()))
    choices: dict[str, Any] = {"enum": [*said["enum"], None]} if "enum" in said else {}
    types = ["string" if choices else said["type"], "null"]
    text = said.get("description", "").strip() or "As in `deburr.toml`."
    return {"type": types, "default": None, "scope": "resource", "markdownDescription": text, **choices, **kind}


def _json(value: Any) -> str:
    return json.dumps(value, indent=2, ensure_ascii=False) + "\n"
