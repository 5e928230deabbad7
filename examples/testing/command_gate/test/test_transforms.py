"""Transforms from a table: in a buffer, or on /tf for a node with a listener of its own."""

import pytest
from command_gate.gate import Gate, distance_ahead
from geometry_msgs.msg import PointStamped, Twist
from rclpy.time import Time

TABLE = """
    frame_id   child_frame_id  stamp   x    y    yaw_deg
    map        base_link       1.0     0    0    0
    map        base_link       2.0     4    0    90
    base_link  camera          static  0.2  0    180
"""


def point_in(frame_id, seconds, x, y):
    point = PointStamped()
    point.header.frame_id = frame_id
    point.header.stamp = Time(seconds=seconds).to_msg()
    point.point.x, point.point.y = x, y
    return point


@pytest.mark.parametrize(
    ("point", "distance"),
    [
        (point_in("map", 1.0, 3.0, 0.0), 3.0),
        (point_in("map", 2.0, 4.0, 2.0), 2.0),
        (point_in("map", 2.0, 3.0, 0.0), None),
        (point_in("camera", 1.0, -1.0, 0.0), 1.2),
    ],
    ids=["ahead", "after a turn", "beside", "of a camera to the rear"],
)
def test_distance_ahead(tf_buffer_from, point, distance):
    assert distance_ahead(tf_buffer_from(TABLE), point) == pytest.approx(distance)


def test_an_obstacle_stops_the_robot(ros_graph, ros_node):
    gate = ros_graph.add(Gate())
    commands = ros_graph.collect(Twist, "cmd_vel")
    ros_graph.broadcast(TABLE)
    obstacle = ros_node.create_publisher(PointStamped, "obstacle", 10)
    obstacle.publish(point_in("map", 2.0, 4.0, 0.4))
    ros_graph.spin_until(lambda: commands)
    assert gate.is_blocked
    assert commands == [Twist()]
