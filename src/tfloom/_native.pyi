"""The compiled core of tfloom: numbers, ids and bytes."""

from collections.abc import Callable, Sequence
from typing import Annotated, Any

import numpy
import numpy.typing
from numpy.typing import NDArray


def block_gil_reacquire_at_exit() -> None:
    """
    Block every other thread that reacquires the GIL after a native call, from now on.

    For the end of the program, because Python would end such threads, and the process with them. Registered with `atexit`; calling it again does nothing.
    """

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

    def matched_count(self) -> int:
        """Return how many peers are connected now."""

    def matched(self) -> list[tuple[bytes, bytes]]:
        """Return the gid and the user data of each peer that is connected now."""

    def notify_event(self, event: int, queue: ReadyQueue | None, token: int) -> None:
        """
        Post `token` to `queue` when `event` (tfloom.rmw.events.Event) may have news; None ends it.
        """

    def take_event(self, event: int) -> tuple[int, int, int, int] | None:
        """
        Return the fields of the event's status, padded with zeros, or None if nothing has changed.
        """

    def write(self, data: bytes) -> None:
        """Send a sample: encapsulation header 00 01 xx xx and little-endian CDR."""

    def assert_liveliness(self) -> None:
        """Say that this writer is alive."""

    def wait_for_acks(self, timeout_ns: int) -> bool:
        """
        Wait until all reliable readers have all that was written; False on a timeout.
        """

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

    def matched_count(self) -> int:
        """Return how many peers are connected now."""

    def matched(self) -> list[tuple[bytes, bytes]]:
        """Return the gid and the user data of each peer that is connected now."""

    def notify_event(self, event: int, queue: ReadyQueue | None, token: int) -> None:
        """
        Post `token` to `queue` when `event` (tfloom.rmw.events.Event) may have news; None ends it.
        """

    def take_event(self, event: int) -> tuple[int, int, int, int] | None:
        """
        Return the fields of the event's status, padded with zeros, or None if nothing has changed.
        """

    def notify(self, queue: ReadyQueue | None, token: int) -> None:
        """Post `token` to `queue` when there is something to take; None ends it."""

    def take(self) -> tuple[bytes, int, int, bytes] | None:
        """
        Remove the oldest sample: (data, source stamp, received stamp, gid), or None.
        """

    def feed(self, sink: Sink) -> None:
        """Push every sample into `sink` from now on, on a thread without Python."""

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

def complete_plan(plan: Plan) -> None:
    """
    Complete a plan after its last field: its class's objects are made and freed by it from now on.
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

class Transform:
    """
    A rigid transform, immutable: parent_from_child takes points of the child into the parent.

    `a_from_c = a_from_b @ b_from_c`: neighbours cancel.
    """

    def __init__(self, translation: Sequence[float] = (0.0, 0.0, 0.0), rotation_xyzw: Sequence[float] = (0.0, 0.0, 0.0, 1.0)) -> None:
        """
        Make one of a position [m] and a quaternion of any length; ValueError if that is zero or not finite.
        """

    @staticmethod
    def from_rpy(roll_rad: float, pitch_rad: float, yaw_rad: float, translation: Sequence[float] = (0.0, 0.0, 0.0)) -> Transform:
        """Make one that turns about the fixed axes x, then y, then z [rad]."""

    @staticmethod
    def from_axis_angle(axis: Sequence[float], angle_rad: float, translation: Sequence[float] = (0.0, 0.0, 0.0)) -> Transform:
        """
        Make one that turns about `axis`, of any length, by `angle_rad`; ValueError if that is zero.
        """

    @staticmethod
    def from_matrix(matrix: object) -> Transform:
        """
        Make one of a matrix (4, 4) or (3, 4); ValueError if it's no rigid transform.
        """

    @staticmethod
    def from_scipy(rotation: object, translation: Sequence[float] = (0.0, 0.0, 0.0)) -> Transform:
        """Make one of a `scipy.spatial.transform.Rotation` and a position [m]."""

    @property
    def translation(self) -> tuple[float, float, float]:
        """Where the child's origin is in the parent [m]."""

    @property
    def rotation_xyzw(self) -> tuple[float, float, float, float]:
        """Unit quaternion x, y, z, w."""

    @property
    def rpy_rad(self) -> tuple[float, float, float]:
        """
        Roll, pitch, yaw about the fixed axes x, y, z [rad]; yaw is 0 where pitch is ±π/2.
        """

    @property
    def axis_angle(self) -> tuple[tuple[float, float, float], float]:
        """Unit axis, and angle from 0 to π [rad]."""

    def rows(self) -> list[tuple[float, float, float, float]]:
        """Return the four rows of the matrix, without numpy."""

    def matrix(self) -> numpy.typing.NDArray[numpy.float64]:
        """Return the matrix (4, 4), float64."""

    def to_scipy(self) -> Any:
        """Return the rotation as a `scipy.spatial.transform.Rotation`."""

    def inverse(self) -> Transform:
        """Return child_from_parent."""

    def interpolate(self, other: Transform, ratio: float) -> Transform:
        """
        Return what is between this (ratio 0) and `other` (1): position linearly, rotation by slerp.
        """

    def apply(self, point: Sequence[float]) -> tuple[float, float, float]:
        """Return a point of the child in the parent."""

    def __matmul__(self, other: Transform) -> Transform:
        """Return the composition."""

    def __eq__(self, other: object, /) -> bool:
        """Return whether all numbers are equal."""

    def __hash__(self) -> int:
        """Return a hash of the numbers."""

    def __reduce__(self) -> tuple[object, ...]:
        """Return what pickle wants."""

    def __repr__(self) -> str:
        """Return a call that makes it."""

