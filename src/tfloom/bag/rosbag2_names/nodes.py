"""Recorder and player: as Jazzy's, which record and play until the end, and as Lyrical's, with several methods."""

from __future__ import annotations

import threading
import weakref
from collections.abc import Callable, Sequence
from datetime import timedelta
from pathlib import Path
from typing import Any, overload

from tfloom.bag.node_running import spin_until
from tfloom.bag.opening import open_bags
from tfloom.bag.playing.player import Player as PlayerNode
from tfloom.bag.playing.run import play
from tfloom.bag.recording.recorder import Recorder as RecorderNode
from tfloom.bag.recording.recorder_services import RefusedError
from tfloom.bag.recording.run import record
from tfloom.bag.rosbag2_names.storage import StorageOptions
from tfloom.bag.rosbag2_names.transport import PlayOptions, RecordOptions
from tfloom.bag.rosbag2_names.writers import writer_settings
from tfloom.bag.writing.bag_writer import WriterSettings
from tfloom.node.client_library import init
from tfloom.node.context.context import Context
from tfloom.node.context.utilities import get_default_context, try_shutdown
from tfloom.node.log.log_output import LoggingSeverity
from tfloom.node.log.logging import get_logging_severity_from_string, set_logger_level

__all__ = ["Player", "Recorder"]

Storages = StorageOptions | Sequence[StorageOptions]


