"""Writers and readers of the in-process wire: a write puts a sample into every matched reader before it returns.

Locks are acquired in this order: a domain's, a writer's, a reader's. A sink calls Python, for example the done callback
of a wait for a transform, which may write, match or close on this wire in its turn. So a sample for a sink is queued
under these locks, and pushed by `LocalReader.flush`, which is called when all of them have been released.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from typing import NamedTuple

from tfloom._native import ReadyQueue, Sink, encode
from tfloom.rmw.base import EndpointInfo, Sample
from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.endpoint_events import MATCH_EVENTS, EndpointEvents
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.events import Event, Status
from tfloom.rmw.qos import INFINITE_NS, DurabilityPolicy, HistoryPolicy, QoS

REFUSAL = "the in-process wire has MATCHED and INCOMPATIBLE_QOS alone"


class _Stored(NamedTuple):
    sample: Sample
    expires_ns: int


def _new_queue(qos: QoS) -> deque[_Stored]:
    """Return an empty queue for as many samples as `qos` keeps."""
    return deque(maxlen=None if qos.history == HistoryPolicy.KEEP_ALL else qos.depth)


class LocalEndpoint:
    """The common part of writers and readers."""

    def __init__(self, info: EndpointInfo) -> None:
        self.info = info
        self.gid = info.gid
        self.events = EndpointEvents(MATCH_EVENTS, REFUSAL)
        self._lock = threading.Lock()
        self._closed = False

    def notify_event(self, event: Event, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `take_event(event)` may have a new status, of MATCHED or INCOMPATIBLE_QOS.

        Raises:
            UnsupportedEventError: the event is another one.
        """
        self.events.notify(event, queue, token)

    def take_event(self, event: Event) -> Status | None:
        """Return the status of `event` if it has changed since it was taken last, or None.

        Raises:
            UnsupportedEventError: the event is neither MATCHED nor INCOMPATIBLE_QOS.
        """
        return self.events.take(event)


