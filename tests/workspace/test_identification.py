"""Which packages colcon finds: build types and dependencies that depend on conditions."""

from __future__ import annotations

from pathlib import Path

import pytest
from colcon_core.package_descriptor import PackageDescriptor
from colcon_ros.package_identification.ros import get_package_with_build_type
from tests.workspace.conftest import write_cmake_package, write_files, write_manifest

from tfloom.ros_imports.ros_distro import ROS_ENVIRONMENT
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


def identified(folder: Path) -> str | None:
    """Return the type of a package's folder as tfloom finds it; None leaves it to others."""
    descriptor = PackageDescriptor(folder)
    Identification().identify(descriptor)
    return descriptor.type


@pytest.mark.filterwarnings("ignore:.*deprecated")
def test_real_ament_cmake_builds_its_packages_itself(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "ros" / "share" / "ament_cmake" / "cmake").mkdir(parents=True)
    write_cmake_package(tmp_path / "balls", "project(balls)\n")
    monkeypatch.delenv("AMENT_PREFIX_PATH", raising=False)
    assert identified(tmp_path / "balls") == READ_TYPE
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path / "ros"))
    assert identified(tmp_path / "balls") is None


def test_ignored_and_foreign_folders_are_left_alone(tmp_path: Path) -> None:
    write_cmake_package(tmp_path / "ignored", "project(ignored)\n")
    (tmp_path / "ignored" / "AMENT_IGNORE").touch()
    assert identified(tmp_path / "ignored") is None
    write_files(tmp_path / "foreign", {"package.xml": "<other>", "CMakeLists.txt": "project(foreign)"})
    assert identified(tmp_path / "foreign") is None
