"""`ament_index_python`: a workspace's packages first, then tfloom's."""

from __future__ import annotations

import warnings
from pathlib import Path

import ament_index_python
import pytest
from ament_index_python import packages, resources
from tests.workspace.conftest import write_files

from tfloom.workspace import index


@pytest.fixture
def prefix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(index.PREFIX_PATH_VARIABLE, str(tmp_path))
    write_files(tmp_path / index.RESOURCE_INDEX, {"packages/my_pkg": "", "plugins/my_pkg": "a;b"})
    (tmp_path / "share" / "my_pkg").mkdir(parents=True)
    return tmp_path


def test_workspace_package_is_found(prefix: Path) -> None:
    assert packages.get_package_prefix("my_pkg") == str(prefix)
    assert packages.get_package_share_directory("my_pkg") == str(prefix / "share" / "my_pkg")
    assert packages.get_packages_with_prefixes()["my_pkg"] == str(prefix)


def test_own_package_is_found(prefix: Path) -> None:
    assert packages.get_package_prefix("turtlesim") == str(index.OWN_PREFIX)
    assert packages.get_packages_with_prefixes()["tf2_ros"] == str(index.OWN_PREFIX)


def test_a_missing_share_folder_is_warned_of(prefix: Path) -> None:
    folder = prefix / "share" / "my_pkg"
    folder.rmdir()
    with warnings.catch_warnings(record=True) as record:
        warnings.simplefilter("always")
        assert packages.get_package_share_directory("my_pkg") == str(folder)
        assert packages.get_package_share_path("my_pkg") == folder
    assert [str(warning.message) for warning in record] == [
        f"Share directory for my_pkg ({folder}) does not exist.",
        f"Share path for my_pkg ({folder}) does not exist.",
    ]
    assert {warning.filename for warning in record} == {__file__}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        packages.get_package_share_directory("my_pkg", print_warning=False)


def test_unknown_package_raises(prefix: Path) -> None:
    with pytest.raises(packages.PackageNotFoundError) as error:
        packages.get_package_prefix("nope")
    assert str(error.value) == f"package 'nope' not found, searching: ['{prefix}']"
    with pytest.raises(ValueError, match="is not a valid package name"):
        packages.get_package_prefix("../x")


def test_resources_are_found(prefix: Path) -> None:
    assert resources.get_resource("plugins", "my_pkg") == ("a;b", str(prefix))
    assert resources.get_resources("plugins") == {"my_pkg": str(prefix)}
    assert resources.get_resource_types() == {"packages", "plugins", "rosidl_interfaces"}
    assert resources.has_resource("plugins", "nope") is False
    with pytest.raises(LookupError, match="Could not find the resource 'nope' of type 'plugins'"):
        resources.get_resource("plugins", "nope")
    with pytest.raises(ament_index_python.InvalidResourceNameError):
        resources.has_resource("plugins", "a/b")
    with pytest.raises(ament_index_python.InvalidResourceTypeNameError):
        resources.get_resources("../packages")


def test_own_packages_are_resources_without_a_workspace(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(index.PREFIX_PATH_VARIABLE, raising=False)
    own = str(index.OWN_PREFIX)
    assert resources.get_resource_types() == {"packages", "rosidl_interfaces"}
    assert resources.get_resources("packages") == packages.get_packages_with_prefixes()
    assert resources.get_resource("packages", "turtlesim") == ("", own)
    assert resources.has_resource("packages", "nope") is False
    text, prefix = resources.get_resource("rosidl_interfaces", "tf2_msgs")
    assert prefix == own
    assert text.splitlines() == [
        "msg/TF2Error.msg",
        "msg/TFMessage.msg",
        "srv/FrameGraph.srv",
        "action/LookupTransform.action",
    ]
    assert resources.has_resource("rosidl_interfaces", "turtlesim") == own
    assert resources.has_resource("rosidl_interfaces", "rclpy") is False
    assert resources.get_resources("plugins") == {}
    assert resources.has_resource("plugins", "turtlesim") is False
    for package in resources.get_resources("rosidl_interfaces"):
        share = packages.get_package_share_path(package)
        missing = [
            line
            for line in resources.get_resource("rosidl_interfaces", package)[0].splitlines()
            if not (share / line).is_file()
        ]
        assert not missing, package


def test_a_workspace_precedes_own_resources(prefix: Path) -> None:
    for kind, text in (("packages", ""), ("rosidl_interfaces", "msg/Mine.msg")):
        write_files(prefix / index.RESOURCE_INDEX, {f"{kind}/tf2_msgs": text})
        assert resources.get_resource(kind, "tf2_msgs") == (text, str(prefix))
        assert resources.get_resources(kind)["tf2_msgs"] == str(prefix)
