"""Observation of a domain: readers of /tf and /tf_static beside the nodes, with no node of its own."""

from __future__ import annotations

import time

from tfloom._native import ReadyQueue, TfObserver, TfObserverSink
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.base import EndpointInfo, NodeName, Participant, Reader
from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import topic_of
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.model import LISTENER_QOS, TOPICS, Description, Observation, observation_of

__all__ = ["LOOSE_QOS", "REQUESTED_QOS", "LiveWatch"]

REQUESTED_QOS = (
    LISTENER_QOS[False]._replace(depth=1000),
    LISTENER_QOS[True]._replace(history=HistoryPolicy.KEEP_ALL),
)
"""Of the readers of moving and of static transforms: as a transform listener requests, but for the depth."""
LOOSE_QOS = QoS(ReliabilityPolicy.BEST_EFFORT, DurabilityPolicy.VOLATILE, depth=1000)
"""Of the readers of publishers that offer less, from which a transform listener receives nothing."""
CLOCK_QOS = QoS(ReliabilityPolicy.BEST_EFFORT, depth=1)
LOOK_S = 0.1
"""Period at which a wait reads the graph, for publishers of another quality [s]."""


class LiveWatch:
    """Records all transforms of a domain from now on, by publisher and edge, on the wire's threads.

    Publishers whose quality of service does not match a transform listener's are recorded, too.
    All methods are for one thread.

    Args:
        participant: The participant that reads.
        node: The node whose readers these are, which was added to the participant.
        buffer: A buffer to fill as well, in the same pass, with what a transform listener would receive; authorities
            are the publishers' gids in hexadecimal.
        topics: The topics of moving and of static transforms.
        cache_time_ns: Age beyond a frame's newest stamp above which a transform counts as too old [ns].
        simulated: Whether stamps are compared with the time on /clock, not with this machine's.
    """

    def __init__(
        self,
        participant: Participant,
        node: NodeName,
        *,
        buffer: Buffer | None = None,
        topics: tuple[str, str] = TOPICS,
        cache_time_ns: int = 10_000_000_000,
        simulated: bool = False,
    ) -> None:
        self.buffer = buffer
        self._participant = participant
        self._node = node
        self._topics = topics
        self._observer = TfObserver(cache_time_ns)
        self._described: dict[bytes, Description] = {}
        self._endpoints: list[EndpointInfo] = []
        self._changes = -1
        self._queue = ReadyQueue()
        self._readers: list[Reader] = []
        self._sinks: list[TfObserverSink] = []
        self._loose: dict[bool, TfObserverSink] = {}
        self._started_ns = time.time_ns()
        if simulated:
            self._read_clock()
        for is_static, qos in enumerate(REQUESTED_QOS):
            self._read(qos, static=bool(is_static))
        self.look()

    def _read(self, qos: QoS, *, static: bool, only: list[bytes] | None = None) -> TfObserverSink:
        topic = topic_of(TFMessage, self._topics[static])
        # With `only`, count and don't store: a listener with the usual quality of service receives nothing from these
        # publishers, so lookups in the buffer must fail as they do there.
        sink = self._observer.sink(static, self.buffer if only is None else None)
        sink.accept_only(only)
        sink.notify(self._queue, len(self._sinks))
        reader = self._participant.create_reader(self._node, topic, qos)
        self._readers.append(reader)
        self._sinks.append(sink)
        reader.feed(sink)
        return sink

    def look(self) -> None:
        """Read the graph if it has changed: publishers' names, and those of another quality."""
        graph = self._participant.graph
        if (changes := graph.changes()) == self._changes:
            return
        self._changes = changes
        # Leave out the own readers, which would look like subscriptions of the user's programs.
        own = {reader.gid for reader in self._readers}
        self._endpoints = [
            end for end in graph.endpoints() if end.topic.name in self._topics and end.gid not in own
        ]
        writers = [end for end in self._endpoints if end.is_writer]
        for end in writers:
            known = self._described.get(end.gid)
            # The gid can arrive before the node that owns it, and the node can leave before its publisher: never
            # replace a known name by none.
            if end.node is not None or known is None:
                self._described[end.gid] = Description(end.node, end.qos)
        for is_static in (False, True):
            self._read_unmatched(
                is_static, [end for end in writers if end.topic.name == self._topics[is_static]]
            )

    def _read_unmatched(self, is_static: bool, writers: list[EndpointInfo]) -> None:
        requested = REQUESTED_QOS[is_static].resolved()
        gids = [end.gid for end in writers if incompatible_policies(end.qos.resolved(), requested)]
        # One additional reader for each topic requests less and accepts those publishers alone; otherwise it would
        # count the transforms of all others twice.
        if is_static in self._loose:
            self._loose[is_static].accept_only(gids)
        elif gids:
            self._loose[is_static] = self._read(LOOSE_QOS, static=is_static, only=gids)

    def _read_clock(self) -> None:
        self._observer.set_simulated_time(0)
        reader = self._participant.create_reader(self._node, topic_of(Clock, "/clock"), CLOCK_QOS)
        self._readers.append(reader)
        reader.feed(self._observer.clock_sink())

    def now_ns(self) -> int:
        """Return the time with which stamps are compared [ns since epoch].

        It is this machine's, or that on /clock, 0 before it is known.
        """
        simulated_ns = self._observer.simulated_time()
        return time.time_ns() if simulated_ns is None else simulated_ns

    def wait(self, end_s: float) -> None:
        """Wait for a transform until `end_s` on the monotonic clock [s]; return at once if one came since last time."""
        # Ask the sinks before sleeping: what came between two waits counts. Sleep for short times only, because a new
        # publisher may need the additional reader, and the graph posts no token to this queue.
        while not any(sink.take_pushed() for sink in self._sinks):
            self.look()
            left_s = end_s - time.monotonic()
            if left_s <= 0 or self._queue.wait(int(min(left_s, LOOK_S) * 1e9) + 1, quiet=True):
                return

    def observation(self) -> Observation:
        """Return all that is known now."""
        self.look()
        return observation_of(
            self._observer.snapshot(),
            self._described,
            (self._started_ns, time.time_ns()),
            topics=self._topics,
            endpoints=self._endpoints,
            is_live=True,
        )

    def close(self) -> None:
        """Close the readers; what was recorded stays."""
        for reader in self._readers:
            reader.close()
