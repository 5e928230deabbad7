"""Publication of static transforms, which hold at all times."""

from __future__ import annotations

import reprlib
import threading
from collections.abc import Iterable
from typing import TYPE_CHECKING

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.qos.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tfloom.tf2_ros.transform_broadcaster import NO_NODE, as_list

if TYPE_CHECKING:
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped
    from tfloom.node.node import Node
    from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions

__all__ = ["StaticTransformBroadcaster"]


class StaticTransformBroadcaster:
    """Publishes on /tf_static, to present subscriptions and to later ones.

    Each message holds all transforms that were sent, because late subscriptions receive the last message alone.
    A transform replaces the previous one of the same child frame.

    Args:
        node: The node that publishes.
        qos: The offered QoS; None: reliable, transient local, depth 1.
        qos_overriding_options: The policies that parameters may override; None: none.
    """

    def __init__(
        self,
        node: Node,
        qos: QoSProfile | int | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
    ) -> None:
        if isinstance(node, type) or not hasattr(node, "create_publisher"):
            raise TypeError(NO_NODE.format(name="StaticTransformBroadcaster", given=reprlib.repr(node)))
        if qos is None:
            qos = QoSProfile(
                depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST
            )
        self.pub_tf = node.create_publisher(
            TFMessage, "/tf_static", qos, qos_overriding_options=qos_overriding_options
        )
        self.net_message = TFMessage()
        """All transforms that were sent. Replaced, never changed, under the lock."""
        self._lock = threading.Lock()

    def send_transform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:
        """Publish one transform or several, together with all that were sent before.

        Raises:
            TypeError: one is not a TransformStamped.
        """
        added = as_list(transform)
        with self._lock:
            by_child = {stamped.child_frame_id: stamped for stamped in [*self.net_message.transforms, *added]}
            message = self.net_message = TFMessage(transforms=list(by_child.values()))
        self.pub_tf.publish(message)
        # Published without the lock, so another thread's later message may be out before this one. The last one has to
        # be the whole, because a late subscription receives that alone.
        while message is not self.net_message:
            message = self.net_message
            self.pub_tf.publish(message)

    sendTransform = send_transform
