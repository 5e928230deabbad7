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

from tfloom.common.xml import read_tree
from tfloom.ros_imports.distributions import distribution_with
from tfloom.workspace import index
from tfloom.workspace.rosdep_keys import library_key, pypi_name

_BUILD_TOOLS = re.compile(
    r"ament_(cmake|lint|python|package|mypy|uncrustify|cpplint|cppcheck)(_\w+)?"
    r"|rosidl_(cmake|default_generators|default_runtime|generator_\w+|interface_packages|typesupport_\w+)"
    r"|colcon|setuptools|cmake"
    r"|launch_testing_ament_cmake|python_cmake_module|ros_environment|ros_workspace|tf2_ros_py|urdf"
)
"""What only the build of ROS needs or its C++, and tfloom does without; and `tf2_ros_py`, the Python of `tf2_ros`."""
_DEPENDS = re.compile(r"(build_|exec_|test_|buildtool_|build_export_|run_|buildtool_export_)?depend")
_ROS_1 = re.compile(r"ROS_VERSION\s*==\s*['\"]?1")
IGNORE_MARKERS = ("AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE")
"""Files by which a folder is left out."""
_MODULES = {"opencv": "cv2", "pil": "PIL", "pykdl": "PyKDL", "tk": "tkinter", "yaml": "yaml"}
"""Modules by rosdep's keys, where the name differs and no distribution may tell."""
_COMPILED = {"image_transport_py"}
"""ROS packages whose Python modules are compiled from C++."""
_ROS_ON_PYPI = {"py_trees": "py-trees", "urdf_parser_py": "urdf-parser-py"}
"""ROS packages that PyPI has, too."""
_OTHERS_ON_PYPI = {"yasmin"}
"""ROS packages that PyPI does not have, but another one of the same name."""


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
    key = library_key(name)
    if key is not None:
        return _has_python(key)
    # Other names with a hyphen are rosdep's, of packages of the system. Another ROS package may be installed by pip.
    return "-" in name or (distribution_with(name) is None and _has_module(name))


def _has_python(key: str) -> bool:
    pypi = pypi_name(key)
    if pypi is None or _has_module(_MODULES.get(key, key.replace("-", "_"))):
        return True
    try:
        distribution(pypi)
    except (PackageNotFoundError, ValueError):
        return False
    return True


def _has_module(name: str) -> bool:
    """Return whether a module can be imported; a mere folder of its name, as one in a workspace, is none."""
    if not name.isidentifier():
        return False
    try:
        spec = find_spec(name)
    except (ImportError, ValueError):
        return False
    return spec is not None and spec.origin is not None


def what_is_missing(name: str) -> str:
    """Return where a dependency was looked for that nobody provides."""
    if library_key(name) is not None:
        return "which is not installed"
    return "neither in this workspace, nor sourced, nor tfloom's, nor installed by pip"


def how_to_provide(name: str) -> str:
    """Return what to do about a dependency that nobody provides."""
    distribution_beside = distribution_with(name)
    if distribution_beside is not None:
        return distribution_beside.how_to_install
    if name in _COMPILED:
        return "it is compiled from C++, which tfloom doesn't build: source a ROS 2 that has it"
    key = library_key(name)
    pypi = _ROS_ON_PYPI.get(name) if key is None else pypi_name(key)
    if pypi is not None:
        return f"pip install {pypi}"
    trap = f"; PyPI's {name} is another package" if name in _OTHERS_ON_PYPI else ""
    return f"put the source of a ROS package into src/, or source a workspace that has it{trap}"


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
