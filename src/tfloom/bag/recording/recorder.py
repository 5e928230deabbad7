"""The node that records: it finds topics, subscribes, and writes what it receives."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tfloom.bag.errors import BagError
from tfloom.bag.node_running import Answer, serve
from tfloom.bag.recording.record_options import RecordOptions
from tfloom.bag.recording.recorded_topics import RecordedTopics
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.interfaces.rosbag2_interfaces.msg import WriteSplitEvent
from tfloom.interfaces.rosbag2_interfaces.srv import IsPaused, Pause, Resume, Snapshot, SplitBagfile
from tfloom.node.clock.time_jump import JumpThreshold
from tfloom.node.context.context import Context
from tfloom.node.log.logging import get_logger
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.duration import Duration
from tfloom.rmw.base import Participant

__all__ = ["Learn", "Recorder"]

FLUSH_NS = 1_000_000_000
"""How long messages wait at most until they are written, so that a kill loses no more [ns]."""
Learn = Callable[[Participant, str], object]
"""Makes the classes of a type from the descriptions of peers; what it returns is not used."""


class Recorder(Node):
    """Records topics into a bag, from `start` to `stop`.

    Its services are those of rosbag2_recorder: ~/is_paused, ~/pause, ~/resume, ~/snapshot, ~/split_bagfile.

    Args:
        folder: The bag's folder, which must not exist.
        settings: How the bag is written.
        options: What is recorded.
        node_name: The node's name.
        learn: Called for a type without a definition here.
        context: The node's context; None: the default one.

    Raises:
        BagError: the folder exists, or can't be written.
    """

    def __init__(
        self,
        folder: Path,
        settings: WriterSettings,
        options: RecordOptions,
        node_name: str = "rosbag2_recorder",
        learn: Learn | None = None,
        context: Context | None = None,
    ) -> None:
        overrides = [Parameter("use_sim_time", value=True)] if options.use_sim_time else []
        super().__init__(node_name, context=context, parameter_overrides=overrides)
        self.options = options
        self.failure: BagError | None = None
        """Why recording ended, if it could not go on."""
        self._is_paused = options.is_start_paused
        self._lock = threading.Lock()
        """Guards the writer: one thread uses it at a time."""
        self._ended = threading.Event()
        self._threads: list[threading.Thread] = []
        self._split_events = self.create_publisher(WriteSplitEvent, "events/write_split", 1)
        if options.has_keyboard:
            self.get_logger().info("Press SPACE for pausing/resuming")
        try:
            self.writer = BagWriter(folder, settings, self._on_split)
        except BagError:
            self.destroy_node()
            raise
        if settings.storage_id == "sqlite3":
            get_logger("rosbag2_storage").info(f"Opened database '{self.writer.file_path}' for READ_WRITE.")
        self.writer.queue.set_paused(self._is_paused)
        self._topics = RecordedTopics(self, self.writer, options, learn)
        serve(self.create_service, self._answers())

    def start(self) -> None:
        """Subscribe to the topics that exist, and go on in threads: with discovery, and with writing.

        Raises:
            BagError: a thread can't be started; the recording has ended.
        """
        self.get_logger().info("Listening for topics...")
        self.get_logger().info("Event publisher thread: Starting")
        if self.options.use_sim_time:
            self._follow_clock()
        self._topics.subscribe_all()
        self.get_logger().info("Recording...")
        for run in (self._write, self._discover):
            thread = threading.Thread(target=run, daemon=True)
            try:
                thread.start()
            except RuntimeError as error:
                self.stop()
                raise BagError(self.writer.folder, f"recording needs two threads: {error}") from error
            self._threads.append(thread)

    def stop(self) -> None:
        """End the threads, write what is left, and complete the bag. Stopping again does nothing.

        Raises:
            BagError: the bag can't be completed, and there was no `failure` before; what was written stays readable.
        """
        if self._ended.is_set():
            return
        # First no more messages get into the queue. Then both threads end: the event ends the wait between two looks at
        # the graph, and a closed queue wakes the thread that waits for a chunk. No lock is held meanwhile, because that
        # thread may need it for its last chunk. Only then can no thread subscribe any more, and the readers are closed.
        self.pause()
        self._ended.set()
        self.writer.queue.close()
        for thread in self._threads:
            thread.join()
        self._topics.close()
        get_logger("rosbag2_cpp").info(
            "Writing remaining messages from cache to the bag. It may take a while"
        )
        if self.writer.settings.compression_mode == "FILE":
            get_logger("rosbag2_compression").info(f"Compressing file: {self.writer.file_path}")
        try:
            with self._lock:
                self.writer.close()
        except BagError:
            if self.failure is None:  # else it says why, and that what was written is kept
                raise
        finally:
            self._report_losses()
            self.get_logger().info("Event publisher thread: Exiting")
            self.get_logger().info("Recording stopped")

    def pause(self) -> None:
        """Discard messages from now on."""
        self._is_paused = True
        self.writer.queue.set_paused(True)
        self.get_logger().info("Pausing recording.")

    def resume(self) -> None:
        """Record messages again."""
        self._is_paused = False
        self.writer.queue.set_paused(False)
        self.get_logger().info("Resuming recording.")

    def toggle_paused(self) -> None:
        """Pause, or resume."""
        if self._is_paused:
            self.resume()
        else:
            self.pause()

    @property
    def is_paused(self) -> bool:
        """Whether messages are discarded."""
        return self._is_paused

    def split_bagfile(self) -> None:
        """Write what was received into the present file, and begin the next one.

        Raises:
            BagError: one of them can't be written.
        """
        # The order matters: messages that arrive from now on count for the duration of the next file, those that wait
        # are written into the present one, and then it is completed. Without the lock, the writing thread could take
        # one of their chunks meanwhile, which would get into the next file.
        with self._lock:
            self.writer.queue.restart_file()
            if not self.writer.settings.is_snapshot:
                self.writer.write_present()
            self.writer.split()

    def take_snapshot(self) -> bool:
        """Write the messages in the cache; return False unless this is a recording in snapshot mode.

        Raises:
            BagError: they can't be written.
        """
        if not self.writer.settings.is_snapshot:
            return False
        with self._lock:
            self.writer.write_present()
        return True

    def _answers(self) -> dict[str, tuple[Any, Answer]]:
        return {
            "is_paused": (IsPaused, lambda _: {"paused": self._is_paused}),
            "pause": (Pause, lambda _: self.pause()),
            "resume": (Resume, lambda _: self.resume()),
            "snapshot": (Snapshot, lambda _: {"success": self._try_to_write(self.take_snapshot)}),
            "split_bagfile": (SplitBagfile, lambda _: self._try_to_write(self.split_bagfile)),
        }

    def _try_to_write(self, write: Callable[[], bool | None]) -> bool:
        """Return whether `write` has written, as it says itself; an error of it ends the recording."""
        try:
            return bool(write())
        except BagError as error:
            self._fail(error)
            return False

    def _on_split(self, closed: Path, opened: Path) -> None:
        get_logger("rosbag2_cpp").info(
            "Writing remaining messages from cache to the bag. It may take a while"
        )
        if self.context.ok():
            try:
                self._split_events.publish(WriteSplitEvent(closed_file=str(closed), opened_file=str(opened)))
            except Exception as error:  # noqa: BLE001  # the context may end meanwhile; the files are whole
                self.get_logger().warning(f"The split was not announced: {error}")

    def _write(self) -> None:
        """Write chunks until the queue is closed, or writing fails, for whatever reason."""
        try:
            self._write_chunks()
        except BagError as error:
            self._fail(error)
        except Exception as error:  # noqa: BLE001  # nobody else would stop a recording that writes nothing
            self._fail(BagError(self.writer.folder, f"writing has ended: {_error_text(error)}"), error)

    def _write_chunks(self) -> None:
        queue = self.writer.queue
        while not self._ended.is_set():
            if self.writer.settings.is_snapshot:  # chunks stay in the queue until `take_snapshot`
                self._ended.wait(FLUSH_NS / 1e9)
                continue
            # Wait for a whole chunk, and after that time take the unfinished one: few small messages may take hours to
            # fill a chunk, and a kill would lose them all.
            queue.wait(FLUSH_NS)
            # The wait is outside of the lock, so that a split needn't wait for it. Taking and writing are inside: a
            # split between them would complete the file before this chunk, which is older, has got into it.
            with self._lock:
                chunk = queue.take(0)
                if chunk is not None:
                    self.writer.write_chunk(chunk)

    def _fail(self, failure: BagError, cause: Exception | None = None) -> None:
        """End the recording because of an error; what was written stays readable."""
        self.writer.queue.close()
        if self.failure is None:
            failure.__cause__ = cause
            self.failure = failure
            self.get_logger().error(f"Recording ends: {failure}")

    def _discover(self) -> None:
        """Subscribe to topics as they appear, until that fails or the recording ends."""
        if self.options.is_discovery_disabled:
            return
        try:
            self._subscribe_to_new()
        except Exception as error:  # noqa: BLE001  # else topics that come later would be missing in silence
            if self.context.ok() and not self._ended.is_set():
                failure = BagError(
                    self.writer.folder, f"no more topics can be subscribed to: {_error_text(error)}"
                )
                self._fail(failure, error)

    def _subscribe_to_new(self) -> None:
        while not self._ended.wait(self.options.polling_interval_s):
            if self._topics.is_complete:
                self.get_logger().info("All requested topics are subscribed. Stopping discovery...")
                return
            self._topics.subscribe_changed()

    def _follow_clock(self) -> None:
        """Stamp messages with the simulated time."""
        queue = self.writer.queue
        clock = self.get_clock()
        # 0 is an unknown time: until the first message of /clock, nothing is recorded rather than with wrong stamps.
        queue.set_simulated_time(0)

        def follow(_: Any) -> None:
            queue.set_simulated_time(clock.now().nanoseconds)

        # With this threshold, each change of the clock is a jump. The queue keeps the time, because it stamps messages
        # on the threads of the wire, which run no Python.
        threshold = JumpThreshold(
            min_forward=Duration(nanoseconds=1), min_backward=Duration(nanoseconds=-1), on_clock_change=True
        )
        self._jump_handle = clock.create_jump_callback(threshold, post_callback=follow)

    def _report_losses(self) -> None:
        dropped = self.writer.queue.dropped_count
        if dropped:
            self.get_logger().warning(
                f"Cache buffers lost messages: {dropped} of {dropped + self.writer.queue.message_count} were dropped, "
                "because they came faster than they could be written. A larger --max-cache-size holds more."
            )
        lost = self._topics.lost_count()
        if lost:
            self.get_logger().warning(f"{lost} messages were lost before they arrived.")


def _error_text(error: Exception) -> str:
    return f"{type(error).__name__}: {error}"
