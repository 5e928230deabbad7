"""`ros2 run rviz2 rviz2` and launch files that start it open the page of `tfloom view`; others say what stands in."""

from __future__ import annotations

import json
import sys
import urllib.request
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program, wait_until

from tfloom.cli import rviz2, view
from tfloom.node.node import Node
from tfloom.viewer.extra import is_installed
from tfloom.workspace import index

needs_view = pytest.mark.skipif(not is_installed(), reason="needs the extra view")
CONFIG = """\
Visualization Manager:
  Displays:
  - {Class: rviz_default_plugins/TF, Enabled: true}
  - {Class: my_plugins/Fancy, Name: My display, Enabled: true}
  Global Options: {Fixed Frame: odom}
"""
SAID = "rviz2: the page of `tfloom view` stands in for RViz, and shows "
LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package="rviz2", executable="rviz2", name="rviz2", output="screen",
             arguments=["-d", {config!r}, "-f", "base"],
             remappings=[("/tf", "tf"), ("/tf_static", "tf_static")], namespace="robot1")
    ])
"""


@pytest.fixture
def config(tmp_path: Path) -> Path:
    path = tmp_path / "robot.rviz"
    path.write_text(CONFIG)
    return path


def opened(program: Program) -> str:
    """Return the address that a program prints, when its page is served."""
    program.wait_for("Open http://127.0.0.1:")
    address = next(line for line in program.lines if "Open http" in line).partition("Open ")[2]
    with urllib.request.urlopen(address) as response:
        assert b"<title>tfloom view</title>" in response.read()
    return address


def fixed_frame(address: str) -> str:
    """Return the fixed frame that a page shows."""
    from websockets.sync.client import connect

    with connect(f"{address.replace('http', 'ws')}api", proxy=None) as page:
        while True:
            message = json.loads(page.recv(timeout=30.0))
            if "state" in message:
                return str(message["state"]["fixed_frame"])


@needs_view
def test_rviz2_says_one_sentence_and_serves_the_page(
    config: Path, onlooker: Node, start_program: Callable[..., Program]
) -> None:
    words = ("-d", config, "--ros-args", "-r", "/tf:=/a/tf", "-p", "use_sim_time:=true")
    program = start_program("tfloom", "run", "rviz2", "rviz2", *words)
    assert fixed_frame(opened(program)) == "odom"
    assert program.lines[0] == f"{SAID}{config}"
    assert any("the display My display of the class my_plugins/Fancy" in line for line in program.lines)
    wait_until(lambda: onlooker.count_subscribers("/a/tf") == 1, what="the remapped topic")
    wait_until(lambda: onlooker.count_subscribers("/clock") == 1, what="the time")
    assert onlooker.count_subscribers("/tf") == 0


@needs_view
def test_launch_file_that_starts_rviz2_opens_the_page(
    config: Path, onlooker: Node, tmp_path: Path, start_program: Callable[..., Program]
) -> None:
    launch_file = tmp_path / "robot.launch.py"
    launch_file.write_text(LAUNCH.format(config=str(config)))
    program = start_program("tfloom", "launch", launch_file)
    assert fixed_frame(opened(program)) == "base"
    assert any(line.endswith(f"{SAID}{config}") for line in program.lines)
    wait_until(lambda: onlooker.count_subscribers("/robot1/tf") == 1, what="the topic in the namespace")


@needs_view
def test_broken_file_is_one_sentence_with_its_line(
    config: Path, start_program: Callable[..., Program]
) -> None:
    config.write_text("Visualization Manager:\n  Displays: [\n")
    program = start_program("tfloom", "run", "rviz2", "rviz2", "-d", config)
    assert program.wait() == 1
    assert any(line.startswith(f"rviz2: {config}:3: ") for line in program.lines)
    assert "Traceback" not in program.output


def test_without_the_extra_the_sentence_has_pips_line(
    config: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(rviz2, "is_installed", lambda: False)
    assert rviz2.run(["-d", str(config)]) == 1
    written = capsys.readouterr()
    assert written.out == ""
    assert written.err.count("\n") == 1
    assert written.err.startswith("rviz2: the page that stands in for RViz needs viser")
    assert "pip install 'tfloom[view]'" in written.err


def test_browser_is_opened_where_there_is_a_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("DISPLAY", ":7")
    assert view._has_browser(needs_terminal=False)
    assert not view._has_browser(needs_terminal=True)  # the output of a test is no terminal
    monkeypatch.delenv("DISPLAY")
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    assert not view._has_browser(needs_terminal=False)


def test_programs_with_windows_say_what_stands_in_for_them() -> None:
    for package, sentence in index.STAND_INS.items():
        assert "`" in sentence
        if package in {"rqt_plot", "gazebo_ros"}:  # each takes a process
            said = transcript.run_here("run", package, package)
            assert (said.exit_code, said.text) == (1, f"Package '{package}' not found\n{sentence}")
    asked = transcript.run_here("pkg", "prefix", "rqt_graph")
    assert asked.exit_code == 1
    assert index.STAND_INS["rqt_graph"] in asked.text
