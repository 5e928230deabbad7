"""Definitions as text: their packages, their content, and errors."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.workspace.conftest import write_files

from tfloom.rosidl.definition_files import interfaces_of
from tfloom.workspace import index, interfaces


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(index.PREFIX_PATH_VARIABLE, str(tmp_path))
    share = tmp_path / "share" / "my_msgs"
    files = {
        "msg/Inner.msg": "# inner\nint32 x  # inner too\n",
        "msg/Outer.msg": (
            "# outer\n\nInner[<=3] inner # one\nstring NAME='a # b'\nint8 MODE=1\nstring<=4 text \"#\"\n"
            "my_msgs/Inner other\n"
        ),
        "msg/Loop.msg": "Loop[] loops\n",
        "msg/Stamped.msg": "Header header\n",
    }
    write_files(share, files)
    write_files(tmp_path, {f"{index.RESOURCE_INDEX}/rosidl_interfaces/my_msgs": ""})
    return share


def test_workspace_interfaces_are_listed_with_own_ones(workspace: Path) -> None:
    packages = interfaces.interface_packages()
    assert packages["my_msgs"] == workspace
    assert list(packages) == sorted(packages)
    assert interfaces_of(packages["my_msgs"], "msg") == ["Inner", "Loop", "Outer", "Stamped"]
    assert "Twist" in interfaces_of(packages["geometry_msgs"], "msg")


OUTER_WITH_NO_COMMENTS = """\
Inner[<=3] inner
\tint32 x
string NAME='a # b'
int8 MODE=1
string<=4 text "#"
my_msgs/Inner other
\tint32 x
"""
OUTER_WITH_ITS_OWN = "# outer\n\n" + OUTER_WITH_NO_COMMENTS.replace("] inner\n", "] inner # one\n")
OUTER_WITH_ALL = OUTER_WITH_ITS_OWN.replace("\tint32 x\n", "\t# inner\n\tint32 x  # inner too\n")


@pytest.mark.parametrize(
    ("comments", "text"),
    [("none", OUTER_WITH_NO_COMMENTS), ("own", OUTER_WITH_ITS_OWN), ("all", OUTER_WITH_ALL)],
)
def test_nested_types_are_expanded_below_their_fields(workspace: Path, comments: str, text: str) -> None:
    assert "\n".join([*interfaces.expanded_definition("my_msgs/msg/Outer", comments), ""]) == text


def test_bare_header_is_std_msgs_header(workspace: Path) -> None:
    assert [*interfaces.expanded_definition("my_msgs/Stamped", "none")] == [
        "Header header",
        "\tbuiltin_interfaces/Time stamp",
        "\t\tint32 sec",
        "\t\tuint32 nanosec",
        "\tstring frame_id",
    ]


def test_recursive_type_ends(workspace: Path) -> None:
    assert list(interfaces.expanded_definition("my_msgs/Loop")) == ["Loop[] loops"]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("my_msg/msg/Inner", "Unknown package 'my_msg'\ndid you mean my_msgs?"),
        (
            "my_msgs/msg/Iner",
            "Could not find the interface '{share}/my_msgs/msg/Iner.idl'\ndid you mean my_msgs/msg/Inner?",
        ),
        (
            "Inner",
            "an interface's name is like std_msgs/msg/String, not 'Inner'\ndid you mean my_msgs/msg/Inner?",
        ),
        ("Nobodys", "an interface's name is like std_msgs/msg/String, not 'Nobodys'"),
        ("../msg/Inner", "an interface's name is like std_msgs/msg/String, not '../msg/Inner'"),
    ],
)
def test_unknown_names_raise_with_the_nearest(workspace: Path, name: str, text: str) -> None:
    with pytest.raises(LookupError) as error:
        interfaces.definition_path(name)
    assert error.value.args[0] == text.replace(
        "{share}", str(interfaces.interface_packages()["my_msgs"].parent)
    )


def test_short_name_finds_its_kind() -> None:
    assert interfaces.split_name("turtlesim/Spawn") == ("turtlesim", "srv", "Spawn")
    assert interfaces.split_name("turtlesim/RotateAbsolute") == ("turtlesim", "action", "RotateAbsolute")
    assert interfaces.split_name("std_msgs/String") == ("std_msgs", "msg", "String")
