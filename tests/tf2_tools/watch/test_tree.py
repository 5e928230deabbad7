"""The shape of frames: branches, chains, roots and loops."""

from __future__ import annotations

from tfloom.tf2_tools.watch.tree import Tree

ROBOT = Tree({"odom": "map", "base": "odom", "laser": "base", "arm": "base", "camera": "rig"})


def test_branches_and_roots() -> None:
    assert ROBOT.branch("laser") == ["laser", "base", "odom", "map"]
    assert ROBOT.roots() == ["map", "rig"]
    assert ROBOT.root("arm") == "map"
    assert "camera" in ROBOT
    assert "cam" not in ROBOT


def test_chains_meet_at_the_nearest_frame() -> None:
    assert ROBOT.chain("arm", "laser") == (["laser", "base"], ["arm", "base"])
    assert ROBOT.chain("map", "base") == (["base", "odom", "map"], ["map"])
    assert ROBOT.chain("map", "camera") is None


def test_a_walk_goes_down() -> None:
    assert list(ROBOT.walk("map")) == [(0, "map"), (1, "odom"), (2, "base"), (3, "arm"), (3, "laser")]


def test_loops_end() -> None:
    looped = Tree({"a": "b", "b": "c", "c": "a", "d": "c", "own": "own"})
    assert looped.loops() == [["a", "b", "c"], ["own"]]
    assert looped.roots() == ["a", "own"]
    assert looped.branch("d") == ["d", "c", "a", "b"]
    assert list(looped.walk("a")) == [(0, "a"), (1, "c"), (2, "b"), (2, "d")]


def test_long_chains_take_a_moment() -> None:
    tree = Tree({f"{number}": f"{number + 1}" for number in range(20_000)})
    assert (tree.roots(), tree.loops()) == (["20000"], [])
    assert Tree({"a": "", "b": "a"}).roots() == [""]
