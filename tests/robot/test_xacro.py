"""xacro, as a program and in launch files."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import psutil
import pytest
from tests.conftest import has_ended, wait_until

from tfloom.launch.core.base_classes import SubstitutionFailure
from tfloom.launch.core.launch_context import LaunchContext
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


def test_packages_that_are_not_installed_are_found_around_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", [])
    monkeypatch.chdir("/")
    for folder in ("clone/bot", "clone/arms", "other/grippers"):
        (tmp_path / folder).mkdir(parents=True)
        name = folder.partition("/")[2]
        (tmp_path / folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
    path = tmp_path / "clone" / "bot" / "bot.xacro"
    path.write_text(f'<robot name="r" {NAMESPACE}><link name="$(find arms)$(find grippers)"/></robot>')
    assert xacro_program.main([str(path)]) == 0
    assert f'name="{tmp_path}/clone/arms{tmp_path}/other/grippers"' in capfd.readouterr().out
    # An installed one counts before them.
    prefix = tmp_path / "installed"
    (prefix / "share" / "ament_index" / "resource_index" / "packages").mkdir(parents=True)
    (prefix / "share" / "ament_index" / "resource_index" / "packages" / "arms").touch()
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    assert xacro_program.main([str(path)]) == 0
    assert f'name="{prefix}/share/arms{tmp_path}/other/grippers"' in capfd.readouterr().out
    path.write_text(f'<robot name="r" {NAMESPACE}>$(find nothere)</robot>')
    with pytest.raises(SystemExit):
        xacro_program.main([str(path)])
    first = capfd.readouterr().err.splitlines()[0]
    assert first.startswith("error: package 'nothere' not found"), first
    assert first.count("nothere") == 1


def doubled(inner: str, outer: str) -> str:
    """Return definitions that have the one before twice, forty times."""
    return inner + "".join(outer.format(number, number - 1) for number in range(1, 41))


ENDLESS = {
    "macros": (
        doubled(
            '<xacro:macro name="m0"><link name="a"/></xacro:macro>',
            '<xacro:macro name="m{0}"><xacro:m{1}/><xacro:m{1}/></xacro:macro>',
        )
        + "<xacro:m40/>",
        "more than 2000 elements, which is the limit",
    ),
    "macros that are empty": (
        doubled(
            '<xacro:macro name="m0"/>', '<xacro:macro name="m{0}"><xacro:m{1}/><xacro:m{1}/></xacro:macro>'
        )
        + "<xacro:m40/>",
        "more than 2000 elements",
    ),
    "blocks": (
        '<xacro:macro name="m" params="*b"><a>'
        + '<xacro:insert_block name="b"/>' * 2
        + "</a></xacro:macro>"
        + "<xacro:m>" * 40
        + "<b/>"
        + "</xacro:m>" * 40,
        "more than 2000 elements",
    ),
    "a macro that calls itself": ('<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>', "recursion"),
    "properties": (
        doubled(
            '<xacro:property name="p0" value="aaaaaaaa"/>',
            '<xacro:property name="p{0}" value="${{p{1}}}${{p{1}}}"/>',
        )
        + '<link name="${p40}"/>',
        "characters, and 1000000 are the limit",
    ),
    "an expression that fills the memory": (
        "<link name=\"${'a' * 10**11}\"/>",
        "MiB of memory, which is the limit",
    ),
    "an expression that doesn't end": ('<link name="${9**9**9}"/>', "more than 2 s, which is the limit"),
    "conditions": (
        '<xacro:macro name="m"><xacro:if value="${python.sum(python.map(len, [[]] * 10**5)) == 0}"><a/></xacro:if>'
        "</xacro:macro>" + "<xacro:m/>" * 1900,
        "more than 2 s, which is the limit",
    ),
}


@pytest.mark.parametrize("kind", ENDLESS)
def test_file_that_stands_for_more_than_the_limits_ends_with_a_line(
    kind: str,
    robot: Path,
    deviations: dict[str, dict[str, str]],
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert "xacro-limits" in deviations
    monkeypatch.setattr(xacro_program, "MAX_ELEMENTS", 2000)
    monkeypatch.setattr(xacro_program, "MAX_S", 2.0 if "2 s" in ENDLESS[kind][1] else 60.0)
    monkeypatch.setattr(xacro_program, "GRACE_S", 0.5)
    text, reason = ENDLESS[kind]
    assert len(text) < 10**5
    robot.write_text(f'<robot name="r" {NAMESPACE}>{text}</robot>')
    with pytest.raises(SystemExit) as end:
        xacro_program.main([str(robot)])
    printed = capfd.readouterr()
    assert end.value.code == 2
    assert reason in printed.err
    assert "Traceback" not in printed.err
    assert printed.out == ""


@pytest.mark.skipif(os.name != "posix", reason="Windows has no such signals")
@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGTERM, 128 + signal.SIGTERM), (signal.SIGKILL, -signal.SIGKILL)]
)
def test_process_of_the_library_ends_with_the_program(
    number: int, code: int, robot: Path, start_program: Callable[..., Any]
) -> None:
    robot.write_text(f'<robot name="r" {NAMESPACE}><link name="${{9**9**9}}"/></robot>')
    program = start_program(*XACRO, robot)

    def child() -> list[psutil.Process]:
        children: list[psutil.Process] = psutil.Process(program.process.pid).children()
        return children

    wait_until(child, what="the library's process")
    (library,) = child()
    # Until it computes: only then it has said with whom it ends, and nothing of Python can end it.
    wait_until(lambda: library.cpu_times().user > 2.0, what="its computation")
    program.process.send_signal(number)
    assert program.wait() == code
    wait_until(lambda: has_ended(library.pid), what="its end")


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


def test_the_command_of_the_library_names_a_file_that_is_absent(robot: Path, tmp_path: Path) -> None:
    """It uses `xml.parsers` without importing it, so that each error before it has parsed a file was another one."""
    program = Path(sys.executable).with_name("xacro")
    run = partial(subprocess.run, capture_output=True, text=True, check=False)
    absent = run([program, tmp_path / "absent.xacro"])
    assert absent.returncode == xacro_program.FAILED
    assert absent.stderr.startswith(f"error: No such file or directory: {tmp_path / 'absent.xacro'}")
    expanded = run([program, robot])
    assert expanded.returncode == 0
    assert parse_urdf(expanded.stdout).name == "r"
    with pytest.raises(SubstitutionFailure, match="No such file or directory"):
        Command(["xacro ", str(tmp_path / "absent.xacro")]).perform(LaunchContext())
    ours = run([sys.executable, "-m", "tfloom", *XACRO[1:], tmp_path / "absent.xacro"])
    assert ours.returncode != 0
    assert "No such file or directory" in ours.stderr
    assert "AttributeError" not in absent.stderr + ours.stderr


def test_other_programs_load_no_parser(tmp_path: Path) -> None:
    program = tmp_path / "other"
    program.write_text("import sys; print('xml' in sys.modules)")
    ran = subprocess.run([sys.executable, program], capture_output=True, text=True, check=True)
    assert ran.stdout == "False\n"
