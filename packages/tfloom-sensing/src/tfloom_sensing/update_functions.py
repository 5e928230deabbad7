"""Tasks that monitor the frequency of events and the age of stamps: diagnostic_updater's update functions."""

from __future__ import annotations

import threading
from collections.abc import Mapping

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticStatus
from tfloom.node.clock.clock import Clock
from tfloom.node.values.time import ClockType, Time
from tfloom_sensing.diagnostic_status_wrapper import DiagnosticStatusWrapper
from tfloom_sensing.diagnostic_tasks import DiagnosticTask

__all__ = [
    "FrequencyStatus",
    "FrequencyStatusParam",
    "Heartbeat",
    "TimeStampStatus",
    "TimeStampStatusParam",
]

_S_TO_NS = 1_000_000_000


class FrequencyStatusParam:
    """The limits of a FrequencyStatus.

    Args:
        freq_bound: `min` and `max`, the bounds of the frequency [Hz]; without `max` there is no upper bound. The
            mapping is read at each run, so that it can be changed.
        tolerance: Accepted deviation from the bounds, as a fraction of them.
        window_size: Length of the window in runs.
    """

    def __init__(self, freq_bound: Mapping[str, float], tolerance: float = 0.1, window_size: int = 5) -> None:
        self.freq_bound = freq_bound
        self.tolerance = tolerance
        self.window_size = window_size


