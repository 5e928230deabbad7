"""A node's messages: publish one, and wait for the answer."""

import pytest
from command_gate.gate import Gate
from geometry_msgs.msg import Twist


@pytest.fixture
def gate(ros_graph):
    """Return the node under test, which runs while the test waits."""
    return ros_graph.add(Gate())


def test_a_plan_is_passed_on(gate, ros_node, ros_graph):
    commands = ros_graph.collect(Twist, "cmd_vel")
    plan = Twist()
    plan.linear.x = 0.3
    ros_node.create_publisher(Twist, "plan", 10).publish(plan)
    ros_graph.spin_until(lambda: commands)
    assert commands == [plan]


def test_silence_stops_the_robot(gate, ros_node, wait_for_message):
    """Wait for half a second of the wall clock; the next file does this without waiting."""
    plan = Twist()
    plan.linear.x = 0.3
    ros_node.create_publisher(Twist, "plan", 10).publish(plan)
    assert wait_for_message(Twist, "cmd_vel", timeout_s=5.0, where=lambda command: command.linear.x == 0)


@pytest.mark.ros_wire("dds")
def test_the_same_over_dds(gate, ros_node, wait_for_message):
    plan = Twist()
    plan.linear.x = 0.3
    publisher = ros_node.create_publisher(Twist, "plan", 10)
    ros_node.create_timer(0.02, lambda: publisher.publish(plan))
    assert wait_for_message(Twist, "cmd_vel") == plan
