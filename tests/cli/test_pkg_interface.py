"""`pkg` and `interface` against the recorded answers."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program

from tfloom.ros_imports.distributions import INTERFACES, find_prefix
from tfloom.workspace import index


@pytest.fixture(autouse=True)
def no_workspace(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(index.PREFIX_PATH_VARIABLE, raising=False)


@pytest.mark.parametrize(
    "name", ["pkg_prefix_bad", "interface_show_bad", "interface_show_action", "interface_proto"]
)
def test_answers_match_the_recording(name: str) -> None:
    recorded = transcript.golden(name)
    answer = transcript.run_here(*recorded.command)
    assert (answer.text, answer.exit_code) == (recorded.text, recorded.exit_code)


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("turtlesim/srv/Spawn", "x: 0.0\ny: 0.0\ntheta: 0.0\nname: ''\n"),
        ("example_interfaces/action/Fibonacci", "order: 0\n"),
    ],
)
def test_proto_prints_the_request_or_goal(name: str, values: str) -> None:
    answer = transcript.run_here("interface", "proto", "--no-quotes", name)
    assert (answer.text.rstrip(), answer.exit_code) == (values.rstrip(), 0)


def test_proto_of_an_unknown_service_gives_the_nearest() -> None:
    answer = transcript.run_here("interface", "proto", "turtlesim/srv/Spwn")
    assert answer.text.endswith("\ndid you mean turtlesim/srv/Spawn?")
    assert answer.exit_code == 1


@pytest.mark.parametrize("name", ["interface_show_msg", "interface_show_srv"])
def test_no_comments_removes_all_comments(name: str, deviations: dict[str, dict[str, str]]) -> None:
    assert "cli-no-comments" in deviations
    recorded = transcript.golden(name)
    lines = [line.removesuffix(" #") for line in recorded.text.splitlines() if line != "#"]
    assert transcript.run_here(*recorded.command).text.splitlines() == lines


def test_interfaces_of_a_package_are_sorted(deviations: dict[str, dict[str, str]]) -> None:
    assert "cli-interface-order" in deviations
    recorded = transcript.golden("interface_package")
    answer = transcript.run_here(*recorded.command)
    assert sorted(answer.text.splitlines()) == sorted(recorded.text.splitlines())


@pytest.mark.parametrize("name", ["interface_list_head", "interface_packages_head"])
def test_reference_interfaces_of_known_packages_are_listed(name: str) -> None:
    recorded = transcript.golden(name)
    words = recorded.command[: recorded.command.index("|")]
    ours = transcript.run_here(*words).text.splitlines()
    for_tests = {"ros2cli_test_interfaces", "test_msgs"}
    assert [line for line in recorded.text.splitlines() if line not in ours and line not in for_tests] == []
    assert ours.index("std_msgs" if "packages" in name else "Messages:") >= 0


def test_own_programs_are_listed() -> None:
    listed = transcript.run_here("pkg", "executables").text.splitlines()
    assert listed == [
        f"{package} {program}" for package in sorted(index.PROGRAMS) for program in index.PROGRAMS[package]
    ]
    one = json.loads(transcript.run_here("pkg", "executables", "tf2_tools", "--json").text)
    assert one == [
        {"package": "tf2_tools", "executable": "view_frames", "target": "tfloom.tf2_tools.view_frames:main"}
    ]


def test_bare_interface_name_gives_the_full_names() -> None:
    answer = transcript.run_here("interface", "show", "twist")
    assert answer.exit_code == 1
    assert answer.text.endswith("not 'twist'\ndid you mean geometry_msgs/msg/Twist?")


def test_turtlesim_programs_match_the_recording() -> None:
    recorded = transcript.golden("pkg_executables")
    assert transcript.run_here(*recorded.command).text.splitlines() == recorded.text.splitlines()


def test_packages_of_tfloom_interfaces_are_listed_as_our_own() -> None:
    assert "nav2_msgs" in transcript.run_here("pkg", "list").text.splitlines()
    prefix = transcript.run_here("pkg", "prefix", "nav2_msgs").text
    assert prefix == str(find_prefix(INTERFACES))
    share = Path(transcript.run_here("pkg", "prefix", "--share", "nav2_msgs").text)
    assert (share / "action" / "NavigateToPose.action").is_file()
    listed = transcript.run_here("interface", "list").text
    assert "    nav2_msgs/action/NavigateToPose\n" in listed
    assert "    vision_msgs/msg/Detection3D\n" in listed
    shown = transcript.run_here("interface", "show", "map_msgs/msg/ProjectedMap").text
    assert shown.startswith("nav_msgs/OccupancyGrid map\n\tstd_msgs/Header header\n")
    assert transcript.run_here("interface", "proto", "nav2_msgs/action/Wait").text.startswith('"time:\n')


def test_packages_with_definitions_and_no_marker_are_listed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "share" / "my_interfaces" / "msg"
    folder.mkdir(parents=True)
    (folder / "Ball.msg").write_text("float64 radius\n")
    monkeypatch.setenv(index.PREFIX_PATH_VARIABLE, str(tmp_path))
    assert transcript.run_here("interface", "package", "my_interfaces").text == "my_interfaces/msg/Ball"
    assert transcript.run_here("interface", "show", "my_interfaces/Ball").text == "float64 radius"


def test_packages_are_listed() -> None:
    listed = transcript.run_here("pkg", "list").text.splitlines()
    assert {"geometry_msgs", "rclpy", "tf2_ros", "turtlesim"} <= set(listed)
    assert listed == sorted(listed)
    assert transcript.run_here("pkg", "prefix", "turtlesim").text == str(index.OWN_PREFIX)
    share = Path(transcript.run_here("pkg", "prefix", "--share", "turtlesim").text)
    assert (share / "msg" / "Pose.msg").is_file()
    assert "<name>turtlesim</name>" in (share / "package.xml").read_text("utf-8")
    assert transcript.run_here("pkg", "xml", "rclpy", "-t", "name").text == "rclpy"


def test_node_of_a_new_package_runs(
    tmp_path: Path, start_program: Callable[..., Program], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    words = ("pkg", "create", "--destination-directory", str(tmp_path), "--node-name", "my_node", "my_pkg")
    created = transcript.run_here(*words)
    assert created.exit_code == 0, created.text
    again = transcript.run_here(*words)
    assert (again.exit_code, again.text.endswith("exists; nothing was written")) == (1, True)
    assert "my_node = my_pkg.my_node:main" in (tmp_path / "my_pkg" / "setup.py").read_text("utf-8")
    # Built by colcon in tests/workspace/test_lint.py.
    node = start_program("python", "-m", "my_pkg.my_node", cwd=tmp_path / "my_pkg")
    node.wait_for("[my_node]: Hi from my_pkg.")
    node.wait_for("[my_node]: 1 s")
    node.signal(2)
    node.wait()
    assert "Traceback" not in node.output


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("--build-type", "cmake"), "a package of build type cmake needs CMake and C++"),
        (
            ("--build-type", "ament_cmake", "--node-name", "a"),
            "nodes and libraries of build type ament_cmake are C++",
        ),
        (("--library-name", "my_pkg"), "'my_pkg' can't be the library's name"),
    ],
)
def test_package_that_cannot_be_built_is_rejected(
    words: tuple[str, ...], reason: str, tmp_path: Path
) -> None:
    answer = transcript.run_here("pkg", "create", "--destination-directory", str(tmp_path), "my_pkg", *words)
    assert (answer.exit_code, answer.text[: len(reason)]) == (1, reason)
    assert list(tmp_path.iterdir()) == []


def test_licenses_are_listed() -> None:
    listed = transcript.run_here("pkg", "create", "my_pkg", "--license", "?").text.splitlines()
    assert listed[0] == "Supported licenses:"
    assert {"Apache-2.0", "BSD-3-Clause", "GPL-3.0-only", "MIT"} < set(listed)
