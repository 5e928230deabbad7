"""The compiled core of tfloom: numbers, ids and bytes."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Annotated, Any, ClassVar, overload

import numpy
import numpy.typing
from numpy.typing import NDArray


def block_waits_at_exit() -> None:
    """
    Block every other thread for ever at the end of its wait, and where Python would end it, from now on.

    Called at the end of the program, because Python would end threads inside native calls, and the process with them. Registered with `atexit`; calling it again does nothing.
    """

def block_if_ending() -> None:
    """
    Block this thread for ever if `block_waits_at_exit` was called on another one.
    """

class Sink:
    """
    A receiver of serialized samples that needs no Python; see `Reader.feed`.
    """

    def push(self, data: bytes, source_stamp_ns: int, received_stamp_ns: int, publisher_gid: bytes) -> None:
        """
        Push one sample: encapsulation header and CDR, stamps [ns since epoch], 16 bytes of gid.
        """

    def forget(self, publisher_gid: bytes) -> None:
        """Forget what is stored for a publisher that has left."""

    def notify(self, queue: ReadyQueue | None, token: int) -> None:
        """
        Post `token` to `queue` after a push, for waits with `quiet` only; None ends it.

        Post at once if there was a push since `take_pushed`.
        """

    def take_pushed(self) -> bool:
        """Return whether a sample was pushed since the last call."""

class SampleQueue(Sink):
    """A sink that stores the newest samples until Python takes them."""

    def __init__(self, depth: int) -> None: ...

    def take(self) -> list[tuple[bytes, int, int, bytes]]:
        """
        Remove and return all samples, each as (data, source stamp, received stamp, gid).
        """

    def pushed(self) -> int:
        """Return how many samples have ever been pushed."""

class ReadyQueue:
    """
    A queue of tokens of entities that are ready: any thread may post, one thread waits.
    """

    def __init__(self) -> None: ...

    def post(self, token: int) -> None:
        """
        Post a token. A token that is posted again before it is taken is taken once.
        """

    def wait(self, timeout_ns: int, quiet: bool = False) -> list[int]:
        """
        Wait for tokens and take all of them, in order of first posting; tokens of sinks only if `quiet`.

        Does not wait if the timeout is 0, and waits without limit if it is negative. Returns an empty list on a timeout. Releases the GIL. A signal's Python handler runs at once, and its exception is raised here.
        """

def open_dds_library(path: str, is_common_build: bool = False) -> str:
    """
    Open the libddsc at `path`, once, and return its version, empty if it records none. It passes a self-test first, unless it is one of PyPI's builds (`is_common_build`) in a version that was tried. Raise RuntimeError if it can't be used.
    """

def intercept_dds_packets(path: str) -> str:
    """
    Translate services for peers on Fast DDS in the packets of the libddsc at `path`. Return the reason why this can't be done here; empty if it is done.
    """

def dds_knows_address(gid: bytes) -> bool:
    """
    Return whether an address of the participant of this endpoint is known.
    """

def dds_read_versions() -> None:
    """
    From here on, note the versions of DDS that participants announce, where `intercept_dds_packets` is done.
    """

def dds_version(gid: bytes) -> str:
    """
    Return the version of DDS that this participant has announced, as 11.0.1; empty if it has not.
    """

def dds_inline_client(key: bytes) -> bytes | None:
    """
    Return the gid that awaits the responses for a client on Fast DDS, by the 8 bytes in its headers; None for others.
    """

def test_dds_library(path: str) -> None:
    """
    Run the self-test of the libddsc at `path`, whichever version it is. Raise RuntimeError with what differs.
    """

class DdsParticipant:
    """This process on one DDS domain."""

    def __init__(self, library_path: str, domain_id: int, config: str, user_data: bytes, is_local: bool = False) -> None:
        """
        Join a domain with the libddsc at `library_path`, Cyclone's XML `config` and the published `user_data`. With `is_local`, bind the domain's sockets to the loopback interface where the system allows it.
        """

    @property
    def gid(self) -> bytes:
        """16 bytes."""

    @property
    def loopback_failure(self) -> str:
        """
        Why the domain's sockets are not bound as `is_local` requests; empty if they are, or without `is_local`.
        """

    def close(self) -> None:
        """
        Leave the domain, after endpoints and graph are closed. Closing again does nothing.
        """

class DdsError(RuntimeError):
    pass

class DdsWriter:
    """A writer of a DDS topic."""

    def __init__(self, participant: DdsParticipant, topic_name: str, type_name: str, qos: tuple[int, int, int, int, int, int, int, int], user_data: bytes, waits: bool = True) -> None:
        """
        Create a writer of a topic, given by its names on the wire; `qos` is a resolved tfloom.rmw.qos.QoS. `waits` is whether a write waits for readers that lag behind.
        """

    @property
    def gid(self) -> bytes:
        """16 bytes."""

    def matched_count(self) -> int:
        """Return how many peers are matched now."""

    def matched(self) -> list[tuple[bytes, bytes]]:
        """Return the gid and the user data of each peer that is matched now."""

    def notify_event(self, event: int, queue: ReadyQueue | None, token: int) -> None:
        """
        Post `token` to `queue` when the status of `event` (tfloom.rmw.events.Event) may have changed; None ends it.
        """

    def take_event(self, event: int) -> tuple[int, int, int, int] | None:
        """
        Return the fields of the event's status, padded with zeros, or None if nothing has changed.
        """

    def write(self, data: bytes) -> bool:
        """
        Send a sample: encapsulation header 00 01 xx xx and little-endian CDR. Return False if readers lag behind and this writer doesn't wait for them: then nothing was sent.
        """

    def write_message(self, message: object) -> bool:
        """
        Encode and send a message. Its large arrays are copied once. For a writer that is an end of no service.
        """

    def join_service(self, reader: DdsReader, service: str, client: bytes | None) -> None:
        """
        Become an end of a service, with the reader of the other topic: a client whose headers have the 8 bytes `client`, or a server. To be called before the first sample is written or taken.
        """

    def assert_liveliness(self) -> None:
        """Signal that this writer is alive."""

    def probe(self) -> None:
        """
        Send a message that readers acknowledge and drop: the end of an instance that does not exist.
        """

    def wait_for_acks(self, timeout_ns: int) -> bool:
        """
        Wait until all reliable readers have acknowledged all samples. Return False on a timeout.
        """

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""

class DdsReader:
    """A reader of a DDS topic."""

    def __init__(self, participant: DdsParticipant, topic_name: str, type_name: str, qos: tuple[int, int, int, int, int, int, int, int], user_data: bytes) -> None:
        """
        Create a reader of a topic, given by its names on the wire; `qos` is a resolved tfloom.rmw.qos.QoS.
        """

    @property
    def gid(self) -> bytes:
        """16 bytes."""

    def matched_count(self) -> int:
        """Return how many peers are matched now."""

    def matched(self) -> list[tuple[bytes, bytes]]:
        """Return the gid and the user data of each peer that is matched now."""

    def notify_event(self, event: int, queue: ReadyQueue | None, token: int) -> None:
        """
        Post `token` to `queue` when the status of `event` (tfloom.rmw.events.Event) may have changed; None ends it.
        """

    def take_event(self, event: int) -> tuple[int, int, int, int] | None:
        """
        Return the fields of the event's status, padded with zeros, or None if nothing has changed.
        """

    def notify(self, queue: ReadyQueue | None, token: int) -> None:
        """Post `token` to `queue` when there are samples to take; None ends it."""

    def take(self) -> tuple[bytes, int, int, bytes] | None:
        """
        Remove the oldest sample: (data, source stamp, received stamp, gid), or None.
        """

    def take_decoded(self, message_class: type) -> tuple[Any, int, int, bytes] | None:
        """
        As `take`; but a large sample that can be decoded is a message of `message_class` instead of bytes.
        """

    def announce_filter(self, expression: str, parameters: list[str]) -> None:
        """
        Tell writers which samples are wanted, in DDS's subset of SQL; an empty expression accepts all.
        """

    def feed(self, sink: Sink) -> None:
        """Push every further sample into `sink`, on a thread without Python."""

    def close(self) -> None:
        """
        Leave the topic. Afterwards neither queue nor sink is used. Closing again does nothing.
        """

class DdsGraph:
    """The participants and endpoints discovered on a DDS domain."""

    def __init__(self, participant: DdsParticipant, topic_name: str, type_name: str, qos: tuple[int, int, int, int, int, int, int, int], user_data: bytes) -> None:
        """
        Start to listen. The names are those of the topic in which participants list their nodes.
        """

    def snapshot(self) -> tuple[list[tuple[bytes, bytes, bytes]], list[tuple[bytes, bytes, bool, bytes, bytes, bytes, tuple[int, int, int, int, int, int, int, int]]]]:
        """
        Return participants (gid, user data, node list) and endpoints (gid, participant's gid, whether a writer, topic, type, user data, qos), texts as the received bytes.
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
    The codec's description of a message class: its fields and their positions.
    """

    def __init__(self, message_class: type, name: str) -> None:
        """Create a plan without fields."""

    def add_field(self, name: str, kind: str, shape: str, count: int, string_bound: int, message_class: object | None, initial: object | None, copies: bool, empty: object | None) -> None:
        """
        Add the next field.

        `kind` is a primitive's name or 'message'; `shape` is '', 'array', 'bounded' or 'unbounded'. `initial` is the default; with `copies`, each message gets a copy of it. `empty` is the array that is copied and filled when a numeric array is decoded.
        """

def complete_plan(plan: Plan) -> None:
    """
    Complete a plan after its last field. From now on it allocates and frees the objects of its class.
    """

def encode(message: object) -> bytes:
    """
    Return a message as encapsulation header and CDR, little-endian, not padded.
    """

def decode(message_class: type, data: object) -> Any:
    """
    Return a message of `message_class`, decoded from encapsulation header and CDR.
    """

def set_message_hooks(compile: object, convert: object, check: object, check_names: object, warn_names: object, encode_error: object, decode_error: object) -> None:
    """
    Set the functions that compile classes, convert arrays and check fields, and the errors that the codec raises.
    """

class HeaderSink(Sink):
    """
    Counts the frames in the headers of a topic's messages, by publisher.

    The messages begin with a `std_msgs/msg/Header`; nothing else is read.
    """

    def __init__(self) -> None: ...

    def uses(self) -> list[tuple[bytes, str, int]]:
        """
        Return the gid of a publisher (16 bytes), a frame id, and the number of messages, for all of these.
        """

    @property
    def unreadable_count(self) -> int:
        """Number of messages that have no such header."""

class Transform:
    """
    A rigid transform, immutable: parent_from_child takes points of the child into the parent.

    `a_from_c = a_from_b @ b_from_c`: neighbours cancel.
    """

    def __init__(self, translation: Sequence[float] = (0.0, 0.0, 0.0), rotation_xyzw: Sequence[float] = (0.0, 0.0, 0.0, 1.0)) -> None:
        """
        Create one from a position [m] and a quaternion of any length.

        Raises ValueError if the quaternion is zero or not finite.
        """

    @staticmethod
    def from_rpy(roll_rad: float, pitch_rad: float, yaw_rad: float, translation: Sequence[float] = (0.0, 0.0, 0.0)) -> Transform:
        """
        Create one from rotations about the fixed axes x, then y, then z [rad].
        """

    @staticmethod
    def from_axis_angle(axis: Sequence[float], angle_rad: float, translation: Sequence[float] = (0.0, 0.0, 0.0)) -> Transform:
        """
        Create one from a rotation about `axis`, of any length, by `angle_rad`.

        Raises ValueError if the axis is zero, unless the angle is zero too.
        """

    @staticmethod
    def from_matrix(matrix: object) -> Transform:
        """
        Create one from a matrix (4, 4) or (3, 4); raises ValueError if it is not a rigid transform.
        """

    @staticmethod
    def from_scipy(rotation: object, translation: Sequence[float] = (0.0, 0.0, 0.0)) -> Transform:
        """
        Create one from a `scipy.spatial.transform.Rotation` and a position [m].
        """

    @property
    def translation(self) -> tuple[float, float, float]:
        """Position of the child's origin in the parent [m]."""

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
        Return the transform between this (ratio 0) and `other` (1): position linearly, rotation by slerp.
        """

    def apply(self, point: Sequence[float]) -> tuple[float, float, float]:
        """Return a point, given in the child, in the parent."""

    def __matmul__(self, other: Transform) -> Transform:
        """Return the composition."""

    def __eq__(self, other: object, /) -> bool:
        """Return whether all numbers are equal."""

    def __hash__(self) -> int:
        """Return a hash of the numbers."""

    def __reduce__(self) -> tuple[object, ...]:
        """Return the class and the arguments for pickle."""

    def __repr__(self) -> str:
        """Return a call that creates an equal value."""

class StampedTransform:
    """The result of a lookup: target_from_source at a time."""

    @property
    def stamp_ns(self) -> int:
        """Time [ns since epoch]."""

    @property
    def frame_id(self) -> str:
        """The target frame, in which transformed data is expressed."""

    @property
    def child_frame_id(self) -> str:
        """The source frame."""

    @property
    def translation(self) -> tuple[float, float, float]:
        """Position of the source frame's origin in the target frame [m]."""

    @property
    def rotation_xyzw(self) -> tuple[float, float, float, float]:
        """Unit quaternion x, y, z, w."""

    @property
    def transform(self) -> Transform:
        """The translation and rotation."""

    def __repr__(self) -> str: ...

class Buffer:
    """A tree of frames over time; see `tfloom.tf2.buffer.Buffer`."""

    def __init__(self, cache_time_ns: int | None = 10000000000) -> None:
        """Create an empty buffer; see `cache_time_ns`."""

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
            LookupException: a frame is unknown, or the chain is a loop.
            ConnectivityException: the two frames are in different trees.
            ExtrapolationException: `stamp_ns` lies outside the stored history.
            InvalidArgumentException: a frame's name is empty or starts with a slash.
        """

    def lookup_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str) -> StampedTransform:
        """
        Return target_from_source between two times: from the source at `source_stamp_ns`, through `fixed_frame`, which is assumed not to move, to the target at `target_stamp_ns`.

        The result is stamped with the target's time. Raises as `lookup` does.
        """

    def can(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> bool:
        """Return whether `lookup` with the same arguments would succeed."""

    def can_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str) -> bool:
        """Return whether `lookup_full` with the same arguments would succeed."""

    def find_obstacle(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> str | None:
        """
        Return tf2's text of the reason why `can` is false, or None if it is true.
        """

    def find_obstacle_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str) -> str | None:
        """
        Return tf2's text of the reason why `can_full` is false, or None if it is true.
        """

    def latest_common_time(self, target_frame: str, source_frame: str) -> int:
        """
        Return the newest time at which the whole chain is known [ns since epoch]; 0 if all of it is static.

        Raises LookupException, ConnectivityException or InvalidArgumentException as `lookup` does.
        """

    def wait(self, target_frame: str, source_frame: str, stamp_ns: int = 0, *, timeout_s: float) -> bool:
        """
        Wait until `lookup` would succeed, and return True.

        Returns False after `timeout_s`, or as soon as it can never succeed because the stamp is older than the cache keeps or a name is invalid.

        Returns within a millisecond after the missing transform is stored. Releases the GIL. Signal handlers run, and their exceptions are raised here.
        """

    def wait_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str, *, timeout_s: float) -> bool:
        """Wait until `lookup_full` would succeed; see `wait`."""

    def add_request(self, target_frame: str, source_frame: str, stamp_ns: int, callback: Callable[[int, bool], object]) -> int | None:
        """
        Call `callback(handle, is_available)` once when `lookup` would succeed.

        It is called on the thread that stores the transform. `is_available` is False if the stamp has become older than the cache keeps.

        Returns the request's handle; or, without a call, 0 if `lookup` succeeds now and None if it never can.
        """

    def add_request_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, source_stamp_ns: int, fixed_frame: str, callback: Callable[[int, bool], object]) -> int | None:
        """
        Call `callback(handle, is_available)` once when `lookup_full` would succeed; see `add_request`.
        """

    def cancel_request(self, handle: int) -> bool:
        """Cancel a request. Return False if it is completed or unknown."""

    def set(self, frame_id: str, child_frame_id: str, stamp_ns: int, translation: Sequence[float], rotation_xyzw: Sequence[float], authority: str = '', static: bool = False) -> bool:
        """
        Store parent_from_child at a time, or for all times if `static`.

        Args:
            frame_id: The parent frame. One leading slash is dropped, here and in the child's name.
            child_frame_id: The child frame.
            stamp_ns: Time of the transform [ns since epoch].
            translation: x, y, z of the child's origin in the parent [m].
            rotation_xyzw: Quaternion of any length but zero; it is normalised.
            authority: Name of the publisher, for the listings.
            static: Whether it is valid at all times.

        Returns:
            False if it was rejected because a name is missing, both are the same, a number is NaN, the quaternion is zero, or it is older than the cache keeps. The log callback is called with the reason.
        """

    def clear(self) -> None:
        """
        Clear the history of all moving frames. Static transforms and frames' names stay.
        """

    def ignore_from(self, stamp_ns: int, duration_s: float) -> None:
        """
        Reject moving transforms from `stamp_ns` on, without logging them, for `duration_s` of real time.

        For a jump back in time: rejects transforms sent before it and received after it.
        """

    @property
    def cache_time_ns(self) -> int | None:
        """
        Length of each frame's history, back from its newest sample [ns]; None if without limit.
        """

    def set_log_callback(self, callback: Callable[[int, str], object] | None) -> None:
        """
        Set the function called for rejected data: `callback(severity, text)`, severity as in Python's logging.

        It is called on the thread that inserts the data, at most once a second for each frame and kind of error; the next text then states how many were held back. None: no function.
        """

    def frame_names(self) -> list[str]:
        """Return the names of all frames, in order of first mention."""

    def has_frame(self, frame_id: str) -> bool:
        """Return whether a frame is known."""

    def branches(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> tuple[list[str], list[str]]:
        """
        Return the frames whose data a lookup reads: the target's branch and the source's, each from the bottom up to below the root, or below the other end. Raises as `lookup` does.
        """

    def path(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> list[str]:
        """
        Return the frames of a lookup's chain, from the source to the target. Raises as `lookup` does.
        """

    def all_frames_as_string(self) -> str:
        """Return a line for each frame with a parent."""

    def all_frames_as_yaml(self, now_s: float = 0.0) -> str:
        """
        Return each frame's parent, broadcaster, rate and times as YAML, and its delay if `now_s` is given.
        """

    def all_frames_as_dot(self, now_s: float = 0.0) -> str:
        """Return the tree in graphviz's DOT language."""

    def fill_many(self, target_frame: str, source_frame: str, stamps_ns: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, 7), order='C', device='cpu')], known: Annotated[NDArray[numpy.uint8], dict(shape=(None,), order='C', device='cpu')], strict: bool, workers: int) -> None:
        """
        Fill `out` (N, 7) with the transforms at `stamps_ns` (N,), `known` (N,) with whether there is one.

        With `strict`, raises as `lookup` does for the first stamp that fails, with its `index`.
        """

    def store_many(self, frame_id: str, child_frame_id: str, stamps_ns: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], positions: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu', writable=False)], rotations_xyzw: Annotated[NDArray[numpy.float64], dict(shape=(None, 4), order='C', device='cpu', writable=False)], authority: str) -> int:
        """
        Store `positions` (N, 3) and `rotations_xyzw` (N, 4) at `stamps_ns` (N,). Return how many were stored.
        """

    def samples(self, frame_id: str, child_frame_id: str) -> tuple[bytearray, bytearray]:
        """
        Return the stamps (int64) and rows (7 float64 each) stored for an edge, as bytes.
        """

    def edges(self) -> list[Edge]:
        """Return each frame that has a parent, in order of first mention."""

    def remove_frame(self, frame_id: str) -> bool:
        """
        Remove a frame: its name, its transforms and those of its children to it.

        Returns False if it is unknown.
        """

    @property
    def memory(self) -> int:
        """Memory of all histories [bytes]."""

    def deskew_float32(self, fixed_frame: str, source_frame: str, target_from_fixed: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], stamps_ns: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float32], dict(shape=(None, 3), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float32], dict(shape=(None, 3), order='C', device='cpu')], workers: int) -> None:
        """
        Transform `points` (N, 3) from `source_frame` at `stamps_ns` (N,) into `fixed_frame`, then by `target_from_fixed` (7,), and write them into `out`.

        Raises as `lookup` does for the first stamp that fails, with its `index`.
        """

    def deskew_float64(self, fixed_frame: str, source_frame: str, target_from_fixed: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], stamps_ns: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu')], workers: int) -> None:
        """
        Transform `points` (N, 3) from `source_frame` at `stamps_ns` (N,) into `fixed_frame`, then by `target_from_fixed` (7,), and write them into `out`.

        Raises as `lookup` does for the first stamp that fails, with its `index`.
        """

    def frozen(self) -> bytes:
        """Return the whole contents as the bytes of a frozen buffer."""

    def map_frozen(self, data: bytes | memoryview) -> None:
        """
        Replace the whole contents and the cache time by those of a frozen buffer.

        `data` is what `frozen` returned. It is not copied, and must not change. Raises ValueError, with nothing changed, if it is not a frozen buffer.
        """

    def set_message(self, transform: object, authority: str, static: bool = False) -> bool:
        """
        Store a `geometry_msgs/msg/TransformStamped` of any class with its fields. Return False if it is rejected.

        Raises TypeError if a field lacks a member.
        """

    def lookup_message(self, target_frame: str, source_frame: str, time: object) -> Any:
        """
        Return the result of `lookup` as a `geometry_msgs/msg/TransformStamped`.

        `time` has `nanoseconds`, or `sec` and `nanosec`; TypeError if it has neither.
        """

    def lookup_message_full(self, target_frame: str, target_time: object, source_frame: str, source_time: object, fixed_frame: str) -> Any:
        """
        Return the result of `lookup_full` as a `geometry_msgs/msg/TransformStamped`; see `lookup_message`.
        """

    def tf_sink(self, authority: str, static: bool, on_held: Callable[[list[int], str, int, int], object] | None = None) -> TfSink:
        """
        Return a sink for `Reader.feed` that stores samples of `tf2_msgs/msg/TFMessage` here.

        An unreadable message is dropped whole, and the log callback is called. With `on_held`, a moving transform stamped further ahead of now than the cache is long, and than its publisher's former ones, is held until that publisher confirms it by a later one. `on_held(gid, child_frame_id, stamp_ns, now_ns)` is called for the first one of each publisher, on any thread.
        """

    def insert_cdr(self, data: bytes, authority: str = '', static: bool = False) -> int:
        """
        Store the transforms of a `tf2_msgs/msg/TFMessage`, given as encapsulation header and CDR.

        Returns how many were stored; the others were rejected, as by `set`. Raises ValueError, with nothing stored, if the bytes are not such a message.
        """

