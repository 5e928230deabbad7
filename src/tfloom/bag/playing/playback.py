"""The course of playing: which message comes next, and when. Any thread may pause it, set its rate, seek and step."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from enum import Enum

from tfloom.bag.bag import Bag
from tfloom.bag.playing.play_clock import PlayClock
from tfloom.bag.playing.read_ahead import ReadAhead, by_sent_time
from tfloom.bag.values import RawMessage

__all__ = ["Playback"]

STEP_PATIENCE_S = 10.0
"""How long a step waits at most until its messages are published [s]."""
MAX_WAIT_S = 1e9
"""The longest wait at once, because the system's waits have a limit [s]: 31 years."""


class _Turn(Enum):
    """What ends the wait for a message's time."""

    PUBLISH = 1
    SEEK = 2
    STOP = 3


class Playback:
    """Plays the messages of topics of a bag once, from one time to another, in `run`.

    Args:
        bag: The bag.
        topics: Names of the topics that are played.
        bounds: The first and the last log time that are played [ns since epoch].
        rate: Seconds of the bag in a second.
        read_ahead: Number of messages that are read ahead, at most.
        on_message: Called for each message, on the thread of `run`.
        on_start: Called with the time at which playing starts, again after each seek, on the same thread.
        is_by_sent_time: Whether messages are played by the times at which they were published, not received.
    """

    def __init__(
        self,
        bag: Bag,
        topics: set[str],
        bounds: tuple[int, int],
        rate: float,
        read_ahead: int,
        on_message: Callable[[RawMessage], None],
        on_start: Callable[[int], None],
        *,
        is_by_sent_time: bool = False,
    ) -> None:
        self._bag = bag
        self._topics = sorted(topics)
        self._bounds = bounds
        self._read_ahead = read_ahead
        self._on_message = on_message
        self._on_start = on_start
        self._is_by_sent_time = is_by_sent_time
        self._changed = threading.Condition()
        """Guards all below."""
        self._clock = PlayClock(bounds[0], rate)
        self._is_paused = True
        self._is_running = False
        self._is_stopped = False
        self._seek_ns: int | None = None
        self._steps = 0
        self._stepped = 0

    @property
    def is_paused(self) -> bool:
        """Whether it is paused."""
        return self._is_paused

    @property
    def rate(self) -> float:
        """Seconds of the bag in a second."""
        return self._clock.rate

    def now_ns(self) -> int:
        """Return the time of the bag [ns since epoch]."""
        with self._changed:
            return min(self._clock.now_ns(), self._bounds[1])

    def set_paused(self, is_paused: bool) -> None:
        """Pause, or go on."""
        with self._changed:
            self._is_paused = is_paused
            if self._is_running:
                self._clock.set_paused(is_paused)
            self._changed.notify_all()

    def set_rate(self, rate: float) -> bool:
        """Set the rate; return False unless it is above 0 and finite."""
        if not 0.0 < rate < math.inf:
            return False
        with self._changed:
            self._clock.set_rate(rate)
            self._changed.notify_all()
        return True

    def set_bounds(self, start_ns: int, end_ns: int) -> None:
        """Set the first and the last log time of the next `run` [ns since epoch]."""
        with self._changed:
            self._bounds = (start_ns, end_ns)

    def seek(self, stamp_ns: int) -> bool:
        """Go on at a time; return False unless the bag has it."""
        if not self._bag.start_ns <= stamp_ns <= self._bag.end_ns:
            return False
        with self._changed:
            self._seek_ns = stamp_ns
            self._clock.set_now(stamp_ns)
            self._changed.notify_all()
        return True

    def seek_by(self, offset_ns: int) -> None:
        """Go on at a time that is earlier or later by an offset, within the bag."""
        first, last = self._bag.start_ns, self._bag.end_ns
        self.seek(min(max(self.now_ns() + offset_ns, first), last))

    def burst(self, count: int) -> int:
        """Wait for the beginning of `run`, which is paused, and step; see `step`."""
        with self._changed:
            self._changed.wait_for(lambda: self._is_running or self._is_stopped, STEP_PATIENCE_S)
        return self.step(count)

    def step(self, count: int) -> int:
        """Publish messages at once while it is paused, and return how many were published.

        Args:
            count: How many; 0: all that are left.
        """
        with self._changed:
            if not self._is_paused or not self._is_running:
                return 0
            before = self._stepped
            # The thread of `run` counts the steps down, and publishes. A negative number stays as it is, so that it
            # asks for all messages until `run` ends and sets it to 0.
            self._steps = count or -1
            self._changed.notify_all()
            # The patience is for one message, not for all: the wait ends early only if no message at all was published
            # within it.
            while self._steps and self._is_running and not self._is_stopped:
                last_stepped = self._stepped
                if not self._changed.wait(STEP_PATIENCE_S) and self._stepped == last_stepped:
                    break
            return self._stepped - before

    def stop(self) -> None:
        """Have `run` return, on whatever thread it waits or publishes."""
        with self._changed:
            self._is_stopped = True
            self._changed.notify_all()

    def restart(self) -> None:
        """Let the next `run` play, although `stop` was called; no other may be running."""
        with self._changed:
            self._is_stopped = False
            self._seek_ns = None

    @property
    def is_stopped(self) -> bool:
        """Whether `stop` was called."""
        return self._is_stopped

    def wait(self, seconds: float) -> bool:
        """Wait; return False if it was stopped meanwhile."""
        with self._changed:
            return not self._changed.wait_for(lambda: self._is_stopped, min(seconds, MAX_WAIT_S))

    def run(self) -> None:
        """Play from the first to the last time, unless it is stopped.

        Raises:
            BagError: the bag can't be read.
        """
        with self._changed:
            # `burst` waits for `_is_running`, because a step before that would be refused.
            start_ns: int | None = self._bounds[0]
            self._clock.set_now(self._bounds[0])
            self._is_running = True
            self._clock.set_paused(self._is_paused)
            self._changed.notify_all()
        try:
            while start_ns is not None:
                self._on_start(start_ns)
                start_ns = self._play_from(start_ns)
        finally:
            # A thread that waits in `step` must learn that no message follows, also if reading has failed.
            with self._changed:
                self._is_running = False
                self._steps = 0
                self._clock.set_paused(True)
                self._changed.notify_all()

    def _play_from(self, start_ns: int) -> int | None:
        """Play from a time on; return the time of a seek, or None at the end."""
        unread = self._bag.messages(self._topics, start_ns, self._bounds[1])
        if self._is_by_sent_time:
            unread = by_sent_time(unread, self._read_ahead)
        messages = ReadAhead(self._bag.path, unread, self._read_ahead)
        is_first = True
        try:
            for message in messages:
                if self._is_by_sent_time and is_first:
                    # Other machines' clocks may differ by any time from that of the recorder, whose the bounds are.
                    with self._changed:
                        self._clock.set_now(message.log_time_ns)
                is_first = False
                turn = self._wait_for(message.log_time_ns)
                if turn is not _Turn.PUBLISH:
                    break
                self._on_message(message)  # without the lock: it may call any method of this object
            # A seek may also come during the last message, which ends the loop without another wait. So the seek, not
            # the reason why the loop ended, tells whether to go on.
            with self._changed:
                seek_ns, self._seek_ns = self._seek_ns, None
                return None if self._is_stopped else seek_ns
        finally:
            messages.close()

    def _wait_for(self, stamp_ns: int) -> _Turn:
        """Wait until a message's time, or for a step."""
        # Each change wakes this thread, which then looks at everything anew: a pause, another rate or a seek changes
        # how long to wait, so no deadline is kept over a wait. Stopping comes before all else, and a seek before a
        # step, because the message at hand is none of those after the seek.
        with self._changed:
            while True:
                if self._is_stopped:
                    return _Turn.STOP
                if self._seek_ns is not None:
                    return _Turn.SEEK
                if self._is_paused:
                    if self._steps:
                        self._take_step(stamp_ns)
                        return _Turn.PUBLISH
                    self._changed.wait()
                    continue
                left_s = self._clock.wait_s(stamp_ns)
                if left_s <= 0.0:
                    return _Turn.PUBLISH
                self._changed.wait(min(left_s, MAX_WAIT_S))

    def _take_step(self, stamp_ns: int) -> None:
        self._steps -= self._steps > 0
        self._stepped += 1
        self._clock.set_now(stamp_ns)
        self._changed.notify_all()
