"""The code blocks of README, of the tutorial and of the how-tos run, and print what the pages say."""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import COLCON_PYTHON, Program, run_to_end
from tests.docs import page
from tests.docs.page import DOCS
from tests.each import for_each

pytestmark = pytest.mark.skipif(os.name != "posix", reason="its commands are for a POSIX shell")

TUTORIAL = sorted((DOCS / "tutorial").glob("*.md"))
HOW_TOS = [
    *sorted((DOCS / "how_to").glob("*.md")),
    *(DOCS / f"{name}.md" for name in ("bags", "beside_ros2", "drop_in")),
]
"""The pages with steps; the last three hold a reference, too."""
README = DOCS.parent / "README.md"
PAGES = [*TUTORIAL, *HOW_TOS, README, DOCS / "index.md", DOCS / "install.md"]
RUN_ELSEWHERE = {"robot_in_a_room"}
"""A page whose command tests/demos/test_robot_show.py runs, and more of it than the page shows."""
WITH_COMMANDS = [
    path for path in PAGES if list(page.commands(page.blocks(path))) and path.stem not in RUN_ELSEWHERE
]
QUOTING = {"testing"}
"""Pages whose blocks are parts of an example, with which tests/testing compares them."""
WITH_PROGRAMS = [
    path
    for path in sorted({*DOCS.glob("*.md"), *PAGES})
    if page.program(page.blocks(path))[1] and path.stem not in QUOTING
]
MAX_COLUMNS = 92
"""What the site's column for text holds of a program, which it does not wrap."""
PLACEHOLDER = re.compile(r"(?<!<)<[a-z][\w ]*>")
BIN = Path(sys.executable).parent


def name_of(path: Path) -> str:
    return path.relative_to(DOCS if path != README else README.parent).with_suffix("").as_posix()


@pytest.fixture
def folder(tmp_path: Path, path: Path) -> Path:
    """Return a folder with the programs of the tutorial, but for those in a workspace."""
    for document in TUTORIAL:
        for name, text in page.files(page.blocks(document)).items():
            if "/" not in name:
                (tmp_path / name).write_text(text, "utf-8")
    return tmp_path


@pytest.mark.wire
@pytest.mark.parametrize("path", WITH_COMMANDS, ids=name_of)
def test_commands_print_what_the_page_says(
    path: Path,
    folder: Path,
    domain_id: int,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
) -> None:
    run_commands(path, folder, start_program, wait_until)


@pytest.mark.wire
@pytest.mark.parametrize("distro", ["kilted", "lyrical"])
@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, marks=pytest.mark.slow if path.stem == "package" else (), id=name_of(path))
        for path in TUTORIAL
        if path in WITH_COMMANDS
    ],
)
def test_the_tutorial_runs_under_each_distribution(
    path: Path,
    folder: Path,
    distro: str,
    domain_id: int,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
) -> None:
    """Run each page with turtlesim's messages imported as that distribution has them."""
    changed = []
    for program in folder.glob("*.py"):
        text = program.read_text("utf-8")
        if (newer := with_newer_messages(text)) != text:
            program.write_text(newer, "utf-8")
            changed.append(program.name)
    assert len(changed) == 2
    run_commands(path, folder, start_program, wait_until, change=with_newer_messages, ROS_DISTRO=distro)


def with_newer_messages(program: str) -> str:
    return program.replace("from turtlesim.", "from turtlesim_msgs.")


def run_commands(
    path: Path,
    folder: Path,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
    change: Callable[[str], str] = str,
    **variables: str,
) -> None:
    """Run the commands of a page, and compare what each prints; `change` is applied to the programs in a workspace."""
    environment = os.environ | COLCON_PYTHON | variables
    environment |= {"PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}", "COLUMNS": "80"}
    for command in page.steps(page.blocks(path)):
        if not isinstance(command, page.Command):
            name, text = command
            (folder / name).write_text(change(text), "utf-8")
            continue
        if (word := command.words.split()[0]) == "source":
            sourced = run_to_end(["bash", "-c", f"{command.words} && env -0"], cwd=folder, env=environment)
            assert sourced.returncode == 0, sourced.stderr
            environment = dict(line.split("=", 1) for line in sourced.stdout.split("\0")[:-1])
            continue
        if not shutil.which(word, path=environment["PATH"]):
            pytest.skip(f"{path.name} runs {word!r}, which is not installed")
        expected = page.pattern(command.output)
        running = start_program("bash", "-c", f"exec {command.words}", cwd=folder, env=environment)
        where = f"{path.name}:{command.line}: {command.words}"

        def is_printed(running: Program = running, expected: page.re.Pattern[str] = expected) -> bool:
            return expected.match(page.MASKED.sub("#", running.output + "\n")) is not None

        if command.is_kept:
            wait_until(is_printed, 30, where)
        else:
            assert running.wait() == 0, f"{where}\n{running.output}"
            assert is_printed(), f"{where}\n{running.output}"


@pytest.mark.parametrize("path", WITH_PROGRAMS, ids=name_of)
def test_programs_print_what_the_page_says(path: Path, tmp_path: Path) -> None:
    code, output = page.program(page.blocks(path))
    done = run_to_end(
        [sys.executable, "-c", code], cwd=tmp_path, env=os.environ | {"RMW_IMPLEMENTATION": "tfloom_local"}
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == output


@for_each(PAGES, name=name_of)
def test_each_block_is_run_or_says_why_not(path: Path) -> None:
    found = page.blocks(path)
    unknown = [block for block in found if block.kind not in page.QUOTED and block.kind[:1] != "{"]
    assert not unknown
    not_run = [block.line for block in found if block.kind == "bash" and not block.reason]
    assert not not_run, "lines of ```bash blocks without <!-- not run: REASON -->"
    program = page.program(found)
    assert bool(program[0]) == bool(program[1]), "a program without its output"


@for_each([README, *sorted(DOCS.rglob("*.md"))], name=name_of)
def test_commands_can_be_pasted(path: Path) -> None:
    """bash reads a placeholder in angle brackets as the name of a file."""
    found = page.blocks(path)
    lines = [line for block in found if block.kind == "bash" for line in block.text.splitlines()]
    lines += [command.words for command in page.commands(found)]
    assert not [line for line in lines if PLACEHOLDER.search(line)]


@for_each(PAGES, name=name_of)
def test_programs_fit_the_column_of_the_site(path: Path) -> None:
    wide = {
        block.line + number: text
        for block in page.blocks(path)
        if block.kind.startswith("python")
        for number, text in enumerate(block.text.splitlines(), 1)
        if len(text) > MAX_COLUMNS
    }
    assert not wide, "a window of 1280 pixels cuts these lines"


def test_a_difference_is_found() -> None:
    expected = page.pattern(["a [1763883600.531203742] b", "…", "c … d"])
    assert expected.match("a # b\nmore\nand more\nc 12 d\nrest\n")
    assert not expected.match("a # b\nmore\nc 12 e\n")
    assert not expected.match("before\na # b\nc 1 d\n")


def test_pages_are_found() -> None:
    assert {"broadcaster", "follower", "install", "launch", "package", "turtle"} == {
        path.stem for path in TUTORIAL
    }
    assert len(HOW_TOS) >= 7
    assert len(WITH_COMMANDS) >= 6
    assert len(WITH_PROGRAMS) >= 4
    assert README in WITH_PROGRAMS
    assert shutil.which("bash")
