"""Tables of transforms: what they hold, and what is wrong in a malformed one."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest
from rclpy.time import Time
from tf2_ros import Buffer, TransformListener

from tfloom.testing.graph import RosGraph
from tfloom.testing.transform_table import TableError, read_table

TABLE = """
    | frame_id | child_frame_id | stamp  | x   | y | yaw_deg |   # of a robot
    |----------|----------------|--------|-----|---|---------|
    | map      | odom           | static | 0.5 | 0 | 0       |
    | odom     | base           | 1.5    | 0   | 0 | 0       |

    | odom     | base           | 60.5   | 1   | 0 | 90      |
"""


def test_a_buffer_holds_all_rows(tf_buffer_from: Callable[[str], Buffer]) -> None:
    buffer = tf_buffer_from(TABLE)
    assert (
        buffer.lookup_transform(
            "map", "base", Time(seconds=1, nanoseconds=500_000_000)
        ).transform.translation.x
        == 0.5
    )
    middle = buffer.lookup_transform("map", "base", Time(seconds=31)).transform
    assert (middle.translation.x, middle.rotation.z) == pytest.approx((1.0, math.sin(math.pi / 8)))
    assert buffer.lookup_transform("map", "odom", Time()).transform.translation.x == 0.5


def test_angles_and_quaternions() -> None:
    (rpy,) = read_table("frame_id child_frame_id roll pitch yaw z\na b 0.1 0.2 0.3 4")
    assert rpy.parent_from_child.rpy_rad == pytest.approx((0.1, 0.2, 0.3))
    assert (rpy.parent_from_child.translation, rpy.stamp_ns) == ((0.0, 0.0, 4.0), None)
    (quaternion,) = read_table("frame_id child_frame_id qx qy qz qw stamp\na b 0 0 2 0 1e-9")
    assert quaternion.parent_from_child.rotation_xyzw == (0.0, 0.0, 1.0, 0.0)
    assert quaternion.stamp_ns == 1


def test_a_listener_receives_them(ros_graph: RosGraph, ros_node: Any) -> None:
    buffer = Buffer(node=ros_node)
    TransformListener(buffer, ros_node)
    ros_graph.broadcast(TABLE)
    assert buffer.lookup_transform("map", "base", Time()).transform.translation.x == pytest.approx(1.5)


HEAD = "frame_id child_frame_id stamp x\n"
MISTAKES = {
    "": "the table has no transform: it needs a line of column names, and a line for each transform",
    HEAD: "the table has no transform",
    "map base 0": "line 1 of the table must name the columns, among them frame_id and child_frame_id: map base 0",
    "frame_id child_frame_id w\na b 1": "line 1 of the table: no column is called w, only child_frame_id, ",
    "frame_id child_frame_id x x\na b 1 1": "line 1 of the table names a column twice",
    "frame_id child_frame_id yaw yaw_deg\na b 1 1": "line 1 of the table: choose one of yaw and yaw_deg",
    "frame_id child_frame_id qx qw\na b 0 1": "line 1 of the table: a quaternion needs all of qx, qy, qz, qw",
    "frame_id child_frame_id qx qy qz qw\na b 0 0 0 0": "line 2 of the table: rotation_xyzw has no direction",
    f"{HEAD}a b 1": "line 2 of the table has 3 cells for 4 columns: a b 1",
    f"{HEAD}a b 1 one": "line 2 of the table: x is one, which is not a finite number",
    f"{HEAD}a b 1 inf": "line 2 of the table: x is inf, which is not a finite number",
    f"{HEAD}# none\n\na a 1 0": "line 4 of the table: a can't be its own parent",
    f"{HEAD}a b now 0": "line 2 of the table: stamp is now, neither seconds above 0 nor static",
    f"{HEAD}a b 0 0": "line 2 of the table: stamp is 0, neither seconds above 0 nor static",
    f"{HEAD}a b nan 0": "line 2 of the table: stamp is nan, neither",
    f"{HEAD}a b 1e99 0": "line 2 of the table: stamp is 1e99, neither",
}


def test_mistakes_are_named_with_their_line() -> None:
    amiss = []
    for text, wanted in MISTAKES.items():
        try:
            read_table(text)
        except TableError as error:
            error_text = str(error)
        else:
            error_text = "no error"
        if not error_text.startswith(wanted):
            amiss.append(f"{text!r}: {error_text}")
    assert not amiss, "\n".join(amiss)
    with pytest.raises(TableError, match="a table is a text with a line of column names, not list"):
        read_table([("map", "base")])