class Edge:
    """A frame, its newest parent, and the range of its history."""

    @property
    def child_frame_id(self) -> str:
        """The frame."""

    @property
    def frame_id(self) -> str:
        """Its parent, by the newest sample."""

    @property
    def authority(self) -> str:
        """Authority of the last insert."""

    @property
    def is_static(self) -> bool:
        """Whether it is valid at all times."""

    @property
    def oldest_ns(self) -> int:
        """Stamp of the oldest sample [ns since epoch]; 0 if static."""

    @property
    def newest_ns(self) -> int:
        """Stamp of the newest sample [ns since epoch]; 0 if static."""

    @property
    def sample_count(self) -> int:
        """Number of samples."""

def move_points_float32(transform: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float32], dict(shape=(None, 3), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float32], dict(shape=(None, 3), order='C', device='cpu')]) -> None:
    """
    Apply `transform` (7,) to `points` (N, 3) and write them into `out`, which may be `points`.
    """

def move_cloud_float32(transform: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], bytes: Annotated[NDArray[numpy.uint8], dict(shape=(None,), order='C', device='cpu')], shape: Sequence[int], steps: Sequence[int], offsets: Sequence[int]) -> None:
    """
    Apply `transform` (7,) to the points of a cloud, in place. Point (row, column) of `shape` begins at row * steps[0] + column * steps[1], and has x, y and z at `offsets` from there, in this machine's byte order.

    Raises ValueError if they are not all within `bytes` (N,).
    """

