"""The functions of `ament_index_python`: paths of packages and their files.

Packages of a sourced workspace precede tfloom's own, so that code can look up `turtlesim` or `geometry_msgs` without a
ROS. They are resources of the types `packages` and `rosidl_interfaces`, too, as installed ones are. Without
AMENT_PREFIX_PATH there is no workspace, which is not an error.
"""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Literal

from tfloom.node.values.exceptions import add_note
from tfloom.ros_imports.guard import ros_home
from tfloom.rosidl.definition_files import KINDS, interfaces_of
from tfloom.workspace import index
from tfloom.workspace.unsourced import how_to_find

AMENT_PREFIX_PATH_ENV_VAR = index.PREFIX_PATH_VARIABLE
RESOURCE_INDEX_SUBFOLDER = index.RESOURCE_INDEX
STAND_IN = Path(os.path.abspath(os.sep), "not-installed", "share")  # noqa: PTH100  # the root, on Windows with its drive
"""A folder that doesn't exist, for the share folders of packages that aren't there, if a launch skips these."""
_PACKAGES, _INTERFACES = "packages", "rosidl_interfaces"
"""The types of the resources that tfloom's own packages have, too."""
on_stand_in: Callable[[str], None] | None = None
"""Called with the name of each package that gets one; None: such a package is an error."""


class InvalidResourceNameError(ValueError):
    """A resource's name contains a path separator."""

    __module__ = ros_home("ament_index_python.resources", __name__)


class InvalidResourceTypeNameError(ValueError):
    """A resource type's name contains a path separator."""

    __module__ = ros_home("ament_index_python.resources", __name__)


class PackageNotFoundError(KeyError):
    """The package is neither in a prefix nor tfloom's own."""

    __module__ = ros_home("ament_index_python.packages", __name__)

    def __str__(self) -> str:
        """Return the text unchanged, because a KeyError would quote it."""
        return str(self.args[0])


def get_search_paths() -> list[str]:
    """Return the folders on AMENT_PREFIX_PATH that exist, in order of precedence."""
    return index.search_paths()


def get_packages_with_prefixes() -> dict[str, str]:
    """Return the prefix of each package by its name."""
    return get_resources("packages")


def get_package_prefix(package_name: str) -> str:
    """Return the prefix that a package is installed under.

    Raises:
        PackageNotFoundError: there is no such package.
        ValueError: it is not a valid package name.
    """
    prefix = _find(package_name)
    if isinstance(prefix, Exception):
        raise prefix
    return prefix or str(index.own_packages()[package_name])


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """Return the folder of a package's files; issue a UserWarning if it doesn't exist, unless told not to.

    Raises:
        PackageNotFoundError: there is no such package.
        ValueError: it is not a valid package name.
    """
    path = _share_folder(package_name)
    if isinstance(path, Exception):
        raise path
    if print_warning and not _exists_or_stands_in(path):
        warnings.warn(f"Share path for {package_name} ({path}) does not exist.", stacklevel=2)
    return path


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    """Return `get_package_share_path` as a string."""
    path = _share_folder(package_name)
    if isinstance(path, Exception):
        raise path
    if print_warning and not _exists_or_stands_in(path):
        warnings.warn(f"Share directory for {package_name} ({path}) does not exist.", stacklevel=2)
    return str(path)


def _exists_or_stands_in(path: Path) -> bool:
    """Return whether there is nothing to warn of: the launch that skips a package has logged that it does so."""
    return path.exists() or path.parent == STAND_IN


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    """Return the text of a resource's marker file, and its prefix.

    Raises:
        LookupError: no prefix has it.
        OSError: its file can't be read.
        ValueError: the type or the name contains a path separator.
    """
    prefix = has_resource(resource_type, resource_name)
    if not prefix:
        raise LookupError(f"Could not find the resource '{resource_name}' of type '{resource_type}'")
    if not index.find_resource(resource_type, resource_name):
        return _own_text(resource_type, resource_name), prefix
    return Path(prefix, RESOURCE_INDEX_SUBFOLDER, resource_type, resource_name).read_text("utf-8"), prefix


