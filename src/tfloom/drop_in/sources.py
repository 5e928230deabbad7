"""Where a listener's transforms come from: a reader of tfloom's own, or a subscription of the node.

The reader belongs to a DDS participant that is opened beside the node, on its domain. All listeners of a process on a
domain share it. The wire's thread passes the bytes to the native buffer, without the GIL and without an executor.

A raw subscription passes the serialized messages through the node's executor. It works with every RMW.
"""

from __future__ import annotations

import os
import threading
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.drop_in import real_ros
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.cyclone.config import is_security_requested
from tfloom.rmw.cyclone.library import find_library
from tfloom.rmw.errors import ConfigurationError, NoBackendError
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoS, ReliabilityPolicy

if TYPE_CHECKING:
    from tfloom._native import Sink, TfSink
    from tfloom.rmw.base import Participant, Reader

__all__ = [
    "OwnReader",
    "OwnReaders",
    "RawSubscription",
    "Source",
    "requested_raw",
    "why_not_own_reader",
    "wire_qos",
]

VARIABLE = "TFLOOM_DROP_IN"
CHOICES = {"": None, "auto": None, "reader": False, "raw": True}
INTEROPERABLE = ("rmw_cyclonedds_cpp", "rmw_fastrtps_cpp", "rmw_fastrtps_dynamic_cpp")
"""The RMWs whose topics a participant of Cyclone reads."""
ANNOUNCE_S = 1.0
"""Period at which the reader announces itself on this machine [s].

A stock ROS 2 announces itself by multicast, which the range LOCALHOST does not receive, and answers an announcement.
"""
NO_GID = bytes(16)


class Source(Protocol):
    """The messages of one topic."""

    topic_name: str
    """Fully qualified, remapped."""

    def feed(self, sink: TfSink) -> None:
        """Push every message from now on into `sink`."""

    def get_publisher_count(self) -> int:
        """Return how many publishers are matched now."""


def requested_raw(raw: bool | None) -> bool | None:
    """Return whether a raw subscription is requested: by the argument `raw`, or else by TFLOOM_DROP_IN; None: neither.

    Raises:
        ConfigurationError: TFLOOM_DROP_IN is none of `CHOICES`.
    """
    text = os.environ.get(VARIABLE, "").strip()
    if text not in CHOICES:
        raise ConfigurationError(f"{VARIABLE} is {text!r}, which is none of: auto, reader, raw")
    return CHOICES[text] if raw is None else raw


def why_not_own_reader() -> str:
    """Return why a reader of tfloom's own could not receive what the process's nodes do; empty if it can."""
    rmw = real_ros.module("rclpy.utilities").get_rmw_implementation_identifier()
    if rmw not in INTEROPERABLE:
        return f"{rmw} is in use, whose wire tfloom does not read"
    if os.environ.get("ROS_DISCOVERY_SERVER"):
        return "ROS_DISCOVERY_SERVER is set, and tfloom is not a client of discovery servers"
    if is_security_requested():
        return "ROS_SECURITY_ENABLE is true, and tfloom has no DDS Security"
    try:
        find_library()
    except NoBackendError as error:
        return str(error)
    return ""


class _SharedParticipant:
    """A participant that is open as long as it is in use."""

    def __init__(self, participant: Participant) -> None:
        self.participant = participant
        self.users = 0


_lock = threading.Lock()
_shared: dict[int, _SharedParticipant] = {}
"""The participants by domain. Guarded by `_lock`."""


def _forget_all() -> None:
    """In a forked child, open new participants, because the parent's cannot be used there."""
    global _lock  # noqa: PLW0603  # a thread of the parent may have held the former one
    _lock = threading.Lock()
    _shared.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_all)


