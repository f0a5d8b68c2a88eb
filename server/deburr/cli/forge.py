"""How forges name the files of a repository: from its top, with `/`. Knows no report."""

import os

from deburr import paths

_TOPS = ("GITHUB_WORKSPACE", "CI_PROJECT_DIR")
"""Where the runners of GitHub and GitLab say that the repository lies."""


def top() -> str:
    """The top of the repository: what the runner says, if the working folder lies in it; else the working folder."""
    here = paths.working_folder()
    said = (paths.absolute(os.environ[name]) for name in _TOPS if os.environ.get(name))
    return next((each for each in said if f"{here}/".startswith(f"{each.rstrip('/')}/")), here)


def inside(file: str, folder: str) -> str:
    """A file seen from a folder that it lies below; others keep their whole path."""
    return file.removeprefix(f"{folder.rstrip('/')}/")
