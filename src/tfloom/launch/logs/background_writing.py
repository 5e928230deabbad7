"""Writing without a wait: while a launch runs, threads write to its screen and its log files.

A terminal that is paused, a pipe that is read slowly and a slow disk each keep `write` for seconds, or for ever. The
launch must obey Ctrl-C meanwhile, and end its processes in time. So it hands texts over: each destination has a thread
that writes them in order. What waits to be written is bounded, because a process whose output goes to a destination
that is behind is not read any more, until it waits itself.

A signal that ends the launch changes this: `hurry`. Processes must be read to end in order, so what the screen does not
take is left out, and counted. Log files get every line, unless they take nothing at all for some seconds.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

__all__ = ["MAX_BACKLOG", "SCREEN", "BackgroundWriter", "BackgroundWriting", "background_writing"]

SCREEN = "screen"
"""Name of the destination that leaves lines out if a signal ends the launch; the others are paths of files."""

MAX_BACKLOG = 1_000_000
"""Characters that wait to be written, from which on a destination is behind."""
PIECE = 65_536
"""Characters that are written at a time, so that slow progress is seen as such."""

PATIENCE_S = 0.02
"""Time to wait until a text is written [s]: usually it is then, so that it stands before what comes next by `print`."""
SCREEN_S = 2.0
"""Time that the screen has for its backlog after all else has ended, if a signal ended the launch [s]."""
STUCK_S = 5.0
"""Time without any progress, after which a log file is given up if a signal ends the launch [s]."""
POLL_S = 0.01

Write = Callable[[str], None]


class BackgroundWriter:
    """One destination: a thread that writes texts in the order in which they were put.

    Any thread may call all methods. `_changed` guards the members.
    """

    def __init__(self, name: str) -> None:
        self.name = name
        self._changed = threading.Condition()
        self._waiting: deque[tuple[Write, str]] = deque()
        self._size = 0
        """Characters that are not written yet, those of the text that the thread writes now included."""
        self._progress_s = time.monotonic()
        """When something was written last, or came after there was nothing to write."""
        self._is_hurried = False
        self._dropped_lines = 0
        self._ends = False
        # A thread inside a `write` that never returns must not keep the program from its end.
        self._thread = threading.Thread(target=self._run, name=f"launch writes {name}", daemon=True)
        self._thread.start()

    @property
    def is_behind(self) -> bool:
        """Whether no more should come for now."""
        with self._changed:
            return self._size > MAX_BACKLOG and not self._drops_excess()

    @property
    def dropped_lines(self) -> int:
        """Count of the lines that were left out."""
        with self._changed:
            return self._dropped_lines

    def _drops_excess(self) -> bool:
        """Return whether what exceeds the backlog is left out."""
        patience_s = 0.0 if self.name == SCREEN else STUCK_S
        return self._is_hurried and time.monotonic() - self._progress_s >= patience_s

    def put(self, write: Write, text: str, *, is_droppable: bool) -> None:
        """Hand a text over, and wait for a moment until it is written.

        Args:
            write: Writes to the destination, on the writer's thread; its errors are its own matter.
            text: What is written.
            is_droppable: Whether the text may be left out after `hurry`.
        """
        with self._changed:
            # Normally nothing is left out, however long the backlog: the caller stops reading its process when
            # `is_behind`. After `hurry` the process is read to its end, and the backlog would grow without bound.
            if is_droppable and self._size > MAX_BACKLOG and self._drops_excess():
                self._dropped_lines += text.count("\n")
                return
            # The time without progress counts from now, not from the last text, which may be minutes ago.
            was_idle = not self._size
            if was_idle:
                self._progress_s = time.monotonic()
            self._waiting.append((write, text))
            self._size += len(text)
            self._changed.notify_all()
            if was_idle:  # else the destination is slow, and waiting would not help
                self._changed.wait_for(lambda: not self._size, PATIENCE_S)

    def hurry(self) -> None:
        """Leave out, from now on, what the destination does not take in time."""
        with self._changed:
            self._is_hurried = True

    def idle_s(self) -> float | None:
        """Return the time since the last progress [s]; None if all is written."""
        with self._changed:
            return time.monotonic() - self._progress_s if self._size else None

    def end(self) -> None:
        """End the thread; if it is inside a `write`, when that returns. What it has not written is lost."""
        with self._changed:
            self._ends = True
            is_writing = bool(self._size)
            self._changed.notify_all()
        # A thread that waits for texts ends at once; one inside a `write` may never do, and is left behind.
        if not is_writing:
            self._thread.join()

    def _run(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._waiting or self._ends)
                if self._ends:
                    return
                write, text = self._waiting.popleft()
            # Without the lock, because `put`, `is_behind` and `hurry` must not wait for a slow destination.
            for start in range(0, len(text), PIECE):
                piece = text[start : start + PIECE]
                write(piece)
                with self._changed:
                    # Now, and not when the text was taken: as long as it is inside `write`, it counts as unwritten, so
                    # that the end of the launch waits for it.
                    self._size -= len(piece)
                    self._progress_s = time.monotonic()
                    self._changed.notify_all()
                    if self._ends:
                        return


class BackgroundWriting:
    """The writers of the launches that run in this process. There is one, `background_writing`.

    Any thread may call all methods, because launches may run in several. `_lock` guards the members.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running = 0
        self._writers: dict[str, BackgroundWriter] = {}
        self._is_hurried = False

    def writer(self, name: str) -> BackgroundWriter | None:
        """Return the writer of a destination; None while no launch runs, when callers write by themselves.

        None also where the system starts no more threads: callers then wait for the destination.
        """
        with self._lock:
            if not self._running:
                return None
            if name not in self._writers:
                try:
                    self._writers[name] = BackgroundWriter(name)
                except RuntimeError:
                    return None
                # A process that first appears after the signal has its own log file, which begins hurried.
                if self._is_hurried:
                    self._writers[name].hurry()
            return self._writers[name]

    def is_behind(self, name: str) -> bool:
        """Return whether a destination has more to write than it should."""
        with self._lock:
            writer = self._writers.get(name)
        return writer is not None and writer.is_behind

    def hurry(self) -> None:
        """Leave out what is not taken in time, and end without it, because a signal ends the launch."""
        with self._lock:
            self._is_hurried = True
            writers = list(self._writers.values())
        for writer in writers:
            writer.hurry()

    @asynccontextmanager
    async def running(self, on_dropped: Callable[[str, int], None]) -> AsyncIterator[None]:
        """Write in the background for the time of a launch; at its end, wait until all is written.

        After `hurry` the wait ends, too, when SCREEN_S have passed for the screen, or a file takes nothing for STUCK_S.

        Args:
            on_dropped: Called at the end with the name of each destination that did not get all lines, and with their
                number; it may log that.
        """
        with self._lock:
            self._running += 1
        try:
            yield
        finally:
            # Launches on several threads share the writers, so the last one to end waits for them. What was left out is
            # told first, while the writers still run: `on_dropped` may log it, which adds to their texts.
            with self._lock:
                writers, is_last = list(self._writers.values()), self._running == 1
            for writer in writers if is_last else []:
                if writer.dropped_lines:
                    on_dropped(writer.name, writer.dropped_lines)
            try:
                if is_last:
                    await self._finish()
            finally:
                self._leave()

    async def _finish(self) -> None:
        import asyncio  # loaded with the first launch

        # The loop must go on meanwhile, because the handler of Ctrl-C is one of its callbacks. So this polls, in place
        # of a wait for the threads. `hurry` may come during it, and its time counts from then. The writers are asked
        # for in each round, because a line that is logged meanwhile may begin a new file.
        hurried_s: float | None = None
        while True:
            with self._lock:
                writers, is_hurried = list(self._writers.values()), self._is_hurried
            if is_hurried and hurried_s is None:
                hurried_s = time.monotonic()
            if not any(_is_awaited(writer, hurried_s) for writer in writers):
                return
            await asyncio.sleep(POLL_S)

    def _leave(self) -> None:
        with self._lock:
            self._running -= 1
            if self._running:
                return
            writers = list(self._writers.values())
            self._writers.clear()
            self._is_hurried = False
        # Without the lock, because `end` waits for a thread, and others may ask for a writer meanwhile.
        for writer in writers:
            writer.end()


def _is_awaited(writer: BackgroundWriter, hurried_s: float | None) -> bool:
    """Return whether a launch waits for a writer at its end; `hurried_s` is when it began to hurry there."""
    # Without a signal the launch waits for as long as there is something to write. After one, the screen has a fixed
    # time, because a paused terminal may never take the rest; a file is waited for while it makes progress.
    idle_s = writer.idle_s()
    if idle_s is None or hurried_s is None:
        return idle_s is not None
    return time.monotonic() - hurried_s < SCREEN_S if writer.name == SCREEN else idle_s < STUCK_S


background_writing = BackgroundWriting()
