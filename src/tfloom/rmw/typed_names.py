"""Topics and services of message and service classes, in the form that a wire takes, and those of an action."""

from __future__ import annotations

import os

from tfloom.common.terminal import shown_part
from tfloom.rmw.base import Graph, Service, Topic
from tfloom.ros_imports.ros_distro import TURTLESIM_PACKAGE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.unique_identifier_msgs.msg import UUID
    from tfloom.rosidl.message import Message
    from tfloom.rosidl.service import Service as ServiceType


def topic_of(msg_type: type[Message], full_name: str, *, is_native: bool = False) -> Topic:
    """Return the topic of messages of a class.

    Args:
        msg_type: The class.
        full_name: The topic's fully qualified name.
        is_native: Whether DDS has the name unchanged, without ROS's prefix.
    """
    return Topic(full_name, msg_type._TYPE_NAME, msg_type._TYPE_HASH, is_native)  # ours


def service_of(srv_type: type[ServiceType], full_name: str) -> Service:
    """Return the service of a class under a fully qualified name."""
    return Service(
        full_name,
        srv_type._TYPE_NAME,  # ours, here and below
        srv_type.Request._TYPE_HASH,
        srv_type.Response._TYPE_HASH,
        srv_type._TYPE_HASH,
    )


TYPE_CHECKING = False

SEND_GOAL = "/_action/send_goal"
CANCEL_GOAL = "/_action/cancel_goal"
GET_RESULT = "/_action/get_result"
FEEDBACK = "/_action/feedback"
STATUS = "/_action/status"

SERVICE_EVENTS = "/_service_event"
"""What follows a service's name in that of the topic of its introspection."""

SEND_GOAL_TYPE = "_SendGoal"
"""Suffix of the action's type name in the type name of its `SEND_GOAL` service."""

GOAL_STATUS = ("UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")
"""The names of the constants of `action_msgs/msg/GoalStatus`."""
CANCEL_REFUSALS = {1: "it was rejected", 2: "the goal is unknown", 3: "the goal has ended"}
"""The meanings of the codes of `action_msgs/srv/CancelGoal`."""


def new_goal_id() -> UUID:
    """Return a random id, a UUID of version 4."""
    from tfloom.interfaces.unique_identifier_msgs.msg import UUID

    uuid_bytes = bytearray(os.urandom(16))
    uuid_bytes[6] = uuid_bytes[6] & 0x0F | 0x40
    uuid_bytes[8] = uuid_bytes[8] & 0x3F | 0x80
    return UUID(uuid=list(uuid_bytes))


def key_of(goal_id: UUID) -> bytes:
    """Return an id as 16 bytes."""
    return bytes(bytearray(goal_id.uuid))


def other_type_text(graph: Graph, name: str, type_name: str) -> str:
    """Return why a client finds no server, where all servers of this name have another type; empty otherwise.

    Args:
        graph: Where the servers are looked for.
        name: Fully qualified name of the service.
        type_name: The client's type.
    """
    types = sorted({end.type_name for end in graph.service_ends() if end.is_server and end.name == name})
    if not types or type_name in types:
        return ""
    text = f"{name} is served as {shown_part(', '.join(types))}, not as {type_name}"
    packages = {known.partition("/")[0] for known in (*types, type_name)}
    if packages == {"turtlesim", "turtlesim_msgs"}:
        text += (
            ": turtlesim's types are in turtlesim_msgs from Kilted on, and in turtlesim before. Here they are in "
            f"{TURTLESIM_PACKAGE}, which ROS_DISTRO decides"
        )
    return text
