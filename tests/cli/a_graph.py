"""The graph of the recorded commands: turtlesim, a talker and a static broadcaster. Ends with its input."""

from __future__ import annotations

import sys

from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.qos import DurabilityPolicy, QoS
from tfloom.rosidl.registry import get_message_class

PARAMETER_EVENTS = ("/parameter_events", "rcl_interfaces/msg/ParameterEvent")
ROSOUT = ("/rosout", "rcl_interfaces/msg/Log")
WRITERS = {
    "turtlesim": [
        PARAMETER_EVENTS,
        ROSOUT,
        ("/turtle1/pose", "turtlesim/msg/Pose"),
        ("/turtle1/color_sensor", "turtlesim/msg/Color"),
        ("/turtle1/rotate_absolute/_action/feedback", "turtlesim/msg/Pose"),
        ("/turtle1/rotate_absolute/_action/status", "action_msgs/msg/GoalStatusArray"),
    ],
    "talker": [PARAMETER_EVENTS, ROSOUT, ("/chatter", "std_msgs/msg/String")],
    "static_transform_publisher_yN3fXTw39MIB7X6W": [
        PARAMETER_EVENTS,
        ROSOUT,
        ("/tf_static", "tf2_msgs/msg/TFMessage"),
    ],
}
READERS = {
    "turtlesim": [PARAMETER_EVENTS, ("/turtle1/cmd_vel", "geometry_msgs/msg/Twist")],
    "talker": [PARAMETER_EVENTS],
    "static_transform_publisher_yN3fXTw39MIB7X6W": [PARAMETER_EVENTS],
}


def topic(name: str, type_name: str) -> Topic:
    return Topic(name, type_name, get_message_class(type_name)._TYPE_HASH)


participants = []
for node_name, written in WRITERS.items():
    participant = open_participant()
    node = NodeName("/", node_name)
    participant.add_node(node)
    for topic_name_and_type in written:
        durability = (
            DurabilityPolicy.TRANSIENT_LOCAL
            if topic_name_and_type[0] == "/tf_static"
            else DurabilityPolicy.VOLATILE
        )
        participant.create_writer(node, topic(*topic_name_and_type), QoS(depth=7, durability=durability))
    for topic_and_type in READERS[node_name]:
        participant.create_reader(node, topic(*topic_and_type), QoS())
    participants.append(participant)
print("ready", flush=True)
sys.stdin.read()
for participant in participants:
    participant.close()