def move_points_float64(transform: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu')]) -> None:
    """
    Apply `transform` (7,) to `points` (N, 3) and write them into `out`, which may be `points`.
    """

def move_cloud_float64(transform: Annotated[NDArray[numpy.float64], dict(shape=(7), order='C', device='cpu', writable=False)], bytes: Annotated[NDArray[numpy.uint8], dict(shape=(None,), order='C', device='cpu')], shape: Sequence[int], steps: Sequence[int], offsets: Sequence[int]) -> None:
    """
    Apply `transform` (7,) to the points of a cloud, in place. Point (row, column) of `shape` begins at row * steps[0] + column * steps[1], and has x, y and z at `offsets` from there, in this machine's byte order.

    Raises ValueError if they are not all within `bytes` (N,).
    """

def use_wide_vectors(are_wide: bool) -> bool:
    """
    Compute lookups at many stamps, and clouds, in vectors of four numbers, if this processor has them, or in those that every processor has. Return whether they are the wide ones. For tests: the wide ones are the default.
    """

def matrices(rows: Annotated[NDArray[numpy.float64], dict(shape=(None, 7), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, 4, 4), order='C', device='cpu')]) -> None:
    """Write the matrices of `rows` (N, 7) into `out` (N, 4, 4)."""

class TfSink(Sink):
    """
    A sink that stores the samples of /tf or /tf_static in a buffer, without Python.
    """

    @property
    def message_count(self) -> int:
        """Number of messages received."""

    @property
    def dropped_count(self) -> int:
        """Number of unreadable messages, which were dropped."""

    @property
    def held_count(self) -> int:
        """Number of transforms that are held now."""

    @property
    def publisher_count(self) -> int:
        """
        Number of publishers whose stamps are remembered, if transforms are held.
        """

    def set_simulated_time(self, now_ns: int | None) -> None:
        """
        Set the time with which stamps are compared [ns since epoch]; 0: unknown, nothing is held; None: the system's.
        """

    def forget_all(self) -> None:
        """
        Drop what is held, and forget all publishers' stamps, after a jump in time.
        """

