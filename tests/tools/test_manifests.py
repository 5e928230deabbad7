"""The package.xml of each package that tfloom stands for."""

from __future__ import annotations

from pathlib import Path

import pytest
from catkin_pkg.package import parse_package
from tools.facades.rooms import ROOT
from tools.manifests import generate_all

from tfloom import __version__
from tfloom.workspace import index
from tfloom.workspace.ament import get_package_prefix, get_package_share_directory


def test_each_package_has_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("AMENT_PREFIX_PATH", raising=False)
    packages = index.own_packages()
    assert {"rclpy", "turtlesim", "demo_nodes_cpp", "cv_bridge", "nav2_msgs", "xacro"} <= {*packages}
    for name in packages:
        package = parse_package(Path(get_package_share_directory(name), "package.xml"))
        assert (package.name, package.version) == (name, __version__)
        # Programs also make the path of the prefix, for the packages of `get_packages_with_prefixes`.
        assert Path(get_package_prefix(name), "share", name, "package.xml").is_file()


def test_colcon_takes_none_of_them_for_sources() -> None:
    """A virtual environment may be below a workspace, whose packages colcon looks for in all folders."""
    for name in generate_all():
        assert (ROOT / name).parents[1].joinpath("COLCON_IGNORE").is_file()
