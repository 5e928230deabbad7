"""Writers and readers on the Zenoh wire.

No lock is held during a call of Zenoh, because a sample for a reader of the same session is delivered within it, on the
thread that writes.
"""

from __future__ import annotations

import math
import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from typing import Any

from tfloom._native import ReadyQueue, Sink, encode
from tfloom.common.signals import signals_deferred
from tfloom.common.terminal import report, shown_part
from tfloom.rmw.base import EndpointInfo, Sample
from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.endpoint_events import READER_EVENTS, WRITER_EVENTS, EndpointEvents
from tfloom.rmw.errors import ClosedError, WireError
from tfloom.rmw.events import Event, Status
from tfloom.rmw.postponed_interrupt import uninterrupted_files
from tfloom.rmw.qos import (
    INFINITE_NS,
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    ReliabilityPolicy,
)
from tfloom.rmw.zenoh.config import reason_of
from tfloom.rmw.zenoh.end import ZenohEnd
from tfloom.rmw.zenoh.events import LostSamples, Timers
from tfloom.rmw.zenoh.feeder import Feeder
from tfloom.rmw.zenoh.graph import Peer, ZenohGraph, peer_name
from tfloom.rmw.zenoh.library import open_library
from tfloom.rmw.zenoh.tokens import Kind, pack_attachment, unpack_attachment
from tfloom.rosidl.other_forms import forms_beside

__all__ = ["ZenohEndpoint", "ZenohReader", "ZenohWriter"]

HEARTBEAT_S = 0.5
"""How long after a sample its number is announced again, so that a reader knows of the last one that it missed [s]."""
HEADER_SIZE = 4
"""Size of the encapsulation header: a shorter sample holds nothing."""
MAX_DEPTH = 1_000_000
"""The most samples that are kept for late readers."""
MAX_REPORTS = 5
"""How many lines an endpoint prints about peers."""
MAX_CATCH_UPS = 256
"""Of how many writers a reader asks for earlier samples at a time."""
CATCH_UP_S = 2.0
"""How long samples are held until the earlier ones have come [s]."""
_NS_PER_S = 1e9
_NOTHING = nullcontext()


