"""The node that plays a bag."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable

from tfloom.bag.bag import Bag
from tfloom.bag.errors import BagError
from tfloom.bag.playing.play_options import PlayOptions
from tfloom.bag.playing.playback import Playback
from tfloom.bag.playing.played_topics import CLOCK, PlayedTopics
from tfloom.bag.playing.player_services import serve_player
from tfloom.bag.playing.progress_bar import PlayStatus, ProgressBar
from tfloom.bag.values import RawMessage
from tfloom.interfaces.rosbag2_interfaces.msg import ReadSplitEvent
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.node.values.time import Time

__all__ = ["SEEK_STEP_NS", "Player"]

SEEK_STEP_NS = 5_000_000_000
"""How far a key seeks [ns]."""
_S_TO_NS = 1_000_000_000
_KEY_LINES = (
    "Press SPACE for Pause/Resume",
    "Press CURSOR_RIGHT for Play Next Message",
    "Press CURSOR_UP for Increase Rate 10%",
    "Press CURSOR_DOWN for Decrease Rate 10%",
)


class Player(Node):
    """Publishes the messages of a bag, from `start` until it ends or `stop`.

    Its services are those of rosbag2_player: ~/pause, ~/resume, ~/toggle_paused, ~/is_paused, ~/get_rate, ~/set_rate,
    ~/play, ~/play_next, ~/burst, ~/seek, ~/stop.

    Args:
        bag: The bag.
        options: What is played.
        node_name: The node's name.
        context: The node's context; None: the default one.
    """

    def __init__(
        self,
        bag: Bag,
        options: PlayOptions,
        node_name: str = "rosbag2_player",
        context: Context | None = None,
    ) -> None:
        super().__init__(node_name, context=context)
        self.bag = bag
        self.options = options
        self.failure: BagError | None = None
        """Why playing ended before the end of the bag."""
        self.ended = threading.Event()
        """Set at the end of the bag, and after `stop`."""
        self.started = threading.Event()
        """Set when the first message may be published, and at the end, however early that comes."""
        self.get_logger().info(f"Set rate to {options.rate:g}")
        self._topics = PlayedTopics(self, bag, options, lambda: self.playback.is_stopped)
        self._publish_clock = self._clock_publisher()
        self._split_events = self.create_publisher(ReadSplitEvent, "events/read_split", 1)
        self._open_files = [0] * len(bag.parts)
        self._is_delayed = False
        self._progress = self._make_progress()
        self.playback = Playback(
            bag,
            self._topics.names,
            self.bounds(),
            options.rate,
            options.read_ahead,
            self._publish,
            self._on_start,
            is_by_sent_time=options.is_by_sent_time,
        )
        # Before any key or request can pause it, which would be undone.
        self.playback.set_paused(options.is_start_paused)
        serve_player(self)
        self._beginning = threading.Lock()
        """Guards the threads: one call at a time begins to play."""
        self._threads: list[threading.Thread] = []
        self._goals_thread: threading.Thread | None = None
        """Sends the goals of this play."""
        if options.has_keyboard:
            self.get_logger().info("Adding keyboard callbacks.")
            for line in _KEY_LINES:
                self.get_logger().info(line)

    @property
    def keys(self) -> dict[str, Callable[[], object]]:
        """What to call for each key of the terminal, by the key's name."""
        return {
            " ": self.toggle_paused,
            "right": lambda: self.playback.step(1),
            "up": lambda: self.set_rate(self.playback.rate * 1.1),
            "down": lambda: self.set_rate(self.playback.rate * 0.9),
            "left": lambda: self.playback.seek_by(-SEEK_STEP_NS),
            "<": lambda: self.playback.seek_by(-SEEK_STEP_NS),
            ">": lambda: self.playback.seek_by(SEEK_STEP_NS),
        }

    def start(self) -> None:
        """Begin to play on a thread.

        Raises:
            BagError: a thread can't be started; then `stop` ends the others.
        """
        self.get_logger().info(f"Playback until timestamp: {self._until_ns()}")
        with self._beginning:
            self._begin_all()

    def play_again(self, start_ns: int, end_ns: int) -> bool:
        """Play a part of the bag, if the last one has ended or was stopped; otherwise return False."""
        with self._beginning:
            if not self.ended.is_set():
                return False
            self.ended.clear()
            self.started.clear()
            self.failure = None
            self.playback.restart()
            self.playback.set_bounds(start_ns, end_ns)
            try:
                self._begin_all()
            except BagError as error:
                self.get_logger().error(str(error))
                self.ended.set()
                return False
            return True

    def stop(self) -> None:
        """End playing, and its threads."""
        self.playback.stop()
        for thread in self._threads:
            thread.join()
        if self._progress is not None:
            self._progress.end()

    def toggle_paused(self) -> None:
        """Pause, or resume."""
        self.set_paused(not self.playback.is_paused)

    def set_paused(self, is_paused: bool) -> None:
        """Pause, or resume."""
        if is_paused != self.playback.is_paused:
            self.playback.set_paused(is_paused)
            self.get_logger().info("Pausing play." if is_paused else "Resuming play.")

    def set_rate(self, rate: float) -> bool:
        """Set the rate; return False unless it is above 0 and finite."""
        is_set = self.playback.set_rate(rate)
        if is_set:
            self.get_logger().info(f"Set rate to {rate:g}")
        else:
            self.get_logger().warning(f"Failed to set rate to invalid value {rate:g}")
        return is_set

    def _begin_all(self) -> None:
        if self.options.clock_hz > 0.0:
            self._begin(self._publish_clock_regularly)
        if self._progress is not None and self.options.progress_hz > 0.0:
            self._begin(self._show_progress_regularly)
        if self._topics.goals is not None:
            self._goals_thread = self._begin(self._topics.goals.run)
        try:
            self._begin(self._play_all)
        except BagError:
            self._end_goals()
            raise

    def _begin(self, run: Callable[[], None]) -> threading.Thread:
        thread = threading.Thread(target=run, daemon=True)
        try:
            thread.start()
        except RuntimeError as error:
            raise BagError(self.bag.path, f"it can't be played: {error}") from error
        self._threads = [*(running for running in self._threads if running.is_alive()), thread]
        return thread

    def _play_all(self) -> None:
        try:
            if self._topics.goals is not None:
                self._topics.goals.wait_for_servers()
            self._play_once()
            while self.options.is_loop and not self.playback.is_stopped:
                self._play_once()
            if self.options.wait_acked_ms >= 0 and not self._topics.wait_for_acks(self.options.wait_acked_ms):
                self.get_logger().error(
                    "Timed out while waiting for all published messages to be acknowledged."
                )
        except BagError as error:
            self.failure = error
        except Exception as error:  # a thread's end alone would look like the bag's
            self.failure = BagError(self.bag.path, f"playing has ended: {type(error).__name__}: {error}")
            self.failure.__cause__ = error
        finally:
            self._end_goals()
            self._show_progress(PlayStatus.STOPPED)
            self.started.set()
            self.ended.set()

    def _end_goals(self) -> None:
        """Wait until all goals were sent, and cancel those that have not ended, unless the bag's end was reached."""
        if self._goals_thread is not None and self._topics.goals is not None:
            self._topics.goals.end(cancels=self.failure is not None)
            self._goals_thread.join()
            self._goals_thread = None

    def _play_once(self) -> None:
        if self.options.delay_s > 0.0:
            self.get_logger().info(f"Sleep {self.options.delay_s * _S_TO_NS:.0f} ns")
            self._is_delayed = True
            try:
                if not self.playback.wait(self.options.delay_s):
                    return
            finally:
                self._is_delayed = False
        self.playback.run()

    def bounds(self) -> tuple[int, int]:
        """Return the first and the last log time that the options want to be played [ns since epoch]."""
        start_ns = self.bag.start_ns + int(self.options.start_offset_s * _S_TO_NS)
        until_ns = self._until_ns(start_ns)
        return start_ns, self.bag.end_ns if until_ns < 0 else min(until_ns, self.bag.end_ns)

    def _until_ns(self, start_ns: int | None = None) -> int:
        """Return the last log time that is played; -1: no limit. The later of two limits counts."""
        if start_ns is None:
            start_ns = self.bag.start_ns + int(self.options.start_offset_s * _S_TO_NS)
        duration_s = self.options.duration_s
        by_duration_ns = start_ns + int(duration_s * _S_TO_NS) if duration_s >= 0.0 else -1
        return max(by_duration_ns, self.options.until_ns, -1)

    def _on_start(self, start_ns: int) -> None:
        self._open_files = [0] * len(self.bag.parts)
        self.started.set()
        self._publish_clock(start_ns)
        if self._topics.goals is not None:
            self._topics.goals.restart()
        self._topics.publish_kept(start_ns)

    def _publish(self, message: RawMessage) -> None:
        if self.options.is_clock_on_all or message.topic in self.options.clock_topics:
            self._publish_clock(message.log_time_ns)
        self._topics.publish(message)
        self._announce_files(message.log_time_ns)
        if self.options.progress_hz < 0.0:
            self._show_progress()

    def _announce_files(self, stamp_ns: int) -> None:
        # A message later than the file's end is of a later one. Files without messages in between are passed over, each
        # with its event.
        for part, files in enumerate(self.bag.parts):
            place = self._open_files[part]
            while place + 1 < len(files) and stamp_ns > files[place].end_ns:
                closed, opened = files[place].path, files[place + 1].path
                name = self.get_fully_qualified_name()
                self._split_events.publish(
                    ReadSplitEvent(closed_file=str(closed), opened_file=str(opened), node_name=name)
                )
                place += 1
            self._open_files[part] = place

    def _make_progress(self) -> ProgressBar | None:
        """Return what shows the progress; None if that isn't wanted, or standard output is no terminal."""
        if not self.options.progress_hz or sys.stdout is None or not sys.stdout.isatty():
            return None
        first, last = self.bounds()
        return ProgressBar(first, last - first, self.options.progress_lines)

    def _show_progress(self, status: PlayStatus | None = None) -> None:
        if self._progress is None:
            return
        if status is None:
            is_running = PlayStatus.PAUSED if self.playback.is_paused else PlayStatus.RUNNING
            status = PlayStatus.DELAYED if self._is_delayed else is_running
        self._progress.show(self.playback.now_ns(), status)

    def _show_progress_regularly(self) -> None:
        while self.playback.wait(1.0 / self.options.progress_hz):
            if self.ended.is_set():
                return
            self._show_progress()

    def _clock_publisher(self) -> Callable[[int], None]:
        """Return what publishes a time on /clock; it does nothing if that isn't wanted."""
        options = self.options
        if not (options.clock_hz or options.clock_topics or options.is_clock_on_all):
            return lambda _: None
        # The thread of the regular times and that of the messages may publish at once.
        publisher = self.create_publisher(Clock, CLOCK, 1)
        lock = threading.Lock()

        def publish(stamp_ns: int) -> None:
            with lock:
                publisher.publish(Clock(clock=Time(nanoseconds=stamp_ns).to_msg()))

        return publish

    def _publish_clock_regularly(self) -> None:
        while self.playback.wait(1.0 / self.options.clock_hz):
            if self.ended.is_set():
                return
            self._publish_clock(self.playback.now_ns())
