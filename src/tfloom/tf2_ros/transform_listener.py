"""Insertion of /tf and /tf_static into a buffer."""

from __future__ import annotations

import secrets
import weakref
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.clock.clock import ROSClock
from tfloom.node.clock.time_jump import ANY_JUMP
from tfloom.node.executing.callback_groups import ReentrantCallbackGroup
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tfloom.node.values.wrong_arguments import node_error
from tfloom.tf2_ros.far_stamps import held_callback, jump_callback, warn_of_held
from tfloom.tf2_ros.listener_base import AUTHORITY, ListenerBase

if TYPE_CHECKING:
    from tfloom._native import TfSink
    from tfloom.node.endpoints.subscription import Subscription

__all__ = ["DEFAULT_STATIC_TF_TOPIC", "DEFAULT_TF_TOPIC", "StaticTransformListener", "TransformListener"]

DEFAULT_TF_TOPIC = "/tf"
"""The topic of moving transforms."""
DEFAULT_STATIC_TF_TOPIC = "/tf_static"
"""The topic of static transforms."""
DEPTH = 100


class TransformListener(ListenerBase):
    """Subscribes to /tf and /tf_static and inserts all transforms into a buffer.

    The wire's thread passes the bytes directly to the native buffer: no message is built, and no executor is needed.
    If `callback`, `static_callback` or the buffer's `set_transform` are overridden, messages are built and passed to
    these, on the executor.

    One transform stamped in the far future would hide all later ones of its frame. So one whose stamp is further ahead
    of the node's time than the buffer's history is long, and than its publisher's former stamps, is held until that
    publisher's next one confirms that its clock is ahead. A warning names the publisher. This applies to transforms
    that are passed directly, and not to static ones.

    It is kept alive by its node, even without another reference to it, until `unregister`.

    Args:
        buffer: The buffer to fill.
        node: The node that subscribes; None: a hidden node of the listener.
        spin_thread: Whether to spin the node on a thread of the listener. The transforms don't need it. An exception of
            one of the node's callbacks is reported by `threading.excepthook`, and the thread goes on.
        qos: The requested QoS of /tf; None: reliable, volatile, depth 100.
        static_qos: The requested QoS of /tf_static; None: reliable, transient local, and all messages are kept.
        tf_topic: Topic of the transforms that change.
        tf_static_topic: Topic of the static transforms.
        static_only: Whether to subscribe to /tf_static alone.
    """

    def __init__(
        self,
        buffer: Any,
        node: Node | None = None,
        *,
        spin_thread: bool = False,
        qos: QoSProfile | int | None = None,
        static_qos: QoSProfile | int | None = None,
        tf_topic: str = DEFAULT_TF_TOPIC,
        tf_static_topic: str = DEFAULT_STATIC_TF_TOPIC,
        static_only: bool = False,
    ) -> None:
        if not hasattr(buffer, "set_transform"):
            raise TypeError(
                f"TransformListener(buffer, node) needs a tf2_ros.Buffer first, got {buffer!r} "
                f"of class {type(buffer).__name__}"
            )
        if node is not None and (error := node_error("TransformListener", node)) is not None:
            raise error
        super().__init__()
        self._owns_node = node is None
        self.node: Node = _hidden_node() if node is None else node
        self.group = ReentrantCallbackGroup()
        self.tf_sub: Subscription[TFMessage] | None = None
        self.tf_static_sub: Subscription[TFMessage] | None = None
        self._buffer = buffer
        if not static_only:
            self.tf_sub = self.node.create_subscription(
                TFMessage,
                tf_topic,
                self.callback,
                QoSProfile(depth=DEPTH) if qos is None else qos,
                callback_group=self.group,
            )
        self.tf_static_sub = self.node.create_subscription(
            TFMessage,
            tf_static_topic,
            self.static_callback,
            _static_profile() if static_qos is None else static_qos,
            callback_group=self.group,
        )
        self.buffer = buffer
        if spin_thread:
            self._spin_on_thread()

    @property
    def buffer(self) -> Any:
        """The buffer. After another one is assigned, new transforms are inserted there."""
        return self._buffer

    @buffer.setter
    def buffer(self, buffer: Any) -> None:
        self._buffer = buffer
        if hasattr(buffer, "watch_clock"):
            buffer.watch_clock(self.node)
        for is_static, subscription in ((False, self.tf_sub), (True, self.tf_static_sub)):
            if subscription is None or not self._is_direct(is_static=is_static):
                continue
            if is_static:
                sink = buffer.tf_sink(AUTHORITY, static=True)
            else:
                held = held_callback(weakref.WeakMethod(self._on_held))
                sink = buffer.tf_sink(AUTHORITY, static=False, on_held=held)
                self._watch_clock(sink)
            subscription.feed(sink)

    def _watch_clock(self, sink: TfSink) -> None:
        """Compare stamps with the node's time, which the sink cannot read itself while it is simulated."""
        self._sink = sink
        clock = self.node.get_clock()
        if self._jump_handle is None:
            self._jump_handle = clock.create_jump_callback(
                ANY_JUMP, post_callback=jump_callback(weakref.WeakMethod(self._on_jump))
            )
        sink.set_simulated_time(self._simulated_ns())

    def _simulated_ns(self) -> int | None:
        clock = self.node.get_clock()
        return clock.now_ns() if isinstance(clock, ROSClock) and clock.ros_time_is_active else None

    def _on_held(self, gid: bytes, child_frame_id: str, stamp_ns: int, now_ns: int) -> None:
        """Warn of a publisher's first transform that is held."""
        if self.tf_sub is None:
            return
        warn_of_held(self.node, self.tf_sub.topic_name, gid, child_frame_id, stamp_ns, now_ns)

    def _spin_on_thread(self) -> None:
        executor = SingleThreadedExecutor(context=self.node.context)
        try:
            self._spin(executor, executor.spin_on_own_thread)
        except RuntimeError:
            if self._owns_node:
                self.node.destroy_node()
            raise

    def unregister(self) -> None:
        """Destroy the subscriptions. The buffer keeps its content."""
        if self._jump_handle is not None:
            self._jump_handle.unregister()
            self._jump_handle = None
        for subscription in (self.tf_sub, self.tf_static_sub):
            if subscription is not None:
                self.node.destroy_subscription(subscription)

    def __del__(self) -> None:
        super().__del__()
        with suppress(Exception):
            if self._owns_node:
                self.node.destroy_node()


class StaticTransformListener(TransformListener):
    """Subscribes to /tf_static alone; see TransformListener."""

    def __init__(
        self,
        buffer: Any,
        node: Node | None = None,
        *,
        spin_thread: bool = False,
        static_qos: QoSProfile | int | None = None,
        tf_static_topic: str = DEFAULT_STATIC_TF_TOPIC,
    ) -> None:
        super().__init__(
            buffer,
            node,
            spin_thread=spin_thread,
            static_qos=static_qos,
            tf_static_topic=tf_static_topic,
            static_only=True,
        )


def _static_profile() -> QoSProfile:
    # All are kept, because each publisher sends its edges once, to a late reader all at once, and there may be any
    # number of publishers.
    return QoSProfile(
        depth=DEPTH, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_ALL
    )


def _hidden_node() -> Node:
    name = f"transform_listener_impl_{secrets.token_hex(5)}"
    # Given as an argument too, so that a `-r __node:=` for the whole program does not rename it.
    return Node(
        name,
        cli_args=["--ros-args", "-r", f"__node:={name}"],
        enable_rosout=False,
        start_parameter_services=False,
    )