class FrequencyStatus(DiagnosticTask):
    """Monitors the frequency of `tick`: WARN if it is out of bounds, ERROR without any call.

    Args:
        params: The limits.
        name: The task's name.
    """

    def __init__(self, params: FrequencyStatusParam, name: str = "FrequencyStatus") -> None:
        super().__init__(name)
        self.params = params
        self.lock = threading.Lock()
        """Guards `count`, `times`, `seq_nums` and `hist_indx`."""
        self.clear()

    def clear(self) -> None:
        """Reset the count, with a window that begins now."""
        with self.lock:
            self.count = 0
            self.times = [_now()] * self.params.window_size
            self.seq_nums = [0] * self.params.window_size
            self.hist_indx = 0

    def tick(self) -> None:
        """Count an event."""
        with self.lock:
            self.count += 1

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Report the frequency in the window, and advance the window."""
        with self.lock:
            now, index = _now(), self.hist_indx
            events = self.count - self.seq_nums[index]
            window_s = (now - self.times[index]).nanoseconds / _S_TO_NS
            self.seq_nums[index], self.times[index] = self.count, now
            self.hist_indx = (index + 1) % self.params.window_size
            count = self.count
        frequency = events / window_s if window_s > 0 else 0.0
        low, high = self._accepted()
        stat.summary(*_judge(events, frequency, low, high))
        stat.add("Events in window", f"{events}")
        stat.add("Events since startup", f"{count}")
        stat.add("Duration of window (s)", f"{window_s:f}")
        stat.add("Actual frequency (Hz)", f"{frequency:f}")
        bound = self.params.freq_bound
        if bound["min"] == bound.get("max"):
            stat.add("Target frequency (Hz)", f"{bound['min']:f}")
        if bound["min"] > 0:
            stat.add("Minimum acceptable frequency (Hz)", f"{low:f}")
        if high is not None:
            stat.add("Maximum acceptable frequency (Hz)", f"{high:f}")
        return stat

    def _accepted(self) -> tuple[float, float | None]:
        """Return the lowest and highest accepted frequency [Hz]; None without an upper bound."""
        bound, tolerance = self.params.freq_bound, self.params.tolerance
        return bound["min"] * (1 - tolerance), bound["max"] * (1 + tolerance) if "max" in bound else None


def _judge(events: int, frequency: float, low: float, high: float | None) -> tuple[bytes, str]:
    if not events:
        return DiagnosticStatus.ERROR, "No events recorded."
    if frequency < low:
        return DiagnosticStatus.WARN, "Frequency too low."
    if high is not None and frequency > high:
        return DiagnosticStatus.WARN, "Frequency too high."
    return DiagnosticStatus.OK, "Desired frequency met"


class TimeStampStatusParam:
    """The limits of a TimeStampStatus.

    Args:
        min_acceptable: Smallest age of a stamp [s]; a negative one accepts stamps in the future.
        max_acceptable: Largest age [s].
    """

    def __init__(self, min_acceptable: float = -1, max_acceptable: float = 5) -> None:
        self.max_acceptable = max_acceptable
        self.min_acceptable = min_acceptable


class TimeStampStatus(DiagnosticTask):
    """Monitors the age of stamps at the call of `tick`: ERROR in the run after a stamp out of limits.

    Args:
        params: The limits; None: the defaults.
        name: The task's name.
    """

    def __init__(self, params: TimeStampStatusParam | None = None, name: str = "Timestamp Status") -> None:
        super().__init__(name)
        self.params = params or TimeStampStatusParam()
        self.lock = threading.Lock()
        """Guards the counts and the state since the last run."""
        self.early_count = 0
        self.late_count = 0
        self.zero_count = 0
        self._forget()

    def _forget(self) -> None:
        self.zero_seen = False
        self.max_delta = 0.0
        self.min_delta = 0.0
        self.deltas_valid = False

    def tick(self, stamp: float | Time | TimeMessage) -> None:
        """Record a stamp: seconds since the epoch, or a time."""
        if isinstance(stamp, TimeMessage):
            stamp = Time.from_msg(stamp)
        stamp_s = stamp.nanoseconds / _S_TO_NS if isinstance(stamp, Time) else float(stamp)
        with self.lock:
            if stamp_s == 0:
                self.zero_seen = True
                return
            delta = _now().nanoseconds / _S_TO_NS - stamp_s
            self.max_delta = max(self.max_delta, delta) if self.deltas_valid else delta
            self.min_delta = min(self.min_delta, delta) if self.deltas_valid else delta
            self.deltas_valid = True

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Report the stamps since the last run."""
        with self.lock:
            stat.summary(*self._judge())
            stat.add("Earliest timestamp delay:", f"{self.min_delta:f}")
            stat.add("Latest timestamp delay:", f"{self.max_delta:f}")
            stat.add("Earliest acceptable timestamp delay:", f"{self.params.min_acceptable:f}")
            stat.add("Latest acceptable timestamp delay:", f"{self.params.max_acceptable:f}")
            stat.add("Late diagnostic update count:", f"{self.late_count}")
            stat.add("Early diagnostic update count:", f"{self.early_count}")
            stat.add("Zero seen diagnostic update count:", f"{self.zero_count}")
            self._forget()
        return stat

    def _judge(self) -> tuple[bytes, str]:
        """Count each kind of violation, and return the summary of the last kind."""
        summary = (DiagnosticStatus.OK, "Timestamps are reasonable.")
        if not self.deltas_valid:
            return DiagnosticStatus.WARN, "No data since last update."
        if self.min_delta < self.params.min_acceptable:
            summary = (DiagnosticStatus.ERROR, "Timestamps too far in future seen.")
            self.early_count += 1
        if self.max_delta > self.params.max_acceptable:
            summary = (DiagnosticStatus.ERROR, "Timestamps too far in past seen.")
            self.late_count += 1
        if self.zero_seen:
            summary = (DiagnosticStatus.ERROR, "Zero timestamp seen.")
            self.zero_count += 1
        return summary


class Heartbeat(DiagnosticTask):
    """A task that always reports OK."""

    def __init__(self) -> None:
        super().__init__("Heartbeat")

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Report that the node is alive."""
        stat.summary(DiagnosticStatus.OK, "Alive")
        return stat


def _now() -> Time:
    """Return the system's time."""
    return Clock(clock_type=ClockType.ROS_TIME).now()
