"""The tree as data, explanations, and frames that are removed."""

from __future__ import annotations

import pytest

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import LookupException

SECOND = 1_000_000_000
HERE = (0.0, 0.0, 0.0)
UPRIGHT = (0.0, 0.0, 0.0, 1.0)


@pytest.fixture
def buffer() -> Buffer:
    buffer = Buffer()
    for stamp in range(1, 5):
        buffer.set("map", "odom", stamp * SECOND, HERE, UPRIGHT, "localisation")
        buffer.set("odom", "base", (stamp + 1) * SECOND, HERE, UPRIGHT, "wheels")
    buffer.set("base", "laser", 0, HERE, UPRIGHT, "calibration", static=True)
    buffer.set("base", "arm", 5 * SECOND, HERE, UPRIGHT)
    buffer.set("shop", "shelf", SECOND, HERE, UPRIGHT)
    return buffer


def test_parents_and_children(buffer: Buffer) -> None:
    assert buffer.parents() == {
        "odom": "map", "map": None, "base": "odom", "laser": "base", "arm": "base", "shelf": "shop", "shop": None
    }  # fmt: skip
    assert buffer.children()["base"] == ["laser", "arm"]
    assert buffer.children()["laser"] == []


def test_children_are_listed_while_a_listener_adds_frames() -> None:
    class Filling(Buffer):
        def frame_names(self) -> list[str]:
            names = super().frame_names()
            self.set("map", f"child_{len(names)}", SECOND, HERE, UPRIGHT)
            return names

    buffer = Filling()
    assert buffer.children() == {}
    assert buffer.children() == {"map": ["child_0"], "child_0": []}


def test_edges_list_the_stored_links(buffer: Buffer) -> None:
    odom, base, laser, *_ = buffer.edges()
    assert (odom.frame_id, odom.child_frame_id, odom.authority) == ("map", "odom", "localisation")
    assert (base.oldest_ns, base.newest_ns, base.sample_count) == (2 * SECOND, 5 * SECOND, 4)
    assert laser.is_static


@pytest.mark.parametrize(
    ("target", "source", "chain"),
    [
        ("map", "laser", ["laser", "base", "odom", "map"]),
        ("laser", "map", ["map", "odom", "base", "laser"]),
        ("arm", "laser", ["laser", "base", "arm"]),
        ("odom", "map", ["map", "odom"]),
        ("map", "map", ["map"]),
    ],
)
def test_chain_lists_the_frames_of_a_lookup(
    buffer: Buffer, target: str, source: str, chain: list[str]
) -> None:
    assert buffer.chain(target, source) == chain
    assert buffer.explain(target, source).chain == chain


def test_common_time_of_frames(buffer: Buffer) -> None:
    assert buffer.common_time("map", "laser", "odom") == 4 * SECOND
    assert buffer.common_time("base", "laser") == 0
    assert buffer.common_time("odom") == 4 * SECOND
    assert buffer.common_time("map") == 0
    with pytest.raises(LookupException):
        buffer.common_time("nowhere")
    with pytest.raises(ValueError, match="needs the name of a frame"):
        buffer.common_time()


def test_explain_names_the_failing_link_and_the_remedy(buffer: Buffer) -> None:
    told = buffer.explain("map", "laser", 5 * SECOND)
    assert told.failing_edge.child_frame_id == "odom"
    assert [edge.child_frame_id for edge in told.edges] == ["laser", "base", "odom"]
    assert "odom ends 1.000000 s before" in told.remedy
    assert "map -> odom: 1.000000 to 4.000000, 4 samples, 1.3 Hz by localisation <-- here" in str(told)
    early = buffer.explain("map", "laser", SECOND)
    assert "base begins 1.000000 s after" in early.remedy


def test_explain_names_unknown_and_unconnected_frames(buffer: Buffer) -> None:
    assert "No transform of lidar has been received" in buffer.explain("map", "lidar").remedy
    apart = buffer.explain("map", "shelf")
    assert "connects map, the root above one end, with shop" in apart.remedy
    assert apart.failing_edge is None
    buffer.clear()
    assert "Nothing is stored of laser" not in str(buffer.explain("base", "laser"))
    fine = buffer.explain("base", "laser")
    assert (fine.error, fine.remedy) == (None, "")


