"""Substitutions by packages and parameters."""

from __future__ import annotations

from pathlib import Path

import pytest

from tfloom.launch.core.base_classes import SubstitutionFailure
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.parse_substitution import parse_substitution
from tfloom.launch.ros.actions.node_defaults import SetParameter
from tfloom.launch.ros.substitutions import FindPackage, FindPackagePrefix, FindPackageShare, Parameter
from tfloom.launch.utilities.substitutions import perform_substitutions
from tfloom.workspace.ament import PackageNotFoundError


def perform(text: str, context: LaunchContext | None = None) -> str:
    return perform_substitutions(context or LaunchContext(), parse_substitution(text))


def test_folders_of_a_package(toys: Path) -> None:
    assert perform("$(find-pkg-prefix toys)/x") == f"{toys}/x"
    assert perform("$(find-pkg-share toys)") == f"{toys}/share/toys"
    assert perform("$(exec-in-pkg show toys)") == f"{toys}/lib/toys/show"
    assert perform("$(exec-in-package show toys)") == f"{toys}/lib/toys/show"
    assert FindPackageShare("toys").perform(LaunchContext()) == f"{toys}/share/toys"
    assert FindPackagePrefix(["to", "ys"]).perform(LaunchContext()) == str(toys)


def test_folders_of_our_own_packages_hold_their_launch_files() -> None:
    share = Path(perform("$(find-pkg-share turtlesim)"))
    assert (share / "launch" / "multisim.launch.py").is_file()
    assert (share / "msg" / "Pose.msg").is_file()
    launch = Path(perform("$(find-pkg-share turtle_tf2_py)/launch"))
    assert sorted(path.name for path in launch.iterdir() if path.name != "__pycache__") == [
        "turtle_tf2_demo.launch.py",
        "turtle_tf2_dynamic_frame_demo.launch.py",
        "turtle_tf2_fixed_frame_demo.launch.py",
        "turtle_tf2_sensor_message.launch.py",
    ]


def test_unknown_package_is_an_error_with_the_nearest(toys: Path) -> None:
    with pytest.raises(
        PackageNotFoundError, match=r"package 'toyz' not found, searching: .*did you mean 'toys'\?"
    ):
        perform("$(find-pkg-share toyz)")


def test_describe() -> None:
    assert FindPackageShare("a").describe() == "FindPackageShare(pkg='a')"
    assert Parameter("a").describe() == "Parameter('a')"
    with pytest.raises(NotImplementedError, match="FindPackage has no method 'find'"):
        FindPackage("turtlesim").perform(LaunchContext())


@pytest.mark.parametrize("text", ["$(find-pkg-share)", "$(find-pkg-share a b)", "$(exec-in-package a)"])
def test_wrong_number_of_arguments(text: str) -> None:
    with pytest.raises(AttributeError, match=r"substitution expects \d arguments?, got \d"):
        perform(text)


def test_parameter_is_what_was_set_last(context: LaunchContext) -> None:
    with pytest.raises(SubstitutionFailure, match="parameter 'a' is not set"):
        perform("$(param a)", context)
    assert perform("$(param a none)", context) == "none"
    assert Parameter("a", default=[1, "x"]).perform(context) == "1x"
    SetParameter("a", "1").execute(context)
    SetParameter("a", 2).execute(context)
    assert perform("$(param a none)", context) == "2"
