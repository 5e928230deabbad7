"""Insertion of /tf and /tf_static into a buffer, beside a node of a real rclpy."""

from __future__ import annotations

import threading
import weakref
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from tfloom.drop_in import real_ros
from tfloom.drop_in.sources import (
    OwnReader,
    OwnReaders,
    RawSubscription,
    requested_raw,
    why_not_own_reader,
    wire_qos,
)
from tfloom.rmw.errors import WireError
from tfloom.tf2.buffer import Buffer as NativeBuffer
from tfloom.tf2_ros.deadlines import call_after
from tfloom.tf2_ros.far_stamps import held_callback, jump_callback, warn_of_held
from tfloom.tf2_ros.listener_base import AUTHORITY, ListenerBase
from tfloom.tf2_ros.transform_listener import (
    DEFAULT_STATIC_TF_TOPIC,
    DEFAULT_TF_TOPIC,
    DEPTH,
)

if TYPE_CHECKING:
    from tfloom._native import TfSink
    from tfloom.drop_in.sources import Source

__all__ = ["DEFAULT_STATIC_TF_TOPIC", "DEFAULT_TF_TOPIC", "StaticTransformListener", "TransformListener"]

CHECK_S = 0.5
"""Period at which a listener checks that its node exists, that its context is not shut down, and what it misses."""
CHECKS_BEFORE_RAW = 16
"""Checks in a row in which the node knows a publisher that the own reader has not discovered.

Fast DDS may take 3 s to send its list of publishers, after the second in which the reader announces itself.
"""


class _Leaving:
    """Own readers beside the subscriptions that replace them.

    Args:
        readers: What closes them.
        sources: They themselves.
    """

    def __init__(self, readers: OwnReaders, sources: list[OwnReader]) -> None:
        self.readers = readers
        self._sources = sources
        self._checks = 0
        self._checks_with_all = 0

    def is_over(self, subscriptions: list[Source]) -> bool:
        """Return whether each subscription had as many publishers as its reader at two checks, or was given its time.

        At the second, because the publishers may learn of the subscription later than it of them.
        """
        self._checks += 1
        counts = [(source.get_publisher_count(), source.topic_name) for source in self._sources]
        matched = {source.topic_name: source.get_publisher_count() for source in subscriptions}
        has_all = all(matched.get(topic_name, 0) >= count for count, topic_name in counts)
        self._checks_with_all = self._checks_with_all + 1 if has_all else 0
        return self._checks_with_all > 1 or self._checks >= CHECKS_BEFORE_RAW


