"""Dependencies that no installed package provides."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, distribution
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree as ET

from tfloom.distributions import distribution_with
from tfloom.workspace import index
from tfloom.xml_parsers import read_tree

_BUILD_TOOLS = re.compile(
    r"ament_(cmake|lint|python|package|xmllint|mypy|uncrustify|cpplint|cppcheck)(_\w+)?"
    r"|rosidl_(default_generators|default_runtime|interface_packages)|colcon|setuptools|cmake"
)
"""What only the build of ROS needs, and tfloom's does without."""
_DEPENDS = re.compile(r"(build_|exec_|test_|buildtool_|build_export_|run_|buildtool_export_)?depend")
_ROS_1 = re.compile(r"ROS_VERSION\s*==\s*['\"]?1")
IGNORE_MARKERS = ("AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE")
"""Files by which a folder is left out."""
_MODULES = {
    "opencv": "cv2",
    "pil": "PIL",
    "pyqt5": "PyQt5",
    "pykdl": "PyKDL",
    "serial": "serial",
    "skimage": "skimage",
    "sklearn": "sklearn",
}
"""Modules whose names differ from those of rosdep's keys `python3-…`."""


class Requirements(NamedTuple):
    """A package of a workspace, and the dependencies that its package.xml names."""

    name: str
    folder: Path
    depends: tuple[str, ...]


def is_package_there(name: str) -> bool:
    """Return whether a ROS package is sourced, tfloom's, or a build tool that tfloom does without."""
    return (
        _BUILD_TOOLS.fullmatch(name) is not None
        or name in index.own_packages()
        or index.find_package(name) is not None
    )


def is_provided(name: str) -> bool:
    """Return whether a dependency is there, or needs not be: sourced, tfloom's, a build tool, or a Python library."""
    if is_package_there(name):
        return True
    python = re.fullmatch(r"python3?-(.+)", name)
    # Other names with a hyphen are rosdep's, of packages of the system.
    return "-" in name if python is None else _has_python(python[1].removesuffix("-pip"))


def _has_python(key: str) -> bool:
    module = _MODULES.get(key, key.replace("-", "_"))
    try:
        if find_spec(module) is not None:
            return True
        distribution(key)
    except (PackageNotFoundError, ImportError, ValueError):
        return False
    return True


def how_to_provide(name: str) -> str:
    """Return what to do about a dependency that nobody provides."""
    distribution_beside = distribution_with(name)
    if distribution_beside is not None:
        return distribution_beside.how_to_install
    python = re.fullmatch(r"python3?-(.+)", name)
    if python is not None:
        return f"pip install {python[1].removesuffix('-pip')}"
    return "put the source of a ROS package into src/, or source a workspace that has it"


def find_source() -> Path | None:
    """Return the folder `src` of the workspace that the working directory is in, or None."""
    try:
        here = Path.cwd()
    except OSError:  # it was removed
        return None
    for folder in (here, *here.parents):
        source = folder / "src"
        if source.is_dir() and next(manifests(source), None) is not None:
            return source
    return None


def manifests(source: Path) -> Iterator[Path]:
    """Yield each package.xml below a folder; packages hold no packages, and marked folders are left out."""
    for folder, folders, names in os.walk(source):
        if any(marker in names for marker in IGNORE_MARKERS):
            folders.clear()
        elif "package.xml" in names:
            folders.clear()
            yield Path(folder, "package.xml")
        folders[:] = sorted(name for name in folders if not name.startswith("."))


def read_requirements(source: Path) -> list[Requirements]:
    """Return what each package below a folder asks for; one whose package.xml is broken asks for nothing."""
    packages = []
    for path in manifests(source):
        try:
            root = read_tree(path.read_bytes())
        except (OSError, ET.ParseError):
            continue
        depends = (
            (tag.text or "").strip()
            for tag in root
            if _DEPENDS.fullmatch(tag.tag) and not _ROS_1.search(tag.get("condition", ""))
        )
        name = (root.findtext("name") or "").strip() or path.parent.name
        packages.append(Requirements(name, path.parent, tuple(dict.fromkeys(filter(None, depends)))))
    return packages


def find_missing(packages: list[Requirements]) -> dict[str, list[str]]:
    """Return what nobody provides, by name, each with the packages that ask for it."""
    workspace_names = {package.name for package in packages}
    users: dict[str, list[str]] = {}
    for package in packages:
        for name in package.depends:
            if name not in workspace_names and not is_provided(name):
                users.setdefault(name, []).append(package.name)
    return dict(sorted(users.items()))
