"""The services of a recorder."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from tfloom.bag.errors import BagError
from tfloom.bag.node_running import Answer, serve
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

__all__ = ["RefusedError", "answers_of", "serve_recorder"]

_SUCCESS, _ERROR = 0, 1
"""The values of `return_code`."""


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
        "resume": (Resume, lambda _: recorder.resume()),
        "snapshot": (Snapshot, lambda _: {"success": _write(recorder, Snapshot, recorder.take_snapshot)}),
        "split_bagfile": (SplitBagfile, lambda _: _write(recorder, SplitBagfile, recorder.split_bagfile)),
        "stop": (Stop, lambda _: _write(recorder, Stop, lambda: _stop(recorder))),
        "record": (Record, lambda request: _do(recorder, Record, lambda: recorder.record(request.uri))),
        "start_discovery": (
            StartDiscovery,
            lambda _: _do(recorder, StartDiscovery, recorder.start_discovery),
        ),
        "stop_discovery": (StopDiscovery, lambda _: _do(recorder, StopDiscovery, recorder.stop_discovery)),
        "is_discovery_running": (IsDiscoveryRunning, lambda _: {"running": recorder.is_discovery_running}),
    }


def _stop(recorder: ServedRecorder) -> None:
    recorder.check_recording()
    recorder.stop()


def _write(recorder: ServedRecorder, service: Any, write: Callable[[], bool | None]) -> bool:
    """Return whether `write` has written, as it says itself; an error of it ends the recording."""
    try:
        return bool(write())
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