class LocalWriter(LocalEndpoint):
    """A writer; see `base.Writer`."""

    def __init__(self, info: EndpointInfo, leave: Callable[[LocalWriter], None]) -> None:
        super().__init__(info)
        self._leave = leave
        self._readers: list[LocalReader] = []
        self._late = _new_queue(info.qos)

    def write_message(self, message: object) -> None:
        """Encode a message, and put it into every matched reader."""
        self.write(encode(message))

    def write(self, data: bytes) -> None:
        """Put a sample into every matched reader.

        Raises:
            ClosedError: the writer has left its topic.
        """
        with self._lock:
            if self._closed:
                raise ClosedError(f"cannot write to {self.info.topic.name}: its writer is closed")
            now_ns = time.time_ns()
            stored = _Stored(Sample(bytes(data), now_ns, now_ns, self.gid), self._expiry_ns(now_ns))
            if self.info.qos.durability == DurabilityPolicy.TRANSIENT_LOCAL:
                self._late.append(stored)
            # Queue the sample under this lock, so that all readers get the samples of this writer in the same order.
            # The sinks get it afterwards, because they may run users' code, which may write to this topic itself.
            readers = tuple(self._readers)
            for reader in readers:
                reader.accept(stored)
        for reader in readers:
            reader.flush()

    def try_write(self, data: bytes) -> bool:
        """Put a sample into every matched reader; see `services.RequestWriter`."""
        self.write(data)
        return True

    def _expiry_ns(self, now_ns: int) -> int:
        lifespan_ns = self.info.qos.lifespan_ns
        return INFINITE_NS if lifespan_ns == INFINITE_NS else now_ns + lifespan_ns

    def match(self, reader: LocalReader) -> None:
        """Connect a reader of the same topic, type and compatible qualities; send it the samples kept for it.

        The caller holds the domain's lock. Either end is new, so that there is nothing to flush: a new writer has kept
        no sample, and a new reader has no sink.
        """
        mine, theirs = self.info, reader.info
        if mine.topic.name != theirs.topic.name or mine.topic.type_name != theirs.topic.type_name:
            return
        if mine.topic.is_native != theirs.topic.is_native:
            return
        if policies := incompatible_policies(mine.qos, theirs.qos):
            self.events.add_incompatible(policies[0])
            reader.events.add_incompatible(policies[0])
            return
        with self._lock:
            if self._closed:
                return
            self._readers.append(reader)
            self.events.add_match(1)
            reader.add_writer(mine)
            # Still under the lock: a sample that is written meanwhile waits, and comes after those that were kept.
            if theirs.qos.durability == DurabilityPolicy.TRANSIENT_LOCAL:
                for stored in self._late:
                    reader.accept(stored)

    def unmatch(self, reader: LocalReader) -> None:
        """Disconnect a reader that leaves."""
        with self._lock:
            if reader in self._readers:
                self._readers.remove(reader)
                self.events.add_match(-1)

    def matched_count(self) -> int:
        """Return how many readers are connected now."""
        with self._lock:
            return len(self._readers)

    def matched_gids(self) -> list[bytes]:
        """Return the gids of the readers that are connected now."""
        with self._lock:
            return [reader.gid for reader in self._readers]

    def assert_liveliness(self) -> None:
        """Do nothing, because leases don't end on this wire."""

    def wait_for_acks(self, timeout_ns: int) -> bool:
        """Return True, because a write delivers its sample before it returns."""
        return True

    def close(self) -> None:
        """Leave the topic; readers keep the samples that they have not taken yet."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
            # Readers are told without the lock, because `remove_writer` flushes into their sinks.
            readers, self._readers = self._readers, []
        for reader in readers:
            reader.remove_writer(self.gid)
        self._leave(self)


class LocalReader(LocalEndpoint):
    """A reader; see `base.Reader`."""

    def __init__(self, info: EndpointInfo, leave: Callable[[LocalReader], None]) -> None:
        super().__init__(info)
        self._leave = leave
        self._waiting = _new_queue(info.qos)
        self._listener: tuple[ReadyQueue, int] | None = None
        self._sink: Sink | None = None
        self._for_sink: deque[_Stored | bytes] = deque()
        """Samples to push into the sink, and gids for it to forget, in order; of any length, because none is lost."""
        self._flusher: int | None = None
        """The thread inside `flush`, guarded by `_lock` as all members are."""
        self._writers: dict[bytes, str] = {}
        """Their gids, each with the hash of the writer's type. Replaced, never changed, under `_lock`."""

    def accept(self, stored: _Stored) -> None:
        """Queue one sample, on the writer's thread, which calls `flush` when it holds no lock."""
        with self._lock:
            if self._closed:
                return
            if self._sink is not None:
                self._for_sink.append(stored)
                return
            self._waiting.append(stored)
            if self._listener is not None:
                self._listener[0].post(self._listener[1])

    def flush(self) -> None:
        """Give the sink what is queued for it. The caller holds no lock, because the sink calls users' functions.

        One thread does so at a time, which keeps the order; other threads leave their samples to it, because a wait
        for it could wait for a user's function that waits for them. A call from inside such a function does not: the
        sample before has been stored by then, and so a write delivers before it returns there too.
        """
        if not self._for_sink:
            return
        me = threading.get_ident()
        with self._lock:
            # Another thread is in here: it takes this sample too, because it looks for more before it leaves. This very
            # thread is in here if a user's function, called by the sink below, has written: then this is a flush inside
            # a flush, and `outer` is the thread again, so that the end of the inner one does not end the outer one.
            if self._flusher not in (None, me):
                return
            outer, self._flusher = self._flusher, me
        try:
            while (task := self._next_task(outer)) is not None:
                _push_or_forget(*task)
        except BaseException:
            with self._lock:
                self._flusher = outer
            self.flush()  # the rest, which other threads have left to this one
            raise

    def _next_task(self, outer: int | None) -> tuple[Sink, _Stored | bytes] | None:
        """Remove and return what to give to the sink, or None, which ends this flush under the same lock."""
        # Whether something is left is decided under the lock under which `accept` queues. So a sample is either found
        # here, or queued after this flush has ended, and then its own thread flushes it.
        with self._lock:
            if self._sink is not None and self._for_sink:
                return self._sink, self._for_sink.popleft()
            self._flusher = outer
            return None

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there is something to take, at once if there already is; None ends it."""
        with self._lock:
            self._listener = None if queue is None else (queue, token)
            if queue is not None and self._waiting:
                queue.post(token)

    def take_decoded(self, _message_class: type) -> Sample | None:
        """As `take`: its data are bytes on this wire."""
        return self.take()

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample whose lifespan hasn't ended, or None."""
        with self._lock:
            while self._waiting:
                stored = self._waiting.popleft()
                if stored.expires_ns > time.time_ns():
                    return stored.sample
        return None

    def announce_filter(self, expression: str, parameters: Sequence[str]) -> None:
        """Do nothing, because no writer filters on this wire."""

    def feed(self, sink: Sink) -> None:
        """Push every sample into `sink` from now on, those already waiting first."""
        with self._lock:
            before, self._sink = self._sink, sink
            self._for_sink.extend(self._waiting)
            self._waiting.clear()
        del before  # outside the lock, because its end may run users' code
        self.flush()

    def publisher_hash(self, gid: bytes) -> str:
        """Return the hash of the type of a writer that is connected; empty if it is not."""
        return self._writers.get(gid, "")

    def add_writer(self, writer: EndpointInfo) -> None:
        """Add a writer that has matched."""
        with self._lock:
            self._writers = self._writers | {writer.gid: writer.topic.type_hash}
            self.events.add_match(1)

    def remove_writer(self, gid: bytes) -> None:
        """Remove a writer that has left, and what the sink stores for it. The caller holds no lock."""
        with self._lock:
            self._writers = {writer: text for writer, text in self._writers.items() if writer != gid}
            self.events.add_match(-1)
            if self._sink is not None:
                self._for_sink.append(gid)
        self.flush()

    def matched_count(self) -> int:
        """Return how many writers are connected now."""
        return len(self._writers)

    def matched_gids(self) -> frozenset[bytes]:
        """Return the gids of the writers that are connected now."""
        return frozenset(self._writers)

    def close(self) -> None:
        """Leave the topic; waiting samples are dropped.

        A sample that another thread is pushing into the sink is not waited for.
        """
        with self._lock:
            if self._closed:
                return
            self._closed = True
            sink, self._sink = self._sink, None
            self._waiting.clear()
            self._for_sink.clear()
            self._writers = {}
        del sink  # outside the lock, because its end may run users' code
        self._leave(self)


def _push_or_forget(sink: Sink, task: _Stored | bytes) -> None:
    """Push a sample whose lifespan hasn't ended, or let the sink forget a writer."""
    if isinstance(task, bytes):
        sink.forget(task)
    elif task.expires_ns > time.time_ns():
        sink.push(*task.sample.for_sink)
