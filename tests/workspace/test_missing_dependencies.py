"""What packages ask for that nobody provides, and the check of `doctor` for it."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.workspace.conftest import write_files, write_manifest

from tfloom.cli.doctor.checks import Verdict, check_workspace
from tfloom.workspace import index
from tfloom.workspace.missing_dependencies import (
    find_missing,
    find_source,
    how_to_provide,
    is_provided,
    read_requirements,
)


@pytest.mark.parametrize(
    ("name", "provided"),
    [
        ("rclpy", True),
        ("geometry_msgs", True),
        ("ament_cmake", True),
        ("ament_cmake_python", True),
        ("ament_xmllint", True),
        ("tf2_ros_py", True),
        ("ros_environment", True),
        ("rosidl_default_generators", True),
        ("ament_lint_auto", True),
        ("python3-numpy", True),
        ("python3-yaml", True),
        ("python3-setuptools", True),
        ("python3-no-such-thing", False),
        ("python3-dev", True),
        ("python3-pil-imagetk", True),
        ("no-such-thing-pip", False),
        ("yaml", True),
        ("libopencv-dev", True),
        ("nav_to_mars", False),
        ("rclcpp", False),
        ("python_orocos_kdl_vendor", True),
        ("rosidl_generator_py", True),
        ("angles", True),
    ],
)
def test_dependency_is_provided(name: str, provided: bool) -> None:
    assert is_provided(name) is provided


def test_remedies_differ() -> None:
    assert how_to_provide("nav2_msgs") == "pip install ./packages/tfloom-interfaces, in tfloom's sources"
    assert how_to_provide("cv_bridge") == "pip install ./packages/tfloom-sensing, in tfloom's sources"
    assert how_to_provide("python3-transforms3d-pip") == "pip install transforms3d"
    assert how_to_provide("roslibpy-pip") == "pip install roslibpy"
    assert how_to_provide("python3-serial") == "pip install pyserial"
    assert how_to_provide("python-opencv") == "pip install opencv-python"
    assert how_to_provide("python3-pyside2.qtgui") == "pip install pyside2"
    assert how_to_provide("urdf_parser_py") == "pip install urdf-parser-py"
    assert how_to_provide("py_trees") == "pip install py-trees"
    assert how_to_provide("yasmin").endswith("a workspace that has it; PyPI's yasmin is another package")
    assert "compiled from C++" in how_to_provide("image_transport_py")
    assert how_to_provide("nav_to_mars").endswith(
        "put the source of a ROS package into src/, or source a workspace that has it"
    )


def test_workspace_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source = tmp_path / "src"
    write_manifest(source / "group" / "first", "ament_python", "rclpy", "second", "nav_to_mars")
    write_manifest(source / "second", "ament_cmake", "nav_to_mars", "sourced_msgs")
    write_manifest(source / "ignored", "ament_cmake", "never_read")
    write_files(source, {"ignored/COLCON_IGNORE": "", "broken/package.xml": "<package>"})
    text = (source / "second" / "package.xml").read_text()
    ros_1 = '<depend condition="$ROS_VERSION == 1">rospy</depend></package>'
    write_files(source / "second", {"package.xml": text.replace("</package>", ros_1)})
    write_files(tmp_path, {f"{index.RESOURCE_INDEX}/packages/sourced_msgs": ""})
    monkeypatch.setenv(index.PREFIX_PATH_VARIABLE, str(tmp_path))
    monkeypatch.chdir(source / "group")
    assert find_source() == source
    requirements = read_requirements(source)
    assert [package.name for package in requirements] == ["first", "second"]
    assert find_missing(requirements) == {"nav_to_mars": ["first", "second"]}
    finding = check_workspace()
    assert finding.verdict is Verdict.WARNING
    assert finding.summary.endswith("ask for what is missing: nav_to_mars (for first, second)")
    write_manifest(source / "nav_to_mars", "ament_cmake")
    assert check_workspace().verdict is Verdict.OK


def test_what_pip_has_installed_is_provided(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_files(
        tmp_path,
        {
            "mars_rover/__init__.py": "",
            "pyserial-3.5.dist-info/METADATA": "Metadata-Version: 2.1\nName: pyserial\nVersion: 3.5\n",
            "only_a_folder/src/x.cpp": "",
        },
    )
    assert not is_provided("mars_rover")
    monkeypatch.syspath_prepend(tmp_path)
    assert is_provided("mars_rover")
    assert is_provided("python3-serial")
    assert not is_provided("only_a_folder")


@pytest.mark.parametrize(
    ("package", "distribution"), [("cv_bridge", "tfloom-sensing"), ("nav2_msgs", "tfloom-interfaces")]
)
def test_a_distribution_beside_tfloom_is_named_where_it_is_missing(
    package: str, distribution: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_manifest(tmp_path / "src" / "camera", "ament_python", "rclpy", package)
    monkeypatch.chdir(tmp_path)
    assert check_workspace().verdict is Verdict.OK
    monkeypatch.setattr("tfloom.ros_imports.distributions.find_prefix", lambda _distribution: None)
    finding = check_workspace()
    assert finding.verdict is Verdict.WARNING
    assert finding.advice == f"{package}: pip install ./packages/{distribution}, in tfloom's sources"


def test_folder_without_a_workspace_has_no_finding(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    finding = check_workspace()
    assert (finding.verdict, finding.summary[:17]) == (Verdict.OK, "no workspace here")
