"""examples/README.md lists each example with the summary of its docstring, and commands that exist."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest
from tests.each import for_each

EXAMPLES = Path(__file__).parents[2] / "examples"
README = (EXAMPLES / "README.md").read_text("utf-8")
PACKAGES = [path.parent for path in EXAMPLES.rglob("package.xml")]
PROGRAMS = [
    path
    for path in sorted(EXAMPLES.rglob("*.py"))
    if not any(package in path.parents for package in PACKAGES)
]


@for_each(PROGRAMS, name=lambda path: path.relative_to(EXAMPLES).as_posix())
def test_each_program_has_a_row(program: Path) -> None:
    name = program.relative_to(EXAMPLES).as_posix()
    first_line = ast.get_docstring(ast.parse(program.read_text("utf-8"))).splitlines()[0]
    assert f"| [`{name}`]({name}) | {first_line} |" in README.splitlines()


@pytest.mark.parametrize("package", PACKAGES, ids=lambda path: path.name)
def test_each_package_is_listed(package: Path) -> None:
    assert f"](./{package.name}/)" in README or f"]({package.relative_to(EXAMPLES).as_posix()}/)" in README


def test_listed_files_exist() -> None:
    links = re.findall(r"\]\(([^)#:]+)\)", README)
    commands = re.findall(r"^python (\S+\.py)", README, re.MULTILINE)
    assert links
    assert commands
    missing = [name for name in links if not (EXAMPLES / name).exists()]
    missing += [name for name in commands if not (EXAMPLES.parent / name).is_file()]
    assert not missing


def test_examples_import_ros_names_only() -> None:
    """They run on any ROS 2; those that show tfloom's own API are marked."""
    own = [
        path.relative_to(EXAMPLES).as_posix()
        for path in EXAMPLES.rglob("*.py")
        if re.search(r"^\s*(import|from) tfloom", path.read_text("utf-8"), re.MULTILINE)
    ]
    for name in own:
        assert name in README.partition("## tfloom's own")[2]
