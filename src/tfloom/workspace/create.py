"""A new package for a workspace, built by colcon: Python (ament_python), or interfaces (ament_cmake)."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable
from pathlib import Path
from shutil import rmtree
from typing import NamedTuple
from xml.sax.saxutils import escape

from tfloom.common.files import write_file
from tfloom.workspace import package_templates as templates
from tfloom.workspace.licenses import find_license_text

BUILD_TYPES = ("ament_python", "ament_cmake")
_TEST_DEPENDS = ("ament_copyright", "ament_flake8", "ament_pep257", "python3-pytest")


class Package(NamedTuple):
    """The description of a new package."""

    name: str
    description: str = "TODO: Package description"
    license: str = "TODO: License declaration"
    maintainer: str = "TODO"
    email: str = "todo@example.com"
    dependencies: tuple[str, ...] = ()
    node: str | None = None
    """Name of a first node; its program has the same name."""
    library: str | None = None
    """Name of a first Python package beside the package's own."""
    build_type: str = "ament_python"


def create_package(package: Package, folder: Path) -> list[Path]:
    """Write a package into `folder/<name>` and return its files.

    Raises:
        FileExistsError: the folder exists.
        OSError: a file can't be written; the folder is removed again.
        ValueError: a name is not a valid one of a package, a node, a library or a dependency; node and library have
            one name; a package of interfaces has a node or a library; or there is no such build type.
    """
    _check(package)
    root = folder / package.name
    root.mkdir(parents=True)
    written = []
    try:
        for path, text in _files(package):
            target = root / path
            target.parent.mkdir(exist_ok=True)
            write_file(target, text)
            written.append(target)
    except BaseException:
        rmtree(root, ignore_errors=True)
        raise
    return written


def _check(package: Package) -> None:
    check_name(package.name, "package")
    for name, what in ((package.node, "node"), (package.library, "library")):
        if name is not None:
            check_name(name, what)
    if package.name == "test":
        raise ValueError("'test' can't be a package's name: its code would be where its tests go")
    if package.library in {package.name, "test"}:
        raise ValueError(f"'{package.library}' can't be the library's name: that folder is the package's own")
    for dependency in package.dependencies:
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_-]*", dependency):
            raise ValueError(f"'{dependency}' can't be a package to depend on")
    if package.build_type not in BUILD_TYPES:
        raise ValueError(
            f"a package of build type {package.build_type} needs CMake and C++; "
            "ament_python doesn't, nor does ament_cmake for messages, services and actions"
        )
    if package.build_type == "ament_cmake" and (package.node or package.library):
        raise ValueError(
            "nodes and libraries of build type ament_cmake are C++, which needs a ROS install: "
            "use --build-type ament_python, and ament_cmake for messages, services and actions alone"
        )


def check_name(name: str, what: str) -> None:
    """Check that a name is valid for a Python module.

    Raises:
        ValueError: it doesn't begin with a lower-case letter, has characters other than those, digits and
            underscores, or is a keyword.
    """
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or keyword.iskeyword(name):
        raise ValueError(
            f"'{name}' can't be a {what}'s name: use lower-case letters, digits and underscores, a letter first"
        )


def _files(package: Package) -> Iterable[tuple[str, str]]:
    yield "package.xml", _manifest(package)
    license_text = find_license_text(package.license)
    if license_text is not None:
        yield "LICENSE", license_text
    yield from _interface_files(package) if package.build_type == "ament_cmake" else _python_files(package)


def _manifest(package: Package) -> str:
    if package.build_type == "ament_cmake":
        groups = [
            [("buildtool_depend", "ament_cmake"), ("buildtool_depend", "rosidl_default_generators")],
            [("depend", name) for name in package.dependencies],
            [("exec_depend", "rosidl_default_runtime")],
            [("member_of_group", "rosidl_interface_packages")],
        ]
    else:
        depends = dict.fromkeys([*(["rclpy"] if package.node else []), *package.dependencies])
        groups = [
            [("depend", name) for name in depends],
            [("test_depend", name) for name in _TEST_DEPENDS],
        ]
    tags = "\n".join(
        "".join(f"  <{tag}>{escape(text)}</{tag}>\n" for tag, text in group) for group in groups if group
    )
    texts = {field: escape(getattr(package, field), {'"': "&quot;"}) for field in package._fields[:5]}
    return templates.PACKAGE_XML.format(**texts, tags=tags, build_type=package.build_type)


def _python_files(package: Package) -> Iterable[tuple[str, str]]:
    name = package.name
    script = f"            '{package.node} = {name}.{package.node}:main',\n" if package.node else ""
    yield "setup.py", templates.SETUP_PY.format(**package._asdict(), scripts=script)
    yield "setup.cfg", templates.SETUP_CFG.format(name=name)
    yield f"resource/{name}", ""
    yield f"{name}/__init__.py", ""
    if package.node:
        class_name = "".join(part.capitalize() for part in package.node.split("_"))
        yield (
            f"{name}/{package.node}.py",
            templates.NODE.format(name=name, node=package.node, class_name=class_name),
        )
    if package.library:
        yield f"{package.library}/__init__.py", ""
    yield from templates.TESTS.items()


def _interface_files(package: Package) -> Iterable[tuple[str, str]]:
    find_packages = "".join(f"find_package({name} REQUIRED)\n" for name in package.dependencies)
    listed = f"  DEPENDENCIES {' '.join(package.dependencies)}\n" if package.dependencies else ""
    text = templates.CMAKE_LISTS.format(name=package.name, find_packages=find_packages, dependencies=listed)
    yield "CMakeLists.txt", text
    yield "msg/Num.msg", templates.MESSAGE