class Spread:
    """
    Number, mean, deviation and extremes of values; all are 0 without a value.
    """

    @property
    def count(self) -> int:
        """Number of values."""

    @property
    def mean(self) -> float:
        """Their mean."""

    @property
    def least(self) -> float:
        """The least."""

    @property
    def greatest(self) -> float:
        """The greatest."""

    @property
    def deviation(self) -> float:
        """Their standard deviation, of the population."""

class Step:
    """
    The motion between two consecutive transforms, in order of their stamps.
    """

    @property
    def stamp_ns(self) -> int:
        """Stamp of the later one [ns since epoch]."""

    @property
    def elapsed_ns(self) -> int:
        """Time between their stamps [ns]; 0: there was no step, or it is static."""

    @property
    def distance(self) -> float:
        """Translation between them [m]."""

    @property
    def angle_rad(self) -> float:
        """Rotation between them, 0 to pi [rad]."""

    @property
    def speed(self) -> float:
        """Distance by time [m/s]; 0 if `elapsed_ns` is 0."""

class EdgeStatistics:
    """
    What is known of the transforms that one publisher has sent for one edge.

    Stamps and times of receipt are [ns since epoch].
    """

    @property
    def count(self) -> int:
        """Number of transforms."""

    @property
    def first_stamp_ns(self) -> int:
        """The stamp received first."""

    @property
    def last_stamp_ns(self) -> int:
        """The stamp received last."""

    @property
    def oldest_stamp_ns(self) -> int:
        """The oldest stamp."""

    @property
    def newest_stamp_ns(self) -> int:
        """The newest stamp."""

    @property
    def first_received_ns(self) -> int:
        """Time of the first receipt."""

    @property
    def last_received_ns(self) -> int:
        """Time of the last receipt."""

    @property
    def stamp_period(self) -> Spread:
        """
        Times from the newest stamp to a newer one [s]; steps back and repetitions are not counted.
        """

    @property
    def receipt_period(self) -> Spread:
        """Times between receipts [s]."""

    @property
    def delay(self) -> Spread:
        """
        Times from the stamp to now, at receipt [s]; negative: stamped ahead of now. Zero stamps are not counted.
        """

    @property
    def out_of_order(self) -> int:
        """Number of transforms older than the newest one."""

    @property
    def steps_back(self) -> int:
        """Number of transforms older than the one received before."""

    @property
    def repeated(self) -> int:
        """Number of moving transforms with the same stamp as the newest one."""

    @property
    def too_old(self) -> int:
        """
        Number of transforms older than the child's newest, from any publisher, by more than the cache time: a buffer rejects them.
        """

    @property
    def ahead(self) -> int:
        """Number of transforms stamped ahead of now."""

    @property
    def zero_stamps(self) -> int:
        """Number of transforms with the stamp 0."""

    @property
    def largest_step_back_ns(self) -> int:
        """
        The longest time by which a stamp was older than the newest one before it [ns].
        """

    @property
    def non_finite(self) -> int:
        """
        Number of transforms with a NaN or an infinity; they are in none of the figures that follow.
        """

    @property
    def worst_norm_error(self) -> float:
        """The greatest difference of a quaternion's length from 1."""

    @property
    def changes(self) -> int:
        """Number of transforms that differ from the one before."""

    @property
    def translation(self) -> tuple[float, float, float]:
        """
        Translation x, y, z of the newest transform [m]; of a static one, of the last.
        """

    @property
    def rotation_xyzw(self) -> tuple[float, float, float, float]:
        """Rotation x, y, z, w of the same transform."""

    @property
    def distance(self) -> Spread:
        """Distances of the steps [m]."""

    @property
    def cosine(self) -> Spread:
        """Cosines of half the angles of the steps."""

    @property
    def longest(self) -> Step:
        """The step of the greatest distance."""

    @property
    def widest(self) -> Step:
        """The step of the greatest angle."""

    @property
    def fastest(self) -> Step:
        """The step of the greatest speed."""

class TfTraffic:
    """What one publisher has sent on /tf, or on /tf_static."""

    @property
    def gid(self) -> bytes:
        """Its gid: 16 bytes."""

    @property
    def is_static(self) -> bool:
        """Whether this is on /tf_static."""

    @property
    def has_left(self) -> bool:
        """Whether it has left."""

    @property
    def messages(self) -> int:
        """Number of messages."""

    @property
    def transforms(self) -> int:
        """Number of transforms."""

    @property
    def bytes(self) -> int:
        """Bytes of the messages."""

    @property
    def unreadable(self) -> int:
        """Number of messages that are not a TFMessage."""

    @property
    def max_transforms(self) -> int:
        """The greatest number of transforms in one message."""

    @property
    def first_received_ns(self) -> int:
        """Time of the first receipt [ns since epoch]."""

    @property
    def last_received_ns(self) -> int:
        """Time of the last receipt [ns since epoch]."""

    @property
    def period(self) -> Spread:
        """Times between receipts of its messages [s]."""

    @property
    def transit(self) -> Spread:
        """
        Times from writing, by the publisher's clock, to receipt, by this machine's [s].
        """

