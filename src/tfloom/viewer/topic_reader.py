"""A topic of a graph, read from all its publishers, whatever quality of service each offers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from tfloom.rmw.errors import WireError
from tfloom.rmw.qos import DurabilityPolicy, QoS, ReliabilityPolicy
from tfloom.viewer.displays.kinds import KEPT_TYPES
from tfloom.viewer.obstacles import qos_text

if TYPE_CHECKING:
    from tfloom.rmw.base import EndpointInfo, NodeName, Participant, Reader, Sample

__all__ = ["TopicReader", "is_latched"]

DEPTH = 50
"""Number of messages of a topic that wait between two pictures; older ones are dropped."""
LATCHED_DEPTH = 100
"""… of publishers that keep messages for late subscriptions."""
KEPT_DEPTH = 2000
"""… of a topic of which all messages matter: one that is dropped doesn't come again."""
MAX_TAKEN = 200
"""Number of messages of one reader that are taken for one picture."""
MAX_SEEN = 3 * KEPT_DEPTH
"""Number of messages that are known as taken, for readers that are behind others."""
HASHED_BYTES = 4096
"""Length of the part of a message by which it is known [bytes]."""


class Request(NamedTuple):
    """What a reader requests of publishers."""

    durability: DurabilityPolicy
    reliability: ReliabilityPolicy


LOOSE = Request(DurabilityPolicy.VOLATILE, ReliabilityPolicy.BEST_EFFORT)
RELIABLE = Request(DurabilityPolicy.VOLATILE, ReliabilityPolicy.RELIABLE)
LATCHED = Request(DurabilityPolicy.TRANSIENT_LOCAL, ReliabilityPolicy.RELIABLE)


def is_latched(writer: EndpointInfo) -> bool:
    """Return whether a publisher sends messages of before to a late subscription, which only a reliable one does."""
    qos = writer.qos.resolved()
    return (
        qos.durability is DurabilityPolicy.TRANSIENT_LOCAL and qos.reliability is ReliabilityPolicy.RELIABLE
    )


def request_for(writer: EndpointInfo) -> Request:
    """Return what is requested of a publisher.

    Best effort, so that no publisher waits for the viewer; but kept messages are only sent to a reliable reader, and
    of some types, each message matters.
    """
    if is_latched(writer):
        return LATCHED
    is_reliable = writer.qos.resolved().reliability is ReliabilityPolicy.RELIABLE
    return RELIABLE if is_reliable and writer.topic.type_name in KEPT_TYPES else LOOSE


class TopicReader:
    """Reads a topic. One thread may use it.

    There is a reader for each request that a publisher needs. What two of them receive counts once.

    Args:
        participant: The participant that reads.
        node: The node whose readers these are.
        publishers: Returns the publishers, the same object while they are the same ones. Those of another type than
            the first one's are left out.
        depths: As `set_depths` takes them.

    Raises:
        WireError: there are no publishers, or the wire refuses a reader.
    """

    def __init__(
        self,
        participant: Participant,
        node: NodeName,
        publishers: Callable[[], Sequence[EndpointInfo]],
        depths: Iterable[int] = (),
    ) -> None:
        self._participant = participant
        self._node = node
        self._publishers = publishers
        self._known = publishers()
        """The publishers that are read."""
        if not self._known:
            raise WireError("nobody publishes it any longer")
        self._topic = self._known[0].topic
        self._depths = list(depths)
        self._readers: dict[Request, Reader] = {}
        self._opened_with: dict[Request, QoS] = {}
        """The quality of service of each reader."""
        self._is_reopened = False
        """Whether a reader took the place of another one, which has received kept messages before."""
        self._seen: dict[tuple[bytes, int, int], None] = {}
        """Publisher, stamp and hash of the messages that were taken last."""
        self.refusal = ""
        """Why the wire refuses a reader that publishers need which came later; empty if it doesn't."""
        try:
            self._read_from(self._known)
        except BaseException:
            self.close()
            raise

    def _read_from(self, publishers: Sequence[EndpointInfo]) -> None:
        needed = {request_for(end) for end in publishers if end.topic.type_name == self._topic.type_name}
        for request in needed - self._readers.keys():
            self._open(request)

    def _open(self, request: Request) -> None:
        qos = self._qos(request)
        self._readers[request] = self._participant.create_reader(self._node, self._topic, qos)
        self._opened_with[request] = qos

    def _qos(self, request: Request) -> QoS:
        is_kept = self._topic.type_name in KEPT_TYPES
        usual = KEPT_DEPTH if is_kept else LATCHED_DEPTH if request is LATCHED else DEPTH
        depth = max((depth or usual for depth in self._depths), default=usual)
        return QoS(request.reliability, request.durability, depth=depth)

    def set_depths(self, depths: Iterable[int]) -> None:
        """Let as many messages wait as the greatest of some numbers, from the next `take` on; 0 is the usual number."""
        self._depths = list(depths)

    def _reopen(self) -> None:
        """Exchange the readers of another depth; where the wire refuses one, the one that is there stays."""
        for request, reader in list(self._readers.items()):
            if self._opened_with[request] == self._qos(request):
                continue
            try:
                self._open(request)
            except WireError as error:
                self.refusal = str(error)
                return
            self._is_reopened, self.refusal = True, ""
            reader.close()

    def take(self) -> Iterator[Sample]:
        """Yield the messages that have come since, also from publishers that have. Never waits."""
        if (publishers := self._publishers()) is not self._known:
            self._known = publishers
            try:
                self._read_from(publishers)
                self.refusal = ""
            except WireError as error:
                self.refusal = str(error)
        for reader in self._readers.values():
            for _ in range(MAX_TAKEN):
                if (sample := reader.take()) is None:
                    break
                if self._is_new(sample) or (len(self._readers) == 1 and not self._is_reopened):
                    yield sample
        self._reopen()

    def silence(self) -> str:
        """Return why no message comes from any publisher of the type that is read; empty if one is heard."""
        if self.refusal or self._participant.graph.delivers_incompatible():
            return self.refusal
        heard = [end for end in self._known if end.topic.type_name == self._topic.type_name]
        return qos_text(heard, [self._qos(request) for request in self._readers])

    def _is_new(self, sample: Sample) -> bool:
        # Where clocks are coarse, two messages have one stamp; of a long one, the first bytes differ, too.
        key = sample.publisher_gid, sample.source_stamp_ns, hash(sample.data[:HASHED_BYTES])
        if key in self._seen:
            return False
        self._seen[key] = None
        if len(self._seen) > MAX_SEEN:
            del self._seen[next(iter(self._seen))]
        return True

    def close(self) -> None:
        """End reading."""
        for reader in self._readers.values():
            reader.close()
        self._readers.clear()
