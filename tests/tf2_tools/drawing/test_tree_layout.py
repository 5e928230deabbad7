"""Layouts of forests: centred, ordered, never overlapping, whatever the forest."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tfloom.tf2_tools.drawing.tree_layout import Layout, Size, arrange


def boxes(layout: Layout, sizes: dict[str, Size]) -> list[tuple[float, float, float, float]]:
    return [
        (
            place.breadth - sizes[node].breadth / 2,
            place.depth,
            place.breadth + sizes[node].breadth / 2,
            place.depth + sizes[node].depth,
        )
        for node, place in layout.places.items()
    ]


def assert_no_overlap(layout: Layout, sizes: dict[str, Size], gap: float = 0.0) -> None:
    rows: dict[float, list[tuple[float, float]]] = {}
    for low, top, high, bottom in boxes(layout, sizes):
        assert low >= -1e-9
        assert high <= layout.size.breadth + 1e-9
        assert bottom <= layout.size.depth + 1e-9
        rows.setdefault(top, []).append((low, high))
    tops = sorted(rows)
    for row in rows.values():
        row.sort()
        for left, right in pairwise(row):
            assert left[1] + gap <= right[0] + 1e-6
    for low, top, _, bottom in boxes(layout, sizes):
        following = [other for other in tops if other > top]
        assert not following or bottom <= following[0] + 1e-9, low


def same_size(parents: dict[str, str], breadth: float = 10.0, depth: float = 4.0) -> dict[str, Size]:
    return dict.fromkeys([*parents, *parents.values()], Size(breadth, depth))


def test_parent_is_centred_over_its_children() -> None:
    parents = {"a": "root", "b": "root", "c": "root"}
    layout = arrange(parents, same_size(parents), sibling_gap=2.0, generation_gap=3.0)
    assert {node: tuple(place) for node, place in layout.places.items()} == {
        "root": (17.0, 0.0),
        "a": (5.0, 7.0),
        "b": (17.0, 7.0),
        "c": (29.0, 7.0),
    }
    assert layout.size == (34.0, 11.0)
    assert layout.roots == ["root"]


def test_small_tree_is_placed_beside_a_deep_one() -> None:
    parents = {"a": "root", "b": "root", "b1": "b", "b2": "b", "b3": "b"}
    layout = arrange(parents, same_size(parents))
    assert layout.places["b"].breadth - layout.places["a"].breadth == 10.0


def test_several_roots_are_side_by_side() -> None:
    parents = {"a": "r1", "b": "r2"}
    sizes = {**same_size(parents), "alone": Size(4.0, 4.0)}
    layout = arrange(parents, sizes, sibling_gap=1.0)
    assert layout.roots == ["r1", "r2", "alone"]
    assert [layout.places[root].breadth for root in layout.roots] == [5.0, 16.0, 24.0]
    assert_no_overlap(layout, sizes, 1.0)


def test_a_cycle_is_cut_at_its_first_node() -> None:
    parents = {"tail": "b", "a": "c", "b": "a", "c": "b"}
    layout = arrange(parents, same_size(parents))
    assert layout.roots == ["a"]
    assert layout.loop_starts == {"a"}
    assert set(layout.places) == {"tail", "a", "b", "c"}


def test_a_frame_that_is_its_own_parent() -> None:
    layout = arrange({"a": "a"}, {"a": Size(1.0, 1.0)})
    assert layout.loop_starts == {"a"}


def test_empty_forest() -> None:
    assert arrange({}, {}).size == (0.0, 0.0)


def test_a_chain_of_five_thousand() -> None:
    parents = {f"f{i + 1}": f"f{i}" for i in range(5000)}
    layout = arrange(parents, same_size(parents))
    assert {place.breadth for place in layout.places.values()} == {5.0}
    assert layout.size.depth == 5001 * 4.0


def test_a_thousand_siblings() -> None:
    parents = {f"f{i}": "root" for i in range(1000)}
    layout = arrange(parents, same_size(parents))
    assert layout.size.breadth == pytest.approx(10_000.0)


@settings(deadline=None, max_examples=30)
@given(st.data())
def test_no_two_nodes_overlap(data: st.DataObject) -> None:
    names = [f"f{i}" for i in range(data.draw(st.integers(1, 40)))]
    parents = {name: data.draw(st.sampled_from(names)) for name in names if data.draw(st.booleans())}
    lengths = st.floats(0.5, 50.0)
    sizes = {name: Size(data.draw(lengths), data.draw(lengths)) for name in names}
    layout = arrange(parents, sizes, sibling_gap=1.0, generation_gap=2.0)
    assert set(layout.places) == set(names)
    assert_no_overlap(layout, sizes, 1.0)
    for child, parent in parents.items():
        if child not in layout.loop_starts:
            assert layout.places[child].depth > layout.places[parent].depth
