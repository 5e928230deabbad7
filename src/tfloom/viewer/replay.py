"""What a display shows to which all messages matter: the same at one time, whatever it showed before."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.viewer.page_command import fault_text
from tfloom.viewer.topic_log import START, Cursor

if TYPE_CHECKING:
    from tfloom.viewer.displays.display import KeepingDisplay
    from tfloom.viewer.topic_log import Entry

__all__ = ["Known", "Replay", "State"]

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
    """What a display knows after all messages up to one of them."""

    number: int
    """The number of the last one."""
    newest_ns: int
    """The time from which all of them count [ns since epoch]."""
    saved: Any
    messages: int
    """How many messages these are."""


class Known:
    """A display, and which messages it knows."""

    def __init__(self, display: KeepingDisplay, state: State, cursor: Cursor) -> None:
        self.display = display
        display.restore(state.saved)
        self.cursor = cursor
        self.newest_ns = state.newest_ns
        self.skipped_ns = NEVER_NS
        """The time from which the first one counts that it was not given [ns since epoch]."""
        self.messages = state.messages
        """How many messages it knows."""
        self.fault = ""
        """Why the last one can't be shown; empty if it can."""

    def is_of(self, until_ns: int) -> bool:
        """Return whether it knows nothing that doesn't count at a time, and was not refused what does."""
        return self.newest_ns <= until_ns < self.skipped_ns


class Replay:
    """Gives displays all messages up to a time, in the order in which they came. One thread may use it.

    Args:
        make: Returns a new display.
        cursor: The place in the log behind which messages may be read again; it is moved.
        base: What displays know before the first message; None: nothing.
    """

    def __init__(self, make: Callable[[], KeepingDisplay], cursor: Cursor, base: State | None = None) -> None:
        self._make = make
        self._cursor = cursor
        self._log = cursor.log
        self._states = [base or State(START, -NEVER_NS, make().saved(), 0)]
        """In order; the first one counts at all times."""
        self._all = None if self._log.is_whole else self._known(make(), self._states[0])
        """Knows all messages, as they come."""
        self._held: Known | None = None
        """Knows those up to the time that was shown last, if one was."""
        self._unsaved = (0, 0)
        """Number and size of the messages since the last state."""
        self._steps = 1
        """How many times as many messages there are between states as at first."""

    def _known(self, display: KeepingDisplay, state: State) -> Known:
        return Known(display, state, Cursor(self._log, state.number))

    def show(self, stamp_ns: int | None) -> Known:
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
        if held is None or not held.is_of(until_ns) or held.cursor.number < state.number:
            self._held = held = self._known(self._make() if held is None else held.display, state)
        self._read(held, stamp_ns, READ_S)
        return held

    def base(self) -> State | None:
        """Return what displays know before the first message of a later log; None where that has all again."""
        if self._log.is_whole:
            return None
        known = self.show(None)
        return State(START, -NEVER_NS, known.display.saved(), known.messages)

    def _read(self, known: Known, stamp_ns: int | None, limit_s: float) -> None:
        until_ns = NEVER_NS - 1 if stamp_ns is None else stamp_ns
        for entry in known.cursor.read(stamp_ns, limit_s):
            if entry.from_ns > until_ns:
                known.skipped_ns = min(known.skipped_ns, entry.from_ns)
                continue
            known.newest_ns = max(known.newest_ns, entry.from_ns)
            known.messages += 1
            try:
                known.display.take(entry.message(), entry.stamp_ns)
                known.fault = ""
            except Exception as error:  # of one message: the others are shown
                known.fault = fault_text(error)
            if known.skipped_ns == NEVER_NS and entry.number > self._states[-1].number:
                self._save(known, entry)

    def _save(self, known: Known, entry: Entry) -> None:
        """Keep what a display knows, if there were many messages since the last time."""
        self._unsaved = self._unsaved[0] + 1, self._unsaved[1] + len(entry.data)
        count, total = self._unsaved
        if count >= self._steps * STATE_MESSAGES or total >= self._steps * STATE_BYTES:
            self._unsaved = (0, 0)
            self._states.append(State(entry.number, known.newest_ns, known.display.saved(), known.messages))
            if self._log.is_whole and len(self._states) > MAX_STATES:
                del self._states[1:-1:2]
                self._steps *= 2

    def _trim(self) -> None:
        """Let the log drop messages that have left its history, if there is a state that has them."""
        while len(self._states) > 1 and self._states[1].number < self._log.first:
            del self._states[0]
        self._cursor.number = self._states[0].number