class TfEdge:
    """One edge of one publisher."""

    @property
    def child(self) -> str:
        """The child frame."""

    @property
    def parent(self) -> str:
        """The parent frame."""

    @property
    def gid(self) -> bytes:
        """The publisher's gid: 16 bytes."""

    @property
    def is_static(self) -> bool:
        """Whether it came on /tf_static."""

    @property
    def statistics(self) -> EdgeStatistics:
        """Its figures."""

class TfChild:
    """A frame that was a child, on either topic and from any publisher."""

    @property
    def child(self) -> str:
        """The frame."""

    @property
    def parent(self) -> str:
        """Its parent in the transform received last."""

    @property
    def reparented(self) -> int:
        """
        Number of transforms whose parent was another than that of the child's former one.
        """

    @property
    def newest_stamp_ns(self) -> int:
        """Newest stamp of its moving transforms; 0: none."""

class TfSnapshot:
    """What an observer has recorded; each list is in order of first receipt."""

    @property
    def publishers(self) -> list[TfTraffic]:
        """The publishers."""

    @property
    def edges(self) -> list[TfEdge]:
        """The edges."""

    @property
    def children(self) -> list[TfChild]:
        """The child frames."""

    @property
    def unrecorded(self) -> int:
        """Number of transforms beyond the observer's limits."""

class TfObserverSink(Sink):
    """Passes the samples of one topic to an observer."""

    def accept_only(self, publishers: Sequence[bytes] | None) -> None:
        """
        Ignore the samples of all publishers but these, given by their gids; None: of none.
        """

class TfClockSink(Sink):
    """Passes the time on /clock to an observer."""

class TfObserver:
    """
    Statistics of all transforms on /tf and /tf_static, by publisher and edge.
    """

    def __init__(self, cache_time_ns: int = 10000000000) -> None: ...

    def sink(self, static: bool, buffer: Buffer | None = None) -> TfObserverSink:
        """
        Return a sink for `Reader.feed` that records samples of `tf2_msgs/msg/TFMessage` here.

        It also stores the transforms in `buffer`, if there is one, with the publisher's gid in hexadecimal as authority.
        """

    def clock_sink(self) -> TfClockSink:
        """
        Return a sink for `Reader.feed` that takes the simulated time from samples of `rosgraph_msgs/msg/Clock`.
        """

    def record(self, data: bytes, publisher_gid: bytes, received_ns: int, static: bool = False, ros1: bool = False, buffer: Buffer | None = None) -> bool:
        """
        Record a recorded message, and store its transforms in `buffer`, if there is one.

        `data` is a `tf2_msgs/msg/TFMessage`: encapsulation header and CDR, or ROS 1's form. Return whether it was readable.
        """

    def snapshot(self) -> TfSnapshot:
        """Return a copy of all that is recorded."""

    def clear(self) -> None:
        """Forget everything."""

    def simulated_time(self) -> int | None:
        """
        Return the time with which stamps are compared [ns since epoch]; 0: unknown; None: the time of receipt.
        """

    def set_simulated_time(self, now_ns: int | None) -> None:
        """
        Set the time with which stamps are compared [ns since epoch]; 0: unknown, delays are not recorded; None: the time of receipt.
        """

class Chunk:
    """
    Messages as MCAP message records, in the order in which they were pushed.
    """

    @property
    def start_ns(self) -> int:
        """Smallest log time [ns since epoch]."""

    @property
    def end_ns(self) -> int:
        """Greatest log time [ns since epoch]."""

    @property
    def message_count(self) -> int:
        """Number of messages; at least one."""

    @property
    def starts_file(self) -> bool:
        """Whether it is the first one of a new file."""

    @property
    def records(self) -> bytes:
        """The records."""

    def counts(self) -> list[tuple[int, int]]:
        """
        Return (channel, number of messages) for each channel that has messages, in order of channels.
        """

    def index(self, channel: int, shift: int) -> bytes:
        """
        Return a channel's entries of MCAP's message index, in order, with `shift` added to each offset.
        """

    def messages(self) -> list[tuple[int, int, int, bytes]]:
        """
        Return each message as (channel, log time [ns], publish time [ns], data).
        """

class ChunkSink(Sink):
    """A sink that pushes the samples of a topic into a ChunkQueue."""

class ChunkQueue:
    """
    Messages of a recording, gathered into chunks: any thread pushes, one takes.

    A full queue drops messages and counts them; a ring drops its oldest chunks instead.
    """

    def __init__(self, chunk_size: int, cache_size: int, duration_ns: int = 0, ring: bool = False) -> None: ...

    def push(self, channel: int, data: bytes, log_time_ns: int, publish_time_ns: int) -> bool:
        """Append a message; return False if the queue is paused, closed or full."""

    def take(self, timeout_ns: int) -> Chunk | None:
        """
        Remove and return the oldest complete chunk, or after the timeout the unfinished one; None if there is no message.
        """

    def wait(self, timeout_ns: int) -> None:
        """
        Wait until there is a complete chunk, the queue is closed, or the timeout.
        """

    def seal(self) -> None:
        """Complete the unfinished chunk."""

    def end_file(self) -> None:
        """
        Complete the unfinished chunk; the next one is the first of a new file.
        """

    def restart_file(self) -> None:
        """
        Let the next message be the first one of a file, from which its duration counts.
        """

    def close(self) -> None:
        """Store nothing more; `take` then returns what is left, without waiting."""

    def set_paused(self, paused: bool) -> None:
        """Set whether messages are discarded, uncounted."""

    def set_simulated_time(self, now_ns: int | None) -> None:
        """
        Set the log time of samples [ns since epoch]; 0: unknown, none is stored; None: their time of receipt.
        """

    def sink(self, channel: int) -> ChunkSink:
        """
        Return a sink for `Reader.feed` that pushes a topic's samples with a channel's number.
        """

    @property
    def has_chunk(self) -> bool:
        """Whether a complete chunk is waiting."""

    @property
    def message_count(self) -> int:
        """Number of messages that were stored."""

    @property
    def dropped_count(self) -> int:
        """Number of messages that a full queue dropped."""

    def dropped_counts(self) -> list[int]:
        """
        Return these numbers by channel, from 0 to the last one that has lost a message.
        """

    @property
    def size(self) -> int:
        """Size of what has not been taken [bytes]."""

def list_mcap_messages(data: bytes, channels: Iterable[int] | None, start_ns: int, end_ns: int) -> list[tuple[int, int, int, int, int]]:
    """
    Return the messages among the MCAP records in `data`, of `channels` (None: all) and with log times from `start_ns` to `end_ns`.

    Each is log time [ns], channel, publish time [ns], and the offset and size of its bytes in `data`. Raises ValueError, with the record's `offset`, if a record is not whole.
    """

def summarise_mcap(data: bytes, begin: int) -> tuple[dict[int, int], int, int, list[tuple[int, int, int]], int]:
    """
    Return what the messages, schemas and channels are that follow each other in `data` from `begin` on.

    They are: the count of messages by channel; the least and the greatest log time [ns]; opcode, offset and size of each other record's content; and the offset of the first record that is of another kind or not whole. Raises ValueError, with the record's `offset`, if a message record is too short.
    """

def summarise_mcap_indexes(data: bytes) -> tuple[int, int, int]:
    """
    Return count, least and greatest log time [ns] of the messages that the message index records in `data` name. Raises ValueError, with the record's `offset`, if a record is another or not whole.
    """