class _Stoppable:
    """The runs of one class, which `cancel` ends."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._stops: set[threading.Event] = set()  # guarded by _lock

    def run(self, work: Callable[[threading.Event], None], level: LoggingSeverity) -> None:
        """Call `work` with the event that ends it, in the default context, which is initialised if it isn't.

        All loggers get the level, but for INFO, which is theirs without it.
        """
        stop = threading.Event()
        with self._lock:
            self._stops.add(stop)
        is_ours = not get_default_context().ok()
        if is_ours:
            init(args=[])
        _set_level(level)
        try:
            work(stop)
        finally:
            if is_ours:
                try_shutdown()
            with self._lock:
                self._stops.discard(stop)

    def cancel(self) -> None:
        """End all runs."""
        with self._lock:
            for stop in self._stops:
                stop.set()


class _Spun:
    """A node, and the thread that spins it between `start_spin` and `stop_spin`.

    Args:
        make: Returns the node in a context: the default one if that is initialised, else one of its own.
        level: That of all loggers, but for INFO.
    """

    def __init__(self, make: Callable[[Context], Any], level: LoggingSeverity) -> None:
        default = get_default_context()
        self._own = None if default.ok() else Context()
        if self._own is not None:
            self._own.init(args=[])
        _set_level(level)
        try:
            self.node = make(self._own or default)
        except BaseException:
            self._shut_down()
            raise
        self._lock = threading.Lock()
        """Guards both below: one call at a time starts or ends the thread."""
        self._thread: threading.Thread | None = None
        self._ended = threading.Event()

    def start_spin(self) -> None:
        """Spin on a thread; do nothing if it does already.

        Raises:
            RuntimeError: a thread can't be started.
        """
        with self._lock:
            if self._thread is not None and self._thread.is_alive():
                return
            self._ended.clear()
            thread = threading.Thread(
                target=spin_until, args=(self.node, lambda: False, self._ended), daemon=True
            )
            thread.start()
            self._thread = thread

    def stop_spin(self) -> None:
        """End the thread, if there is one."""
        with self._lock:
            self._ended.set()
            if self._thread is not None:
                self._thread.join()
                self._thread = None

    def close(self) -> None:
        """End what the node does, and the node."""
        self.stop_spin()
        try:
            self.node.stop()
        finally:
            self.node.destroy_node()
            self._shut_down()

    def _shut_down(self) -> None:
        if self._own is not None:
            self._own.try_shutdown()


class _Controlled:
    """What both classes have in common: by which of their forms an object was made, and the spinning."""

    def __init__(self) -> None:
        self._spun: _Spun | None = None

    def _keep(self, spun: _Spun) -> None:
        self._spun = spun
        weakref.finalize(self, spun.close)  # which must not hold this object

    def _opened(self, call: str) -> _Spun:
        if self._spun is None:
            name = type(self).__name__
            raise RuntimeError(
                f"{name}.{call}() needs the options at the construction: {name}(StorageOptions(…), …Options())"
            )
        return self._spun

    def start_spin(self) -> None:
        """Spin the node on a thread, so that it answers its services. It does nothing while it is spun.

        Raises:
            RuntimeError: a thread can't be started, or this was made without options.
        """
        self._opened("start_spin").start_spin()

    def stop_spin(self) -> None:
        """End the spinning.

        Raises:
            RuntimeError: this was made without options.
        """
        self._opened("stop_spin").stop_spin()


class Recorder(_Controlled):
    """Records: `Recorder(log_level)` in one call of `record`, until `cancel` or Ctrl-C; with options by calls.

    `Recorder(storage_options, record_options, log_level="info", node_name="rosbag2_recorder")` has a node at once. Its
    `record` begins and returns, `pause` and `resume` are as the services, and `stop` completes the bag. It reads no
    keys.

    Raises:
        ValueError: there is no such log level: debug, info, warn, error or fatal.
        BagError: an option can't be used.
    """

    _runs = _Stoppable()

    @overload
    def __init__(self, log_level: str = "info") -> None: ...
    @overload
    def __init__(
        self,
        storage_options: StorageOptions,
        record_options: RecordOptions,
        log_level: str = "info",
        node_name: str = "rosbag2_recorder",
    ) -> None: ...
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        if _has_options(args, kwargs):
            self._keep(_spun_recorder(*args, **kwargs))
        else:
            self._level = _given_level(*args, **kwargs)

    @overload
    def record(self, uri: str = "") -> None: ...
    @overload
    def record(
        self,
        storage_options: StorageOptions,
        record_options: RecordOptions,
        node_name: str = "rosbag2_recorder",
    ) -> None: ...
    def record(self, *args: Any, **kwargs: Any) -> None:
        """Record into a new bag: with options until the end; without, begin, and return.

        Args:
            args: The storage and what is recorded, and the node's name; or, after a construction with options, the
                bag's folder in place of that of the options, for another bag after `stop`.
            kwargs: The same, by name.

        Raises:
            BagError: the bag can't be written; what was written before stays readable.
            RuntimeError: this is recording.
        """
        if self._spun is None:
            self._record_until_end(*args, **kwargs)
            return
        try:
            self._spun.node.record(*args, **kwargs)
        except RefusedError as refusal:
            raise RuntimeError(str(refusal)) from None

    def _record_until_end(
        self,
        storage_options: StorageOptions,
        record_options: RecordOptions,
        node_name: str = "rosbag2_recorder",
    ) -> None:
        settings, options = _settings_of(storage_options, record_options), record_options.to_options()
        self._runs.run(
            lambda stop: record(Path(storage_options.uri), settings, options, node_name=node_name, stop=stop),
            self._level,
        )

    def pause(self) -> None:
        """Discard messages from now on."""
        self._opened("pause").node.pause()

    def resume(self) -> None:
        """Record messages again."""
        self._opened("resume").node.resume()

    def is_paused(self) -> bool:
        """Return whether messages are discarded."""
        return bool(self._opened("is_paused").node.is_paused)

    def stop(self) -> None:
        """Complete the bag. Stopping again does nothing.

        Raises:
            BagError: the bag can't be completed, or recording had ended before because of this error.
        """
        node: RecorderNode = self._opened("stop").node
        node.stop()
        failure, node.failure = node.failure, None
        if failure is not None:
            raise failure

    @staticmethod
    def cancel() -> None:
        """End all recordings of this process that `Recorder(log_level)` has begun."""
        Recorder._runs.cancel()


class Player(_Controlled):
    """Plays: `Player(log_level)` in one call of `play`, until the end, `cancel` or Ctrl-C; with options by calls.

    `Player(storage_options, play_options, log_level="info", node_name="rosbag2_player")` has a node at once, for one
    bag or for a list of them. Its `play` begins and returns. It reads no keys.

    Raises:
        ValueError: there is no such log level: debug, info, warn, error or fatal.
        BagError: the bag can't be read.
    """

    _runs = _Stoppable()

    @overload
    def __init__(self, log_level: str = "info") -> None: ...
    @overload
    def __init__(
        self,
        storage_options: Storages,
        play_options: PlayOptions,
        log_level: str = "info",
        node_name: str = "rosbag2_player",
    ) -> None: ...
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        self._has_begun = False
        if _has_options(args, kwargs):
            self._keep(_spun_player(*args, **kwargs))
        else:
            self._level = _given_level(*args, **kwargs)

    @overload
    def play(self) -> bool: ...
    @overload
    def play(self, storage_options: Storages, play_options: PlayOptions) -> None: ...
    def play(self, *args: Any, **kwargs: Any) -> bool | None:
        """Play a bag: with options until the end; without, begin, and return False if it is being played.

        Args:
            args: The bag, or a list of bags, and how it is played.
            kwargs: The same, by name.

        Raises:
            BagError: it can't be read.
        """
        if self._spun is None:
            self._play_until_end(None, *args, **kwargs)
            return None
        if args or kwargs:
            raise TypeError("play() of a Player that was made with options has no arguments")
        node = self._node("play")
        if self._has_begun:
            return node.play_again(*node.bounds())
        self._has_begun = True
        node.start()
        return True

    @overload
    def burst(self, num_messages: int) -> int: ...
    @overload
    def burst(self, storage_options: Storages, play_options: PlayOptions, num_messages: int) -> None: ...
    def burst(self, *args: Any, **kwargs: Any) -> int | None:
        """Publish messages at once in the paused state; 0: all that are left.

        Args:
            args: Their number; before it, with `Player(log_level)`, the bag and how it is played.
            kwargs: The same, by name.

        Returns:
            How many were published; None after the end of what `Player(log_level)` plays.

        Raises:
            BagError: the bag can't be read.
        """
        if self._spun is None:
            self._burst_until_end(*args, **kwargs)
            return None
        return self._burst(*args, **kwargs)

    def _burst(self, num_messages: int) -> int:
        return self._node("burst").playback.step(num_messages)

    def _burst_until_end(
        self, storage_options: Storages, play_options: PlayOptions, num_messages: int
    ) -> None:
        self._play_until_end(num_messages, storage_options, play_options)

    def _play_until_end(
        self, burst: int | None, storage_options: Storages, play_options: PlayOptions
    ) -> None:
        options = play_options.to_options()
        options.is_start_paused |= burst is not None
        paths = _paths(storage_options)
        self._runs.run(lambda stop: play(paths, options, burst=burst, stop=stop), self._level)

    def _node(self, call: str) -> PlayerNode:
        node: PlayerNode = self._opened(call).node
        return node

    def pause(self) -> None:
        """Pause."""
        self._node("pause").set_paused(True)

    def resume(self) -> None:
        """Go on."""
        self._node("resume").set_paused(False)

    def toggle_paused(self) -> None:
        """Pause, or go on."""
        self._node("toggle_paused").toggle_paused()

    def is_paused(self) -> bool:
        """Return whether it is paused."""
        return self._node("is_paused").playback.is_paused

    def get_rate(self) -> float:
        """Return how many seconds of the bag are played in a second."""
        return self._node("get_rate").playback.rate

    def set_rate(self, rate: float) -> bool:
        """Set it; return False unless it is above 0 and finite."""
        return self._node("set_rate").set_rate(rate)

    def play_next(self) -> bool:
        """Publish the next message in the paused state; return False if there is none, or it isn't paused."""
        return self._burst(1) == 1

    def seek(self, time_point: int) -> None:
        """Go on at a log time [ns since epoch]; one before or after the bag is its first or its last one."""
        node = self._node("seek")
        node.playback.seek(min(max(int(time_point), node.bag.start_ns), node.bag.end_ns))

    def stop(self) -> None:
        """End playing; `play` begins again. Stopping again does nothing."""
        self._node("stop").stop()

    def wait_for_playback_to_start(self, timeout: timedelta | float | None = None) -> bool:
        """Wait until messages are played, or have been; return False if that takes longer than a timeout.

        Args:
            timeout: A timedelta or seconds; None, or negative: no limit.

        Raises:
            BagError: playing has ended because of it.
        """
        node = self._node("wait_for_playback_to_start")
        return self._wait(node, node.started, timeout)

    def wait_for_playback_to_finish(self, timeout: timedelta | float | None = None) -> bool:
        """Wait for the end, also that by `stop`; return False if that takes longer than a timeout.

        Args:
            timeout: A timedelta or seconds; None, or negative: no limit.

        Raises:
            BagError: playing has ended because of it.
        """
        node = self._node("wait_for_playback_to_finish")
        return self._wait(node, node.ended, timeout)

    @staticmethod
    def _wait(node: PlayerNode, event: threading.Event, timeout: timedelta | float | None) -> bool:
        seconds = timeout.total_seconds() if isinstance(timeout, timedelta) else timeout
        is_set = event.wait(None if seconds is None or seconds < 0.0 else seconds)
        if node.failure is not None:
            raise node.failure
        return is_set

    def get_starting_time(self) -> int:
        """Return the first log time that is played [ns since epoch]."""
        return self._node("get_starting_time").bounds()[0]

    def get_playback_duration(self) -> int:
        """Return how much of the bag is played [ns]."""
        first, last = self._node("get_playback_duration").bounds()
        return last - first

    @staticmethod
    def cancel() -> None:
        """End all playing of this process that `Player(log_level)` has begun."""
        Player._runs.cancel()


