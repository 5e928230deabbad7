"""The house's rules: imports point down the shelves, one door for each library, no ROS name inside."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
HOUSE = ROOT / "src" / "tfloom"
ROS_NAMES = {path.name for path in (HOUSE / "ros_names").glob("*")}
SHELVES = [
    ["_native"],
    ["rosidl", "interfaces", "tf2"],
    ["rmw"],
    ["node"],
    ["tf2_ros", "bag", "workspace"],
    ["tf2_tools", "turtlesim", "robot", "launch", "demos"],
    ["cli"],
]
SHELF = {room: shelf for shelf, rooms in enumerate(SHELVES) for room in rooms}
DOORS = {
    "zenoh": "rmw/zenoh.py",
    "pygame": "turtlesim/window.py",
    "viser": "viewer/",
    "mcap": "bag/",
    "rosbags": "bag/",
    "colcon_core": "workspace/",
    "catkin_pkg": "workspace/",
    "reportlab": "tf2_tools/",
    "argcomplete": "cli/main.py",
    "PIL": "turtlesim/picture.py",
    "transforms3d": "tf2_ros/transformations.py",
    "nanobind": "nowhere in Python",
    "cyclonedds": "nowhere in Python",
}


def modules() -> list[Path]:
    return sorted(path for path in HOUSE.rglob("*.py") if "ros_names" not in path.parts)


def imports(path: Path) -> Iterator[tuple[str, int]]:
    """Yield each imported module of a file as a dotted name, with its line."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}:{node.lineno}: a relative import"
            package = node.module or ""
            for alias in node.names:
                name = f"{package}.{alias.name}"
                yield (name if is_module(name) else package), node.lineno


def is_module(dotted: str) -> bool:
    path = ROOT / "src" / Path(*dotted.split("."))
    return path.is_dir() or path.with_suffix(".py").is_file()


def room(dotted: str) -> str:
    return dotted.split(".")[1] if dotted.count(".") else ""


def own_package_tops(path: Path) -> set[str]:
    parts = path.relative_to(ROOT / "src").with_suffix("").parts
    return {".".join(parts[:end]) for end in range(2, len(parts))}


@pytest.mark.parametrize("path", modules(), ids=lambda path: str(path.relative_to(HOUSE)))
def test_a_module_imports_only_what_stands_below_it(path: Path) -> None:
    here = path.relative_to(HOUSE).parts[0].removesuffix(".py")
    own_tops = own_package_tops(path)
    for name, line in imports(path):
        where = f"{path.relative_to(ROOT)}:{line} imports {name}"
        top = name.split(".")[0]
        assert top not in ROS_NAMES, f"{where}, a ROS name; import it from its room in tfloom"
        if top in DOORS:
            door = DOORS[top]
            assert str(path.relative_to(HOUSE).as_posix()).startswith(door), (
                f"{where}; its one door is {door}"
            )
        there = room(name) if top == "tfloom" else ""
        if there not in SHELF or here not in SHELF or there == here:
            continue
        peers = here == "interfaces" and there == "rosidl"
        assert SHELF[there] < SHELF[here] or peers, f"{where}, which doesn't stand below {here}"
        assert name not in own_tops, f"{where}, its own package's top; import the file that defines the thing"


def test_every_room_stands_on_a_shelf() -> None:
    rooms = {
        path.name
        for path in HOUSE.iterdir()
        if path.is_dir() and path.name not in {"__pycache__", "ros_names"}
    }
    assert rooms <= set(SHELF)


def test_the_command_line_starts_without_the_rooms() -> None:
    tree = ast.parse((HOUSE / "cli" / "main.py").read_text("utf-8"))
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("tfloom"):
            assert room(node.module or "") in {"", "cli"}, f"cli/main.py:{node.lineno} loads {node.module}"


@pytest.mark.parametrize("folder", ["core", "tf2", "cdr", "dds"])
def test_the_native_core_knows_no_python(folder: str) -> None:
    for path in (ROOT / "native" / folder).glob("*"):
        text = path.read_text("utf-8")
        assert not re.search(r'#include\s*[<"](nanobind|Python\.h)', text), path
        if folder != "dds":
            assert "dlopen" not in text, f"{path}: libddsc has one door, native/dds"


def test_native_rooms_stand_on_each_other_in_one_direction() -> None:
    below = {"core": set(), "tf2": {"core"}, "cdr": {"core", "tf2"}, "dds": {"core"}}
    for folder, allowed in below.items():
        for path in (ROOT / "native" / folder).glob("*"):
            for other in re.findall(r'#include "(\w+)/', path.read_text("utf-8")):
                assert other in allowed | {folder}, f"{path.name} includes {other}/"


def modules_loaded_by(*arguments: str, **environment: str) -> set[str]:
    """Run Python and return the names of all modules that it imported."""
    result = subprocess.run(
        [sys.executable, "-X", "importtime", *arguments],
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
        env=os.environ | environment,
    )
    return {
        line.rsplit("|", 1)[1].strip()
        for line in result.stderr.splitlines()
        if line.startswith("import time:")
    }


def test_tf2_alone_loads_no_messages_and_no_wire() -> None:
    loaded = modules_loaded_by("-c", "import tfloom.tf2.buffer")
    assert not {name for name in loaded if name.startswith(("tfloom.rosidl", "tfloom.rmw", "tfloom.node"))}


@pytest.mark.parametrize(
    "arguments", [["--help"], ["topic", "list", "--spin-time", "0.2"]], ids=["help", "topic list"]
)
def test_a_quick_command_loads_nothing_heavy(arguments: list[str], domain_id: int) -> None:
    loaded = modules_loaded_by("-m", "tfloom.cli", *arguments, ROS_DOMAIN_ID=str(domain_id))
    assert not loaded & {"numpy", "pygame", "PIL", "reportlab", "yaml", "asyncio"}
