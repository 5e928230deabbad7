"""The services of a player."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

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
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time

if TYPE_CHECKING:
    from tfloom.bag.playing.player import Player

__all__ = ["PlayerServices"]


class PlayerServices:
    """Serves requests by a player's methods."""

    def __init__(self, player: Player) -> None:
        self._player = player
        for kind, name, answer in (
            (Pause, "pause", self._pause),
            (Resume, "resume", self._resume),
            (TogglePaused, "toggle_paused", self._toggle_paused),
            (IsPaused, "is_paused", self._is_paused),
            (GetRate, "get_rate", self._get_rate),
            (SetRate, "set_rate", self._set_rate),
            (Play, "play", self._play),
            (PlayNext, "play_next", self._play_next),
            (Burst, "burst", self._burst),
            (Seek, "seek", self._seek),
            (Stop, "stop", self._stop),
        ):
            player.create_service(kind, f"~/{name}", answer)

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
        start_ns = bag.start_ns + Time.from_msg(request.start_offset).nanoseconds
        until_ns = Time.from_msg(request.playback_until_timestamp).nanoseconds
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
        response.success = self._player.playback.seek(Time.from_msg(request.time).nanoseconds)
        return response

    def _stop(self, _: Any, response: Any) -> Any:
        self._player.playback.stop()
        return response
