"""Which packages colcon finds: build types and dependencies that depend on conditions."""

from __future__ import annotations

from pathlib import Path

import pytest
from colcon_core.package_descriptor import PackageDescriptor
from colcon_ros.package_identification.ros import get_package_with_build_type
from tests.workspace.conftest import write_files, write_manifest

from tfloom.ros_environment import ROS_ENVIRONMENT
from tfloom.workspace.colcon.identification import READ_TYPE, Identification


@pytest.mark.filterwarnings("ignore:.*deprecated")  # of pyparsing, in catkin_pkg
def test_conditions_on_ros_are_those_of_ros_2(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ROS_ENVIRONMENT:
        monkeypatch.setenv(name, "")  # so that it is restored
        monkeypatch.delenv(name)
    write_manifest(tmp_path / "both", "ament_cmake", "here", "there", name="both")
    path = tmp_path / "both" / "package.xml"
    text = path.read_text()
    for tag, version in (("<build_type>", 2), ("<depend>here", 2), ("<depend>there", 1)):
        text = text.replace(tag, tag.replace(">", f' condition="$ROS_VERSION == {version}">', 1))
    write_files(tmp_path / "both", {"package.xml": text, "CMakeLists.txt": "project(both)\n"})
    found = PackageDescriptor(tmp_path / "both")
    Identification().identify(found)
    assert (found.type, found.name) == (READ_TYPE, "both")
    package, _ = get_package_with_build_type(str(found.path))
    assert [str(dependency) for dependency in package.build_depends if dependency.evaluated_condition] == [
        "here"
    ]