def _has_options(args: tuple[Any, ...], kwargs: dict[str, Any]) -> bool:
    """Return whether arguments of a construction have options, so that they are Lyrical's."""
    return "storage_options" in kwargs or bool(args and not isinstance(args[0], str))


def _given_level(log_level: str = "info") -> LoggingSeverity:
    return _severity(log_level)


def _spun_recorder(
    storage_options: StorageOptions,
    record_options: RecordOptions,
    log_level: str = "info",
    node_name: str = "rosbag2_recorder",
) -> _Spun:
    level = _severity(log_level)
    settings, options = _settings_of(storage_options, record_options), record_options.to_options()
    options.has_keyboard = False
    folder = Path(storage_options.uri)
    return _Spun(
        lambda context: RecorderNode(folder, settings, options, node_name, context=context, waits=True), level
    )


def _spun_player(
    storage_options: Storages,
    play_options: PlayOptions,
    log_level: str = "info",
    node_name: str = "rosbag2_player",
) -> _Spun:
    level = _severity(log_level)
    options = play_options.to_options()
    options.has_keyboard = False
    bag = open_bags(_paths(storage_options))
    spun = _Spun(lambda context: PlayerNode(bag, options, node_name, context), level)
    weakref.finalize(spun, bag.close)
    return spun


def _paths(storage_options: Storages) -> list[Path]:
    storages = [storage_options] if isinstance(storage_options, StorageOptions) else storage_options
    return [Path(storage.uri) for storage in storages]


def _settings_of(storage_options: StorageOptions, record_options: RecordOptions) -> WriterSettings:
    mode = record_options.compression_mode.upper()
    return writer_settings(storage_options, "" if mode == "NONE" else mode)


def _severity(log_level: str) -> LoggingSeverity:
    if log_level not in {"debug", "info", "warn", "error", "fatal"}:
        raise ValueError(f"there is no log level '{log_level}': debug, info, warn, error or fatal")
    return get_logging_severity_from_string(log_level.upper())


def _set_level(level: LoggingSeverity) -> None:
    if level != LoggingSeverity.INFO:
        set_logger_level("", level)
