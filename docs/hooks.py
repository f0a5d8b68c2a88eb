"""MkDocs asks this for the pages that are made from the code each time the site is built."""

from typing import Any

from deburr.dev.reference import reference


def on_files(files: Any, config: Any) -> Any:
    """Add the generated pages to those that are written."""
    from mkdocs.structure.files import File

    for name, text in reference().items():
        files.append(File.generated(config, name, content=text))
    return files
