"""What the context of a launch and its service share: events, their handlers, and whether it runs."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.launch.core.event import Event

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop, Future

__all__ = ["HandlesEvents", "RunState"]


class HandlesEvents(Protocol):
    """The methods of an event handler that a launch calls."""

    def matches(self, event: Event) -> bool:
        """Return whether the handler handles an event."""

    def handle(self, event: Event, context: Any) -> Any:
        """Handle an event, and return the entities to visit."""


class RunState:
    """The state of a launch that its service changes. Used on the thread that runs the launch."""

    def __init__(self) -> None:
        self.events: SimpleQueue[Event] = SimpleQueue()
        """Events to handle, the oldest first."""
        self.handlers: deque[HandlesEvents] = deque()
        """Event handlers, in the order in which they are asked."""
        self.loop: AbstractEventLoop | None = None
        """Loop that runs the launch; None while it doesn't run."""
        self.is_shutdown = False
        """Whether a Shutdown event has been handled."""
        self.unskippable: object = None
        """The one entity that isn't skipped if it needs what isn't here, as the launch file itself; None: none is."""
        self.skipped_includes: list[str] = []
        """A sentence on each included file that was skipped, which may have set launch configurations."""
        self.wake: Callable[[], None] = _do_nothing
        """Wakes the service, while one waits for events."""
        self.report: Callable[[Exception], None] | None = None
        """Ends the launch because of an error; None while it doesn't run."""
        self._futures: list[Future[Any]] = []

    def start(
        self, loop: AbstractEventLoop, wake: Callable[[], None], report: Callable[[Exception], None]
    ) -> None:
        """Begin a run on an asyncio loop.

        Args:
            loop: The loop.
            wake: Called when there is something to do.
            report: Called with an error that is to end the launch.
        """
        self.loop, self.wake, self.report, self.is_shutdown = loop, wake, report, False
        self.skipped_includes.clear()

    def stop(self) -> None:
        """End the run; events are kept for the next one."""
        self.loop, self.wake, self.report = None, _do_nothing, None

    def emit(self, event: Event) -> None:
        """Add an event to those to handle."""
        self.events.put(event)
        self.wake()

    def add_future(self, future: Future[Any]) -> None:
        """Keep the launch running until a future is done."""
        self._futures.append(future)
        future.add_done_callback(lambda _: self.wake())

    def has_open_futures(self) -> bool:
        """Return whether a future that was added is not done."""
        return any(not future.done() for future in self._futures)


def _do_nothing() -> None:
    """Wake nobody, because no service runs."""