class TfRecords:
    """
    Stores recorded TFMessages in a buffer, without message objects. It must be used by one thread at a time.
    """

    def __init__(self, buffer: Buffer) -> None: ...

    def add_topic(self, name: str, static: bool, ros1: bool) -> int:
        """
        Return the number of a topic, whose name becomes the authority of its transforms.
        """

    def insert(self, topic: int, data: bytes) -> None:
        """Store a message of a topic."""

    def insert_mcap(self, data: bytes, channels: Sequence[tuple[int, int]], start_ns: int, end_ns: int) -> int:
        """
        Store the messages among the MCAP records in `data`. Return where the first record begins that is not whole, or the length of `data`.

        `channels` are pairs of a channel and a topic's number. Messages of moving transforms are stored if their log time is from `start_ns` to `end_ns`. Raises ValueError, with the record's `offset`, if a message record is too short.
        """

    @property
    def message_count(self) -> int:
        """Number of messages."""

    @property
    def dropped_count(self) -> int:
        """Number of unreadable messages, which were logged."""

class Vector:
    """KDL's vector of three numbers, which can be set."""

    @overload
    def __init__(self) -> None:
        """Create zero, or the identity."""

    @overload
    def __init__(self, other: Vector) -> None:
        """Create a copy without its header."""

    @overload
    def __init__(self, x: float, y: float, z: float) -> None:
        """Create one from its components."""

    def __eq__(self, other: object, /) -> bool:
        """Return whether all numbers differ by less than 1e-6."""

    def __ne__(self, other: object, /) -> bool:
        """Return whether any number differs by 1e-6 or more."""

    def __repr__(self) -> str:
        """Return the numbers with six digits."""

    def __copy__(self) -> Any:
        """Return a copy with the same attributes."""

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        """Return a copy with copies of the attributes."""

    def __getstate__(self) -> tuple[Any, ...]:
        """Return the numbers, and the attributes if there are any."""

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        """Set what `__getstate__` returned, here or in Orocos' PyKDL."""

    @property
    def header(self) -> Any:
        """
        The stamp and frame of a value that tf2_kdl converts. Raises AttributeError if none is set.
        """

    @header.setter
    def header(self, header: object) -> None: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    @overload
    def x(self, value: float) -> None:
        """Set the component."""

    @overload
    def x(self) -> float:
        """Return the component."""

    @overload
    def y(self, value: float) -> None:
        """Set the component."""

    @overload
    def y(self) -> float:
        """Return the component."""

    @overload
    def z(self, value: float) -> None:
        """Set the component."""

    @overload
    def z(self) -> float:
        """Return the component."""

    def __add__(self, other: Vector) -> Vector:
        """Return the sum."""

    def __sub__(self, other: Vector) -> Vector:
        """Return the difference."""

    def __iadd__(self, other: Vector) -> Vector:
        """Add in place."""

    def __isub__(self, other: Vector) -> Vector:
        """Subtract in place."""

    @overload
    def __mul__(self, factor: float) -> Vector:
        """Return the product with a number."""

    @overload
    def __mul__(self, other: Vector) -> Vector:
        """Return the cross product."""

    def __rmul__(self, factor: float) -> Vector:
        """Return the product with a number."""

    def __truediv__(self, divisor: float) -> Vector:
        """Return the quotient by a number."""

    def __neg__(self) -> Vector:
        """Return the opposite."""

    def ReverseSign(self) -> None:
        """Reverse the sign of each number in place."""

    @staticmethod
    def Zero() -> Vector:
        """Return (0, 0, 0)."""

    def __getitem__(self, index: int) -> float:
        """Return one number; raises IndexError."""

    def __setitem__(self, index: int, value: float) -> None:
        """Set one number; raises IndexError."""

    def __iter__(self) -> Iterator[float]:
        """Return an iterator over the numbers."""

    def Norm(self, eps: float = 1e-06) -> float:
        """Return the length; 0 if no component reaches `eps`."""

    def Normalize(self, eps: float = 1e-06) -> float:
        """
        Divide by the length, and return it. A vector shorter than `eps` becomes (1, 0, 0), and 0 is returned.
        """

class Rotation:
    """
    KDL's rotation, a matrix of 3 x 3 numbers, which can be set: `R[i, j]`. Angles in rad.
    """

    @overload
    def __init__(self) -> None:
        """Create zero, or the identity."""

    @overload
    def __init__(self, other: Rotation) -> None:
        """Create a copy without its header."""

    @overload
    def __init__(self, xx: float, yx: float, zx: float, xy: float, yy: float, zy: float, xz: float, yz: float, zz: float) -> None:
        """Create one from the matrix, row by row."""

    @overload
    def __init__(self, x: Vector, y: Vector, z: Vector) -> None:
        """Create one from its columns."""

    def __eq__(self, other: object, /) -> bool:
        """Return whether all numbers differ by less than 1e-6."""

    def __ne__(self, other: object, /) -> bool:
        """Return whether any number differs by 1e-6 or more."""

    def __repr__(self) -> str:
        """Return the numbers with six digits."""

    def __copy__(self) -> Any:
        """Return a copy with the same attributes."""

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        """Return a copy with copies of the attributes."""

    def __getstate__(self) -> tuple[Any, ...]:
        """Return the numbers, and the attributes if there are any."""

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        """Set what `__getstate__` returned, here or in Orocos' PyKDL."""

    @property
    def header(self) -> Any:
        """
        The stamp and frame of a value that tf2_kdl converts. Raises AttributeError if none is set.
        """

    @header.setter
    def header(self, header: object) -> None: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    @staticmethod
    def Identity() -> Rotation:
        """Return the identity."""

    @staticmethod
    def RotX(angle: float) -> Rotation:
        """Return a rotation about x."""

    @staticmethod
    def RotY(angle: float) -> Rotation:
        """Return a rotation about y."""

    @staticmethod
    def RotZ(angle: float) -> Rotation:
        """Return a rotation about z."""

    @staticmethod
    def Rot(rotvec: Vector, angle: float) -> Rotation:
        """
        Return a rotation about an axis of any length; about x, if it is shorter than 1e-6.
        """

    @staticmethod
    def Rot2(rotvec: Vector, angle: float) -> Rotation:
        """Return a rotation about an axis of length one, which is not checked."""

    @staticmethod
    def RPY(roll: float, pitch: float, yaw: float) -> Rotation:
        """
        Return Rz(yaw) Ry(pitch) Rx(roll): about the fixed axes x, y and z, in this order.
        """

    @staticmethod
    def EulerZYX(alpha: float, beta: float, gamma: float) -> Rotation:
        """Return Rz(alpha) Ry(beta) Rx(gamma)."""

    @staticmethod
    def EulerZYZ(alpha: float, beta: float, gamma: float) -> Rotation:
        """Return Rz(alpha) Ry(beta) Rz(gamma)."""

    @staticmethod
    def Quaternion(x: float, y: float, z: float, w: float) -> Rotation:
        """
        Return the rotation of a unit quaternion. Another length scales the matrix by its square.
        """

    def GetRPY(self) -> tuple[float, float, float]:
        """Return roll, pitch and yaw; roll is 0 where pitch is ±π/2."""

    def GetEulerZYX(self) -> tuple[float, float, float]:
        """Return alpha, beta and gamma; gamma is 0 where beta is ±π/2."""

    def GetEulerZYZ(self) -> tuple[float, float, float]:
        """Return alpha, beta and gamma; gamma is 0 where beta is 0 or π."""

    def GetQuaternion(self) -> tuple[float, float, float, float]:
        """Return x, y, z, w of the unit quaternion."""

    def GetRot(self) -> Vector:
        """Return the axis times the angle."""

    def GetRotAngle(self, eps: float = 1e-06) -> tuple[float, Vector]:
        """
        Return the angle from 0 to π, and the axis of length one; z at angle 0.

        A matrix that is symmetric within `eps` is one of 0 or π.
        """

    def DoRotX(self, angle: float) -> None:
        """Turn in place about the own x axis."""

    def DoRotY(self, angle: float) -> None:
        """Turn in place about the own y axis."""

    def DoRotZ(self, angle: float) -> None:
        """Turn in place about the own z axis."""

    def SetInverse(self) -> None:
        """Invert in place."""

    @overload
    def UnitX(self) -> Vector:
        """Return the first column."""

    @overload
    def UnitX(self, vec: Vector) -> None:
        """Set the first column."""

    @overload
    def UnitY(self) -> Vector:
        """Return the second column."""

    @overload
    def UnitY(self, vec: Vector) -> None:
        """Set the second column."""

    @overload
    def UnitZ(self) -> Vector:
        """Return the third column."""

    @overload
    def UnitZ(self, vec: Vector) -> None:
        """Set the third column."""

    def __getitem__(self, index: tuple[int, int]) -> float:
        """Return the number of a row and a column; raises IndexError."""

    def __setitem__(self, index: tuple[int, int], value: float) -> None:
        """Set the number of a row and a column; raises IndexError."""

    @overload
    def Inverse(self) -> Rotation:
        """Return the inverse."""

    @overload
    def Inverse(self, other: Vector) -> Vector: ...

    @overload
    def Inverse(self, other: Twist) -> Twist: ...

    @overload
    def Inverse(self, other: Wrench) -> Wrench:
        """Return the product with the inverse: the same in the child's axes."""

    @overload
    def __mul__(self, other: Rotation) -> Rotation:
        """Return the composition."""

    @overload
    def __mul__(self, other: Vector) -> Vector: ...

    @overload
    def __mul__(self, other: Twist) -> Twist: ...

    @overload
    def __mul__(self, other: Wrench) -> Wrench:
        """Return the product: the same in the parent's axes."""