@pytest.mark.parametrize(
    ("target", "source", "remedy"),
    [
        ("map", "/laser", "Request laser, without the slash."),
        ("", "laser", "Both frame names must be non-empty."),
        ("first", "second", "No transform of first or second has been received"),
    ],
)
def test_explain_names_invalid_frame_ids(buffer: Buffer, target: str, source: str, remedy: str) -> None:
    assert buffer.explain(target, source).remedy.startswith(remedy)


def test_explain_names_a_gap_in_another_tree(buffer: Buffer) -> None:
    told = buffer.explain("map", "shelf", 9 * SECOND)
    assert told.failing_edge.child_frame_id == "shelf"
    assert told.remedy.endswith("Also, map, the root above one end, is not connected with shop.")


def test_explain_of_a_cleared_buffer(buffer: Buffer) -> None:
    buffer.clear()
    assert buffer.explain("map", "base", 2 * SECOND).remedy.startswith("Nothing is stored of base now")


def test_explain_of_histories_without_overlap() -> None:
    buffer = Buffer()
    for child, stamps in (("a", (5, 6)), ("b", (1, 2))):
        for stamp in stamps:
            buffer.set("root", child, stamp * SECOND, HERE, UPRIGHT)
    told = buffer.explain("a", "b")
    assert told.failing_edge.child_frame_id == "a"
    assert told.remedy == "The frames have no common time: a alone misses the requested time by 3.000000 s."


def test_explain_names_loops_and_too_long_chains() -> None:
    buffer = Buffer()
    for parent, child in (("a", "b"), ("b", "c"), ("c", "a"), ("x", "y"), ("a", "leaf")):
        buffer.set(parent, child, SECOND, HERE, UPRIGHT)
    assert buffer.explain("x", "leaf").remedy == "Find the publishers of this loop of parents: a, c, b."
    fine = buffer.explain("a", "b")  # the loop is not on this path
    assert (fine.error, fine.chain) == (None, ["b", "a"])
    assert [edge.child_frame_id for edge in fine.edges] == ["b"]
    for index in range(1001):
        buffer.set(f"f{index}", f"f{index + 1}", SECOND, HERE, UPRIGHT)
    assert "more than 1000 links" in buffer.explain("f0", "f1001").remedy


def test_chain_is_that_of_the_requested_time() -> None:
    buffer = Buffer()
    for parent, stamps in (("a", (1, 2)), ("b", (3, 4))):
        for stamp in stamps:
            buffer.set(parent, "x", stamp * SECOND, HERE, UPRIGHT)
    assert buffer.chain("a", "x", SECOND) == ["x", "a"]
    assert buffer.chain("x", "a", SECOND) == ["a", "x"]
    assert buffer.chain("b", "x", 3 * SECOND) == ["x", "b"]
    told = buffer.explain("a", "x", SECOND)
    assert told.chain == ["x", "a"]
    assert str(told).splitlines()[1].startswith("  a -> x: 1.000000 to 4.000000")
    assert str(told).endswith("; its present parent is b")


def test_chain_of_an_unknown_frame_raises(buffer: Buffer) -> None:
    with pytest.raises(LookupException):
        buffer.chain("map", "nowhere")
    with pytest.raises(LookupException):
        buffer.chain("nowhere", "nowhere")


def test_removed_frame_can_be_inserted_again(buffer: Buffer) -> None:
    assert buffer.remove_frame("base")
    assert not buffer.remove_frame("base")
    assert "base" not in buffer.frame_names()
    assert buffer.parents()["laser"] is None
    with pytest.raises(LookupException):
        buffer.lookup("map", "base")
    assert not buffer.can("laser", "arm")
    buffer.set("odom", "base", 4 * SECOND, HERE, UPRIGHT)
    buffer.set("base", "laser", 0, HERE, UPRIGHT, static=True)
    assert buffer.can("map", "laser", 4 * SECOND)
    assert not buffer.can("map", "arm")


def test_removing_a_parent_keeps_samples_of_other_parents() -> None:
    buffer = Buffer()
    buffer.set("a", "x", SECOND, HERE, UPRIGHT)
    buffer.set("b", "x", 2 * SECOND, HERE, UPRIGHT)
    buffer.remove_frame("b")
    assert buffer.lookup("a", "x").stamp_ns == SECOND
