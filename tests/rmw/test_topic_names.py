"""ROS names and DDS names, both ways."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tfloom.rmw.topic_names import key_values, topic_from_dds, topic_to_dds, type_from_dds, type_to_dds

GOLDEN = json.loads((Path(__file__).parents[1] / "golden" / "wire_jazzy_cyclonedds.json").read_text("utf-8"))
ENDPOINTS = [*GOLDEN["publication"], *GOLDEN["subscription"]]


@pytest.mark.parametrize(("ros", "dds"), [("/tf", "rt/tf"), ("/turtle1/pose", "rt/turtle1/pose")])
def test_topic_names_convert_both_ways(ros: str, dds: str) -> None:
    assert topic_to_dds(ros) == dds
    assert topic_from_dds(dds) == ros


@pytest.mark.parametrize(
    "dds", ["", "rt", "rt/", "ros_discovery_info", "rq/spawnRequest", "rr/spawnReply", "rts/a", "/rt/a"]
)
def test_other_topics_are_not_ros_topics(dds: str) -> None:
    assert topic_from_dds(dds) is None


@pytest.mark.parametrize("end", ENDPOINTS, ids=lambda end: end["topic_name"])
def test_recorded_type_names_convert_both_ways(end: dict[str, str]) -> None:
    ros = type_from_dds(end["type_name"])
    assert ros.count("/") == 2
    assert type_to_dds(ros) == end["type_name"]


@pytest.mark.parametrize("name", ["plain::Type", "dds_::Type_", "a::b::c", ""])
def test_other_type_names_are_unchanged(name: str) -> None:
    assert type_from_dds(name) == name


@pytest.mark.parametrize("name", ["String", "std_msgs/String", "std_msgs//String", "a/b/c/d"])
def test_invalid_type_name_error_has_an_example(name: str) -> None:
    with pytest.raises(ValueError, match="a type's name is like 'std_msgs/msg/String'"):
        type_to_dds(name)


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b"enclave=/;", {"enclave": "/"}),
        (b"serviceid= 1.10;typehash=RIHS01_00;", {"serviceid": " 1.10", "typehash": "RIHS01_00"}),
        (b"", {}),
        (b"typehash", {}),
        (b"\xff\xfe=;;=a;b=", {"\ufffd\ufffd": "", "": "a", "b": ""}),
    ],
)
def test_user_data_is_parsed(data: bytes, told: dict[str, str]) -> None:
    assert key_values(data) == told
