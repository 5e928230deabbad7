"""Each file that a program writes beside its work may be refused at each call: it says so once, and goes on."""

from __future__ import annotations

import ast
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end
from tests.faults.refused_files import ROWS

import tfloom

SOURCE = Path(tfloom.__path__[-1])
PRELOADED = Path(__file__).parents[1] / "native" / "refused_writes.c"
TELLS = ("tfloom: ", "[launch]: ", "told: ")

WORK = "- the work itself, which ends with the error"
OF_A_BUILD = "- a build's: the build ends with the error"
OF_A_COMMAND = "- what the command was asked for: it ends with the error"
OF_THE_CALLER = "- for other rooms: the caller gets the error"
WRITERS = {
    "bag/reading/bag_file.py": "- a copy that reading needs: the reader gets the error",
    "bag/reading/sqlite_reader.py": "- a copy that reading needs: the reader gets the error",
    "bag/reindexing.py": WORK,
    "bag/rosbag2_names/storage.py": WORK,
    "bag/writing/bag_writer.py": WORK,
    "bag/writing/compression.py": WORK,
    "bag/writing/sqlite_file.py": WORK,
    "cli/api/bag.py": OF_A_COMMAND,
    "cli/api/pkg.py": OF_A_COMMAND,
    "cli/tf/plot.py": OF_A_COMMAND,
    "cli/tf/save.py": OF_A_COMMAND,
    "launch/logs/logging.py": "log_of_a_launch",
    "launch/logs/log_handlers.py": "log_of_a_launch",
    "launch/ros/temporary_files.py": "- the parameters of a node: its action ends with the error",
    "launch/logs/library_handlers.py": "- of a program that chose one: the standard library reports its errors",
    "launch/testing/launch_test.py": OF_A_COMMAND,
    "node/log/log_file.py": "log_of_a_node",
    "rmw/cyclone/library.py": "- a file in memory",
    "tf2/buffer.py": OF_THE_CALLER,
    "tf2/trajectory.py": OF_THE_CALLER,
    "tf2_tools/drawing/pdf.py": "- into memory",
    "tf2_tools/drawing/png.py": "- into memory",
    "tf2_tools/view_frames.py": OF_A_COMMAND,
    "turtlesim/picture.py": "picture_of_a_simulation",
    "turtlesim/record.py": "picture_of_a_simulation",
    "viewer/described.py": "- what xacro makes of a description: who asks for it gets the error",
    "viewer/pictures.py": "- into memory",
    "viewer/program.py": "layout_of_a_page",
    "common/files.py": OF_THE_CALLER,
    "common/terminal.py": "- /dev/null",
    "workspace/colcon/environment.py": OF_A_BUILD,
    "workspace/colcon/pytest_tests.py": OF_A_BUILD,
    "workspace/create.py": OF_A_COMMAND,
    "workspace/installing.py": OF_A_BUILD,
    "workspace/interface_package.py": OF_A_BUILD,
    "workspace/interface_stubs.py": OF_A_BUILD,
    "workspace/leftovers.py": OF_A_BUILD,
    "workspace/program_scripts.py": OF_A_BUILD,
}
"""By file that writes files: the row that refuses it each call, or why there is none."""

WRITING_CALLS = {
    *(
        "write_file",
        "Replacement",
        "write_text",
        "write_bytes",
        "touch",
        "mkdir",
        "makedirs",
        "mkdtemp",
        "mkstemp",
    ),
    *(
        "NamedTemporaryFile",
        "TemporaryFile",
        "TemporaryDirectory",
        "symlink_to",
        "symlink",
        "hardlink_to",
        "link",
    ),
    *(
        "copy",
        "copy2",
        "copyfile",
        "copytree",
        "rename",
        "memfd_create",
        "FileHandler",
        "RotatingFileHandler",
    ),
    *("TimedRotatingFileHandler", "WatchedFileHandler", "save", "savefig", "mkfifo"),
}
"""Names of functions, methods and classes that create files."""
OF_SHUTIL_AND_OS = {"copy", "copy2", "copyfile", "copytree", "rename", "link", "symlink"}
"""Of these, the names that mean files only as functions of a module."""
PLANTED = {
    "with open(path, 'a') as log: pass": True,
    "path.open(mode='wb')": True,
    "os.open(path, os.O_WRONLY | os.O_CREAT)": True,
    "os.open(path, flags)": True,
    "sqlite3.connect(path)": True,
    "class Own(logging.FileHandler): pass": True,
    "write_file(path, text)": True,
    "shutil.copy2(a, b)": True,
    "open(path)": False,
    "path.open('rb')": False,
    "zenoh.open(config)": False,
    "os.open('/dev/tty', os.O_RDONLY)": False,
    "message.copy()": False,
}


