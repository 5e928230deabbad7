"""Importing extension modules as ROS 2 packages do: DLL folders on Windows, and advice where the import fails."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from importlib.machinery import EXTENSION_SUFFIXES, PathFinder
from pathlib import Path
from types import ModuleType
from typing import Any

__all__ = ["add_dll_directories_from_env", "import_c_library"]

_GUIDE = "https://docs.ros.org/en/{distro}/How-To-Guides/Installation-Troubleshooting.html#{section}"


@contextmanager
def add_dll_directories_from_env(env_name: str) -> Iterator[list[Any]]:
    """Have Windows search the folders named in an environment variable for DLLs, for the length of a `with`.

    Args:
        env_name: The variable, which names folders as PATH does; those that don't exist are left out.

    Yields:
        The handles of `os.add_dll_directory`; none on other systems.
    """
    handles: list[Any] = []
    if sys.platform == "win32":
        folders = [Path(folder) for folder in os.environ.get(env_name, "").split(os.pathsep) if folder]
        handles = [os.add_dll_directory(str(folder.resolve())) for folder in folders if folder.is_dir()]
    try:
        yield handles
    finally:
        for handle in handles:
            handle.close()


def import_c_library(name: str, package: str | None = None) -> ModuleType:
    """Import an extension module and return it.

    Args:
        name: Its name, as for `importlib.import_module`.
        package: The package that a name with a leading dot is relative to.

    Raises:
        ImportError: it isn't there, or can't be loaded; the text says which, and where ROS's guide has advice.
    """
    try:
        with add_dll_directories_from_env("PATH"):
            return import_module(name, package)
    except ImportError as error:
        error.msg += _advice(error, name, package)
        raise


def _advice(error: ImportError, name: str, package: str | None) -> str:
    if error.path is None:
        file = _folder(package) / f"{name.rpartition('.')[2]}{EXTENSION_SUFFIXES[0]}"
        problem = "isn't present on the system"
        section = "import-failing-without-library-present-on-the-system"
    elif Path(error.path).is_file():
        file = Path(error.path)
        problem = "failed to be imported while being present on the system"
        section = "import-failing-even-with-library-present-on-the-system"
    else:
        return ""
    guide = _GUIDE.format(distro=os.environ.get("ROS_DISTRO", "rolling"), section=section)
    return f"\nThe C extension '{file}' {problem}. Please refer to '{guide}' for possible solutions"


def _folder(package: str | None) -> Path:
    """Return the folder in which a package's modules are, or that of all packages if it isn't found."""
    spec = PathFinder.find_spec(package.partition(".")[0]) if package else None
    if package and spec and spec.submodule_search_locations:
        return Path(spec.submodule_search_locations[0], *package.split(".")[1:])
    return Path(__file__).parents[2]
