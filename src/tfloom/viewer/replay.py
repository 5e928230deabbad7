"""What a display shows to which all messages matter: the same at one time, whatever it showed before."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.viewer.fault_text import fault_text
from tfloom.viewer.history import START

if TYPE_CHECKING:
    from tfloom.viewer.displays.display import KeepingDisplay
    from tfloom.viewer.history import MessageLog, Place

__all__ = ["Cursor", "Replay", "State"]

STATE_MESSAGES = 256
STATE_BYTES = 8 * 1024 * 1024
"""Number and size of messages after which a state is kept, from which an earlier time is reached."""
MAX_STATES = 40
"""Number of states that are kept of a recording; of more, every second one is."""
READ_S = 0.5
"""How long messages of an earlier time are read for one picture [s]."""
NEVER_NS = 2**63
"""After all times [ns since epoch]."""


class State(NamedTuple):
    """What a display knows after all messages up to a place."""

    place: Place
    newest_ns: int
    """The time from which all of them count [ns since epoch]."""
    saved: Any
    known: int
    """How many messages these are."""


class Cursor:
    """A display, and which messages it knows."""

    def __init__(self, display: KeepingDisplay, state: State) -> None:
        self.display = display
        display.restore(state.saved)
        self.place = state.place
        self.newest_ns = state.newest_ns
        self.skipped_ns = NEVER_NS
        """The time from which the first one counts that it was not given [ns since epoch]."""
        self.known = state.known
        """How many messages it knows."""
        self.fault = ""
        """Why the last one can't be shown; empty if it can."""
        self.is_behind = False
        """Whether there are more than could be read for one picture."""

    def is_of(self, until_ns: int) -> bool:
        """Return whether it knows nothing that doesn't count at a time, and was not refused what does."""
        return self.newest_ns <= until_ns < self.skipped_ns


class Replay:
    """Gives displays all messages up to a time, in the order in which they came. One thread may use it.

    Args:
        make: Returns a new display.
        log: The messages.
        decode: Returns the message of an entry's bytes.
        base: What displays know before the first message; None: nothing.
    """

    def __init__(
        self,
        make: Callable[[], KeepingDisplay],
        log: MessageLog,
        decode: Callable[[bytes], Any],
        base: State | None = None,
    ) -> None:
        self._make = make
        self._log = log
        self._decode = decode
        self._states = [base or State(START, -NEVER_NS, make().saved(), 0)]
        """In order; the first one counts at all times."""
        self._all = None if log.is_whole else Cursor(make(), self._states[0])
        """Knows all messages, as they come."""
        self._held: Cursor | None = None
        """Knows those up to the time that was shown last, if one was."""
        self._unsaved = (0, 0)
        """Number and size of the messages since the last state."""
        self._steps = 1
        """How many times as many messages there are between states as at first."""

    def show(self, stamp_ns: int | None) -> Cursor:
        """Return a display with the messages up to a time [ns since epoch]; None: all."""
        if self._all is not None:
            self._read(self._all, None, math.inf)
            self._trim()
            if stamp_ns is None:
                self._held = None
                return self._all
        until_ns = NEVER_NS - 1 if stamp_ns is None else stamp_ns
        first, *others = self._states
        state = next((state for state in reversed(others) if state.newest_ns <= until_ns), first)
        held = self._held
        if held is None or not held.is_of(until_ns) or held.place < state.place:
            self._held = held = Cursor(self._make() if held is None else held.display, state)
        self._read(held, stamp_ns, time.monotonic() + READ_S)
        return held

    def base(self) -> State | None:
        """Return what displays know before the first message of a later log; None where that has all again."""
        if self._log.is_whole:
            return None
        cursor = self.show(None)
        return State(START, -NEVER_NS, cursor.display.saved(), cursor.known)

    def _read(self, cursor: Cursor, stamp_ns: int | None, end_s: float) -> None:
        until_ns = NEVER_NS - 1 if stamp_ns is None else stamp_ns
        cursor.is_behind = False
        first = cursor.place
        for place, from_ns, entry in self._log.after(cursor.place, stamp_ns):
            if time.monotonic() > end_s and cursor.place > first:
                cursor.is_behind = True
                return
            cursor.place = place
            if from_ns > until_ns:
                cursor.skipped_ns = min(cursor.skipped_ns, from_ns)
                continue
            cursor.newest_ns = max(cursor.newest_ns, from_ns)
            cursor.known += 1
            try:
                cursor.display.take(self._decode(entry.data), entry.stamp_ns)
                cursor.fault = ""
            except Exception as error:  # of one message: the others are shown
                cursor.fault = fault_text(error)
            if cursor.skipped_ns == NEVER_NS and place > self._states[-1].place:
                self._save(cursor, len(entry.data))

    def _save(self, cursor: Cursor, size: int) -> None:
        """Keep what a display knows, if there were many messages since the last time."""
        self._unsaved = self._unsaved[0] + 1, self._unsaved[1] + size
        count, total = self._unsaved
        if count >= self._steps * STATE_MESSAGES or total >= self._steps * STATE_BYTES:
            self._unsaved = (0, 0)
            self._states.append(State(cursor.place, cursor.newest_ns, cursor.display.saved(), cursor.known))
            if self._log.is_whole and len(self._states) > MAX_STATES:
                del self._states[1:-1:2]
                self._steps *= 2

    def _trim(self) -> None:
        """Let the log drop messages that are too old, if there is a state that has them."""
        droppable = self._log.droppable()
        while len(self._states) > 1 and self._states[1].place <= droppable:
            del self._states[0]
            self._log.drop(self._states[0].place)
