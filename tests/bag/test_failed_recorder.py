"""Recorders whose threads meet an error, and their splits."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.bag.recordings import rows_of
from tests.bag.written_bags import CHATTER, START_NS, STEP_NS, push, raising, row, text
from tests.conftest import wait_until

from tfloom._native import Chunk
from tfloom.bag.errors import BagError
from tfloom.bag.metadata import read_metadata
from tfloom.bag.recording import recorder as recorder_module
from tfloom.bag.recording.recorded_topics import RecordOptions
from tfloom.bag.recording.recorder import Recorder
from tfloom.bag.recording.recorder_services import answers_of
from tfloom.bag.topic_choice import TopicChoice
from tfloom.bag.writing.bag_writer import WriterSettings
from tfloom.node.context.context import Context

Start = Callable[[WriterSettings], tuple[Recorder, int]]


@pytest.fixture
def started(local_context: Context, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Start]:
    """Start a recorder of what a test pushes into its queue; it is stopped at the end.

    Return it, and the channel of /chatter.
    """
    monkeypatch.setattr(recorder_module, "FLUSH_NS", 10_000_000)
    recorders: list[Recorder] = []

    def start(settings: WriterSettings) -> tuple[Recorder, int]:
        options = RecordOptions(TopicChoice(["/late"]), polling_interval_s=0.01, has_keyboard=False)
        recorder = Recorder(tmp_path / "bag", settings, options, context=local_context)
        recorders.append(recorder)
        recorder.start()
        return recorder, recorder.writer.add_topic(CHATTER)

    yield start
    for recorder in recorders:
        recorder.stop()
        recorder.destroy_node()


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
@pytest.mark.parametrize(
    ("error", "reason"),
    [
        (RuntimeError("dictionary changed size"), "RuntimeError: dictionary changed size"),
        (OSError(28, "No space left on device"), "No space left on device"),
    ],
)
def test_any_error_while_writing_ends_the_recording_loudly(
    error: Exception,
    reason: str,
    storage_id: str,
    started: Start,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: Any,
) -> None:
    recorder, channel = started(WriterSettings(storage_id))
    push(recorder.writer.queue, channel, 0)
    wait_until(lambda: recorder.writer.message_count == 1)
    with monkeypatch.context() as patched:
        patched.setattr(recorder.writer._file, "write", raising(error))
        push(recorder.writer.queue, channel, 1)
        wait_until(lambda: recorder.failure is not None)
    assert f"it can't be written: {reason}" in str(recorder.failure)
    assert not recorder.writer.queue.push(channel, text(2), START_NS, START_NS)
    recorder.stop()
    assert "Recording ends: " in capfd.readouterr().err
    assert rows_of(tmp_path / "bag") == [row(0), row(1)]  # written by a second try


def test_error_beside_the_files_ends_the_recording_loudly(
    started: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    recorder, channel = started(WriterSettings())
    monkeypatch.setattr(recorder.writer, "_count", raising(ValueError("odd")))
    push(recorder.writer.queue, channel, 0)
    wait_until(lambda: recorder.failure is not None)
    assert "bag: writing has ended: ValueError: odd" in str(recorder.failure)
    monkeypatch.undo()


def test_error_in_discovery_ends_the_recording_loudly(
    started: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    recorder, channel = started(WriterSettings())
    push(recorder.writer.queue, channel, *range(3))
    with monkeypatch.context() as patched:
        patched.setattr(recorder._topics, "subscribe_changed", raising(ValueError("odd")))
        wait_until(lambda: recorder.failure is not None)
    assert "bag: no more topics can be subscribed to: ValueError: odd" in str(recorder.failure)
    recorder.stop()
    assert rows_of(tmp_path / "bag") == [row(0), row(1), row(2)]


def test_split_that_cannot_be_announced_is_a_split(
    started: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: Any
) -> None:
    recorder, channel = started(WriterSettings())
    monkeypatch.setattr(recorder._split_events, "publish", raising(ValueError("odd")))
    push(recorder.writer.queue, channel, 0)
    recorder.split_bagfile()
    push(recorder.writer.queue, channel, 1)
    recorder.stop()
    assert recorder.failure is None
    assert "The split was not announced: odd" in capfd.readouterr().err
    assert [file.message_count for file in read_metadata(tmp_path / "bag").files] == [1, 1]


def test_duration_of_a_file_is_counted_from_the_split(started: Start, tmp_path: Path) -> None:
    recorder, channel = started(WriterSettings(max_file_duration_ns=10 * STEP_NS))
    push(recorder.writer.queue, channel, *range(6))
    recorder.split_bagfile()
    push(recorder.writer.queue, channel, *range(6, 20))
    recorder.stop()
    files = read_metadata(tmp_path / "bag").files
    spans = [(file.start_ns - START_NS, file.duration_ns, file.message_count) for file in files]
    assert spans == [
        (0, 5 * STEP_NS, 6),
        (6 * STEP_NS, 10 * STEP_NS, 11),
        (17 * STEP_NS, 2 * STEP_NS, 3),
    ]


def test_first_failure_is_told(started: Start, capfd: Any) -> None:
    recorder, _ = started(WriterSettings())
    first, second = (BagError(recorder.writer.folder, text_) for text_ in ("first", "second"))
    recorder.fail(first)
    recorder.fail(second)
    assert recorder.failure is first
    assert capfd.readouterr().err.count("Recording ends: ") == 1


def test_failed_service_ends_the_recording(started: Start, monkeypatch: pytest.MonkeyPatch) -> None:
    recorder, _ = started(WriterSettings(is_snapshot=True))
    fail = raising(BagError(recorder.writer.folder, "full"))
    monkeypatch.setattr(recorder.writer, "write_present", fail)
    monkeypatch.setattr(recorder.writer, "split", fail)
    answers = {name: answer for name, (_, answer) in answers_of(recorder).items()}
    assert answers["snapshot"](None) == {"success": False}
    assert "full" in str(recorder.failure)
    recorder.failure = None
    answers["split_bagfile"](None)
    assert "full" in str(recorder.failure)


@pytest.mark.parametrize("has_failed", [False, True])
def test_bag_that_cannot_be_completed(
    has_failed: bool, started: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    recorder, _ = started(WriterSettings())
    fail = raising(BagError(recorder.writer.folder, "full"))
    with monkeypatch.context() as patched:
        patched.setattr(recorder.writer, "close", fail)
        if has_failed:
            recorder.fail(BagError(recorder.writer.folder, "before"))
            recorder.stop()
        else:
            with pytest.raises(BagError, match="full"):
                recorder.stop()
    recorder.writer.close()


def test_error_in_discovery_after_the_end_is_none(started: Start, monkeypatch: pytest.MonkeyPatch) -> None:
    recorder, _ = started(WriterSettings())

    def end(*_: object) -> None:
        recorder.context.shutdown()
        raise ValueError("the context has ended")

    with monkeypatch.context() as patched:
        patched.setattr(recorder._topics, "subscribe_changed", end)
        wait_until(lambda: not recorder.is_discovery_running)
    assert recorder.failure is None


def test_bag_is_completed_when_the_threads_have_ended(
    started: Start, monkeypatch: pytest.MonkeyPatch, capfd: Any
) -> None:
    recorder, channel = started(WriterSettings())
    discovering, writing, closed = threading.Event(), threading.Event(), threading.Event()
    alive: list[bool] = []
    close, write = recorder._topics.close, recorder.writer.write_chunk

    # Only a stop that doesn't wait for these threads comes to `close_topics` while they wait.
    def discover() -> None:
        discovering.set()
        closed.wait(0.2)

    def write_chunk(chunk: Chunk) -> None:
        writing.set()
        closed.wait(0.6)  # longer than the other thread, for which the stop waits first
        write(chunk)

    def close_topics() -> None:
        thread = recorder._writing
        assert thread is not None
        alive.extend((thread.is_alive(), recorder.is_discovery_running))
        closed.set()
        close()

    monkeypatch.setattr(recorder._topics, "subscribe_changed", discover)
    monkeypatch.setattr(recorder.writer, "write_chunk", write_chunk)
    monkeypatch.setattr(recorder._topics, "close", close_topics)
    push(recorder.writer.queue, channel, 0)
    assert discovering.wait(10)
    assert writing.wait(10)
    recorder.stop()
    recorder.stop()
    assert alive == [False, False]
    assert capfd.readouterr().err.count("Recording stopped") == 1
