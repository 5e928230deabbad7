"""The services of a recorder."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from tfloom.bag.errors import BagError
from tfloom.bag.node_running import Answer, refusal_of_time, serve
from tfloom.interfaces.rosbag2_interfaces.srv import (
    IsDiscoveryRunning,
    IsPaused,
    Pause,
    Record,
    Resume,
    Snapshot,
    SplitBagfile,
    StartDiscovery,
    Stop,
    StopDiscovery,
)
from tfloom.node.log.rcutils_logger import RcutilsLogger
from tfloom.ros_imports import ros_distro

__all__ = ["RefusedError", "answers_of", "serve_recorder"]

_SUCCESS, _ERROR = 0, 1
"""The values of `return_code`; Lyrical's for a split that is refused is the same."""
_SPLIT_FAILED = 4
"""That of a split that can't be written."""


class RefusedError(Exception):
    """A recorder does not do what it was asked for, because of the state in which it is.

    Attributes:
        state: That state, for the log.
    """

    def __init__(self, reason: str, state: str) -> None:
        super().__init__(reason)
        self.state = state


class ServedRecorder(Protocol):
    """A recorder, as its services need it."""

    @property
    def is_paused(self) -> bool:
        """Whether messages are discarded."""

    @property
    def is_discovery_running(self) -> bool:
        """Whether topics are looked for."""

    def check_recording(self) -> None:
        """Raise RefusedError unless this is recording."""

    def create_service(self, srv_type: Any, srv_name: str, callback: Callable[[Any, Any], Any]) -> Any:
        """Create a service of the node, as `Node.create_service`."""

    def get_logger(self) -> RcutilsLogger:
        """Return the node's logger."""

    def pause(self) -> None:
        """Discard messages from now on."""

    def resume(self) -> None:
        """Record messages again."""

    def take_snapshot(self) -> bool:
        """Write the messages in the cache; return False unless this is a recording in snapshot mode."""

    def split_bagfile(self) -> None:
        """Begin the next file."""

    def record(self, uri: str) -> None:
        """Record into another bag, after `stop`."""

    def stop(self) -> None:
        """Complete the bag."""

    def start_discovery(self) -> None:
        """Look for topics."""

    def stop_discovery(self) -> None:
        """Look for no more topics."""

    def fail(self, failure: BagError) -> None:
        """End the recording because of an error."""


def serve_recorder(recorder: ServedRecorder) -> None:
    """Create the services of a recorder."""
    serve(recorder.create_service, answers_of(recorder))


def answers_of(recorder: ServedRecorder) -> dict[str, tuple[Any, Answer]]:
    """Return the services of a recorder, by their names: each with its type, and what answers requests."""
    return {
        "is_paused": (IsPaused, lambda _: {"paused": recorder.is_paused}),
        "pause": (Pause, lambda _: recorder.pause()),
        "resume": (Resume, lambda request: _resume(recorder, request)),
        "snapshot": (Snapshot, lambda _: {"success": _write(recorder, Snapshot, recorder.take_snapshot)}),
        "split_bagfile": (SplitBagfile, lambda request: _split(recorder, request)),
        "stop": (Stop, lambda _: _end(recorder, Stop, lambda: _stop(recorder), failed=_ERROR)),
        "record": (Record, lambda request: _do(recorder, Record, lambda: _record(recorder, request))),
        "start_discovery": (
            StartDiscovery,
            lambda _: _do(recorder, StartDiscovery, recorder.start_discovery),
        ),
        "stop_discovery": (StopDiscovery, lambda _: _do(recorder, StopDiscovery, recorder.stop_discovery)),
        "is_discovery_running": (IsDiscoveryRunning, lambda _: {"running": recorder.is_discovery_running}),
    }


def _resume(recorder: ServedRecorder, request: Any) -> dict[str, object]:
    refusal = refusal_of_time(request, "resume", Resume.Response)
    if not refusal:
        recorder.resume()
    return refusal


def _split(recorder: ServedRecorder, request: Any) -> dict[str, object]:
    refusal = refusal_of_time(request, "split", SplitBagfile.Response)
    return refusal or _end(recorder, SplitBagfile, recorder.split_bagfile, failed=_SPLIT_FAILED)


def _record(recorder: ServedRecorder, request: Any) -> None:
    start = getattr(request, "start_time", None)  # from Lyrical on
    if start is not None and (start.sec or start.nanosec):
        text = "only start_time 0, which is now, can be asked for here"
        raise RefusedError(text, "with a start_time")
    recorder.record(request.uri)


def _end(
    recorder: ServedRecorder, service: Any, write: Callable[[], object], *, failed: int
) -> dict[str, object]:
    """Write; return the fields of a response that says how that went, which it has from Lyrical on.

    An error of it ends the recording.
    """
    code, text = _SUCCESS, ""
    try:
        write()
    except RefusedError as refusal:
        _report(recorder, service, refusal)
        code, text = _ERROR, str(refusal)
    except BagError as error:
        recorder.fail(error)
        code, text = failed, str(error)
    return {"return_code": code, "error_string": text} if ros_distro.HAS_LATER_DEFINITIONS else {}


def _stop(recorder: ServedRecorder) -> None:
    recorder.check_recording()
    recorder.stop()


def _write(recorder: ServedRecorder, service: Any, write: Callable[[], bool]) -> bool:
    """Return whether `write` has written, as it says itself; an error of it ends the recording."""
    try:
        return write()
    except RefusedError as refusal:
        _report(recorder, service, refusal)
    except BagError as error:
        recorder.fail(error)
    return False


def _do(recorder: ServedRecorder, service: Any, do: Callable[[], None]) -> dict[str, object]:
    """Return the fields of a response that says whether `do` has raised an error, and which one."""
    try:
        do()
    except RefusedError as refusal:
        _report(recorder, service, refusal)
        return {"return_code": _ERROR, "error_string": str(refusal)}
    except BagError as error:
        recorder.get_logger().error(f"Error during {service.__name__} request: {error}")
        return {"return_code": _ERROR, "error_string": str(error)}
    return {"return_code": _SUCCESS, "error_string": ""}


def _report(recorder: ServedRecorder, service: Any, refusal: RefusedError) -> None:
    recorder.get_logger().warning(f"Received {service.__name__} request {refusal.state}. Ignoring request.")
