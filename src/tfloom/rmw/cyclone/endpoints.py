"""Writers and readers on Cyclone: thin wrappers of the native ones."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, cast

from tfloom._native import DdsError, DdsReader, DdsWriter, ReadyQueue, Sink
from tfloom.rmw.base import Sample
from tfloom.rmw.errors import ClosedError, ForkedError, UnsupportedEventError, WireError
from tfloom.rmw.events import Count, Event, IncompatibleQoS, LivelinessChanged, Matched, Status
from tfloom.rmw.forks import Inherited
from tfloom.rmw.qos import QoSPolicyKind
from tfloom.rmw.topic_names import key_values

_POLICY_KINDS = {
    2: QoSPolicyKind.DURABILITY,
    4: QoSPolicyKind.DEADLINE,
    8: QoSPolicyKind.LIVELINESS,
    11: QoSPolicyKind.RELIABILITY,
}
"""ROS's policy kinds, by DDS's policy ids (1.4, 2.2.3)."""

_ACKS_SLICE_NS = 100_000_000
"""Time between two checks for signals."""


class CycloneEndpoint:
    """The common part of writers and readers."""

    kind = ""
    """For error texts: reader or writer."""

    _native: DdsWriter | DdsReader

    def __init__(
        self, native: DdsWriter | DdsReader, topic_name: str, forget: Callable[[CycloneEndpoint], None]
    ) -> None:
        self.gid: bytes = native.gid
        self.topic_name = topic_name
        self._native = native
        self._forget = forget
        self._closed = False

    def matched_count(self) -> int:
        """Return how many peers are connected now."""
        return self._native.matched_count()

    def matched(self) -> list[tuple[bytes, bytes]]:
        """Return the gid and the USER_DATA of each peer that is connected now."""
        return self._native.matched()

    def notify_event(self, event: Event, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `take_event(event)` may have a new status, and once at the start; None ends it.

        Raises:
            UnsupportedEventError: the other kind of endpoint has this event, this one does not.
        """
        try:
            self._native.notify_event(event, queue, token)
        except ValueError as error:
            raise UnsupportedEventError(f"{event.name}: {error}") from None

    def take_event(self, event: Event) -> Status | None:
        """Return the status of `event` if it has changed since it was taken last, or None.

        Raises:
            UnsupportedEventError: the other kind of endpoint has this event, this one does not.
        """
        try:
            fields = self._native.take_event(event)
        except ValueError as error:
            raise UnsupportedEventError(f"{event.name}: {error}") from None
        return None if fields is None else _status(event, fields)

    def invalidate_after_fork(self) -> None:
        """Become the copy of the parent's endpoint in a forked child."""
        what = f"the {self.kind} of {self.topic_name}"
        self._native = cast("Any", Inherited(what, self._native))

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""
        if not self._closed:
            self._closed = True
            self._forget(self)
            self._native.close()


def _status(event: Event, fields: tuple[int, int, int, int]) -> Status:
    if event == Event.MATCHED:
        return Matched(*fields)
    if event == Event.LIVELINESS_CHANGED:
        return LivelinessChanged(*fields)
    if event == Event.INCOMPATIBLE_QOS:
        return IncompatibleQoS(fields[0], fields[1], _POLICY_KINDS.get(fields[2], QoSPolicyKind.INVALID))
    return Count(fields[0], fields[1])


