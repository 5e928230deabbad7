"""message_filters that pass on what differs from the last message that they have passed on."""

from __future__ import annotations

import threading
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Sequence
from operator import attrgetter
from typing import Any

from tfloom.common.text import given_text
from tfloom.node.values.wrong_arguments import not_callable
from tfloom.tf2_ros.message_filters import JumpBack, SimpleFilter

__all__ = [
    "CachedComparisonHandler",
    "ComparisonFilter",
    "ComparisonHandler",
    "DeltaCompare",
    "DeltaFilter",
    "PathDeltaFilter",
]

Getter = Callable[[Any], Any]


class ComparisonHandler(ABC):
    """Base of what decides whether a message is passed on."""

    @abstractmethod
    def message_fits(self, message: Any) -> bool:
        """Return whether a message is passed on."""

    @abstractmethod
    def do_fields_fit(self, field_a: Any, field_b: Any) -> bool:
        """Return whether the values of one field, in the last message and in this one, let this one pass."""


class CachedComparisonHandler(ComparisonHandler):
    """Compares fields with those of the last message that was passed on. A derived class defines `do_fields_fit`.

    Args:
        field_getters: What returns the value of a field of a message, or several of these.

    Raises:
        TypeError: one can't be called.
        ValueError: there is none, so that nothing could differ.
    """

    def __init__(self, field_getters: Getter | Iterable[Getter]) -> None:
        getters = [field_getters] if callable(field_getters) else list(field_getters)
        for getter in getters:
            if not callable(getter):
                raise TypeError(
                    f"{type(self).__name__} needs callables that return a field, {not_callable(getter)}"
                )
        if not getters:
            raise ValueError(f"{type(self).__name__} needs at least one callable that returns a field")
        self._field_getters = getters
        self._message_cache: Any = None
        self._lock = threading.Lock()
        """Guards the replacement of the last message."""

    def message_fits(self, message: Any) -> bool:
        """Return whether a message is passed on: the first one is, and one of which any field fits. It is kept then."""
        # Getters and comparisons are the program's, so they run without the lock: where another message was passed on
        # meanwhile, this one is compared with that.
        while True:
            cached = self._message_cache
            if cached is not None and not any(
                self.do_fields_fit(getter(cached), getter(message)) for getter in self._field_getters
            ):
                return False
            with self._lock:
                if self._message_cache is cached:
                    self._message_cache = message
                    return True

    def forget(self) -> None:
        """Let the next message pass."""
        with self._lock:
            self._message_cache = None


class DeltaCompare(CachedComparisonHandler):
    """Lets messages pass of which any field differs from that of the last one."""

    def do_fields_fit(self, field_a: Any, field_b: Any) -> bool:
        """Return whether two values differ; arrays differ if any of their elements does."""
        is_equal = field_a == field_b
        return not (bool(is_equal.all()) if hasattr(is_equal, "all") else is_equal)


class ComparisonFilter(SimpleFilter):
    """Passes on the messages that a handler lets pass, compared in the order in which they come.

    Args:
        comparison_handler: Its `message_fits` decides.
        message_filter: The input filter; None: messages come from `add` alone.

    Raises:
        TypeError: the handler has no `message_fits`.
    """

    def __init__(self, comparison_handler: CachedComparisonHandler, message_filter: Any = None) -> None:
        super().__init__()
        if not hasattr(comparison_handler, "message_fits"):
            raise TypeError(
                f"{type(self).__name__} needs a handler, which has message_fits, got {given_text(comparison_handler)}"
            )
        self._handler = comparison_handler
        self.incoming_connection: int | None = None
        if message_filter is not None:
            self.connectInput(message_filter)

    def connectInput(self, message_filter: Any) -> None:
        """Connect to an input filter.

        Raises:
            RuntimeError: this is connected to another one.
        """
        if self.incoming_connection is not None:
            raise RuntimeError("Already connected")
        self._clock = getattr(message_filter, "_clock", None)
        self.incoming_connection = message_filter.registerCallback(self.add)

    def message_fits(self, message: Any) -> bool:
        """Return whether a message is passed on."""
        return self._handler.message_fits(message)

    def add(self, message: Any) -> None:
        """Pass a message on, if it fits."""
        if self.message_fits(message):
            self.signalMessage(message)

    def clear_after_jump(self, jump: JumpBack) -> None:
        """Let the next message pass, because another recording has begun; see `SimpleFilter`."""
        if hasattr(self._handler, "forget"):
            self._handler.forget()
        super().clear_after_jump(jump)


class DeltaFilter(ComparisonFilter):
    """Passes on messages of which any field differs from that of the last one that was passed on.

    Args:
        field_getters: What returns the value of a field of a message, or several of these.
        message_filter: The input filter; None: messages come from `add` alone.
    """

    def __init__(self, field_getters: Getter | Iterable[Getter], message_filter: Any = None) -> None:
        super().__init__(DeltaCompare(field_getters), message_filter)


class PathDeltaFilter(DeltaFilter):
    """The same, with fields that are named: `PathDeltaFilter(["pose.position.x", "header.frame_id"])`.

    Args:
        paths: Names of fields, with a dot before that of an inner one; each also as a list of names.
        message_filter: The input filter; None: messages come from `add` alone.

    Raises:
        TypeError: a path is neither.
    """

    def __init__(self, paths: str | Sequence[str | Sequence[str]], message_filter: Any = None) -> None:
        super().__init__(
            [attrgetter(_dotted(path)) for path in ([paths] if isinstance(paths, str) else paths)],
            message_filter,
        )


def _dotted(path: str | Sequence[str]) -> str:
    names = path.split(".") if isinstance(path, str) else list(path)
    if not names or not all(isinstance(name, str) and name.isidentifier() for name in names):
        raise TypeError(f"a path is names of fields, as 'pose.position.x', got {given_text(path)}")
    return ".".join(names)
