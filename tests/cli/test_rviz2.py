"""rviz2, rqt_graph, rqt_plot and rqt_console open the page of `tfloom view`; others say what stands in."""

from __future__ import annotations

import json
import sys
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import transcript
from tests.conftest import Program, wait_until

from tfloom.cli import page_programs, rqt, view
from tfloom.node.node import Node
from tfloom.rosidl.class_search import find_class
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


def states(address: str) -> Iterator[dict[str, Any]]:
    """Give the states that a page gets."""
    from websockets.sync.client import connect

    with connect(f"{address.partition('?')[0].replace('http', 'ws')}api", proxy=None) as page:
        while True:
            message = json.loads(page.recv(timeout=30.0))
            if "state" in message:
                yield message["state"]


def fixed_frame(address: str) -> str:
    """Return the fixed frame that a page shows."""
    return str(next(states(address))["fixed_frame"])


def plots_of(address: str, count: int) -> list[dict[str, Any]]:
    """Return the plots of a page, once it has so many."""
    return next(state["plots"] for state in states(address) if len(state["plots"]) == count)


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
    monkeypatch.setattr(page_programs, "is_installed", lambda: False)
    assert page_programs.run_rviz2(["-d", str(config)]) == 1
    written = capsys.readouterr()
    assert written.out == ""
    assert written.err.count("\n") == 1
    assert written.err.startswith("rviz2: the page that stands in for RViz needs viser")
    assert "pip install 'tfloom[view]'" in written.err


def test_browser_is_opened_where_there_is_a_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    for name in ("BROWSER", "CI"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("DISPLAY", ":7")
    assert view._has_browser(needs_terminal=False)
    assert not view._has_browser(needs_terminal=True)  # the output of a test is no terminal
    monkeypatch.delenv("DISPLAY")
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    assert not view._has_browser(needs_terminal=False)
    monkeypatch.setenv("BROWSER", "firefox")
    assert view._has_browser(needs_terminal=False)
    monkeypatch.setenv("CI", "true")
    assert not view._has_browser(needs_terminal=False)


def test_programs_with_windows_say_what_stands_in_for_them() -> None:
    for package, sentence in index.STAND_INS.items():
        assert "`" in sentence
        if package in {"rqt_publisher", "gazebo_ros"}:  # each takes a process
            said = transcript.run_here("run", package, package)
            assert (said.exit_code, said.text) == (1, f"Package '{package}' not found\n{sentence}")
    asked = transcript.run_here("pkg", "prefix", "rqt_publisher")
    assert asked.exit_code == 1
    assert index.STAND_INS["rqt_publisher"] in asked.text


@needs_view
def test_rqt_plot_opens_the_page_at_its_plots(onlooker: Node, start_program: Callable[..., Program]) -> None:
    words = ("/turtle1/pose/x", "turtle1/pose/y:theta", "-t", "--ros-args", "-p", "use_sim_time:=true")
    program = start_program("tfloom", "run", "rqt_plot", "rqt_plot", *words)
    address = opened(program)
    assert address.endswith("/?panel=plots")
    assert program.lines[0] == "rqt_plot: the panel Plots of `tfloom view` stands in for rqt_plot"
    assert program.lines[-1] == f"Open {address}"
    onlooker.create_publisher(find_class("turtlesim/msg/Pose"), "/turtle1/pose", 1)
    shown = {(plot["topic"], plot["field"]) for plot in plots_of(address, 3)}
    assert shown == {("/turtle1/pose", field) for field in ("x", "y", "theta")}
    wait_until(lambda: onlooker.count_subscribers("/clock") == 1, what="the time")


@needs_view
@pytest.mark.parametrize(("name", "panel"), [("rqt_graph", "graph"), ("rqt_console", "log")])
def test_launch_file_that_starts_a_window_of_rqt_opens_the_page_at_its_panel(
    name: str, panel: str, tmp_path: Path, start_program: Callable[..., Program]
) -> None:
    launch_file = tmp_path / "rqt.launch.xml"
    launch_file.write_text(f'<launch><node pkg="{name}" exec="{name}" output="screen"/></launch>')
    assert opened(start_program("tfloom", "launch", launch_file)).endswith(f"/?panel={panel}")


def test_words_that_rqt_and_plots_have_no_use_for_are_named(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for words in (["--colour", "red"], ["/turtle1/pose/x"]):
        with pytest.raises(SystemExit) as end:
            rqt.run_graph(words)
        assert end.value.code == 2
        assert f"rqt_graph: error: unrecognized arguments: {' '.join(words)}" in capsys.readouterr().err
    monkeypatch.setattr(rqt, "is_installed", lambda: False)
    assert rqt.run_console([]) == 1
    assert capsys.readouterr().err.startswith(
        "rqt_console: the page that stands in for rqt_console needs viser"
    )


@needs_view
@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["/a b"], "rqt_plot: argument --plot: /a b is not a topic with a field, as /turtle1/pose/x"),
        (
            [f"/n{number}/data" for number in range(13)],
            "rqt_plot: argument --plot: there are 12 plots already",
        ),
    ],
)
def test_plots_that_can_not_be_are_one_sentence(
    words: list[str], sentence: str, start_program: Callable[..., Program]
) -> None:
    program = start_program("tfloom", "run", "rqt_plot", "rqt_plot", *words)
    assert program.wait() == 1
    assert sentence in program.lines
    assert "Traceback" not in program.output