class CycloneWriter(CycloneEndpoint):
    """A writer; see `base.Writer`."""

    kind = "writer"
    native_type = DdsWriter
    _native: DdsWriter

    @property
    def native(self) -> DdsWriter:
        """The native writer, for native code that sends to it without Python."""
        return self._native

    def write(self, data: bytes) -> None:
        """Send one sample; blocks while readers of a reliable topic lag behind.

        Raises:
            ClosedError: the writer has left its topic.
            ValueError: the sample doesn't start with the header of little-endian CDR, or ends there.
        """
        try:
            self._native.write(data)
        except RuntimeError as error:
            raise self._error("write to", error) from None

    def write_message(self, message: object) -> None:
        """Encode and send a message, as `write`, with one copy less of large arrays.

        Raises:
            ClosedError: the writer has left its topic.
            EncodeError: a field's value doesn't fit its type.
        """
        try:
            self._native.write_message(message)
        except DdsError as error:  # not what a value of the message raises
            raise self._error("write to", error) from None

    def join_service(self, reader: CycloneReader, service: str, client: bytes | None) -> None:
        """Become an end of a service, with the reader of the other topic: a client with this key, or a server."""
        self._native.join_service(reader.native, service, client)

    def probe(self) -> None:
        """Send a message that readers acknowledge and drop.

        Raises:
            ClosedError: the writer has left its topic.
        """
        try:
            self._native.probe()
        except RuntimeError as error:
            raise self._error("probe the readers of", error) from None

    def assert_liveliness(self) -> None:
        """Assert that this writer is alive.

        Raises:
            ClosedError: the writer has left its topic.
        """
        try:
            self._native.assert_liveliness()
        except RuntimeError as error:
            raise self._error("assert liveliness on", error) from None

    def wait_for_acks(self, timeout_ns: int) -> bool:
        """Wait until all connected reliable readers have acknowledged all samples; return False on a timeout.

        A timeout of 0 returns at once; a negative one is endless. Ctrl-C ends the wait.

        Raises:
            ClosedError: the writer has left its topic.
        """
        left_ns = timeout_ns
        try:
            while left_ns < 0 or left_ns > _ACKS_SLICE_NS:
                if self._native.wait_for_acks(_ACKS_SLICE_NS):
                    return True
                left_ns -= _ACKS_SLICE_NS
            return self._native.wait_for_acks(left_ns)
        except RuntimeError as error:
            raise self._error("wait for readers of", error) from None

    def _error(self, what: str, error: RuntimeError) -> WireError:
        if isinstance(error, ForkedError):
            return error
        kind = ClosedError if self._closed else WireError
        return kind(f"cannot {what} {self.topic_name}: {error}")


class CycloneRequestWriter(CycloneWriter):
    """The writer of a client: one that doesn't wait for readers that lag behind."""

    native_type = staticmethod(partial(DdsWriter, waits=False))  # type: ignore[assignment]

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self._write_lock = threading.Lock()
        """Held by a write, because the native writer takes back what it can't send, the last one."""

    def try_write(self, data: bytes) -> bool:
        """Send one sample; return False if readers lag behind, and nothing was sent.

        Raises:
            ClosedError: the writer has left its topic.
            ValueError: as `write`.
        """
        try:
            with self._write_lock:
                return self._native.write(data)
        except RuntimeError as error:
            raise self._error("write to", error) from None


class CycloneReader(CycloneEndpoint):
    """A reader; see `base.Reader`."""

    kind = "reader"
    native_type = DdsReader
    _native: DdsReader

    @property
    def native(self) -> DdsReader:
        """The native reader, for `CycloneWriter.join_service`."""
        return self._native

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there is something to take, at once if there may be; None ends it."""
        self._native.notify(queue, token)

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample, or None. Its time of receipt is the time of this call."""
        sample_fields = self._native.take()
        return None if sample_fields is None else Sample(*sample_fields)

    def publisher_hash(self, gid: bytes) -> str:
        """Return the hash in the USER_DATA of a publisher that is connected; empty if it is not, or has none."""
        user_data = next((user_data for peer, user_data in self.matched() if peer == gid), b"")
        return key_values(user_data).get("typehash", "")

    def take_decoded(self, message_class: type) -> Sample | None:
        """As `take`; but the data of a large sample is a message of `message_class`, if it can be decoded."""
        sample_fields = self._native.take_decoded(message_class)
        return None if sample_fields is None else Sample(*sample_fields)

    def announce_filter(self, expression: str, parameters: Sequence[str]) -> None:
        """Tell writers of Fast DDS which samples are wanted; an empty expression accepts all."""
        self._native.announce_filter(expression, list(parameters))

    def feed(self, sink: Sink) -> None:
        """Push every sample into `sink` from now on, those already waiting first."""
        self._native.feed(sink)
