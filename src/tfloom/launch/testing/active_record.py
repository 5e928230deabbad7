"""A record of events to which another thread adds."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from typing import Generic, Protocol, TypeVar

from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.actions.execute_process import ExecuteProcess

__all__ = ["ActiveRecord"]

Event = TypeVar("Event")
Found = TypeVar("Found")
Found_co = TypeVar("Found_co", covariant=True)


class Record(Protocol[Event, Found_co]):
    """Recorded events of processes."""

    def append(self, event: Event, /) -> None:
        """Record an event."""

    def __iter__(self) -> Iterator[Event]: ...

    def processes(self) -> list[ExecuteProcess]:
        """Return the actions of the processes."""

    def process_names(self) -> list[str]:
        """Return the names of the processes."""

    def __getitem__(self, key: ExecuteLocal | str, /) -> Found_co: ...


class ActiveRecord(Generic[Event, Found]):
    """Events of processes that still run: all methods can be called on any thread.

    Args:
        record: Holds the events; guarded by `_changed`.
    """

    def __init__(self, record: Record[Event, Found]) -> None:
        self._changed = threading.Condition()
        self._record = record
        self._is_closed = False  # guarded by _changed

    def close(self) -> None:
        """End all waits, because no more events can come."""
        with self._changed:
            self._is_closed = True
            self._changed.notify_all()

    def append(self, event: Event) -> None:
        """Record an event, and wake all that wait."""
        with self._changed:
            self._record.append(event)
            self._changed.notify_all()

    def __iter__(self) -> Iterator[Event]:
        with self._changed:
            return iter(self._record)

    def processes(self) -> list[ExecuteProcess]:
        """Return the actions of all processes, each once."""
        with self._changed:
            return self._record.processes()

    def process_names(self) -> list[str]:
        """Return the names of all known processes."""
        with self._changed:
            return self._record.process_names()

    def __getitem__(self, key: ExecuteLocal | str) -> Found:
        """Return what is recorded of a process, by its action or its name.

        Raises:
            KeyError: the process is not known.
        """
        with self._changed:
            return self._record[key]