class Twist:
    """
    KDL's velocity of a body: `vel`, that of the point of reference, and `rot`, the angular one.
    """

    @overload
    def __init__(self) -> None:
        """Create zero, or the identity."""

    @overload
    def __init__(self, other: Twist) -> None:
        """Create a copy without its header."""

    @overload
    def __init__(self, vel: Vector, rot: Vector) -> None:
        """Create one from both velocities."""

    def __eq__(self, other: object, /) -> bool:
        """Return whether all numbers differ by less than 1e-6."""

    def __ne__(self, other: object, /) -> bool:
        """Return whether any number differs by 1e-6 or more."""

    def __repr__(self) -> str:
        """Return the numbers with six digits."""

    def __copy__(self) -> Any:
        """Return a copy with the same attributes."""

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        """Return a copy with copies of the attributes."""

    def __getstate__(self) -> tuple[Any, ...]:
        """Return the numbers, and the attributes if there are any."""

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        """Set what `__getstate__` returned, here or in Orocos' PyKDL."""

    @property
    def header(self) -> Any:
        """
        The stamp and frame of a value that tf2_kdl converts. Raises AttributeError if none is set.
        """

    @header.setter
    def header(self, header: object) -> None: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    @property
    def vel(self) -> Vector:
        """Velocity of the point of reference [m/s]."""

    @vel.setter
    def vel(self, value: Vector) -> None: ...

    @property
    def rot(self) -> Vector:
        """Angular velocity [rad/s]."""

    @rot.setter
    def rot(self, value: Vector) -> None: ...

    def RefPoint(self, base: Vector) -> Twist:
        """
        Return the same motion with the point of reference moved by `base`, in the same axes.
        """

    def __add__(self, other: Twist) -> Twist:
        """Return the sum."""

    def __sub__(self, other: Twist) -> Twist:
        """Return the difference."""

    def __iadd__(self, other: Twist) -> Twist:
        """Add in place."""

    def __isub__(self, other: Twist) -> Twist:
        """Subtract in place."""

    def __mul__(self, factor: float) -> Twist:
        """Return the product with a number."""

    def __rmul__(self, factor: float) -> Twist:
        """Return the product with a number."""

    def __truediv__(self, divisor: float) -> Twist:
        """Return the quotient by a number."""

    def __neg__(self) -> Twist:
        """Return the opposite."""

    def ReverseSign(self) -> None:
        """Reverse the sign of each number in place."""

    @staticmethod
    def Zero() -> Twist:
        """Return a twist of zeros."""

    def __getitem__(self, index: int) -> float:
        """Return one number; raises IndexError."""

    def __setitem__(self, index: int, value: float) -> None:
        """Set one number; raises IndexError."""

    def __iter__(self) -> Iterator[float]:
        """Return an iterator over the numbers."""

class Wrench:
    """
    KDL's load on a body: `force`, and `torque` about the point of reference.
    """

    @overload
    def __init__(self) -> None:
        """Create zero, or the identity."""

    @overload
    def __init__(self, other: Wrench) -> None:
        """Create a copy without its header."""

    @overload
    def __init__(self, force: Vector, torque: Vector) -> None:
        """Create one from force and torque."""

    def __eq__(self, other: object, /) -> bool:
        """Return whether all numbers differ by less than 1e-6."""

    def __ne__(self, other: object, /) -> bool:
        """Return whether any number differs by 1e-6 or more."""

    def __repr__(self) -> str:
        """Return the numbers with six digits."""

    def __copy__(self) -> Any:
        """Return a copy with the same attributes."""

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        """Return a copy with copies of the attributes."""

    def __getstate__(self) -> tuple[Any, ...]:
        """Return the numbers, and the attributes if there are any."""

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        """Set what `__getstate__` returned, here or in Orocos' PyKDL."""

    @property
    def header(self) -> Any:
        """
        The stamp and frame of a value that tf2_kdl converts. Raises AttributeError if none is set.
        """

    @header.setter
    def header(self, header: object) -> None: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    @property
    def force(self) -> Vector:
        """Force [N]."""

    @force.setter
    def force(self, value: Vector) -> None: ...

    @property
    def torque(self) -> Vector:
        """Torque about the point of reference [Nm]."""

    @torque.setter
    def torque(self, value: Vector) -> None: ...

    def RefPoint(self, base: Vector) -> Wrench:
        """
        Return the same load with the point of reference moved by `base`, in the same axes.
        """

    def __add__(self, other: Wrench) -> Wrench:
        """Return the sum."""

    def __sub__(self, other: Wrench) -> Wrench:
        """Return the difference."""

    def __iadd__(self, other: Wrench) -> Wrench:
        """Add in place."""

    def __isub__(self, other: Wrench) -> Wrench:
        """Subtract in place."""

    def __mul__(self, factor: float) -> Wrench:
        """Return the product with a number."""

    def __rmul__(self, factor: float) -> Wrench:
        """Return the product with a number."""

    def __truediv__(self, divisor: float) -> Wrench:
        """Return the quotient by a number."""

    def __neg__(self) -> Wrench:
        """Return the opposite."""

    def ReverseSign(self) -> None:
        """Reverse the sign of each number in place."""

    @staticmethod
    def Zero() -> Wrench:
        """Return a wrench of zeros."""

    def __getitem__(self, index: int) -> float:
        """Return one number; raises IndexError."""

    def __setitem__(self, index: int, value: float) -> None:
        """Set one number; raises IndexError."""

    def __iter__(self) -> Iterator[float]:
        """Return an iterator over the numbers."""