class TransformListener(ListenerBase):
    """Subscribes to /tf and /tf_static for a node of a real rclpy, and inserts all transforms into a buffer.

    The topics are remapped by the node's rules. By default tfloom opens its own reader beside the node, on the
    node's domain, whose thread passes the bytes directly to the native buffer, with no executor. Where such a reader
    would not receive what the node does, it is a raw subscription of the node, and `why_raw` states why. If `callback`,
    `static_callback` or the buffer's `set_transform` are overridden, or the buffer is tf2_ros's, it is an ordinary
    subscription.

    The own reader discovers within the range of ROS_AUTOMATIC_DISCOVERY_RANGE, which is LOCALHOST by default here.
    If the node knows a publisher for 8 s that the reader has not discovered, the listener changes to a raw subscription
    and logs a warning. With `raw=False` it only warns.

    It ends when its context is shut down, when its node is destroyed, or by `unregister`. Until then its node keeps it
    alive, even without another reference to it.

    Args:
        buffer: The buffer to fill.
        node: The node of rclpy.
        spin_thread: Whether to spin the node on a thread of the listener. Transforms of the own reader don't need it.
        qos: The requested QoS of /tf; None: reliable, volatile, depth 100.
        static_qos: The requested QoS of /tf_static; None: reliable, transient local, and all messages are kept.
        tf_topic: Topic of the transforms that change.
        tf_static_topic: Topic of the static transforms.
        static_only: Whether to subscribe to /tf_static alone.
        raw: True: a raw subscription of the node; False: a reader of tfloom's own; None: as TFLOOM_DROP_IN says (`raw`,
            `reader` or `auto`), and else the reader where it can receive the same as the node.

    Raises:
        ImportError: a subscription is needed, and tf2_msgs is not installed for the node's ROS.
        WireError: the reader was requested, and cannot be opened.
        ConfigurationError: TFLOOM_DROP_IN has another value.
    """

    def __init__(
        self,
        buffer: Any,
        node: Any,
        *,
        spin_thread: bool = False,
        qos: Any = None,
        static_qos: Any = None,
        tf_topic: str = DEFAULT_TF_TOPIC,
        tf_static_topic: str = DEFAULT_STATIC_TF_TOPIC,
        static_only: bool = False,
        raw: bool | None = None,
    ) -> None:
        super().__init__()
        self.node = node
        self.group = real_ros.module("rclpy.callback_groups").ReentrantCallbackGroup()
        self.tf_sub: Any = None
        """The source of /tf: a reader of tfloom's own, or a subscription of rclpy."""
        self.tf_static_sub: Any = None
        """The source of /tf_static, as `tf_sub`."""
        self.why_raw = ""
        """Why the transforms come by a raw subscription; empty where they don't."""
        self._buffer = buffer
        self._lock = threading.RLock()
        """Guards the sources, and the change to others. Not held while the context is queried, because a context calls
        `_on_shutdown` under its own lock."""
        self._has_ended = False
        self._readers: OwnReaders | None = None
        self._leaving: _Leaving | None = None
        """The readers that a raw subscription replaces, until it hears what they hear."""
        self._sources: dict[bool, Source] = {}
        """The sources that feed the native buffer, by whether they are static."""
        self._topics = [] if static_only else [(False, tf_topic, _profile() if qos is None else qos)]
        self._topics.append((True, tf_static_topic, _static_profile() if static_qos is None else static_qos))
        self._raw = requested_raw(raw)
        self._undiscovered_checks = 0
        self._has_warned = False
        self._subscribe()
        # By the setter, which feeds the sources that `_subscribe` has opened. The node then holds the listener, so that
        # one that nobody stores lives as long as its node.
        self.buffer = buffer
        vars(node).setdefault("_tfloom_listeners", set()).add(self)
        node.context.on_shutdown(self._on_shutdown)
        call_after(CHECK_S, _check_callback(weakref.ref(self)))
        if spin_thread:
            self._spin_on_thread()

    def _spin_on_thread(self) -> None:
        executors = real_ros.module("rclpy.executors")
        executor = executors.SingleThreadedExecutor(context=self.node.context)

        def run() -> None:
            with suppress(executors.ExternalShutdownException):
                executor.spin()

        self._spin(executor, run)

    def _subscribe(self) -> None:
        # Three ways, from the slowest to the fastest. Where a user's Python must see each transform, an ordinary
        # subscription decodes the messages. Else the bytes go to the native buffer: by a raw subscription, on the
        # executor's thread, or by a reader of tfloom's own, on the wire's thread. A failure to open the reader ends in
        # the raw subscription, unless the reader was asked for by name.
        is_direct = isinstance(self._buffer, NativeBuffer) and all(
            self._is_direct(is_static=is_static) for is_static in (False, True)
        )
        if not is_direct:
            self._subscribe_to_messages()
            return
        if self._raw is None:
            self.why_raw = why_not_own_reader()
        elif self._raw:
            self.why_raw = "it was requested"
        if not self.why_raw:
            try:
                self._open_readers()
            except WireError as error:
                if self._raw is not None:
                    raise
                self.why_raw = str(error)
        if self.why_raw:
            self._subscribe_raw()
            if self._raw is None:
                self.node.get_logger().info(
                    f"tfloom receives transforms by a raw subscription of this node: {self.why_raw}"
                )

    def _subscribe_to_messages(self) -> None:
        message = real_ros.message_class("tf2_msgs", "TFMessage")
        for is_static, topic, qos in self._topics:
            callback = self.static_callback if is_static else self.callback
            subscription = self.node.create_subscription(
                message, topic, callback, qos, callback_group=self.group
            )
            self._set(is_static, subscription)

    def _open_readers(self) -> None:
        # If one topic fails, no reader stays open, because the caller then subscribes to all topics through the node,
        # or raises.
        readers = OwnReaders(self.node)
        try:
            for is_static, topic, qos in self._topics:
                reader = readers.open(self.node.resolve_topic_name(topic), wire_qos(qos))
                self._sources[is_static] = reader
                self._set(is_static, reader)
        except BaseException:
            readers.close()
            raise
        self._readers = readers

    def _subscribe_raw(self) -> None:
        for is_static, topic, qos in self._topics:
            try:
                source = RawSubscription(self.node, topic, qos, self.group)
            except ImportError as error:
                raise ImportError(
                    f"{error}; a raw subscription needs it: {self.why_raw}", name=error.name
                ) from None
            self._sources[is_static] = source
            self._set(is_static, source.subscription)

    def _set(self, is_static: bool, source: Any) -> None:
        if is_static:
            self.tf_static_sub = source
        else:
            self.tf_sub = source

    @property
    def buffer(self) -> Any:
        """The buffer. After another one is assigned, new transforms are inserted there."""
        return self._buffer

    @buffer.setter
    def buffer(self, buffer: Any) -> None:
        with self._lock:
            if self._sources and not isinstance(buffer, NativeBuffer):
                raise TypeError("assign a buffer of tfloom, or create another listener for this one")
            self._buffer = buffer
            if hasattr(buffer, "watch_clock"):
                buffer.watch_clock(self.node)
            self._feed()

    def _feed(self) -> None:
        for is_static, source in self._sources.items():
            # Transforms stamped far ahead are held only where the own readers deliver them, with the gid of the
            # publisher that the warning names; a raw subscription has no gid. Static ones are valid at any time.
            if is_static or self._readers is None:
                source.feed(self._buffer.tf_sink(AUTHORITY, static=is_static))
                continue
            held = held_callback(weakref.WeakMethod(self._on_held))
            sink = self._buffer.tf_sink(AUTHORITY, static=False, on_held=held)
            self._watch_clock(sink)
            source.feed(sink)

    def _watch_clock(self, sink: TfSink) -> None:
        """Compare stamps with the node's time, which the sink cannot read itself while it is simulated."""
        self._sink = sink
        clock = self.node.get_clock()
        if self._jump_handle is None:
            duration = real_ros.module("rclpy.duration").Duration
            threshold = real_ros.module("rclpy.clock").JumpThreshold(
                min_forward=duration(nanoseconds=1), min_backward=duration(nanoseconds=-1)
            )
            self._jump_handle = clock.create_jump_callback(
                threshold, post_callback=jump_callback(weakref.WeakMethod(self._on_jump))
            )
        sink.set_simulated_time(self._simulated_ns())

    def _simulated_ns(self) -> int | None:
        clock = self.node.get_clock()
        if not getattr(clock, "ros_time_is_active", False):
            return None
        now_ns: int = clock.now().nanoseconds
        return now_ns

    def _on_held(self, gid: bytes, child_frame_id: str, stamp_ns: int, now_ns: int) -> None:
        """Warn of a publisher's first transform that is held."""
        source = self._sources.get(False)
        if source is not None:
            warn_of_held(self.node, source.topic_name, gid, child_frame_id, stamp_ns, now_ns)

    def check(self) -> bool:
        """Close the own readers if the node or its context has ended, and return whether both exist.

        If the node knows a publisher that the readers have not discovered for some checks in a row, log a warning, and
        change to a raw subscription unless the readers were requested.
        """
        if self._has_ended:
            return False
        if not _exists(self.node) or not self.node.context.ok():
            self._end()
            return False
        if self._readers is not None and not self._has_warned:
            self._check_discovery()
        self._close_left_readers()
        return True

    def _check_discovery(self) -> None:
        # The graph is queried without the lock, because a shutdown on another thread needs it to close the sources.
        with self._lock:
            readers = [source for source in self._sources.values() if isinstance(source, OwnReader)]
        unknown = set()
        for reader in readers:
            # The counts are cheap, and agree nearly always. Only else compare the publishers by their gids, because a
            # publisher that does not match the reader is known to both, and is not a reason to change.
            if self.node.count_publishers(reader.topic_name) <= reader.get_publisher_count():
                continue
            node_names = {
                bytes(info.endpoint_gid)[:16]: f"{info.node_namespace.rstrip('/')}/{info.node_name}"
                for info in self.node.get_publishers_info_by_topic(reader.topic_name)
            }
            unknown |= {
                f"{node_names[gid]} on {reader.topic_name}" for gid in reader.undiscovered(set(node_names))
            }
        self._undiscovered_checks = self._undiscovered_checks + 1 if unknown else 0
        if self._undiscovered_checks < CHECKS_BEFORE_RAW:
            return
        self._has_warned = True
        names = ", ".join(sorted(unknown))
        problem = (
            f"tfloom's reader has not discovered publishers that this node knows: {names}. It searches as "
            "ROS_AUTOMATIC_DISCOVERY_RANGE says, LOCALHOST if that is not set; see docs/drop_in.md"
        )
        if self._raw is not None or real_ros.find("tf2_msgs") is None:
            self.node.get_logger().warning(problem)
            return
        self.node.get_logger().warning(
            f"{problem}. From now on a raw subscription of this node takes its place"
        )
        self._change_to_raw(f"the own reader has not discovered {names}")

    def _change_to_raw(self, reason: str) -> None:
        # The readers stay open until the subscription hears all that they hear: between their end and its beginning,
        # and before its publishers know of it, a transform would be lost. What comes by both is stored once.
        with self._lock:
            if self._has_ended or self._readers is None:
                return
            former, before = dict(self._sources), (self.tf_sub, self.tf_static_sub)
            try:
                self.why_raw = reason
                self._subscribe_raw()
            except BaseException:
                created = [source for source in self._sources.values() if isinstance(source, RawSubscription)]
                self._sources, self.why_raw = former, ""
                self.tf_sub, self.tf_static_sub = before
                for source in created:
                    self.node.destroy_subscription(source.subscription)
                raise
            readers = [source for source in former.values() if isinstance(source, OwnReader)]
            self._leaving = _Leaving(self._readers, readers)
            self._readers = None
            self._feed()

    def _close_left_readers(self) -> None:
        """Close the readers that a subscription replaces, if it hears all that they hear, or has had long enough."""
        leaving = self._leaving
        if leaving is None:
            return
        subscriptions = [self._sources[is_static] for is_static, _, _ in self._topics]
        if not leaving.is_over(subscriptions):
            return
        with self._lock:
            if self._leaving is not leaving:  # the listener has just ended
                return
            self._leaving = None
        leaving.readers.close()

    def _on_shutdown(self) -> None:
        self._end()

    def _end(self) -> None:
        """Close the own readers. Subscriptions end with the node."""
        # Take what is to be closed under the lock, and close it after. A shutdown, the periodic check and the user may
        # all come here at once; one of them gets each thing, and the others None.
        with self._lock:
            self._has_ended = True
            readers, self._readers = self._readers, None
            leaving, self._leaving = self._leaving, None
            handle, self._jump_handle = self._jump_handle, None
        if handle is not None:
            with suppress(Exception):  # the clock may have ended with the context
                handle.unregister()
        if readers is not None:
            readers.close()
        if leaving is not None:
            leaving.readers.close()

    def unregister(self) -> None:
        """End the sources. The buffer keeps its content."""
        had_readers = self._readers is not None
        self._end()
        # Not in _end, because rclpy's context skips a callback if an object is freed while it calls them.
        vars(self.node).get("_tfloom_listeners", set()).discard(self)
        if had_readers:
            return
        for subscription in (self.tf_sub, self.tf_static_sub):
            if subscription is not None and not isinstance(subscription, OwnReader):
                self.node.destroy_subscription(subscription)


