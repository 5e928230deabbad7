"""Differences of two trees, each kind by itself."""

from __future__ import annotations

import math

import pytest

from tfloom.tf2_tools.watch.difference import Difference, Link, differences

NO_TURN = (0.0, 0.0, 0.0, 1.0)


def link(child: str, parent: str, x: float = 0.0, *, yaw_rad: float = 0.0, static: bool = True) -> Link:
    """Return a link whose child is displaced along x and turned about z."""
    return Link(
        child, parent, static, (x, 0.0, 0.0), (0.0, 0.0, math.sin(yaw_rad / 2), math.cos(yaw_rad / 2))
    )


def compared(
    before: list[Link], after: list[Link], translation: float = 0.0, rotation_rad: float = 0.0
) -> list[Difference]:
    """Return the differences of two lists of links."""
    trees = ({link.child: link for link in links} for links in (before, after))
    return differences(*trees, translation=translation, rotation_rad=rotation_rad)


def test_equal_trees_have_no_difference() -> None:
    tree = [link("base", "odom", 5.0, static=False), link("laser", "base", 1.0, yaw_rad=0.1)]
    assert compared(tree, tree) == []


def test_edges_of_one_tree_only() -> None:
    found = compared([link("a", "base")], [link("b", "base")])
    assert [(difference.kind, difference.child) for difference in found] == [("removed", "a"), ("added", "b")]


def test_another_parent_and_another_kind() -> None:
    found = compared(
        [link("laser", "base"), link("wheel", "base")],
        [link("laser", "mast"), link("wheel", "base", static=False)],
    )
    assert [(difference.kind, difference.child) for difference in found] == [
        ("re-parented", "laser"),
        ("kind", "wheel"),
    ]


def test_tolerances_apply_to_distance_and_angle() -> None:
    before, after = [link("laser", "base")], [link("laser", "base", 0.03, yaw_rad=-0.2)]
    (moved,) = compared(before, after)
    assert (moved.kind, moved.distance) == ("moved", pytest.approx(0.03))
    assert moved.angle_rad == pytest.approx(0.2)
    assert compared(before, after, 0.031, 0.21) == []
    assert len(compared(before, after, 0.031, 0.19)) == len(compared(before, after, 0.029, 0.21)) == 1


def test_a_negated_quaternion_is_the_same_rotation() -> None:
    turned = link("laser", "base", yaw_rad=1.0)
    negated = turned._replace(rotation_xyzw=tuple(-part for part in turned.rotation_xyzw))  # type: ignore[arg-type]
    assert compared([turned], [negated], rotation_rad=1e-12) == []


def test_values_of_moving_transforms_are_not_compared() -> None:
    assert (
        compared([link("base", "odom", 1.0, static=False)], [link("base", "odom", 9.0, static=False)]) == []
    )