class StampedTransform:
    """A lookup's answer: target_from_source at a time."""

    @property
    def stamp_ns(self) -> int:
        """Time [ns since epoch]."""

    @property
    def frame_id(self) -> str:
        """The target frame: data that went through the transform is in it."""

    @property
    def child_frame_id(self) -> str:
        """The source frame."""

    @property
    def translation(self) -> tuple[float, float, float]:
        """Where the source frame's origin is in the target frame [m]."""

    @property
    def rotation_xyzw(self) -> tuple[float, float, float, float]:
        """Unit quaternion x, y, z, w."""

    @property
    def transform(self) -> Transform:
        """The same as a value to compute with."""

    def __repr__(self) -> str: ...

class Buffer:
    """A tree of frames over time; see `tfloom.tf2.buffer.Buffer`."""

    def __init__(self, cache_time_ns: int | None = 10000000000) -> None:
        """Make an empty buffer; see `cache_time_ns`."""

    def lookup(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> StampedTransform:
        """
        Return target_from_source: the transform that takes data in `source_frame` into `target_frame`.

        Between two stored stamps, translation is interpolated linearly and rotation by slerp.

        Args:
            target_frame: Frame to express the data in.
            source_frame: Frame the data is in now.
            stamp_ns: Time of the transform [ns since epoch]; 0 is the newest time at which the whole chain is known.

        Returns:
            Translation [m] and unit quaternion (x, y, z, w), stamped with the time used.

        Raises:
            LookupException: a frame has never been heard of, or the chain is a loop.
            ConnectivityException: the two frames are in different trees.
            ExtrapolationException: `stamp_ns` lies outside the stored history.
            InvalidArgumentException: a frame's name is empty or starts with a slash.
        """

    def lookup_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str) -> StampedTransform:
        """
        Return target_from_source across time: the source at its stamp, by way of `fixed_frame`, which is taken not to move, into the target at its own.

        The answer has the target's stamp. Raises as `lookup` does.
        """

    def can(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> bool:
        """Return whether `lookup` with the same arguments would have an answer."""

    def can_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str) -> bool:
        """
        Return whether `lookup_full` with the same arguments would have an answer.
        """

    def find_obstacle(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> str | None:
        """Return why `can` is false, in tf2's words, or None."""

    def find_obstacle_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str) -> str | None:
        """Return why `can_full` is false, in tf2's words, or None."""

    def latest_common_time(self, target_frame: str, source_frame: str) -> int:
        """
        Return the newest time at which the whole chain is known [ns since epoch]; 0 if all of it is static.

        Raises LookupException, ConnectivityException or InvalidArgumentException as `lookup` does.
        """

    def wait(self, target_frame: str, source_frame: str, stamp_ns: int = 0, *, timeout_s: float) -> bool:
        """
        Wait until `lookup` has an answer: True. False after `timeout_s`, or as soon as it's clear that none will come, as the stamp is older than all that the cache keeps or a name is invalid.

        Wakes within a millisecond of the transform that was missing. Releases the GIL; signal handlers run, and what they raise is raised here.
        """

    def wait_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str, *, timeout_s: float) -> bool:
        """Wait until `lookup_full` has an answer; see `wait`."""

    def add_request(self, target_frame: str, source_frame: str, stamp_ns: int, callback: Callable[[int, bool], object]) -> int | None:
        """
        Ask to be called when `lookup` has an answer.

        `callback(handle, is_available)` is called once, on the thread that stored the transform; with False when the stamp has become older than the cache keeps.

        Returns the request's handle; 0 if there is an answer now, and None if there can never be one: then nothing is called.
        """

    def add_request_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str, callback: Callable[[int, bool], object]) -> int | None:
        """Ask to be called when `lookup_full` has an answer; see `add_request`."""

    def cancel_request(self, handle: int) -> bool:
        """Forget a request. Returns False if it has been answered, or never was."""

    def set(self, frame_id: str, child_frame_id: str, stamp_ns: int, translation: Sequence[float], rotation_xyzw: Sequence[float], authority: str = '', static: bool = False) -> bool:
        """
        Store parent_from_child at a time, or for all times if `static`.

        Args:
            frame_id: The parent frame; one leading slash is dropped, here and from the child.
            child_frame_id: The child frame.
            stamp_ns: When it was so [ns since epoch].
            translation: x, y, z of the child's origin in the parent [m].
            rotation_xyzw: Quaternion of any length but zero; it's stored with length one.
            authority: Who says so; the listings print it.
            static: Whether it holds at all times.

        Returns:
            False if it was rejected: a name is missing, both are the same, a number is NaN, the quaternion is zero, or it's older than the cache keeps. The reason goes to the log callback.
        """

    def clear(self) -> None:
        """
        Forget the history of all moving frames. Static transforms and frames' names stay.
        """

    def ignore_from(self, stamp_ns: int, duration_s: float) -> None:
        """
        Reject moving transforms from `stamp_ns` on, without a word, for `duration_s` by the wall clock.

        After a jump back in time: what was sent before it and comes after it.
        """

    @property
    def cache_time_ns(self) -> int | None:
        """
        How far back each frame's history reaches from its newest sample [ns]; None: without limit.
        """

    def set_log_callback(self, callback: Callable[[int, str], object] | None) -> None:
        """
        Set who is told of rejected data: `callback(severity, text)`, severity as in Python's logging.

        It's called on the thread that brought the data, at most once a second for each frame and kind of trouble; the line then says how many were held back. None: nobody.
        """

    def frame_names(self) -> list[str]:
        """Return the names of all frames, in order of first mention."""

    def has_frame(self, frame_id: str) -> bool:
        """Return whether a frame has been heard of."""

    def branches(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> tuple[list[str], list[str]]:
        """
        Return the frames whose data a lookup reads: the target's branch and the source's, each from the bottom up to below the root, or below the other end. Raises as `lookup` does.
        """

    def path(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> list[str]:
        """
        Return the frames that a lookup goes through, from the source to the target. Raises as `lookup` does.
        """

    def all_frames_as_string(self) -> str:
        """Return a line for each frame with a parent."""

    def all_frames_as_yaml(self, now_s: float = 0.0) -> str:
        """
        Return each frame's parent, broadcaster, rate and times as YAML; with its delay if `now_s` is given.
        """

    def all_frames_as_dot(self, now_s: float = 0.0) -> str:
        """Return the tree in graphviz's language."""

    def fill_many(self, target_frame: str, source_frame: str, stamps_ns: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, 7), order='C', device='cpu')], known: Annotated[NDArray[numpy.uint8], dict(shape=(None,), order='C', device='cpu')], strict: bool, workers: int) -> None:
        """
        Fill `out` (N, 7) with the transforms at `stamps_ns` (N,), `known` (N,) with whether there is one.

        `strict`: raises as `lookup` does for the first stamp without an answer, with its `index`.
        """

    def store_many(self, frame_id: str, child_frame_id: str, stamps_ns: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], rows: Annotated[NDArray[numpy.float64], dict(shape=(None, 7), order='C', device='cpu', writable=False)], authority: str) -> int:
        """
        Store `rows` (N, 7) at `stamps_ns` (N,); returns how many were not rejected.
        """

    def samples(self, frame_id: str, child_frame_id: str) -> tuple[bytearray, bytearray]:
        """
        Return the stamps (int64) and rows (7 float64 each) stored for an edge, as bytes.
        """

    def edges(self) -> list[Edge]:
        """Return each frame that has a parent, in order of first mention."""

    def remove_frame(self, frame_id: str) -> bool:
        """
        Forget a frame: its name, its transforms and those of its children to it.

        Returns False if it has never been heard of.
        """

    @property
    def memory(self) -> int:
        """What all histories take [octets]."""

    def deskew_float32(self, fixed_frame: str, source_frame: str, target_from_fixed: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], stamps_ns: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float32], dict(shape=(None, 3), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float32], dict(shape=(None, 3), order='C', device='cpu')], workers: int) -> None:
        """
        Write `points` (N, 3), each of `source_frame` at its of `stamps_ns` (N,), in `fixed_frame` and then moved by `target_from_fixed` (7,), into `out`.

        Raises as `lookup` does for the first stamp without an answer, with its `index`.
        """

    def deskew_float64(self, fixed_frame: str, source_frame: str, target_from_fixed: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], stamps_ns: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu')], workers: int) -> None:
        """
        Write `points` (N, 3), each of `source_frame` at its of `stamps_ns` (N,), in `fixed_frame` and then moved by `target_from_fixed` (7,), into `out`.

        Raises as `lookup` does for the first stamp without an answer, with its `index`.
        """

    def frozen(self) -> bytes:
        """Return all that is stored as the bytes of a frozen buffer."""

    def map_frozen(self, data: bytes | memoryview) -> None:
        """
        Take what `frozen` returned in place of all that is stored, and the cache time with it.

        `data` is not copied, and must not change. Raises ValueError, with nothing changed, where it's no frozen buffer.
        """

    def set_message(self, transform: object, authority: str, static: bool = False) -> bool:
        """
        Store a `geometry_msgs/msg/TransformStamped` of any class that has its fields; False if it's rejected.

        Raises TypeError where one of its parts lacks a member.
        """

    def lookup_message(self, target_frame: str, source_frame: str, time: object) -> Any:
        """
        Return what `lookup` does as a `geometry_msgs/msg/TransformStamped`.

        `time` has `nanoseconds`, or `sec` and `nanosec`; TypeError if it has neither.
        """

    def lookup_message_full(self, target_frame: str, target_time: object, source_frame: str, source_time: object, fixed_frame: str) -> Any:
        """
        Return what `lookup_full` does as a `geometry_msgs/msg/TransformStamped`; times as in `lookup_message`.
        """

    def tf_sink(self, authority: str, static: bool) -> TfSink:
        """
        Make a sink for `Reader.feed`: what it takes as `tf2_msgs/msg/TFMessage` is stored here.

        A message that can't be read is dropped whole, and the log callback is told.
        """

    def insert_cdr(self, data: bytes, authority: str = '', static: bool = False) -> int:
        """
        Store the transforms of a `tf2_msgs/msg/TFMessage`, given as encapsulation header and CDR.

        Returns how many were stored; the others were rejected, as by `set`. Raises ValueError, with nothing stored, where the bytes are no such message.
        """

