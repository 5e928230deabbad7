"""Workspaces for tests: packages written from texts, and built with colcon."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path
from typing import NamedTuple

from tests.conftest import COLCON_PYTHON, PYTEST, run_to_end

BIN = Path(sys.executable).parent
MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>0.1.0</version>
  <description>Of a test.</description>
  <maintainer email="me@example.com">Me</maintainer>
  <license>Apache-2.0</license>
{depends}  <export>
    <build_type>{build_type}</build_type>
  </export>
</package>
"""
SETUP_PY = """\
from setuptools import setup

setup(
    name="{name}",
    version="0.1.0",
    packages=["{name}"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/{name}"]),
        ("share/{name}", ["package.xml"]),
    ],
    zip_safe=True,
    entry_points={{"console_scripts": ["say = {name}.say:main"]}},
)
"""


class Built(NamedTuple):
    """The result of `colcon build`."""

    folder: Path
    code: int
    output: str


def write_files(folder: Path, files: dict[str, str]) -> None:
    """Write files below a folder from their texts by path."""
    for path, text in files.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, "utf-8")


def write_manifest(folder: Path, build_type: str, *depends: str, name: str = "") -> None:
    """Write the package.xml of a package, which is named as its folder if not otherwise."""
    tags = "".join(f"  <depend>{dependency}</depend>\n" for dependency in depends)
    text = MANIFEST.format(name=name or folder.name, depends=tags, build_type=build_type)
    write_files(folder, {"package.xml": text})


def write_cmake_package(folder: Path, cmake: str, *depends: str, **files: str) -> None:
    """Write a package of build type ament_cmake; in the paths of files `__` is a slash, and `_DOT_` a dot."""
    write_manifest(folder, "ament_cmake", *depends)
    named = {path.replace("__", "/").replace("_DOT_", "."): text for path, text in files.items()}
    write_files(folder, {"CMakeLists.txt": cmake, **named})


def write_python_package(folder: Path, code: str, *depends: str, setup: str = SETUP_PY) -> None:
    """Write a package of build type ament_python whose program `say` is `code`, with a function main."""
    name = folder.name
    write_manifest(folder, "ament_python", *depends)
    cfg = f"[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n"
    write_files(
        folder,
        {
            "setup.py": setup.format(name=name),
            "setup.cfg": cfg,
            f"resource/{name}": "",
            f"{name}/__init__.py": "",
            f"{name}/say.py": code,
        },
    )


def colcon(folder: Path, *words: str, **environment: str) -> Built:
    """Run colcon in a workspace; without AMENT_PREFIX_PATH unless it is given."""
    clean = {name: value for name, value in os.environ.items() if name != "AMENT_PREFIX_PATH"}
    path = f"{BIN}{os.pathsep}{clean['PATH']}"
    result = run_to_end(
        [BIN / "colcon", *words],
        cwd=folder,
        env={
            **clean,
            "PATH": path,
            "PYTHONDONTWRITEBYTECODE": "",
            "PYTEST_ADDOPTS": " ".join(PYTEST[2:]),
            **environment,
        },
        timeout_s=240,
    )
    return Built(folder, result.returncode, result.stdout + result.stderr)


def in_shell(built: Path, line: str, shell: str = "bash", **environment: str) -> str:
    """Return the output of a line of shell script after a workspace's set-up script was sourced."""
    result = run_to_end(
        [shell, "-c", f". '{built}/install/setup.{shell}' && {line}"],
        env={**os.environ, **COLCON_PYTHON, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}", **environment},
    )
    return re.sub(r"\n+$", "", result.stdout + result.stderr)
