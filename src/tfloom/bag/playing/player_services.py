"""The services of a player."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from tfloom.bag.bag import Bag
from tfloom.bag.node_running import Answer, refusal_of_time, serve
from tfloom.bag.playing.playback import Playback
from tfloom.interfaces.rosbag2_interfaces.srv import (
    Burst,
    GetRate,
    IsPaused,
    Pause,
    Play,
    PlayNext,
    Resume,
    Seek,
    SetRate,
    Stop,
    TogglePaused,
)
from tfloom.node.values.duration import S_TO_NS, Duration

__all__ = ["serve_player"]


class ServedPlayer(Protocol):
    """A player, as its services need it."""

    bag: Bag
    playback: Playback

    def create_service(self, srv_type: Any, srv_name: str, callback: Callable[[Any, Any], Any]) -> Any:
        """Create a service of the node, as `Node.create_service`."""

    def set_paused(self, is_paused: bool) -> None:
        """Pause, or resume."""

    def toggle_paused(self) -> None:
        """Pause, or resume."""

    def set_rate(self, rate: float) -> bool:
        """Set the rate; return False unless it is above 0 and finite."""

    def play_again(self, start_ns: int, end_ns: int) -> bool:
        """Play a part of the bag, if the last one has ended; otherwise return False."""


def serve_player(player: ServedPlayer) -> None:
    """Create the services of a player."""
    playback = player.playback
    answers: dict[str, tuple[Any, Answer]] = {
        "pause": (Pause, lambda _: player.set_paused(True)),
        "resume": (Resume, lambda request: _resume(player, request)),
        "toggle_paused": (TogglePaused, lambda _: player.toggle_paused()),
        "is_paused": (IsPaused, lambda _: {"paused": playback.is_paused}),
        "get_rate": (GetRate, lambda _: {"rate": playback.rate}),
        "set_rate": (SetRate, lambda request: {"success": player.set_rate(request.rate)}),
        "play": (Play, lambda request: {"success": player.play_again(*_part_to_play(player.bag, request))}),
        "play_next": (PlayNext, lambda _: {"success": playback.step(1) == 1}),
        "burst": (Burst, lambda request: {"actually_burst": playback.step(request.num_messages)}),
        "seek": (Seek, lambda request: {"success": playback.seek(_nanoseconds(request.time))}),
        "stop": (Stop, lambda _: playback.stop()),
    }
    serve(player.create_service, answers)


def _resume(player: ServedPlayer, request: Any) -> dict[str, object]:
    refusal = refusal_of_time(request, "resume", Resume.Response)
    if not refusal:
        player.set_paused(False)
    return refusal


def _part_to_play(bag: Bag, request: Any) -> tuple[int, int]:
    """Return the first and the last log time that a request wants [ns since epoch]."""
    start_ns = bag.start_ns + max(0, _nanoseconds(request.start_offset))
    until_ns = _nanoseconds(request.playback_until_timestamp)
    duration_ns = Duration.from_msg(request.playback_duration).nanoseconds
    end_ns = max(until_ns, start_ns + duration_ns if duration_ns > 0 else 0)
    return start_ns, end_ns if end_ns > 0 else bag.end_ns


def _nanoseconds(stamp: Any) -> int:
    """Return a message of a time as a count [ns]; it may be negative, which Time refuses by an error."""
    return int(stamp.sec * S_TO_NS + stamp.nanosec)
