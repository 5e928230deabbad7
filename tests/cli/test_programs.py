"""All programs of tfloom end without traceback when stopped, and reject invalid arguments with a message."""

from __future__ import annotations

import re
import signal
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program

from tfloom.cli.run import run_here
from tfloom.node.node import Node
from tfloom.workspace.index import PROGRAMS

EVERY = [(package, name) for package, names in PROGRAMS.items() for name in names]

RUNNING = {
    "buffer_server": ("tf_buffer", []),
    "draw_square": ("draw_square", []),
    "dynamic_frame_tf2_broadcaster": ("dynamic_frame_tf2_broadcaster", []),
    "fixed_frame_tf2_broadcaster": ("fixed_frame_tf2_broadcaster", []),
    "foxglove_bridge": ("foxglove_bridge", ["--ros-args", "-p", "port:=0", "--"]),
    "introspection": ("introspection_client", []),
    "joint_state_publisher": ("joint_state_publisher", []),
    "listener": ("listener", []),
    "listener_serialized": ("serialized_subscriber", []),
    "mimic": ("turtle_mimic", []),
    "robot_state_publisher": (
        "robot_state_publisher",
        [str(Path(__file__).parents[1] / "golden" / "arm.urdf")],
    ),
    "static_transform_publisher": ("one", ["--frame-id", "world", "--child-frame-id", "one"]),
    "static_turtle_tf2_broadcaster": ("static_turtle_tf2_broadcaster", ["two", *"000000"]),
    "talker": ("talker", []),
    "tf2_echo": ("tf2_echo", ["world", "turtle1"]),
    "tf2_monitor": ("tf2_monitor_main", []),
    "turtle_tf2_broadcaster": ("turtle_tf2_frame_publisher", []),
    "turtle_tf2_listener": ("turtle_tf2_frame_listener", []),
    "turtle_tf2_message_broadcaster": ("turtle_tf2_message_broadcaster", []),
    "turtlesim_node": ("turtlesim", ["--headless"]),
}
"""Programs that run until they are stopped: the name of the node of each, and its words."""


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["INT", "TERM"])
def test_programs_end_without_traceback_when_stopped(
    onlooker: Node, number: int, start_program: Callable[..., Program], wait_until: Callable[..., None]
) -> None:
    programs = {
        node: start_program(
            *("tfloom", "run", package, name, *RUNNING[name][1]),
            *(("--ros-args", "-r", "__node:=one") if name == "static_transform_publisher" else ()),
        )
        for package, name in EVERY
        if name in RUNNING
        for node in [RUNNING[name][0]]
    }
    assert len(programs) == len(RUNNING)
    wait_until(lambda: programs.keys() <= set(onlooker.get_node_names()), 90, "all nodes")
    for program in programs.values():
        program.signal(number)
    for program in programs.values():
        assert program.wait() == 0, program.output
        assert "Traceback" not in program.output
        assert "ignored" not in program.output


def complaint(package: str, name: str, words: list[str], capfd: pytest.CaptureFixture[str]) -> str:
    """Return the output of a program that rejects its arguments."""
    before = signal.getsignal(signal.SIGTERM), sys.argv
    try:
        code = run_here(PROGRAMS[package][name], name, words)
    finally:
        signal.signal(signal.SIGTERM, before[0])
        sys.argv = before[1]
    printed = capfd.readouterr()
    assert code not in {0, None}
    assert "Traceback" not in printed.err
    return printed.out + printed.err


@pytest.mark.parametrize(("package", "name"), EVERY)
def test_unknown_arguments_are_rejected(package: str, name: str, capfd: pytest.CaptureFixture[str]) -> None:
    text = complaint(package, name, ["--such-nonsense", "x", "y", "z", "--ros-args", "-p", "a:=1"], capfd)
    assert "usage" in text.lower() or "--such-nonsense" in text


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["-r"], "Failed to parse ROS arguments: -r needs a value: [node:]from:=to"),
        (["-p", "x"], "Failed to parse ROS arguments: cannot understand '-p x': expected [node:]name:=value"),
        (["--params-file", "/nowhere.yaml"], "No such file or directory: '/nowhere.yaml'"),
    ],
)
@pytest.mark.parametrize(
    ("package", "name"), [program for program in EVERY if program[1] != "xacro"]
)  # it is no node
def test_malformed_ros_arguments_are_rejected(
    package: str, name: str, words: list[str], text: str, capfd: pytest.CaptureFixture[str]
) -> None:
    own = RUNNING.get(name, ("", []))[1]
    said = complaint(package, name, [*own, "--ros-args", *words], capfd)
    assert text in said
    assert said.startswith(f"{name}: ")
    assert said.count("\n") == 1


@pytest.mark.parametrize(
    ("package", "name", "parameter", "text"),
    [
        (
            "turtlesim",
            "turtlesim_node",
            "background_r:=abc",
            "parameter 'background_r' to 'abc' of type 'STRING'",
        ),
        ("turtlesim", "turtlesim_node", "holonomic:=3", "expecting type 'BOOL'"),
        ("turtle_tf2_py", "turtle_tf2_broadcaster", "turtlename:=3", "expecting type 'STRING'"),
        ("turtle_tf2_py", "turtle_tf2_broadcaster", "turtlename:=a b", "Invalid topic name"),
        ("turtle_tf2_py", "turtle_tf2_time_travel", "delay:=soon", "expecting type 'DOUBLE'"),
        ("turtle_tf2_py", "turtle_tf2_time_travel", "delay:=.nan", "Reason: must be a number of seconds"),
        ("turtle_tf2_py", "turtle_tf2_listener", "target_frame:=7", "expecting type 'STRING'"),
        ("tf2_ros", "buffer_server", "buffer_size:=abc", "parameter 'buffer_size' to 'abc' of type 'STRING'"),
        ("tf2_ros", "static_transform_publisher", "rotation.w:=abc", "expecting type 'DOUBLE'"),
        (
            "demo_nodes_py",
            "introspection",
            "client_configure_introspection:=all",
            "must be one of 'disabled'",
        ),
        ("demo_nodes_py", "set_parameters_callback", "param1:=x", "expecting type 'DOUBLE'"),
        ("foxglove_bridge", "foxglove_bridge", "port:=abc", "expecting type 'INTEGER'"),
        ("demo_nodes_py", "talker", "use_sim_time:=maybe", "expecting type 'BOOL'"),
    ],
)
def test_invalid_parameters_are_rejected(
    package: str,
    name: str,
    parameter: str,
    text: str,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    own = RUNNING.get(name, ("", []))[1]
    said = complaint(package, name, [*own, "--ros-args", "-p", parameter], capfd)
    (error,) = [line for line in said.splitlines() if line.startswith(f"{name}: ")]
    assert text in error


def test_docs_list_all_programs() -> None:
    text = (Path(__file__).parents[2] / "docs" / "commands.md").read_text("utf-8")
    rows = [line.split("|") for line in text.splitlines() if line.startswith("| `")]
    listed = {row[1].strip(" `"): set(re.findall("`([^`]+)`", row[2])) for row in rows}
    for package, names in PROGRAMS.items():
        assert listed[package] == names.keys()


def test_tf2_programs_match_the_recording() -> None:
    recorded = transcript.golden("pkg_executables_tf2").text.splitlines()
    listed = [transcript.run_here("pkg", "executables", package).text for package in ("tf2_ros", "tf2_tools")]
    assert "\n".join(listed).splitlines() == recorded