def opens_to_write(call: ast.Call, name: str) -> bool:
    """Return whether a call of `open` may create or change a file."""
    is_method = isinstance(call.func, ast.Attribute)
    if is_method and ast.unparse(call.func) == "os.open":
        return not (len(call.args) > 1 and "O_RDONLY" in ast.unparse(call.args[1]))
    mode = call.args[0 if is_method else 1 :][:1] + [
        word.value for word in call.keywords if word.arg == "mode"
    ]
    return name == "open" and any(
        isinstance(given, ast.Constant) and isinstance(given.value, str) and set(given.value) & set("wax+")
        for given in mode
    )


def writes(node: ast.AST) -> bool:
    """Return whether a part of a program creates or changes files."""
    if isinstance(node, ast.ClassDef):
        return any(ast.unparse(base).endswith("FileHandler") for base in node.bases)
    if not isinstance(node, ast.Call):
        return False
    name = getattr(node.func, "attr", getattr(node.func, "id", ""))
    if name in OF_SHUTIL_AND_OS:
        return ast.unparse(node.func).split(".")[0] in ("os", "shutil")
    return (
        name in WRITING_CALLS
        or ast.unparse(node.func) == "sqlite3.connect"
        or (name == "open" and opens_to_write(node, name))
    )


def writing_files() -> Iterator[str]:
    for path in sorted(SOURCE.rglob("*.py")):
        name = path.relative_to(SOURCE).as_posix()
        if not name.startswith(("ros_names/", "interfaces/")) and any(
            writes(node) for node in ast.walk(ast.parse(path.read_text("utf-8")))
        ):
            yield name


@pytest.mark.parametrize(("text", "expected"), PLANTED.items())
def test_planted_writers_are_found(text: str, *, expected: bool) -> None:
    assert any(writes(node) for node in ast.walk(ast.parse(text))) is expected


def test_every_file_that_writes_has_a_row() -> None:
    """A new writer needs a row in `refused_files.py`, or a reason here."""
    assert sorted(writing_files()) == sorted(WRITERS), (
        "WRITERS of tests/faults/test_refused_files.py: a file that writes gets a row, or a reason"
    )
    assert {row for row in WRITERS.values() if not row.startswith("-")} == set(ROWS)


@pytest.fixture(scope="module")
def preloaded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Return the environment of a program whose writes can be refused."""
    if sys.platform != "linux" or shutil.which("cc") is None:
        pytest.skip("builds a library with cc")
    library = tmp_path_factory.mktemp("refused") / "refused_writes.so"
    subprocess.run(["cc", "-shared", "-fPIC", PRELOADED, "-o", library, "-ldl"], check=True)
    return {**os.environ, "LD_PRELOAD": f"{os.environ.get('LD_PRELOAD', '')} {library}"}


@pytest.mark.parametrize("row", ROWS)
def test_each_refused_write_is_told_once_and_ends_nothing(
    row: str, preloaded: dict[str, str], tmp_path: Path
) -> None:
    command = [sys.executable, "-m", "tests.faults.refused_files", row, tmp_path]
    done = run_to_end(command, env=preloaded, cwd=Path(__file__).parents[2])
    assert done.returncode == 0, done.stderr
    places: list[dict[str, Any]] = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(places) > 3
    assert [place["refused"] > 0 for place in places] == [True] * (len(places) - 1) + [False]
    assert [place["raised"] for place in places] == [""] * len(places)
    for number, place in enumerate(places):
        told = [line for line in place["told"] if line.startswith(TELLS)]
        assert bool(told) == (number < len(places) - 1), (number, place)
        without_number = [line.partition(" are lost")[0] for line in told]
        assert len(set(without_number)) == len(told), place
    assert [line for place in places for line in place["told"] if "Traceback" in line] == []
