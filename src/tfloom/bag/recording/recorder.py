"""The node that records: it finds topics, subscribes, and writes what it receives."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tfloom.bag.errors import BagError
from tfloom.bag.recording.discovery import Discovery
from tfloom.bag.recording.recorded_topics import RecordedTopics, RecordOptions
from tfloom.bag.recording.recorder_services import RefusedError, serve_recorder
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.common.signals import signals_deferred
from tfloom.interfaces.rosbag2_interfaces.msg import (
    MessagesLostEvent,
    MessagesLostEventTopicStat,
    WriteSplitEvent,
)
from tfloom.node.clock.clock import Clock, JumpHandle
from tfloom.node.clock.time_jump import JumpThreshold
from tfloom.node.context.context import Context
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.log.logging import get_logger
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import ClockType
from tfloom.rmw.base import Participant

__all__ = ["Learn", "Recorder"]

FLUSH_NS = 1_000_000_000
"""How long messages wait at most until they are written, so that a kill loses no more [ns]."""
MAX_LOSSES_HZ = 1000.0
Learn = Callable[[Participant, str], object]
"""Makes the classes of a type from the descriptions of peers; what it returns is not used."""


class Recorder(Node):
    """Records topics into a bag, from `start` to `stop`, and after that into others, from `record` to `stop`.

    Its services are those of rosbag2_recorder: ~/is_paused, ~/pause, ~/resume, ~/snapshot, ~/split_bagfile, ~/record,
    ~/stop, ~/start_discovery, ~/stop_discovery, ~/is_discovery_running. Any thread may call its methods; `_lock` guards
    what writes, and `_transition` what begins and ends.

    Args:
        folder: The bag's folder, which must not exist.
        settings: How the bag is written.
        options: What is recorded.
        node_name: The node's name.
        learn: Called for a type without a definition here.
        context: The node's context; None: the default one.
        waits: Whether the bag is created by `record`, as another one after `stop`, and not now.

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
        *,
        waits: bool = False,
    ) -> None:
        overrides = [Parameter("use_sim_time", value=True)] if options.use_sim_time else []
        super().__init__(node_name, context=context, parameter_overrides=overrides)
        self.options = options
        self.failure: BagError | None = None
        """Why recording ended, if it could not go on."""
        self._folder = folder
        self._settings = settings
        self._learn = learn
        self._is_paused = options.is_start_paused
        self._lock = threading.Lock()
        """Guards the writer: one thread uses it at a time."""
        self._transition = threading.RLock()
        """Guards the threads, the pause, the writer's replacement and that of the topics: one change at a time."""
        self._ended = threading.Event()
        self._writing: threading.Thread | None = None
        self._jump_handle: JumpHandle | None = None
        self._split_events = self.create_publisher(WriteSplitEvent, "events/write_split", 1)
        self._discovery = self._make_discovery()
        self._told_losses: dict[str, tuple[int, int]] = {}
        self._loss_events = self._make_loss_events()
        if options.has_keyboard:
            self.get_logger().info("Press SPACE for pausing/resuming")
        if waits:
            self._ended.set()
        else:
            try:
                self._open(folder)
            except BagError:
                self.destroy_node()
                raise
        serve_recorder(self)

    def start(self) -> None:
        """Subscribe to the topics that exist, and go on in threads: with discovery, and with writing.

        Raises:
            BagError: a thread can't be started; the recording has ended.
        """
        with self._transition:
            self.get_logger().info("Listening for topics...")
            self.get_logger().info("Event publisher thread: Starting")
            if self.options.use_sim_time:
                self._follow_clock()
            self._topics.subscribe_all()
            self._say_what_begins()
            writing = threading.Thread(target=self._write, daemon=True)
            try:
                writing.start()
                self._writing = writing
                if not self.options.is_discovery_disabled:
                    self._discovery.start()
            except RuntimeError as error:
                self.stop()
                raise BagError(self.writer.folder, f"recording needs two threads: {error}") from error

    def record(self, uri: str = "") -> None:
        """Record into another bag, after `stop`. Messages are discarded until `resume`, because `stop` pauses.

        Args:
            uri: The bag's folder, which must not exist; empty: that of the last one, or the one given at first.

        Raises:
            RefusedError: this is recording.
            BagError: the folder exists, or can't be written, or a thread can't be started.
        """
        with self._transition:
            if self.is_recording:
                raise RefusedError("Recorder is already recording.", "while already recording")
            self._open(Path(uri) if uri else self._folder)
            self._ended.clear()
            self.start()

    def stop(self) -> None:
        """End the threads, write what is left, and complete the bag. Stopping again does nothing.

        Raises:
            BagError: the bag can't be completed, and there was no `failure` before; what was written stays readable.
        """
        with self._transition, signals_deferred():
            if self.is_recording:
                self._stop()

    def _open(self, folder: Path) -> None:
        """Create the bag, and begin with no topics."""
        self.writer = BagWriter(folder, self._settings, self._on_split)
        self._folder = folder
        self._told_losses = {}
        if self._settings.storage_id == "sqlite3":
            get_logger("rosbag2_storage").info(f"Opened database '{self.writer.file_path}' for READ_WRITE.")
        self.writer.set_paused(self._is_paused)
        self._topics = RecordedTopics(self, self.writer, self.options, self._learn)
        self._discovery = self._make_discovery()

    def _make_discovery(self) -> Discovery:
        return Discovery(self._subscribe_to_new, self.options.polling_interval_s, self._on_failed_discovery)

    def _make_loss_events(self) -> Publisher[MessagesLostEvent] | None:
        """Return the publisher of what was lost, which a timer calls; None if that isn't wanted."""
        if self.options.losses_hz <= 0.0:
            return None
        # By a clock that can't stand still, as simulated time does.
        clock = Clock(clock_type=ClockType.STEADY_TIME)
        self.create_timer(
            1.0 / min(self.options.losses_hz, MAX_LOSSES_HZ), self._announce_losses, clock=clock
        )
        return self.create_publisher(MessagesLostEvent, "events/rosbag2_messages_lost", 1)

    def _announce_losses(self) -> None:
        """Publish how many messages of topics have been lost since the last time, if there were any."""
        if self._loss_events is None or not self.is_recording:
            return
        losses = self._topics.losses()
        told, self._told_losses = self._told_losses, losses
        statistics = [
            MessagesLostEventTopicStat(
                topic_name=name,
                messages_lost_in_transport=transport - told.get(name, (0, 0))[0],
                messages_lost_in_recorder=cache - told.get(name, (0, 0))[1],
            )
            for name, (transport, cache) in sorted(losses.items())
            if (transport, cache) != told.get(name, (0, 0))
        ]
        if statistics:
            name = self.get_fully_qualified_name()
            self._loss_events.publish(MessagesLostEvent(node_name=name, messages_lost_statistics=statistics))

    def _announce_last_losses(self) -> None:
        if self.context.ok():
            try:
                self._announce_losses()
            except Exception as error:  # the context may end meanwhile; the bag is completed
                self.get_logger().warning(f"The losses were not announced: {error}")

    def _say_what_begins(self) -> None:
        if not self._is_paused:
            self.get_logger().info("Recording...")
        elif self.options.has_keyboard:
            self.get_logger().info("Wait for recording: Press SPACE to start.")

    def _stop(self) -> None:
        # First no more messages get into the queue. Then both threads end: the event ends the wait between two looks at
        # the graph, and a closed queue wakes the thread that waits for a chunk. `_lock` is not held meanwhile, because
        # that thread may need it for its last chunk. Only then can no thread subscribe any more, and the readers are
        # closed.
        self.pause()
        self._announce_last_losses()
        self._ended.set()
        self.writer.close_queues()
        self._discovery.stop()
        if self._writing is not None:
            self._writing.join()
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
        with self._transition:
            self._is_paused = True
            if self.is_recording:
                self.writer.set_paused(True)
            self.get_logger().info("Pausing recording.")

    def resume(self) -> None:
        """Record messages again."""
        with self._transition:
            self._is_paused = False
            if self.is_recording:
                self.writer.set_paused(False)
            self.get_logger().info("Resuming recording.")

    def toggle_paused(self) -> None:
        """Pause, or resume."""
        with self._transition:
            if self._is_paused:
                self.resume()
            else:
                self.pause()

    @property
    def is_paused(self) -> bool:
        """Whether messages are discarded."""
        return self._is_paused

    @property
    def is_recording(self) -> bool:
        """Whether the bag is not completed yet."""
        return not self._ended.is_set()

    def check_recording(self) -> None:
        """Raise RefusedError unless this is recording."""
        if not self.is_recording:
            raise RefusedError("Recorder is not currently recording.", "while not in recording")

    @property
    def is_discovery_running(self) -> bool:
        """Whether topics are looked for."""
        return self._discovery.is_running

    def start_discovery(self) -> None:
        """Subscribe to topics as they appear, also if the options say not to.

        Raises:
            RefusedError: they are looked for already, or this isn't recording.
            BagError: a thread can't be started.
        """
        with self._transition:
            self.check_recording()
            if self.is_discovery_running:
                raise RefusedError("Discovery is already running.", "while discovery is already running")
            try:
                self._discovery.start()
            except RuntimeError as error:
                raise BagError(self.writer.folder, f"discovery needs a thread: {error}") from error

    def stop_discovery(self) -> None:
        """Subscribe to no more topics; those that are recorded go on.

        Raises:
            RefusedError: no topics are looked for.
        """
        with self._transition:
            if not self.is_discovery_running:
                raise RefusedError("Discovery is not running.", "while discovery is not running")
            self._discovery.stop()

    def split_bagfile(self) -> None:
        """Write what was received into the present file, and begin the next one.

        Raises:
            RefusedError: this isn't recording.
            BagError: one of them can't be written.
        """
        # The order matters: messages that arrive from now on count for the duration of the next file, those that wait
        # are written into the present one, and then it is completed. Without the lock, the writing thread could take
        # one of their chunks meanwhile, which would get into the next file.
        with self._lock:
            self.check_recording()
            self.writer.queue.restart_file()
            if not self.writer.settings.is_snapshot:
                self.writer.write_present()
            self.writer.split()

    def take_snapshot(self) -> bool:
        """Write the messages in the cache; return False unless this is a recording in snapshot mode.

        Raises:
            RefusedError: this isn't recording.
            BagError: they can't be written.
        """
        if not self._settings.is_snapshot:
            return False
        with self._lock:
            self.check_recording()
            self.writer.write_present()
        return True

    def fail(self, failure: BagError, cause: Exception | None = None) -> None:
        """End the recording because of an error; what was written stays readable."""
        self.writer.close_queues()
        if self.failure is None:
            failure.__cause__ = cause
            self.failure = failure
            self.get_logger().error(f"Recording ends: {failure}")

    def _on_split(self, closed: Path, opened: Path) -> None:
        get_logger("rosbag2_cpp").info(
            "Writing remaining messages from cache to the bag. It may take a while"
        )
        if self.context.ok():
            try:
                name = self.get_fully_qualified_name()
                self._split_events.publish(
                    WriteSplitEvent(closed_file=str(closed), opened_file=str(opened), node_name=name)
                )
            except Exception as error:  # the context may end meanwhile; the files are whole
                self.get_logger().warning(f"The split was not announced: {error}")

    def _write(self) -> None:
        """Write chunks until the queue is closed, or writing fails, for whatever reason."""
        try:
            self._write_chunks()
        except BagError as error:
            self.fail(error)
        except Exception as error:  # nobody else would stop a recording that writes nothing
            self.fail(BagError(self.writer.folder, f"writing has ended: {_error_text(error)}"), error)

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

    def _on_failed_discovery(self, error: Exception) -> None:
        """End the recording because topics that appear can't be subscribed to."""
        if self.context.ok() and self.is_recording:
            reason = f"no more topics can be subscribed to: {_error_text(error)}"
            self.fail(BagError(self.writer.folder, reason), error)

    def _subscribe_to_new(self) -> bool:
        """Subscribe to what has appeared; return whether all topics are recorded that may ever be wanted."""
        if self._topics.is_complete:
            self.get_logger().info("All requested topics are subscribed. Stopping discovery...")
            return True
        self._topics.subscribe_changed()
        return False

    def _follow_clock(self) -> None:
        """Stamp messages with the simulated time."""
        clock = self.get_clock()

        def follow(_: Any = None) -> None:
            self.writer.set_simulated_time(clock.now().nanoseconds)

        # 0 is an unknown time: until the first message of /clock, nothing is recorded rather than with wrong stamps.
        follow()
        if self._jump_handle is not None:
            return
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
