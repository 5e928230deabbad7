"""Tasks for a program's own executor, which begin when it runs them, on any thread, or never."""

from __future__ import annotations

import time
import weakref
from collections.abc import Callable, Container
from typing import TYPE_CHECKING, Any

from tfloom.node.executing.task import Task
from tfloom.node.executing.work_queue import GROUPS_FREED_ON_COMPLETION, Work, WorkQueue, member_of

if TYPE_CHECKING:
    from tfloom.node.executing.entity import Entity

__all__ = ["OfferedWork"]

OFFER_AGAIN_NS = 10_000_000
"""How long a task that a program's own executor got, and has not begun, is left to its threads, before it is returned
again [ns]. It is returned again at once where the wait ends otherwise."""


class _Offered:
    """A task that a program's own executor got.

    Args:
        task: The task.
        entity: Its entity; None for a program's own task, or the rest of a callback.
    """

    def __init__(self, task: Task[Any], entity: Entity | None) -> None:
        # The task of an entity is kept by the program alone: where nobody can run it, the entity gets another one.
        self._task = weakref.ref(task)
        self.entity = entity
        self._step_count = task.step_count
        self.again_ns = time.monotonic_ns() + OFFER_AGAIN_NS

    def task(self) -> Task[Any] | None:
        """Return the task if it may still begin."""
        task = self._task()
        return None if task is None or self.has_begun() or task.done() or task.cancelled() else task

    def has_begun(self) -> bool:
        """Return whether the task has begun."""
        task = self._task()
        return task is not None and task.step_count != self._step_count


class OfferedWork(WorkQueue):
    """A queue whose work is begun for the caller, or offered to it in tasks that it may run."""

    def __init__(self) -> None:
        super().__init__()
        self._offered: dict[int, _Offered] = {}
        """The tasks that `wait_for_ready_callbacks` has returned and that may still begin, by token.

        Used by the thread that spins alone, as are the two below.
        """
        self._nodes_waited_for: Container[Any] | None = None
        """The nodes whose entities the present wait is for; None: all."""
        self._other_nodes: list[int] = []
        """Tokens of entities of other nodes, which have posted meanwhile."""

    def _begin_wait(
        self, for_nodes: Container[Any] | None, *, is_begun: bool
    ) -> Callable[[int], Work | None]:
        """Begin a wait for work that is begun, or offered; return what is called with each token.

        Args:
            for_nodes: The nodes whose entities are waited for; None: all.
            is_begun: Whether the work is begun.
        """
        self._nodes_waited_for = for_nodes
        self._has_response = False
        self._ready.extend(self._other_nodes)
        self._other_nodes.clear()
        if not is_begun:
            self._forget_begun()
            return self._offer
        # What was offered, and not begun, is begun here.
        self._ready.extend(token for token, offered in self._offered.items() if not offered.has_begun())
        self._offered.clear()
        return self._begin

    def _offer(self, token: int) -> Work | None:
        """As `_begin`, but return a task, which takes the item, and begins in the group, when it is run."""
        offered = self._offered.get(token)
        if offered is not None:
            if offered.task() is not None:  # it posts again when that task has begun
                return None
            del self._offered[token]
        entity = self._entities.get(token)
        task = self._tasks.get(token) if entity is None else self._task_of(entity, token)
        if task is None or task.done() or task.cancelled():
            return None
        self._offered[token] = _Offered(task, entity)
        return Work(entity, task)

    def _task_of(self, entity: Entity, token: int) -> Task[Any] | None:
        """Return the task of an entity, or None if it has nothing to run in this wait."""
        if not self._is_waited_for(entity):
            self._other_nodes.append(token)
        elif self._goes_at_once(entity):
            self._take_responses(token)
        elif self._may_begin(entity, token) and entity.has_next():
            return self._new_task(entity, token)
        elif entity.is_timed:
            self._timers.set(token, entity.deadline_ns())
        return None

    def _is_waited_for(self, entity: Entity) -> bool:
        return self._nodes_waited_for is None or entity.owner in self._nodes_waited_for

    def _may_begin(self, entity: Entity, token: int) -> bool:
        """Return whether the group of an entity admits its callback; post it again when that may have changed."""
        group = entity.callback_group
        if group is None or group.can_execute(member_of(group, entity)):
            return True
        if type(group) in GROUPS_FREED_ON_COMPLETION:
            self._park(group, entity, token)
        else:
            self._unadmitted.append(token)
        return False

    def _new_task(self, entity: Entity, token: int) -> Task[Any]:
        """Return the task that takes what an entity has next, and runs its callback, as far as its group admits it."""

        def run() -> Any:
            group = entity.callback_group
            if group is not None and not group.beginning_execution(member_of(group, entity)):
                if type(group) in GROUPS_FREED_ON_COMPLETION:
                    self._park(group, entity, token)
                else:
                    self._queue.post(token)
                return None
            taken = None
            try:
                taken = entity.take_next()
            finally:
                if taken is None:
                    self._end(entity)
                self._queue.post(token)  # there may be more
            if taken is None:
                return None
            running = reference()
            if running is not None:
                self._register_task(running)
                # Not at the end of `run`: a callback that is a coroutine occupies its group until it completes.
                running.when_complete(lambda: self._end(entity))
            return self._call(entity, taken)

        task: Task[Any] = Task(run, executor=self)
        reference = weakref.ref(task)
        return task

    def _call(self, entity: Entity, taken: Any) -> Any:
        """Run an entity's callback."""
        return entity.run(taken)

    def _forget_begun(self) -> None:
        """Forget the offered tasks that have begun, and look again at what the others were for that never will."""
        for token, offered in list(self._offered.items()):
            if offered.task() is None:
                del self._offered[token]
                if not offered.has_begun():
                    self._queue.post(token)

    def _offered_again(self, end_ns: int | None) -> Work | None:
        """Return a task that was offered and has not begun, after `OFFER_AGAIN_NS` or at the wait's end.

        After a response, return a task that does nothing: the response has completed its future already, because
        callbacks on all threads of a pool may wait for it.
        """
        if self._has_response:
            return Work(self._answered, Task(_do_nothing, executor=self))
        self._forget_begun()
        now_ns = time.monotonic_ns()
        for offered in self._offered.values():
            task = offered.task()
            if (
                task is None
                or task.executing()
                or not (offered.entity is None or self._is_waited_for(offered.entity))
            ):
                continue
            if now_ns >= offered.again_ns or (end_ns is not None and now_ns >= end_ns):
                offered.again_ns = now_ns + OFFER_AGAIN_NS
                return Work(offered.entity, task)
        return None

    def _look_again_ns(self, end_ns: int | None) -> int | None:
        """Return when to look at the offered tasks again, during a wait until `end_ns`."""
        ends_ns = [offered.again_ns for offered in self._offered.values()]
        if end_ns is not None:
            ends_ns.append(end_ns)
        return min(ends_ns, default=None)


def _do_nothing() -> None:
    pass
