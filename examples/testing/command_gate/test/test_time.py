"""Simulated time that the test steps by hand: seconds take milliseconds, and the result is always the same."""

import pytest
from command_gate.gate import Gate
from geometry_msgs.msg import Twist


@pytest.fixture
def commands(ros_graph, ros_time, ros_node):
    """Return the list of commands after the node has received one plan, at 100 s."""
    ros_graph.add(Gate())
    received = ros_graph.collect(Twist, "cmd_vel")
    plan = Twist()
    plan.linear.x = 0.3
    ros_node.create_publisher(Twist, "plan", 10).publish(plan)
    ros_graph.spin_until_idle()
    return received


def test_the_robot_goes_on_for_half_a_second(commands, ros_time):
    ros_time.step(0.5)
    assert [command.linear.x for command in commands] == [0.3]


def test_then_it_is_stopped_once(commands, ros_time):
    ros_time.step(0.6)
    assert [command.linear.x for command in commands] == [0.3, 0.0]
    ros_time.step(60.0, every_s=0.1)
    assert len(commands) == 2
