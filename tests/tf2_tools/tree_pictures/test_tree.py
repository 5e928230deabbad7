"""Trees of frames: order, roots, loops, what is stale, and their JSON."""

from __future__ import annotations

import json

from tests.tf2_tools.tree_pictures import trees

from tfloom.tf2_tools.tree_pictures.tree import build_tree, natural_key, tree_json


def test_frames_are_in_the_order_of_numbers_in_their_names() -> None:
    records = [trees.static(name, "base") for name in ("joint10", "joint2", "arm")]
    assert build_tree(records, 0.0).frames == ["base", "arm", "joint2", "joint10"]
    assert sorted(["a007", "a12", "a7", "a"], key=natural_key) == ["a", "a007", "a7", "a12"]


def test_a_transform_is_stale_beside_newer_ones() -> None:
    tree = build_tree(
        [
            trees.record("now", "map"),
            trees.record("late", "map", age_s=1.1),
            trees.record("slow", "map", age_s=1.1, rate=0.5),
            trees.static("fixed", "map"),
        ],
        trees.NOW_S + 1000.0,
    )
    states = {child: edge.state for child, edge in tree.edges.items()}
    assert states == {"now": "live", "late": "stale", "slow": "live", "fixed": "static"}
    assert tree.summary() == "5 frames, 4 transforms (1 static), 1 tree, 1 stale"


def test_a_loop_has_a_root_and_no_parent_for_it() -> None:
    tree = build_tree([trees.record("b", "a"), trees.record("a", "b"), trees.record("c", "b")], 0.0)
    assert tree.layout.roots == ["a"]
    assert tree.state_of("a") == "loop"
    assert tree.children == {"a": ["b"], "b": ["c"], "c": []}


def test_json_has_all_that_is_drawn() -> None:
    newest_s = trees.NOW_S - 0.004
    tree = build_tree(
        [trees.record("激光", "base", rate=float("inf")), trees.static("fixed", "base")],
        12.5,
        {"激光": ["/驅動"]},
    )
    assert json.loads(json.dumps(tree_json(tree), allow_nan=False)) == {
        "recorded_at_s": 12.5,
        "newest_s": newest_s,
        "frames": ["base", "fixed", "激光"],
        "roots": ["base"],
        "loops": [],
        "transforms": [
            {
                "parent": "base",
                "child": "fixed",
                "publishers": ["default_authority"],
                "authority": "default_authority",
                "state": "static",
                "rate_hz": None,
                "buffer_length_s": None,
                "newest_s": None,
                "oldest_s": None,
            },
            {
                "parent": "base",
                "child": "激光",
                "publishers": ["/驅動"],
                "authority": "default_authority",
                "state": "live",
                "rate_hz": None,
                "buffer_length_s": 5.016,
                "newest_s": newest_s,
                "oldest_s": newest_s - 5.016,
            },
        ],
    }
