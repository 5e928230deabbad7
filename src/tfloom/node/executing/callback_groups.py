"""Callback groups: rules for which callbacks may run at the same time."""

from __future__ import annotations

import threading
import weakref
from typing import TYPE_CHECKING, Any

from tfloom.common.text import given_text
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["CallbackGroup", "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup", "group_error"]


MIN_PURGED = 64
"""With fewer members, a group keeps the references to those that are gone."""


class CallbackGroup:
    """A set of entities with one rule for which of their callbacks may run at the same time.

    An executor calls `beginning_execution` and `ending_execution` around each callback. An entity that must not run
    yet is parked here, and posted again when a callback of the group completes.
    """

    def __init__(self) -> None:
        self.entities: set[weakref.ref[Any]] = set()
        """Weak references to the members; those of members that are gone are removed from time to time."""
        self._max_entities = MIN_PURGED
        """With more references, those of members that are gone are removed."""
        self._parked: list[tuple[Any, Callable[[], None]]] = []
        self._parked_lock = threading.Lock()
        """Guards `_parked`."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def add_entity(self, entity: Any) -> None:
        """Add an entity to the group."""
        self.entities.add(weakref.ref(entity))
        if len(self.entities) > self._max_entities:
            # Not by a callback of the reference: the set would change while a program iterates over it.
            self.entities.difference_update([member for member in list(self.entities) if member() is None])
            self._max_entities = max(MIN_PURGED, 2 * len(self.entities))

    def remove_entity(self, entity: Any) -> None:
        """Undo `add_entity`."""
        self.entities.discard(weakref.ref(entity))

    def has_entity(self, entity: Any) -> bool:
        """Return whether an entity is in the group."""
        return weakref.ref(entity) in self.entities

    def can_execute(self, entity: Any) -> bool:
        """Return whether a callback of `entity` may begin."""
        raise NotImplementedError

    def beginning_execution(self, entity: Any) -> bool:
        """Begin a callback of `entity`; return False if it must not begin yet."""
        raise NotImplementedError

    def ending_execution(self, entity: Any) -> None:
        """End a callback of `entity`."""
        raise NotImplementedError

    def park(self, entity: Any, post_again: Callable[[], None]) -> None:
        """Call `post_again` when a callback of the group completes, so that `entity` is looked at again."""
        with self._parked_lock:
            self._parked.append((entity, post_again))

    def has_parked(self, entity: Any) -> bool:
        """Return whether an entity waits for a callback of the group to complete."""
        with self._parked_lock:
            return any(parked is entity for parked, _ in self._parked)

    def has_parked_another(self, entity: Any) -> bool:
        """Return whether an entity other than `entity` waits for a callback of the group to complete."""
        with self._parked_lock:
            return any(parked is not entity for parked, _ in self._parked)

    def release_parked(self) -> None:
        """Post the parked entities again."""
        if self._parked:
            with self._parked_lock:
                parked, self._parked = self._parked, []
            for _, post_again in parked:
                post_again()


class ReentrantCallbackGroup(CallbackGroup):
    """A group whose callbacks may run at any time, also several calls of one callback at the same time."""

    def can_execute(self, entity: Any) -> bool:
        """Return True."""
        return True

    def beginning_execution(self, entity: Any) -> bool:
        """Return True."""
        return True

    def ending_execution(self, entity: Any) -> None:
        """Do nothing."""


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """A group that runs one callback at a time."""

    def __init__(self) -> None:
        super().__init__()
        self._active_entity: Any = None
        self._lock = threading.Lock()
        """Guards changes of `_active_entity`."""

    def is_running(self, entity: Any) -> bool:
        """Return whether the callback that runs is one of `entity`."""
        return self._active_entity is entity

    def can_execute(self, entity: Any) -> bool:
        """Return whether no callback is running."""
        return self._active_entity is None

    def beginning_execution(self, entity: Any) -> bool:
        """Begin a callback, unless one is running."""
        with self._lock:
            if self._active_entity is None:
                self._active_entity = entity
                return True
        return False

    def ending_execution(self, entity: Any) -> None:
        """End the running callback."""
        with self._lock:
            if self._active_entity is entity:
                self._active_entity = None


def group_error(group: object) -> AttributeError | None:
    """Return the error of a `callback_group` that is neither None nor a group, or None if it is one of them."""
    if isinstance(group, type):
        return AttributeError(
            f"expected a callback group, got the class {group.__name__}: write {group.__name__}()"
        )
    if group is None or hasattr(group, "add_entity"):
        return None
    given = given_text(group)
    return AttributeError(f"expected a callback group, as ReentrantCallbackGroup(), got {given}")
