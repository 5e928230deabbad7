"""The services of a player."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from tfloom.bag.bag import Bag
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
from tfloom.node.values.constants import S_TO_NS
from tfloom.node.values.duration import Duration

__all__ = ["PlayerServices"]


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


class PlayerServices:
    """Serves requests by a player's methods."""

    def __init__(self, player: ServedPlayer) -> None:
        self._player = player
        player.create_service(Pause, "~/pause", self._pause)
        player.create_service(Resume, "~/resume", self._resume)
        player.create_service(TogglePaused, "~/toggle_paused", self._toggle_paused)
        player.create_service(IsPaused, "~/is_paused", self._is_paused)
        player.create_service(GetRate, "~/get_rate", self._get_rate)
        player.create_service(SetRate, "~/set_rate", self._set_rate)
        player.create_service(Play, "~/play", self._play)
        player.create_service(PlayNext, "~/play_next", self._play_next)
        player.create_service(Burst, "~/burst", self._burst)
        player.create_service(Seek, "~/seek", self._seek)
        player.create_service(Stop, "~/stop", self._stop)

    def _pause(self, _: Any, response: Any) -> Any:
        self._player.set_paused(True)
        return response

    def _resume(self, _: Any, response: Any) -> Any:
        self._player.set_paused(False)
        return response

    def _toggle_paused(self, _: Any, response: Any) -> Any:
        self._player.toggle_paused()
        return response

    def _is_paused(self, _: Any, response: Any) -> Any:
        response.paused = self._player.playback.is_paused
        return response

    def _get_rate(self, _: Any, response: Any) -> Any:
        response.rate = self._player.playback.rate
        return response

    def _set_rate(self, request: Any, response: Any) -> Any:
        response.success = self._player.set_rate(request.rate)
        return response

    def _play(self, request: Any, response: Any) -> Any:
        bag = self._player.bag
        start_ns = bag.start_ns + max(0, _nanoseconds(request.start_offset))
        until_ns = _nanoseconds(request.playback_until_timestamp)
        duration_ns = Duration.from_msg(request.playback_duration).nanoseconds
        limits = [until_ns, start_ns + duration_ns if duration_ns > 0 else 0]
        end_ns = max(limits) if max(limits) > 0 else bag.end_ns
        response.success = self._player.play_again(start_ns, end_ns)
        return response

    def _play_next(self, _: Any, response: Any) -> Any:
        response.success = self._player.playback.step(1) == 1
        return response

    def _burst(self, request: Any, response: Any) -> Any:
        response.actually_burst = self._player.playback.step(request.num_messages)
        return response

    def _seek(self, request: Any, response: Any) -> Any:
        response.success = self._player.playback.seek(_nanoseconds(request.time))
        return response

    def _stop(self, _: Any, response: Any) -> Any:
        self._player.playback.stop()
        return response


def _nanoseconds(stamp: Any) -> int:
    """Return a message of a time as a count [ns]; it may be negative, which Time refuses by an error."""
    return int(stamp.sec * S_TO_NS + stamp.nanosec)