class StaticTransformListener(TransformListener):
    """Subscribes to /tf_static alone; see TransformListener."""

    def __init__(
        self,
        buffer: Any,
        node: Any,
        *,
        spin_thread: bool = False,
        static_qos: Any = None,
        tf_static_topic: str = DEFAULT_STATIC_TF_TOPIC,
        raw: bool | None = None,
    ) -> None:
        super().__init__(
            buffer,
            node,
            spin_thread=spin_thread,
            static_qos=static_qos,
            tf_static_topic=tf_static_topic,
            static_only=True,
            raw=raw,
        )


def _check_callback(listener: weakref.ref[TransformListener]) -> Any:
    """Return a function that checks a listener now and, as long as it exists, after each period."""

    def check() -> None:
        living = listener()
        if living is None:
            return
        is_alive = True
        with suppress(Exception):  # the node may be destroyed meanwhile; the next check ends the listener
            is_alive = living.check()
        if is_alive:
            call_after(CHECK_S, check)

    return check


def _exists(node: Any) -> bool:
    """Return whether a node is not destroyed: rclpy's handle can then be entered."""
    try:
        with node.handle:
            return True
    except Exception:  # noqa: BLE001, InvalidHandle, a name of rclpy's compiled half
        return False


def _profile() -> Any:
    return real_ros.module("rclpy.qos").QoSProfile(depth=DEPTH)


def _static_profile() -> Any:
    qos = real_ros.module("rclpy.qos")
    return qos.QoSProfile(
        depth=DEPTH, durability=qos.DurabilityPolicy.TRANSIENT_LOCAL, history=qos.HistoryPolicy.KEEP_ALL
    )