def get_resources(resource_type: str) -> dict[str, str]:
    """Return the prefix of each resource of a type by the resource's name."""
    _check_type(resource_type)
    return _own_resources(resource_type) | index.resources(resource_type)


def get_resource_types() -> set[str]:
    """Return the types of all resources in any prefix."""
    folders = [Path(prefix, RESOURCE_INDEX_SUBFOLDER) for prefix in index.search_paths()]
    found = {path.name for folder in folders if folder.is_dir() for path in folder.iterdir() if path.is_dir()}
    return found | {_PACKAGES, _INTERFACES}


def has_resource(resource_type: str, resource_name: str) -> str | Literal[False]:
    """Return the first prefix that has the resource, or False.

    Raises:
        ValueError: the type or the name contains a path separator.
    """
    _check_type(resource_type)
    if not resource_name or set(resource_name) & set("/\\"):
        raise InvalidResourceNameError(f"Resource name '{resource_name}' is invalid")
    if prefix := index.find_resource(resource_type, resource_name):
        return prefix
    own_prefix = index.own_packages().get(resource_name)
    return str(own_prefix) if own_prefix is not None and _is_own(resource_type, resource_name) else False


def _own_resources(resource_type: str) -> dict[str, str]:
    """Return the prefix of each resource of tfloom's own packages, which have no marker files, by its name."""
    return {
        name: str(prefix) for name, prefix in index.own_packages().items() if _is_own(resource_type, name)
    }


def _is_own(resource_type: str, package: str) -> bool:
    """Return whether one of tfloom's own packages is a resource of a type."""
    if resource_type == _INTERFACES:
        return bool(_own_text(_INTERFACES, package))
    return resource_type == _PACKAGES


def _own_text(resource_type: str, package: str) -> str:
    """Return what the marker file of one of tfloom's own packages would hold: its definitions, a line for each."""
    if resource_type == _PACKAGES:
        return ""
    folder = index.share_folder(package, None)
    return "\n".join(f"{kind}/{name}.{kind}" for kind in KINDS for name in interfaces_of(folder, kind))


def _check_type(resource_type: str) -> None:
    if not resource_type or set(resource_type) & set("/\\"):
        raise InvalidResourceTypeNameError(f"Resource type '{resource_type}' is invalid")


def _share_folder(package: str) -> Path | Exception:
    """Return the folder of a package's files, or the error that there is no such package."""
    prefix = _find(package)
    if isinstance(prefix, PackageNotFoundError) and on_stand_in is not None:
        on_stand_in(package)
        return STAND_IN / package
    return prefix if isinstance(prefix, Exception) else index.share_folder(package, prefix)


def _find(package: str) -> str | Exception | None:
    """Return a package's prefix, None for one of tfloom's own, or the error that there is none.

    The callers raise the error, so that its traceback is short.
    """
    if not isinstance(package, str):
        return TypeError(f"a package's name must be a str, not {package!r} of class {type(package).__name__}")
    if not re.fullmatch(r"[a-zA-Z0-9][a-zA-Z0-9_-]+", package):
        return ValueError(f"'{package}' is not a valid package name")
    prefix = index.find_package(package)
    if prefix is None and package not in index.own_packages():
        error = PackageNotFoundError(f"package '{package}' not found, {_where_searched()}")
        if hint := how_to_find(package):
            add_note(error, hint)
        return error
    return prefix


def _where_searched() -> str:
    """Return which folders were searched, or that there were none but tfloom's own."""
    if paths := index.search_paths():
        return f"searching: {paths}"
    if os.environ.get(AMENT_PREFIX_PATH_ENV_VAR):
        return (
            f"no folder of {AMENT_PREFIX_PATH_ENV_VAR} exists: source the workspace's install/setup.bash anew"
        )
    return f"no workspace is sourced in this terminal ({AMENT_PREFIX_PATH_ENV_VAR} is not set)"
