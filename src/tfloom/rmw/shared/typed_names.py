"""Topics and services of message and service classes, in the form that a wire takes."""

from __future__ import annotations

from tfloom.rmw.base import Service, Topic

TYPE_CHECKING = False
if TYPE_CHECKING:
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