class Edge:
    """A frame and what a buffer knows of its parent."""

    @property
    def child_frame_id(self) -> str:
        """The frame."""

    @property
    def frame_id(self) -> str:
        """Its parent, by the newest sample."""

    @property
    def authority(self) -> str:
        """Who set it last."""

    @property
    def is_static(self) -> bool:
        """Whether it holds at all times."""

    @property
    def oldest_ns(self) -> int:
        """Stamp of the oldest sample [ns since epoch]; 0 if static."""

    @property
    def newest_ns(self) -> int:
        """Stamp of the newest sample [ns since epoch]; 0 if static."""

    @property
    def sample_count(self) -> int:
        """How many samples there are."""

def move_points_float32(transform: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float32], dict(shape=(None, 3), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float32], dict(shape=(None, 3), order='C', device='cpu')]) -> None:
    """
    Write `transform` (7,) of `points` (N, 3) into `out`, which may be `points`.
    """

def move_points_float64(transform: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu')]) -> None:
    """
    Write `transform` (7,) of `points` (N, 3) into `out`, which may be `points`.
    """

def matrices(rows: Annotated[NDArray[numpy.float64], dict(shape=(None, 7), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, 4, 4), order='C', device='cpu')]) -> None:
    """Write the matrices of `rows` (N, 7) into `out` (N, 4, 4)."""

class TfSink(Sink):
    """Takes the samples of /tf or /tf_static into a buffer, without Python."""

    @property
    def message_count(self) -> int:
        """How many messages have come."""

    @property
    def dropped_count(self) -> int:
        """How many of them were unreadable, and dropped."""
