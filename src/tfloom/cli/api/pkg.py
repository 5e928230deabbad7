"""The functions of `ros2pkg.api`: packages and their programs."""

from __future__ import annotations

import atexit
import shutil
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

from tfloom.workspace import index
from tfloom.workspace.ament import PackageNotFoundError, get_package_prefix, get_packages_with_prefixes
from tfloom.workspace.program_scripts import write_script

__all__ = [
    "PackageNotFound",
    "get_executable_paths",
    "get_package_names",
    "get_prefix_path",
    "package_name_completer",
]


class PackageNotFound(Exception):
    """There is no such package.

    Args:
        package_name: Its name.
    """

    def __init__(self, package_name: str) -> None:
        super().__init__(f"package '{package_name}' not found")
        self.package_name = package_name


def get_package_names() -> Any:
    """Return the names of all packages, tfloom's own included."""
    return get_packages_with_prefixes().keys()


def get_prefix_path(package_name: str) -> str | None:
    """Return the prefix of a package; None if there is no such package."""
    try:
        return get_package_prefix(package_name)
    except (PackageNotFoundError, ValueError):
        return None


def get_executable_paths(*, package_name: str) -> list[str]:
    """Return the paths of a package's programs; for one of tfloom's own, those of scripts that start them.

    Raises:
        PackageNotFound: there is no such package.
    """
    prefix = get_prefix_path(package_name)
    if prefix is None:
        raise PackageNotFound(package_name)
    if index.find_package(package_name) is None:
        own = index.PROGRAMS.get(package_name, {})
        return [str(write_script(_scripts(), package_name, name, own[name])) for name in sorted(own)]
    return [str(path) for path in index.package_programs(package_name, prefix)]


@cache
def _scripts() -> Path:
    """Return the folder of this process's scripts, which is removed when Python ends."""
    folder = tempfile.mkdtemp(prefix="tfloom_programs_")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)


def package_name_completer(**_: Any) -> list[str]:
    """Return the names of all packages."""
    return list(get_package_names())
