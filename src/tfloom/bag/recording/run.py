"""A recording from its start until it is stopped."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tfloom.bag.key_presses import handled_keys
from tfloom.bag.node_running import spin_until
from tfloom.bag.recording.recorded_topics import RecordOptions
from tfloom.bag.recording.recorder import Learn, Recorder
from tfloom.bag.writing.bag_writer import WriterSettings

__all__ = ["record"]


def record(
    folder: Path,
    settings: WriterSettings,
    options: RecordOptions,
    *,
    node_name: str = "rosbag2_recorder",
    learn: Learn | None = None,
    stop: threading.Event | None = None,
) -> None:
    """Record until the context is shut down, by Ctrl-C too, or `stop` is set. The default context is initialised.

    Raises:
        BagError: the bag can't be written; what was written before stays readable.
    """
    recorder: Recorder | None = None

    def toggle_paused() -> None:
        if recorder is not None:
            recorder.toggle_paused()

    with handled_keys({" ": toggle_paused}, enabled=options.has_keyboard):
        recorder = Recorder(folder, settings, options, node_name, learn)
        try:
            recorder.start()
            spin_until(recorder, lambda: recorder.failure is not None, stop)
        finally:
            with _uninterrupted():
                try:
                    recorder.stop()
                finally:
                    recorder.destroy_node()
    if recorder.failure is not None:
        raise recorder.failure


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Ignore Ctrl-C during the block, because the bag is being completed."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