class Frame:
    """
    KDL's frame, parent_from_child: the rotation `M` and the origin `p`. `F * x` changes the axes of a vector, a twist, a wrench or a frame to the parent's, and their point of reference to the parent's origin.
    """

    @overload
    def __init__(self) -> None:
        """Create zero, or the identity."""

    @overload
    def __init__(self, other: Frame) -> None:
        """Create a copy without its header."""

    @overload
    def __init__(self, R: Rotation, V: Vector) -> None:
        """Create one from a rotation and an origin."""

    @overload
    def __init__(self, V: Vector) -> None:
        """Create one without a rotation."""

    @overload
    def __init__(self, R: Rotation) -> None:
        """Create one at the parent's origin."""

    def __eq__(self, other: object, /) -> bool:
        """Return whether all numbers differ by less than 1e-6."""

    def __ne__(self, other: object, /) -> bool:
        """Return whether any number differs by 1e-6 or more."""

    def __repr__(self) -> str:
        """Return the numbers with six digits."""

    def __copy__(self) -> Any:
        """Return a copy with the same attributes."""

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        """Return a copy with copies of the attributes."""

    def __getstate__(self) -> tuple[Any, ...]:
        """Return the numbers, and the attributes if there are any."""

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        """Set what `__getstate__` returned, here or in Orocos' PyKDL."""

    @property
    def header(self) -> Any:
        """
        The stamp and frame of a value that tf2_kdl converts. Raises AttributeError if none is set.
        """

    @header.setter
    def header(self, header: object) -> None: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    @property
    def M(self) -> Rotation:
        """The rotation."""

    @M.setter
    def M(self, value: Rotation) -> None: ...

    @property
    def p(self) -> Vector:
        """The origin in the parent [m]."""

    @p.setter
    def p(self, value: Vector) -> None: ...

    @staticmethod
    def Identity() -> Frame:
        """Return the identity."""

    @staticmethod
    def DH(a: float, alpha: float, d: float, theta: float) -> Frame:
        """
        Return the frame of Denavit and Hartenberg's parameters: Rz(theta) Tz(d) Tx(a) Rx(alpha).
        """

    @staticmethod
    def DH_Craig1989(a: float, alpha: float, d: float, theta: float) -> Frame:
        """
        Return the frame of the parameters as modified by Craig: Tx(a) Rx(alpha) Rz(theta) Tz(d).
        """

    def Integrate(self, twist: Twist, sample_frequency: float) -> None:
        """
        Move in place by a twist in the own axes for `1 / sample_frequency` seconds.

        A rotation of less than 1e-6 is left out.
        """

    def __getitem__(self, index: tuple[int, int]) -> float:
        """
        Return the number of a row and a column, of which 3 is the origin's; raises IndexError.
        """

    def __setitem__(self, index: tuple[int, int], value: float) -> None:
        """Set the number of a row and a column; raises IndexError."""

    @overload
    def Inverse(self) -> Frame:
        """Return the inverse."""

    @overload
    def Inverse(self, other: Vector) -> Vector: ...

    @overload
    def Inverse(self, other: Twist) -> Twist: ...

    @overload
    def Inverse(self, other: Wrench) -> Wrench:
        """Return the product with the inverse: the same in the child's axes."""

    @overload
    def __mul__(self, other: Frame) -> Frame:
        """Return the composition."""

    @overload
    def __mul__(self, other: Vector) -> Vector: ...

    @overload
    def __mul__(self, other: Twist) -> Twist: ...

    @overload
    def __mul__(self, other: Wrench) -> Wrench:
        """Return the product: the same in the parent's axes."""

@overload
def kdl_set_to_zero(value: Vector) -> None: ...

@overload
def kdl_set_to_zero(value: Wrench) -> None: ...

@overload
def kdl_set_to_zero(value: Twist) -> None:
    """Set each number to zero."""

@overload
def kdl_dot(a: Vector, b: Vector) -> float:
    """Return the dot product."""

@overload
def kdl_dot(a: Twist, b: Wrench) -> float: ...

@overload
def kdl_dot(a: Wrench, b: Twist) -> float:
    """Return the power."""

@overload
def kdl_equal(a: Vector, b: Vector, eps: float = 1e-06) -> bool: ...

@overload
def kdl_equal(a: Wrench, b: Wrench, eps: float = 1e-06) -> bool: ...

@overload
def kdl_equal(a: Twist, b: Twist, eps: float = 1e-06) -> bool: ...

@overload
def kdl_equal(a: Rotation, b: Rotation, eps: float = 1e-06) -> bool: ...

@overload
def kdl_equal(a: Frame, b: Frame, eps: float = 1e-06) -> bool:
    """Return whether all numbers differ by less than `eps`."""

@overload
def kdl_diff(a: Vector, b: Vector, dt: float = 1.0) -> Vector: ...

@overload
def kdl_diff(a: Rotation, b: Rotation, dt: float = 1.0) -> Vector: ...

@overload
def kdl_diff(a: Frame, b: Frame, dt: float = 1.0) -> Twist: ...

@overload
def kdl_diff(a: Twist, b: Twist, dt: float = 1.0) -> Twist: ...

@overload
def kdl_diff(a: Wrench, b: Wrench, dt: float = 1.0) -> Wrench:
    """
    Return the constant velocity from `a` to `b` in `dt` seconds, in the axes that both are given in.
    """

@overload
def kdl_add_delta(a: Vector, da: Vector, dt: float = 1.0) -> Vector: ...

@overload
def kdl_add_delta(a: Rotation, da: Vector, dt: float = 1.0) -> Rotation: ...

@overload
def kdl_add_delta(a: Frame, da: Twist, dt: float = 1.0) -> Frame: ...

@overload
def kdl_add_delta(a: Twist, da: Twist, dt: float = 1.0) -> Twist: ...

@overload
def kdl_add_delta(a: Wrench, da: Wrench, dt: float = 1.0) -> Wrench:
    """
    Return what `a` becomes in `dt` seconds with the velocity `da`: the reverse of `diff`.
    """

class JointChain:
    """
    The joints of a robot in order from the root, for their poses at many positions.
    """

    def __init__(self, joints: Sequence[tuple[tuple[str, Sequence[float], Sequence[float]], int, int, float, float]], variable_count: int) -> None:
        """
        Each joint is its form, the index of its parent link, its first variable, and multiplier and offset of a mimic joint. Joint i moves link i + 1; link 0 is the root. A form is the type, the origin (7 numbers) and the axis. Raises ValueError if an index is out of range.
        """

    @property
    def joint_count(self) -> int:
        """Number of joints."""

    @property
    def variable_count(self) -> int:
        """Number of position variables."""

    def fill_joints(self, positions: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, None, 7), order='C', device='cpu')]) -> None:
        """
        Fill `out` (N, joints, 7) with parent_from_child at `positions` (N, variables).
        """

    def fill_links(self, positions: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], out: Annotated[NDArray[numpy.float64], dict(shape=(None, None, 7), order='C', device='cpu')]) -> None:
        """
        Fill `out` (N, links, 7) with root_from_link at `positions` (N, variables).
        """

class StateTransforms:
    """
    Converts `sensor_msgs/msg/JointState` to `tf2_msgs/msg/TFMessage`, as bytes.
    """

    def __init__(self, joints: Sequence[tuple[str, str, str, tuple[str, Sequence[float], Sequence[float]]]], mimicries: Sequence[tuple[int, int, float, float]]) -> None:
        """
        Each joint is its name, its frame_id, its child_frame_id, and its form as that of a JointChain's. A mimicry is the index of a joint, that of the joint it follows, a multiplier and an offset; one that follows a mimic joint comes after it.
        """

    def convert(self, data: bytes, now_ns: int, interval_ns: int | None) -> bytes | None:
        """
        Return the transforms of a serialized message; None if there are none or they are not due: the joint that was published least recently was so less than `interval_ns` before the message's stamp.

        Raises ValueError if the bytes are not a JointState, or names and positions differ in number.
        """

    def forget_stamps(self) -> None:
        """Make the next message due, after a jump in time."""

    @property
    def left_out(self) -> str:
        """
        A joint of the last message that was left out because its position is not finite; or empty.
        """

    def sink(self, interval_ns: int | None, publish: Callable[[bytes], object], report: Callable[[str, bytes], object], writer: object = None) -> StateSink:
        """
        Return a sink for `Reader.feed` that converts messages, as `convert` does, on the wire's thread.

        `publish(data)` and `report(what, data)` are called on a thread that may wait, in order; messages are lost while a hundred calls wait. `what` is "refused", with the message; "left out", with a joint's name; or "moved back", for a time before that of the last message. The callables must not refer to the sink. With a `DdsWriter`, transforms are written by it, and `publish` is not called.
        """

class StateSink(Sink):
    """A sink of `sensor_msgs/msg/JointState`."""

    def set_simulated_time(self, now_ns: int | None) -> None:
        """
        Set the time of messages that arrive from now on [ns since epoch]; None: the system's.
        """