class ZenohEndpoint(ZenohEnd):
    """The common part of writers and readers: its peers and its events."""

    def __init__(
        self, info: EndpointInfo, graph: ZenohGraph, timers: Timers, forget: Callable[[Any], None]
    ) -> None:
        watched_kind = Kind.SUBSCRIPTION if info.is_writer else Kind.PUBLISHER
        super().__init__(info.gid, info.topic.name, watched_kind, graph, forget)
        self.info = info
        known = WRITER_EVENTS if info.is_writer else READER_EVENTS
        self.events = EndpointEvents(known, f"a {self.kind} has no such event")
        self._timers = timers
        self._timer_numbers: list[int] = []
        self._active_s: float | None = None
        """When it wrote or received last, on the monotonic clock [s]; None: never."""
        self._peers: set[bytes] = set()
        """The gids of the peers, guarded by the graph's lock."""
        self._report_count = 0
        """How many lines were printed about peers."""

    def add_peer(self, peer: Peer) -> Callable[[], None] | None:
        """Note a peer: one of the same type and hash receives, or sends, whatever its quality of service."""
        mine, theirs = self.info.topic, peer.end
        if theirs.type_name != mine.type_name:
            return None
        if mine.type_hash and theirs.type_hash not in ("", mine.type_hash, mine.other_hash):
            forms = forms_beside(mine.type_name, mine.type_hash) if self.info.is_writer else None
            if forms is not None and theirs.type_hash == forms[1].type_hash:
                return None  # a reader of tfloom's takes both, one of another program's only the other
            return lambda: self._report_hashes(peer)
        qualities = (self.info.qos, theirs.qos) if self.info.is_writer else (theirs.qos, self.info.qos)
        if policies := incompatible_policies(*qualities):
            self.events.add_incompatible(policies[0])
        # One of an incompatible quality is a peer, too: samples pass.
        self._peers.add(peer.gid)
        self.events.add_match(1)
        return self._peer_matched(peer)

    def remove_peer(self, peer: Peer) -> None:
        """Note a peer that has left."""
        if peer.gid in self._peers:
            self._peers.discard(peer.gid)
            self.events.add_match(-1)
            self._peer_unmatched(peer)
        self._peer_left(peer)

    def _peer_matched(self, _peer: Peer) -> Callable[[], None] | None:
        """Note more of a peer; return what is to be done without a lock."""
        return None

    def _peer_unmatched(self, peer: Peer) -> None:
        """Note that a peer has left."""

    def _peer_left(self, _peer: Peer) -> None:
        """Note that another endpoint of the topic, a peer or not, has left."""

    def matched_count(self) -> int:
        """Return how many peers are connected now; 0 once it is closed."""
        self._check_process()
        return 0 if self._is_closed else self.events.matched_count()

    def _report(self, text: str) -> None:
        """Print a line about a peer. There are few of them, because any program may announce any number of peers."""
        self._report_count += 1
        if self._report_count > MAX_REPORTS:
            return
        if self._report_count == MAX_REPORTS:
            text += f"; others are not reported: `ros2 topic info -v {self.info.topic.name}` lists them"
        report(f"tfloom: {text}")

    def _report_hashes(self, peer: Peer) -> None:
        """Print that nothing passes to or from a peer whose type has the same name and another definition."""
        mine, other = self.info.topic, "publisher" if peer.token.kind is Kind.PUBLISHER else "subscription"
        self._report(
            f"nothing passes between the {self.kind} of {mine.name} and the {other} of {peer_name(peer)}, because "
            f"their definitions of {mine.type_name} differ: {mine.type_hash} here, {shown_part(peer.end.type_hash)} "
            "there"
        )

    def notify_event(self, event: Event, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `take_event(event)` may have a new status, and once at the start; None ends it.

        Raises:
            UnsupportedEventError: the other kind of endpoint has this event, this one does not.
        """
        if queue is not None:
            self._check_process()
        self.events.notify(event, queue, token)

    def take_event(self, event: Event) -> Status | None:
        """Return the status of `event` if it has changed since it was taken last, or None.

        Raises:
            UnsupportedEventError: the other kind of endpoint has this event, this one does not.
        """
        self._check_process()
        return self.events.take(event)

    def _call_at(self, first_s: float, check: Callable[[float], float]) -> None:
        self._timer_numbers.append(self._timers.add(first_s, check))

    def _watch_deadline(self) -> None:
        """Start to count missed deadlines, if the quality of service has a deadline."""
        if self.info.qos.deadline_ns < INFINITE_NS:
            period_s = self.info.qos.deadline_ns / _NS_PER_S
            self._call_at(time.monotonic() + period_s, lambda now_s: self._check_deadline(now_s, period_s))

    def _check_deadline(self, now_s: float, period_s: float) -> float:
        """Count a deadline that has passed since the last sample; return when to look again [s]."""
        if self._active_s is None:
            return now_s + period_s
        if now_s < self._active_s + period_s:
            return self._active_s + period_s
        self.events.count(Event.DEADLINE_MISSED)
        return now_s + period_s

    def invalidate_after_fork(self) -> None:
        """Become the copy of the parent's endpoint in a forked child."""
        super().invalidate_after_fork()
        self.events.invalidate_after_fork()

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""
        super().close()
        if not self._is_forked:  # a thread of the parent may have held the lock of the timers
            for number in self._timer_numbers:
                self._timers.remove(number)


class ZenohWriter(ZenohEndpoint):
    """A writer; see `base.Writer`."""

    kind = "writer"

    def __init__(
        self, info: EndpointInfo, graph: ZenohGraph, timers: Timers, forget: Callable[[Any], None]
    ) -> None:
        super().__init__(info, graph, timers, forget)
        self._sequence_number = 0
        self._lease: _OwnLease | None = None
        self._publisher: Any = None
        self._own_readers: set[bytes] = set()
        """Those of this session, which Zenoh calls while it writes."""
        qos = info.qos
        self._is_timed = qos.deadline_ns < INFINITE_NS or qos.liveliness_lease_ns < INFINITE_NS

    def declare(self, session: Any, key: str) -> Any:
        """Open the publisher of Zenoh, and return it."""
        zenoh = open_library()
        import zenoh.ext as extension

        qos = self.info.qos
        is_reliable = qos.reliability == ReliabilityPolicy.RELIABLE
        options: dict[str, Any] = {}
        if qos.durability == DurabilityPolicy.TRANSIENT_LOCAL:
            options = {
                "cache": extension.CacheConfig(max_samples=min(qos.depth, MAX_DEPTH)),
                "publisher_detection": True,
            }
            if is_reliable:
                options["sample_miss_detection"] = extension.MissDetectionConfig(
                    heartbeat=None, sporadic_heartbeat=HEARTBEAT_S
                )
        # One stopped reader of a publisher that blocks stops it for seconds, so only one that keeps all does.
        blocks = is_reliable and qos.history == HistoryPolicy.KEEP_ALL
        control, reliability = zenoh.CongestionControl, zenoh.Reliability
        self._publisher = extension.declare_advanced_publisher(
            session,
            key,
            congestion_control=control.BLOCK if blocks else control.DROP,
            reliability=reliability.RELIABLE if is_reliable else reliability.BEST_EFFORT,
            **options,
        )
        return self._publisher

    def _peer_matched(self, peer: Peer) -> Callable[[], None] | None:
        if peer.token.zid == self._graph.zid:
            self._own_readers.add(peer.gid)
        return None

    def _peer_unmatched(self, peer: Peer) -> None:
        self._own_readers.discard(peer.gid)

    def start_timers(self) -> None:
        """Start to watch its deadline and its lease."""
        self._watch_deadline()
        qos = self.info.qos
        if qos.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC and qos.liveliness_lease_ns < INFINITE_NS:
            self._lease = _OwnLease(self.events, qos.liveliness_lease_ns / _NS_PER_S, self._timers)

    def write_message(self, message: object) -> None:
        """Encode and send a message, as `write`; raise EncodeError if a value doesn't fit its field."""
        self.write(encode(message))

    def write(self, data: bytes) -> None:
        """Send one sample. A reliable one waits for room for a short time, and without end if it keeps all.

        Raises:
            ClosedError: the writer has left its topic.
            WireError: Zenoh refuses the sample.
        """
        self._check_process()
        with self._lock:
            if self._is_closed:
                raise ClosedError(f"cannot write to {self.info.topic.name}: its writer is closed")
            self._sequence_number += 1
            number = self._sequence_number
        if self._is_timed:
            self._active_s = time.monotonic()
            if self._lease is not None:
                self._lease.renew()
        try:
            with signals_deferred() if self._own_readers else _NOTHING:
                self._publisher.put(bytes(data), attachment=pack_attachment(number, self.gid))
        except open_library().ZError as error:
            if self._is_closed:
                raise ClosedError(f"cannot write to {self.info.topic.name}: its writer is closed") from None
            raise WireError(f"cannot write to {self.info.topic.name}: {reason_of(error)}") from None

    def assert_liveliness(self) -> None:
        """Assert that this writer is alive. On this wire other programs learn of it by samples alone.

        Raises:
            ClosedError: the writer has left its topic.
        """
        self._check_process()
        if self._is_closed:
            raise ClosedError(f"cannot assert liveliness on {self.info.topic.name}: its writer is closed")
        if self._lease is not None:
            self._lease.renew()

    def wait_for_acks(self, timeout_ns: int) -> bool:
        """Return True, because readers acknowledge nothing on this wire."""
        self._check_process()
        if self._is_closed:
            raise ClosedError(f"cannot wait for readers of {self.info.topic.name}: its writer is closed")
        return True

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""
        super().close()
        if self._lease is not None and not self._is_forked:
            self._lease.end()


class ZenohReader(ZenohEndpoint):
    """A reader; see `base.Reader`."""

    kind = "reader"

    def __init__(
        self, info: EndpointInfo, graph: ZenohGraph, timers: Timers, forget: Callable[[Any], None]
    ) -> None:
        super().__init__(info, graph, timers, forget)
        is_bounded = info.qos.history != HistoryPolicy.KEEP_ALL
        self._waiting: deque[Sample] = deque(maxlen=min(info.qos.depth, MAX_DEPTH) if is_bounded else None)
        self._listener: tuple[ReadyQueue, int] | None = None
        self._feeder: Feeder | None = None
        """What pushes the samples into a sink."""
        self._left_gids: list[bytes] = []
        """Publishers that have left, for the sink."""
        self._received_count = 0
        self._lost = LostSamples()
        self._catches_up = info.qos.durability == DurabilityPolicy.TRANSIENT_LOCAL and info.qos.depth > 1
        self._held: dict[bytes, dict[int, Sample]] = {}
        """The samples of each writer whose earlier ones are asked for, by their numbers."""
        self._released: dict[bytes, set[int]] = {}
        """The numbers of the samples that were held of each writer."""
        self._origin: tuple[Any, str] = (None, "")
        """The session, and the key of the topic."""
        self._lifespans_ns: dict[bytes, int] = {}
        """Of the writers that have one. Replaced, never changed."""
        self._leases: dict[bytes, _Lease] = {}
        """Of the writers that must assert their liveliness. Replaced, never changed."""
        self._is_timed = info.qos.deadline_ns < INFINITE_NS
        self._hashes: dict[bytes, str] = {}
        """What the keys of a publisher's samples have, where two definitions are read. Guarded by the lock."""

    def declare(self, session: Any, key: str) -> Any:
        """Open the subscriber of Zenoh, and return it."""
        zenoh = open_library()
        import zenoh.ext as extension

        qos = self.info.qos
        self._origin = session, key
        callback = zenoh.handlers.Callback(self._on_sample, indirect=False)
        # An advanced subscriber with no option is the same on the wire. But it drops a sample whose time is before the
        # last one's, and two threads that write at once have such.
        if qos.durability != DurabilityPolicy.TRANSIENT_LOCAL:
            return session.declare_subscriber(key, callback)
        recovers = qos.reliability == ReliabilityPolicy.RELIABLE
        return extension.declare_advanced_subscriber(
            session,
            key,
            callback,
            history=extension.HistoryConfig(
                detect_late_publishers=True, max_samples=min(qos.depth, MAX_DEPTH)
            ),
            recovery=extension.RecoveryConfig(periodic_queries=None, heartbeat=True) if recovers else None,
            subscriber_detection=True,
        )

    def start_timers(self) -> None:
        """Start to watch its deadline."""
        self._watch_deadline()

    def _on_sample(self, sample: Any) -> None:
        """Queue a sample; called on a thread of Zenoh, which all topics share."""
        header = unpack_attachment(sample.attachment)
        if header is None:
            return
        data = sample.payload.to_bytes()
        if len(data) < HEADER_SIZE:
            return
        number, stamp_ns, gid = header
        if self.info.topic.other_hash and not self._note_form(gid, str(sample.key_expr)):
            return
        now_ns = time.time_ns()
        if self._is_timed:
            self._active_s = time.monotonic()
        if self._leases and (lease := self._leases.get(gid)):
            lease.renew()
        accepted = Sample(data, stamp_ns, now_ns, gid, number)
        with self._lock:
            if self._is_closed or self._is_held(number, accepted):
                return
            is_late = number > 1 and self._catches_up and self._hold(number, accepted)
            if not is_late:
                self._accept(number, accepted)
        if is_late:
            self._catch_up(gid)

    def _note_form(self, gid: bytes, key: str) -> bool:
        """Note the hash in the key of a publisher's sample; return whether it is of a known form."""
        type_hash = key.rpartition("/")[2]
        if type_hash not in (self.info.topic.type_hash, self.info.topic.other_hash):
            return False
        with self._lock:
            if len(self._hashes) >= MAX_CATCH_UPS and gid not in self._hashes:
                self._hashes.clear()
            self._hashes[gid] = type_hash
        return True

    def publisher_hash(self, gid: bytes) -> str:
        """Return the hash of a publisher's type, by the key of its last sample; empty if it has sent none."""
        topic = self.info.topic
        if not topic.other_hash:
            return topic.type_hash
        with self._lock:
            return self._hashes.get(gid, "")

    def _is_held(self, number: int, sample: Sample) -> bool:
        """Return whether a sample is held now, or has been and is here again; the caller holds the lock."""
        gid = sample.publisher_gid
        if self._held and (held := self._held.get(gid)) is not None:
            held[number] = sample
            # No more than the depth is delivered of them, so a fast writer must not fill the memory meanwhile. Old ones
            # are dropped many at a time, because sorting takes long.
            depth = self._waiting.maxlen
            if depth is not None and len(held) > 2 * depth:
                stale = sorted(held)[:-depth]
                self._released.setdefault(gid, set()).update(stale)
                for old in stale:
                    del held[old]
            return True
        released = self._released.get(gid) if self._released else None
        if released and number in released:  # Zenoh's own query has brought it too
            released.discard(number)
            return True
        return False

    def _hold(self, number: int, sample: Sample) -> bool:
        """Hold a sample if it is its writer's first one here, and return whether it is; the caller holds the lock."""
        gid = sample.publisher_gid
        if self._lost.knows(gid) or len(self._held) >= MAX_CATCH_UPS:
            return False
        self._held[gid] = {number: sample}
        while len(self._released) >= MAX_CATCH_UPS:
            del self._released[next(iter(self._released))]
        return True

    def _accept(self, number: int, sample: Sample) -> None:
        """Queue a sample, unless its lifespan has ended; the caller holds the lock."""
        lost = self._lost.add(sample.publisher_gid, number)
        if lost:
            self.events.count(Event.MESSAGE_LOST, lost)
        if self._is_over(sample.publisher_gid, sample.source_stamp_ns, sample.received_stamp_ns):
            return
        self._waiting.append(sample._replace(reception_sequence_number=self._received_count))
        self._received_count += 1
        if self._feeder is not None:
            self._feeder.wake()
        elif self._listener is not None:
            self._listener[0].post(self._listener[1])

    def _catch_up(self, gid: bytes) -> None:
        """Ask for what a writer, whose first sample here wasn't its first, has kept; hold its samples meanwhile.

        A reader asks a new writer at once. Until that knows of the reader, it sends nothing. What it writes after its
        reply and before that time would be lost, and Zenoh recovers gaps alone.
        """
        zenoh = open_library()
        session, key = self._origin

        def add(reply: Any) -> None:
            sample = reply.ok
            header = None if sample is None else unpack_attachment(sample.attachment)
            if header is None or header.gid != gid:
                return
            data = sample.payload.to_bytes()
            with self._lock:
                held = self._held.get(gid)
                if held is not None and len(data) >= HEADER_SIZE and len(held) < MAX_DEPTH:
                    held.setdefault(
                        header.sequence_number,
                        Sample(data, header.source_stamp_ns, time.time_ns(), gid, header.sequence_number),
                    )

        is_asked = False
        try:
            session.get(
                f"{key}/@adv/pub/*/**?_max={min(self.info.qos.depth, MAX_DEPTH)}",
                zenoh.handlers.Callback(add, lambda: self._release(gid), indirect=False),
                target=zenoh.QueryTarget.ALL,
                consolidation=zenoh.ConsolidationMode.NONE,
                accept_replies=zenoh.ReplyKeyExpr.ANY,
                timeout=CATCH_UP_S,
            )
            is_asked = True
        finally:  # what is held must not be so for ever
            if not is_asked:
                self._release(gid)

    def _release(self, gid: bytes) -> None:
        """Deliver what is held of a writer, in the order of its numbers."""
        while True:
            with self._lock:
                batch = self._held.get(gid)
                if not batch or self._is_closed:
                    self._held.pop(gid, None)
                    return
                self._held[gid] = {}
                numbers = sorted(batch)
                if self.info.qos.history != HistoryPolicy.KEEP_ALL:
                    numbers = numbers[-self.info.qos.depth :]
                self._released.setdefault(gid, set()).update(batch)
                for number in numbers:
                    self._accept(number, batch[number])

    def _is_over(self, gid: bytes, stamp_ns: int, now_ns: int) -> bool:
        """Return whether the lifespan of a sample has ended."""
        lifespan_ns = self._lifespans_ns.get(gid) if self._lifespans_ns else None
        return lifespan_ns is not None and stamp_ns + lifespan_ns < now_ns

    def _peer_matched(self, peer: Peer) -> Callable[[], None] | None:
        qos = peer.end.qos
        self.events.change_liveliness(1, 0)
        if qos.lifespan_ns < INFINITE_NS:
            self._lifespans_ns = {**self._lifespans_ns, peer.gid: qos.lifespan_ns}
        if qos.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC and qos.liveliness_lease_ns < INFINITE_NS:
            try:
                lease = _Lease(self.events, qos.liveliness_lease_ns / _NS_PER_S, self._timers)
            except RuntimeError as error:  # there is no thread for it; samples are received nevertheless
                reason = str(error)
                return lambda: self._report(
                    f"the liveliness of the publisher of {self.info.topic.name} in {peer_name(peer)} is not watched, "
                    f"which takes a thread: {reason}"
                )
            self._leases = {**self._leases, peer.gid: lease}
        return None

    def _peer_unmatched(self, peer: Peer) -> None:
        lease = self._leases.get(peer.gid)
        is_alive = lease is None or lease.end()
        self.events.change_liveliness(-1 if is_alive else 0, 0 if is_alive else -1)
        self._lifespans_ns = {gid: entry for gid, entry in self._lifespans_ns.items() if gid != peer.gid}
        self._leases = {gid: entry for gid, entry in self._leases.items() if gid != peer.gid}

    def _peer_left(self, peer: Peer) -> None:
        # What it has sent stays known: a peer whose router ends leaves, and comes back with the same gid.
        with self._lock:
            if self._feeder is not None:
                self._left_gids.append(peer.gid)
                self._feeder.wake()

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there is something to take, at once if there already is; None ends it."""
        if queue is not None:
            self._check_process()
        with self._lock:
            self._listener = None if queue is None else (queue, token)
            if queue is not None and self._waiting:
                queue.post(token)

    def take_decoded(self, _message_class: type) -> Sample | None:
        """As `take`: its data are bytes on this wire."""
        return self.take()

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample whose lifespan hasn't ended, or None."""
        self._check_process()
        with self._lock:
            while self._waiting:
                sample = self._waiting.popleft()
                if not self._lifespans_ns or not self._is_over(
                    sample.publisher_gid, sample.source_stamp_ns, time.time_ns()
                ):
                    return sample
        return None

    def announce_filter(self, expression: str, parameters: Sequence[str]) -> None:
        """Do nothing, because no writer filters on this wire."""

    def feed(self, sink: Sink) -> None:
        """Push every sample into `sink` from now on, those already waiting first, on a thread of this reader's own.

        Raises:
            WireError: the system has no thread.
        """
        self._check_process()
        with self._lock:
            before, self._feeder = self._feeder, None
        if before is not None:
            before.end()
        try:
            feeder = Feeder(sink, self._take_all)
        except RuntimeError as error:
            raise WireError(f"cannot feed {self.info.topic.name}, which takes a thread: {error}") from None
        with self._lock:
            is_late = self._is_closed
            if not is_late:
                self._feeder = feeder
        if is_late:
            feeder.end()
        else:
            feeder.wake()

    def _take_all(self) -> tuple[list[Sample], list[bytes]]:
        with self._lock:
            taken = list(self._waiting), self._left_gids
            self._waiting.clear()
            self._left_gids = []
            return taken

    def close(self) -> None:
        """Leave the topic; waiting samples are dropped, and none is pushed any more."""
        super().close()
        with self._lock:
            feeder, self._feeder = self._feeder, None
            self._waiting.clear()
            self._held.clear()
            self._released.clear()
            leases, self._leases = self._leases, {}
        for lease in leases.values():
            lease.end()
        if feeder is not None and not self._is_forked:
            feeder.end()


class _Lease:
    """The liveliness of a writer that must assert it, as a reader sees it.

    Raises:
        RuntimeError: the system has no thread.
    """

    def __init__(self, events: EndpointEvents, lease_s: float, timers: Timers) -> None:
        self._events = events
        self._lease_s = lease_s
        self._timers = timers
        self._lock = threading.Lock()
        self._renewed_s = time.monotonic()
        self._is_alive = True
        self._is_ended = False
        self._number = timers.add(self._renewed_s + lease_s, self._check)

    def renew(self) -> None:
        """Note an assertion, or a sample: the writer is alive, for another lease."""
        with self._lock:
            self._renewed_s = time.monotonic()
            if self._is_alive or self._is_ended:
                return
            self._is_alive = True
            self._tell(is_alive=True)
            self._number = self._timers.add(self._renewed_s + self._lease_s, self._check)

    def _check(self, now_s: float) -> float:
        """Tell that the lease is over, if it is; return when to look again [s]: not before it is renewed."""
        with self._lock:
            end_s = self._renewed_s + self._lease_s
            if now_s < end_s:
                return end_s
            if self._is_alive and not self._is_ended:
                self._is_alive = False
                self._tell(is_alive=False)
        return math.inf

    def _tell(self, *, is_alive: bool) -> None:
        change = 1 if is_alive else -1
        self._events.change_liveliness(change, -change)

    def end(self) -> bool:
        """Stop to watch it, and return whether it is alive."""
        with self._lock:
            self._is_ended = True
            is_alive = self._is_alive
        self._timers.remove(self._number)
        return is_alive


class _OwnLease(_Lease):
    """The liveliness of an own writer."""

    def _tell(self, *, is_alive: bool) -> None:
        if not is_alive:
            self._events.count(Event.LIVELINESS_LOST)


uninterrupted_files.add(ZenohReader.take.__code__.co_filename)