class OwnReaders:
    """The readers of one listener, on the graph as a hidden node beside that of the user.

    Args:
        node: The user's node.

    Raises:
        WireError: the domain cannot be joined; the text has the reason.
    """

    def __init__(self, node: Any) -> None:
        from tfloom.rmw.cyclone.wire import open_participant

        self._domain_id = node.context.get_domain_id()
        self._readers: list[OwnReader] = []
        self._name = NodeName(node.get_namespace(), f"_tf_listener_of_{node.get_name()}")
        with _lock:
            if self._domain_id not in _shared:
                _shared[self._domain_id] = _SharedParticipant(
                    open_participant(self._domain_id, announce_s=ANNOUNCE_S)
                )
            self._use = _shared[self._domain_id]
            self._use.users += 1
        self._is_open = True
        self._use.participant.add_node(self._name)

    def open(self, topic_name: str, qos: QoS) -> OwnReader:
        """Open a reader of a topic of TFMessage.

        Raises:
            WireError: the wire refuses it.
        """
        topic = Topic(topic_name, TFMessage._TYPE_NAME, TFMessage._TYPE_HASH)
        reader = self._use.participant.create_reader(self._name, topic, qos)
        self._readers.append(OwnReader(reader, topic_name, self._use.participant))
        return self._readers[-1]

    def close(self) -> None:
        """Close the readers, and leave the domain if no other listener is on it. Closing again does nothing."""
        with _lock:
            if not self._is_open:
                return
            self._is_open = False
            self._use.users -= 1
            # The last one takes the participant out of the table under the lock, so that a new listener opens another
            # one, and never gets one that is about to close. In a forked child the table may hold another already.
            is_last = not self._use.users
            if is_last and _shared.get(self._domain_id) is self._use:
                del _shared[self._domain_id]
        for reader in self._readers:
            reader.close()
        if is_last:
            self._use.participant.close()
        else:
            self._use.participant.remove_node(self._name)


class OwnReader:
    """A reader of tfloom's own; see `Source`."""

    def __init__(self, reader: Reader, topic_name: str, participant: Participant) -> None:
        self.topic_name = topic_name
        self._reader = reader
        self._participant = participant
        self._discovered: set[bytes] = set()

    def feed(self, sink: Sink) -> None:
        """Push every message from now on into `sink`, on the wire's thread."""
        self._reader.feed(sink)

    def get_publisher_count(self) -> int:
        """Return how many publishers are matched now."""
        return self._reader.matched_count()

    def undiscovered(self, gids: set[bytes]) -> set[bytes]:
        """Return those of some writers' gids that this participant has never discovered."""
        if not gids <= self._discovered:
            self._discovered |= {end.gid for end in self._participant.graph.endpoints() if end.is_writer}
        return gids - self._discovered

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""
        self._reader.close()


class RawSubscription:
    """A raw subscription of a node; see `Source`.

    Args:
        node: The node.
        topic_name: The topic, before remapping.
        qos: rclpy's QoSProfile, or a depth.
        group: The callback group.

    Raises:
        ImportError: tf2_msgs is not installed for the node's ROS.
    """

    def __init__(self, node: Any, topic_name: str, qos: Any, group: Any) -> None:
        self._sink: TfSink | None = None
        self.subscription = node.create_subscription(
            real_ros.message_class("tf2_msgs", "TFMessage"),
            topic_name,
            self._take,
            qos,
            callback_group=group,
            raw=True,
        )
        self.topic_name = self.subscription.topic_name

    def _take(self, data: bytes) -> None:
        if self._sink is not None:
            self._sink.push(data, 0, 0, NO_GID)

    def feed(self, sink: TfSink) -> None:
        """Push every message from now on into `sink`, on the executor's thread."""
        self._sink = sink

    def get_publisher_count(self) -> int:
        """Return how many publishers are matched now; 0 by an rclpy that can't tell."""
        count = getattr(self.subscription, "get_publisher_count", None)
        return 0 if count is None else int(count())


def wire_qos(qos: Any) -> QoS:
    """Return the quality of service of rclpy's QoSProfile, or of a depth.

    Raises:
        ValueError: the depth is negative.
    """
    if isinstance(qos, int):
        if qos < 0:
            raise ValueError("history depth must be greater than or equal to zero")
        return QoS(depth=qos)
    return QoS(
        reliability=ReliabilityPolicy(int(qos.reliability)),
        durability=DurabilityPolicy(int(qos.durability)),
        history=HistoryPolicy(int(qos.history)),
        depth=int(qos.depth),
        deadline_ns=qos.deadline.nanoseconds,
        lifespan_ns=qos.lifespan.nanoseconds,
        liveliness=LivelinessPolicy(int(qos.liveliness)),
        liveliness_lease_ns=qos.liveliness_lease_duration.nanoseconds,
    )
