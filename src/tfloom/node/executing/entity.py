"""What an executor runs: the base of subscriptions, timers, guard conditions and the rest."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tfloom._native import ReadyQueue
    from tfloom.node.executing.callback_groups import CallbackGroup

__all__ = ["Entity"]


class Entity:
    """An object with a callback that an executor runs.

    While it is attached, it posts its token whenever it may have something to run. The executor then calls `take`,
    on the thread that spins, and `run` with what it got, on whichever thread runs callbacks; and `take` again later,
    until there is nothing more.
    """

    is_timed = False
    """Whether to take at `deadline_ns`, rather than after a post."""

    is_polled = False
    """Whether to take, too, whenever the executor wakes for any reason."""

    goes_by_group = True
    """Whether the callback group admits `run`; else it is called at once, on the thread that spins."""

    callback_group: CallbackGroup | None

    _part_of: Any = None  # the node, which a reference to a part keeps alive

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` to `queue` when there may be something to take, at once if there already is."""
        raise NotImplementedError

    def detach(self) -> None:
        """Stop posting."""
        raise NotImplementedError

    def take(self) -> Any:
        """Remove and return one thing to run, or None. Never blocks."""
        raise NotImplementedError

    def run(self, taken: Any) -> Any:
        """Run the callback with what was taken; the result may be a coroutine, which the executor then runs."""
        raise NotImplementedError

    def deadline_ns(self) -> int | None:
        """Return when to take next, by `time.monotonic_ns`; None: after the next post."""
        return None

    def destroy(self) -> None:
        """Stop for good."""
        raise NotImplementedError
