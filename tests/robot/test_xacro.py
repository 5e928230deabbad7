"""xacro, as a program and in launch files."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.substitution import SubstitutionFailure
from tfloom.launch.substitutions.command import Command
from tfloom.launch.substitutions.find_executable import FindExecutable
from tfloom.robot import xacro_program
from tfloom.robot.urdf import parse_urdf

XACRO = ("tfloom", "run", "xacro", "xacro")
NAMESPACE = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
TEXT = f"""<robot name="r" {NAMESPACE}><xacro:arg name="first" default="a"/>
<link name="$(arg first)"/><xacro:include filename="$(find my_robot)/parts.xacro"/>
<xacro:leg length="${{2 * 0.25}}"/></robot>"""
PARTS = f"""<robot {NAMESPACE}><xacro:macro name="leg" params="length"><link name="leg"/>
<joint name="hip" type="fixed"><parent link="$(arg first)"/><child link="leg"/>
<origin xyz="0 0 ${{-length}}"/></joint></xacro:macro></robot>"""


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a file with macros, some of which an installed package has."""
    pytest.importorskip("xacro", reason="xacro is not installed: pip install 'tfloom[robot]'")
    prefix = tmp_path / "in stall"
    share = prefix / "share" / "my_robot"
    share.mkdir(parents=True)
    (share / "parts.xacro").write_text(PARTS)
    marker = prefix / "share" / "ament_index" / "resource_index" / "packages" / "my_robot"
    marker.parent.mkdir(parents=True)
    marker.touch()
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    path = tmp_path / "ein Röbot.xacro"
    path.write_text(TEXT)
    return path


@pytest.fixture
def context() -> LaunchContext:
    """Return the context of a launch whose PATH does not lead to this environment."""
    context = LaunchContext()
    context.environment["PATH"] = "/usr/bin"
    return context


def check(text: str, first: str = "a") -> None:
    robot = parse_urdf(text)
    assert robot.links == (first, "leg")
    assert robot.joints["hip"].origin.translation == (0.0, 0.0, -0.5)


def test_the_program(robot: Path, start_program: Callable[..., Any]) -> None:
    program = start_program(*XACRO, robot)
    assert program.wait() == 0, program.output
    check(program.output)
    output = robot.with_suffix(".urdf")
    program = start_program(*XACRO, robot, "first:=b", "-o", output)
    assert program.wait() == 0, program.output
    check(output.read_text(), "b")


def test_its_errors_are_lines(
    robot: Path,
    deviations: dict[str, dict[str, str]],
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(sys, "argv", [])  # which `main` sets
    assert "xacro-entities" in deviations
    for name, text, reason in [
        ("nothere.xacro", None, "No such file or directory"),
        ("broken.xacro", "<robot", "XML parsing error"),
        (
            "entity.xacro",
            f'<!DOCTYPE robot [<!ENTITY a "a">]><robot name="&a;" {NAMESPACE}/>',
            "the entity 'a' is used or declared, but entities are not supported: line 1, column 28",
        ),
        ("none.xacro", f'<robot name="r" {NAMESPACE}>$(find nothere)</robot>', "nothere"),
    ]:
        path = robot.with_name(name)
        if text is not None:
            path.write_text(text)
        with pytest.raises(SystemExit) as end:
            xacro_program.main([str(path)])
        printed = "".join(capfd.readouterr())
        assert end.value.code == 2, printed
        assert reason in printed
        assert "Traceback" not in printed


def test_where_it_is_not_installed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "xacro", None)
    assert xacro_program.main(["a.xacro"]) == 1
    assert capsys.readouterr().err == "xacro: xacro is not installed: pip install 'tfloom[robot]'\n"


@pytest.mark.parametrize("command", ["xacro", "ros2 run xacro xacro"])
def test_command_of_launch_files(
    robot: Path, context: LaunchContext, command: str, deviations: dict[str, dict[str, str]]
) -> None:
    assert "launch-own-programs" in deviations
    context.environment["AMENT_PREFIX_PATH"] = os.environ["AMENT_PREFIX_PATH"]
    check(Command([f"{command} '", str(robot), "' first:=c"]).perform(context), "c")


def test_find_executable_of_launch_files(robot: Path, context: LaunchContext) -> None:
    path = FindExecutable(name="xacro").perform(context)
    assert Path(path).parent == Path(sys.executable).parent
    done = subprocess.run([path, str(robot)], capture_output=True, text=True, timeout=60, check=True)
    check(done.stdout)


def test_a_command_that_fails_says_why(robot: Path, context: LaunchContext) -> None:
    with pytest.raises(SubstitutionFailure, match=r"No such file or directory: .*nothere\.xacro") as raised:
        Command(f"xacro '{robot.with_name('nothere.xacro')}'").perform(context)
    assert "Traceback" not in str(raised.value)
