"""Node lists of a real ROS 2, and malformed bytes."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tfloom.rmw.base import NodeName
from tfloom.rmw.cyclone.discovery_info import NodeEnds, NodeListError, decode, encode

GOLDEN = json.loads((Path(__file__).parents[1] / "golden" / "wire_jazzy_cyclonedds.json").read_text("utf-8"))
RECORDED = [bytes.fromhex(text) for text in GOLDEN["ros_discovery_info_cdr"]]

gids = st.lists(st.binary(min_size=16, max_size=16), max_size=4)
texts = st.text(st.characters(exclude_characters="\0", codec="utf-8"), max_size=12)
nodes = st.lists(st.builds(NodeEnds, st.builds(NodeName, texts, texts), gids, gids), max_size=4)


@pytest.mark.parametrize(
    ("data", "name", "ends"),
    [(RECORDED[0], "turtlesim", (20, 23)), (RECORDED[1], "static_transform_publisher", (8, 10))],
)
def test_recorded_lists_survive_decoding_and_encoding(data: bytes, name: str, ends: tuple[int, int]) -> None:
    gid, (node,) = decode(data)
    assert gid.hex().startswith("0110")
    assert node.name.namespace == "/"
    assert node.name.name.startswith(name)
    assert (len(node.reader_gids), len(node.writer_gids)) == ends
    assert all(end.startswith(gid[:12]) for end in (*node.reader_gids, *node.writer_gids))
    assert encode(gid, [node]) == data


def test_the_recorded_endpoints_belong_to_the_recorded_nodes() -> None:
    writers = {gid for data in RECORDED for node in decode(data)[1] for gid in node.writer_gids}
    for end in GOLDEN["publication"]:
        if end["topic_name"] != "ros_discovery_info":
            assert bytes.fromhex(end["key"].replace("-", "")) in writers


@settings(deadline=None, max_examples=40)
@given(gid=st.binary(min_size=16, max_size=16), nodes=nodes)
def test_encoded_lists_are_decoded(gid: bytes, nodes: list[NodeEnds]) -> None:
    assert decode(encode(gid, nodes)) == (gid, nodes)


@pytest.mark.parametrize("data", RECORDED)
def test_each_truncation_raises(data: bytes) -> None:
    for size in range(len(data)):
        with pytest.raises(NodeListError):
            decode(data[:size])


@settings(deadline=None)
@given(st.binary(max_size=200))
def test_random_bytes_are_decoded_or_rejected(data: bytes) -> None:
    for candidate in (data, b"\0\1\0\0" + data, RECORDED[0][:32] + data):
        with suppress(NodeListError):
            gid, nodes = decode(candidate)
            assert len(gid) == 16
            assert sum(len(node.reader_gids) + len(node.writer_gids) for node in nodes) * 16 < len(candidate)


def test_huge_count_is_rejected_before_a_loop() -> None:
    with pytest.raises(NodeListError, match="4294967295 items are announced at byte 20 of 20"):
        decode(b"\0\1\0\0" + bytes(16) + b"\xff\xff\xff\xff")


def test_big_endian_is_rejected() -> None:
    with pytest.raises(NodeListError, match="little-endian"):
        decode(b"\0\0\0\0" + RECORDED[0][4:])
