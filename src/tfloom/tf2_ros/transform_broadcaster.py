"""Publication of transforms that change."""

from __future__ import annotations

import reprlib
from collections.abc import Iterable
from typing import TYPE_CHECKING

from tfloom.common.text import given_text
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.qos.qos import QoSProfile

if TYPE_CHECKING:
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped
    from tfloom.node.node import Node

__all__ = ["TransformBroadcaster"]

NO_NODE = "{name}(node) needs the node that publishes, got {given}"


class TransformBroadcaster:
    """Publishes on /tf.

    Args:
        node: The node that publishes.
        qos: The offered QoS; None: reliable, volatile, depth 100.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        if isinstance(node, type) or not hasattr(node, "create_publisher"):
            raise TypeError(NO_NODE.format(name="TransformBroadcaster", given=reprlib.repr(node)))
        self.pub_tf = node.create_publisher(TFMessage, "/tf", QoSProfile(depth=100) if qos is None else qos)

    def send_transform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:
        """Publish one transform or several, in one message.

        Raises:
            TypeError: one is not a TransformStamped.
        """
        self.pub_tf.publish(TFMessage(transforms=as_list(transform)))

    sendTransform = send_transform


def as_list(transform: TransformStamped | Iterable[TransformStamped]) -> list[TransformStamped]:
    """Return one transform or several as a list.

    Raises:
        TypeError: one is not a TransformStamped.
    """
    transforms = list(transform) if isinstance(transform, Iterable) else [transform]
    for stamped in transforms:
        if not hasattr(stamped, "child_frame_id"):
            given = given_text(stamped)
            raise TypeError(
                f"sendTransform() needs a geometry_msgs.msg.TransformStamped, or several, got {given}"
            )
    return transforms
