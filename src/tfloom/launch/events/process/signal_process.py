"""A signal to some processes."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import Any

from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent

__all__ = ["SignalProcess"]


class SignalProcess(ProcessTargetedEvent):
    """Sends a signal to processes.

    Args:
        signal_number: The signal: its number, its name ("SIGINT"), or one of `signal.Signals`.
        process_matcher: Returns whether it is sent to the process of an action.

    Raises:
        ValueError: there is no such signal.
    """

    name = "launch.events.process.SignalProcess"

    def __init__(
        self, *, signal_number: str | int | signal.Signals, process_matcher: Callable[[Any], bool]
    ) -> None:
        super().__init__(process_matcher=process_matcher)
        if isinstance(signal_number, str):
            name = signal_number if signal_number.startswith("SIG") else f"SIG{signal_number}"
            try:
                self._signal = signal.Signals[name]
            except KeyError:
                raise ValueError(f"'{signal_number}' is no name of a signal, as SIGINT is one") from None
        else:
            self._signal = signal.Signals(signal_number)

    @property
    def signal(self) -> signal.Signals:
        """The signal."""
        return self._signal

    @property
    def signal_name(self) -> str:
        """Name of the signal, as "SIGINT"."""
        return self._signal.name
