"""The base of all that an executor runs: subscriptions, timers, guard conditions and others."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from tfloom.node.values.exceptions import InvalidHandle
from tfloom.node.values.handle import Handle
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from typing_extensions import Self

    from tfloom._native import ReadyQueue
    from tfloom.node.executing.callback_groups import CallbackGroup

__all__ = ["CallbackEntity", "Entity", "make_parts"]


_KEPT_LOCK = threading.Lock()
"""Held while a thread removes what an entity has kept."""


class Entity:
    """An object with a callback that an executor runs.

    While it is attached, it posts its token whenever it may have something to run. The executor then calls `take` on
    the thread that spins, and `run` with the result on a thread that runs callbacks, and repeats this until `take`
    returns None.
    """

    is_timed = False
    """Whether to call `take` at `deadline_ns`, not after a post."""

    is_polled = False
    """Whether to call `take` also whenever the executor wakes for any reason."""

    goes_by_group = True
    """Whether `run` belongs to the callback group; otherwise it is called at once, on the thread that spins."""

    takes_on_any_thread = False
    """Whether `take` may be called on any thread, one at a time."""

    posts_when_attached = False
    """Whether it posts whenever it is attached, even if it has nothing to run."""

    callback_group: CallbackGroup | None

    refused_item: Any = None
    """What `take` returned and no callback was called with. It stays here, where the next executor finds it."""

    stands_for: Any = None
    """The program's object that this is a part of, as an ActionClient or a Waitable; None: it is one by itself."""

    owner: Any = None
    """The node. It is referenced, because a reference to the entity keeps it alive."""

    on_destroy: Callable[[Any], object] | None = None
    """Called with this by the first `destroy` of what a program destroys itself: the node forgets it."""

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def member(self) -> Any:
        """The program's object: the member of the callback group, and what `wait_for_ready_callbacks` returns."""
        return self if self.stands_for is None else self.stands_for

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` to `queue` when there may be something to take, at once if there already is."""
        raise NotImplementedError

    def detach(self) -> None:
        """Stop posting the token; the executor calls this when the entity is removed."""
        raise NotImplementedError

    def take(self) -> Any:
        """Remove and return one thing to run, or None. Never blocks."""
        raise NotImplementedError

    def has_next(self) -> bool:
        """Return whether `take_next` has something; where only `take` can tell, keep what it returned for that."""
        if self.refused_item is None:
            self.refused_item = self.take()
        return self.refused_item is not None

    def take_next(self) -> Any:
        """As `take`, after what was kept here."""
        if self.refused_item is None:
            return self.take()
        with _KEPT_LOCK:  # a task of a program's own executor may begin on any thread
            kept, self.refused_item = self.refused_item, None
        return self.take() if kept is None else kept

    def run(self, taken: Any) -> Any:
        """Run the callback with the result of `take`; if that returns a coroutine, the executor runs it."""
        raise NotImplementedError

    def deadline_ns(self) -> int | None:
        """Return the time of the next `take`, by `time.monotonic_ns`; None: after the next post."""
        return None

    def belongings(self) -> Sequence[Entity]:
        """Return the entities that the node destroys together with this one, before it."""
        return ()

    def destroy(self) -> None:
        """Stop permanently; the node calls this when the entity is destroyed."""
        raise NotImplementedError


def make_parts(whole: Any, group: CallbackGroup, parts: Iterable[Entity]) -> None:
    """Make entities parts of a program's object, which is the member of `group` in their place."""
    for part in parts:
        part.stands_for = whole
        if part.callback_group is not None:
            part.callback_group.remove_entity(part)
    group.add_entity(whole)


class CallbackEntity(Entity):
    """An entity that posts its token by itself, for a callback without arguments: a timer or a guard condition."""

    _kind = ""
    """For error texts."""

    callback: Callable[..., Any] | None
    """None: it only wakes the executor."""

    _destroyed = False
    _queue: ReadyQueue | None = None
    _token = 0

    @property
    def handle(self) -> Handle:
        """Proxy of the entity, for code that expects rclpy's C handle.

        After the end, it raises InvalidHandle when it is entered.
        """
        return Handle(self, self._alive)

    def _alive(self) -> Self:
        """Return this entity.

        Raises:
            InvalidHandle: it was destroyed.
        """
        if self._destroyed:
            raise InvalidHandle(f"cannot use a {self._kind} that was destroyed")
        return self

    def _end(self) -> None:
        """Post no more tokens, and tell the node."""
        was_destroyed, self._destroyed = self._destroyed, True
        self.detach()
        if not was_destroyed and self.on_destroy is not None:
            self.on_destroy(self)

    def _post(self) -> None:
        queue = self._queue  # another thread may detach it meanwhile
        if queue is not None:
            queue.post(self._token)

    def detach(self) -> None:
        """Stop posting the token."""
        self._queue = None

    def run(self, taken: Any) -> Any:
        """Call the callback."""
        return None if self.callback is None else self.callback()
