"""The compiled core of tfloom: numbers, ids and bytes."""

from typing import Any


class Sink:
    """Takes serialized samples without Python; see `Reader.feed`."""

    def push(self, data: bytes, source_stamp_ns: int, received_stamp_ns: int, publisher_gid: bytes) -> None:
        """
        Push one sample: encapsulation header and CDR, stamps [ns since epoch], 16 octets of gid.
        """

class SampleQueue(Sink):
    """A sink that keeps the newest samples, for Python to take many at once."""

    def __init__(self, depth: int) -> None: ...

    def take(self) -> list[tuple[bytes, int, int, bytes]]:
        """Remove and return all: (data, source stamp, received stamp, gid) each."""

    def pushed(self) -> int:
        """Return how many samples have ever been pushed."""

class ReadyQueue:
    """
    Tokens of entities that have something to do: any thread posts, one thread waits.
    """

    def __init__(self) -> None: ...

    def post(self, token: int) -> None:
        """
        Post a token. One that is posted again before it is taken is taken once.
        """

    def wait(self, timeout_ns: int) -> list[int]:
        """
        Wait for tokens and take all of them, in order of first posting.

        Does not wait with a timeout of 0, waits for ever with a negative one. Empty on a timeout. Releases the GIL; a signal's Python handler runs at once, and what it raises is raised here.
        """

class DdsParticipant:
    """This process on one DDS domain."""

    def __init__(self, library_path: str, domain_id: int, config: str, user_data: bytes) -> None:
        """
        Join a domain with the libddsc at `library_path`, Cyclone's XML `config` and `user_data` for all to see.
        """

    @property
    def gid(self) -> bytes:
        """16 octets."""

    def close(self) -> None:
        """
        Leave the domain; endpoints and graph are to be closed before. Closing again does nothing.
        """

class DdsWriter:
    """The sending end of a DDS topic."""

    def __init__(self, participant: DdsParticipant, topic_name: str, type_name: str, qos: tuple[int, int, int, int, int, int, int, int], user_data: bytes) -> None:
        """
        Offer a topic by its names on the wire; `qos` is a resolved tfloom.rmw.qos.QoS.
        """

    @property
    def gid(self) -> bytes:
        """16 octets."""

    def write(self, data: bytes) -> None:
        """Send a sample: encapsulation header 00 01 xx xx and little-endian CDR."""

    def matched_count(self) -> int:
        """Return how many readers are connected now."""

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""

class DdsReader:
    """The receiving end of a DDS topic."""

    def __init__(self, participant: DdsParticipant, topic_name: str, type_name: str, qos: tuple[int, int, int, int, int, int, int, int], user_data: bytes) -> None:
        """
        Ask for a topic by its names on the wire; `qos` is a resolved tfloom.rmw.qos.QoS.
        """

    @property
    def gid(self) -> bytes:
        """16 octets."""

    def notify(self, queue: ReadyQueue | None, token: int) -> None:
        """Post `token` to `queue` when there is something to take; None ends it."""

    def take(self) -> tuple[bytes, int, int, bytes] | None:
        """
        Remove the oldest sample: (data, source stamp, received stamp, gid), or None.
        """

    def feed(self, sink: Sink) -> None:
        """Push every sample into `sink` from now on, on a thread without Python."""

    def matched_count(self) -> int:
        """Return how many writers are connected now."""

    def close(self) -> None:
        """
        Leave the topic; neither queue nor sink are touched afterwards. Closing again does nothing.
        """

class DdsGraph:
    """What has been discovered on a DDS domain."""

    def __init__(self, participant: DdsParticipant, topic_name: str, type_name: str, qos: tuple[int, int, int, int, int, int, int, int], user_data: bytes) -> None:
        """
        Listen; the names are those of the topic in which participants list their nodes.
        """

    def snapshot(self) -> tuple[list[tuple[bytes, bytes, bytes]], list[tuple[bytes, bytes, bool, bytes, bytes, bytes, tuple[int, int, int, int, int, int, int, int]]]]:
        """
        Return participants (gid, user data, node list) and endpoints (gid, participant's gid, whether a writer, topic, type, user data, qos), texts as the bytes that came.
        """

    def changes(self) -> int:
        """Return a number that grows with each change."""

    def notify(self, queue: ReadyQueue | None, token: int) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""

    def close(self) -> None:
        """Stop listening. Closing again does nothing."""

class MessageBase:
    """The native part of `tfloom.rosidl.message.Message`."""

    def __setattr__(self, name, value, /):
        """Implement setattr(self, name, value)."""

    def __delattr__(self, name, /):
        """Implement delattr(self, name)."""

    def __init__(self, /, *args, **kwargs):
        """Initialize self.  See help(type(self)) for accurate signature."""

def check_fields_by_default(value: bool) -> None:
    """
    Set whether messages check what is assigned to their fields, where `check_fields` is not given.
    """

class Plan:
    """
    What the codec knows of a message class: its fields and where they lie.
    """

    def __init__(self, message_class: type, name: str) -> None:
        """Start a plan that has no fields yet."""

    def add_field(self, name: str, kind: str, shape: str, count: int, string_bound: int, message_class: object | None, initial: object | None, copies: bool, empty: object | None) -> None:
        """
        Add the next field.

        `kind` is a primitive's name or 'message', `shape` '', 'array', 'bounded' or 'unbounded'. `initial` is its default, which `copies` says to copy for each message. `empty` is a numeric array as it is before anything is read into it.
        """

def encode(message: object) -> bytes:
    """
    Give a message as encapsulation header and CDR, little-endian, not padded.
    """

def decode(message_class: type, data: object) -> Any:
    """Build a message of `message_class` from encapsulation header and CDR."""

def set_message_hooks(compile: object, convert: object, check: object, check_names: object, encode_error: object, decode_error: object) -> None:
    """
    Say how classes are compiled, arrays converted and fields checked, and which errors the codec raises.
    """
