"""turtlesim's interfaces have the package name of the distribution."""

from __future__ import annotations

import runpy

import pytest

import tfloom.demos.turtle_tf2_py.messages as theirs
import tfloom.turtlesim.messages as ours

PACKAGES = {
    **dict.fromkeys((None, "humble", "jazzy"), "turtlesim"),
    **dict.fromkeys(("kilted", "rolling"), "turtlesim_msgs"),
}


@pytest.mark.parametrize("distro", PACKAGES)
def test_package_name_depends_on_the_distribution(
    distro: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    if distro:
        monkeypatch.setenv("ROS_DISTRO", distro)
    for module in (ours, theirs):
        assert f"{PACKAGES[distro]}/msg/Pose" == runpy.run_path(module.__file__)["Pose"]._TYPE_NAME
