"""The lists of interfaces, as `rosidl_runtime_py` gives them."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.workspace.conftest import write_files

from tfloom.workspace import index
from tfloom.workspace.get_interfaces import (
    get_action_interfaces,
    get_interface_packages,
    get_interface_path,
    get_interfaces,
    get_message_interfaces,
    get_service_interfaces,
)


@pytest.fixture
def prefix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a sourced prefix with a package that has interfaces, and one that has none."""
    packages = (f"{index.RESOURCE_INDEX}/packages/{name}" for name in ("my_interfaces", "my_pkg"))
    definitions = (f"share/my_interfaces/msg/{name}" for name in ("Point.msg", "Point.idl", "OfIdl.idl"))
    write_files(tmp_path, dict.fromkeys((*packages, *definitions), ""))
    monkeypatch.setenv(index.PREFIX_PATH_VARIABLE, str(tmp_path))
    return tmp_path


def test_of_a_kind() -> None:
    assert get_message_interfaces(["turtlesim"]) == {"turtlesim": ["msg/Color", "msg/Pose"]}
    assert "std_srvs" not in get_message_interfaces()
    assert get_action_interfaces(["turtlesim"]) == {"turtlesim": ["action/RotateAbsolute"]}
    assert "srv/Spawn" in get_service_interfaces()["turtlesim"]


@pytest.mark.usefixtures("prefix")
@pytest.mark.parametrize("package", ["rclpy", "tf2_ros", "tf2_tools", "my_pkg"])
def test_a_package_without_interfaces_is_known(package: str) -> None:
    for function in (
        get_interfaces,
        get_message_interfaces,
        get_service_interfaces,
        get_action_interfaces,
    ):
        assert function([package]) == {}
    assert package not in get_interface_packages()
    assert get_interfaces([package, "my_interfaces"]) == {"my_interfaces": ["msg/OfIdl", "msg/Point"]}


def test_an_unknown_package_is_an_error() -> None:
    for function in (get_interfaces, get_message_interfaces):
        with pytest.raises(LookupError, match="Unknown package 'nope'"):
            function(["turtlesim", "nope"])
    with pytest.raises(LookupError, match="Unknown package 'nope'"):
        get_interface_path("nope/msg/Pose")


def test_paths_with_and_without_a_suffix(prefix: Path) -> None:
    for name in ("turtlesim/msg/Pose", "turtlesim/msg/Pose.msg"):
        assert get_interface_path(name).endswith("turtlesim/msg/Pose.msg")
    folder = prefix / "share" / "my_interfaces" / "msg"
    for name, file in (
        ("Point", "Point.msg"),
        ("Point.msg", "Point.msg"),
        ("Point.idl", "Point.idl"),
        ("OfIdl", "OfIdl.idl"),
    ):
        assert get_interface_path(f"my_interfaces/msg/{name}") == str(folder / file)
    for name in ("turtlesim/msg/Nope", "turtlesim/msg/Nope.msg", "turtlesim/msg/Pose.srv", "turtlesim/Pose"):
        missing = name if "." in name else f"{name}.idl"
        with pytest.raises(LookupError, match=f"Could not find the interface '/.*/{missing}'"):
            get_interface_path(name)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("Pose", "Expected at least two parts separated by '/'"),
        ("", "Expected at least two parts separated by '/'"),
        ("turtlesim//Pose", "Must not contain empty parts"),
        ("/turtlesim/msg/Pose", "Must not contain empty parts"),
        ("turtlesim/../Pose", "Must not contain '..'"),
    ],
)
def test_names_that_are_none(name: str, reason: str) -> None:
    with pytest.raises(ValueError, match=f"Invalid name '{name}'. {reason}"):
        get_interface_path(name)
