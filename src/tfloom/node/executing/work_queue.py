"""The callbacks and tasks of an executor that are ready to run.

Entities post tokens to one queue, so no set of entities is built for a wait. In each pass, one item is taken from
each entity that has posted; an entity that had one is checked again in the next pass.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Coroutine, Iterable
from itertools import count
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from tfloom._native import ReadyQueue
from tfloom.node.context.context import WAKE
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from tfloom.node.executing.task import Future, Task
from tfloom.node.executing.timer_schedule import TimerSchedule

if TYPE_CHECKING:
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.entity import Entity

__all__ = ["GROUPS_FREED_ON_COMPLETION", "Work", "WorkQueue", "member_of"]

T = TypeVar("T")
GROUPS_FREED_ON_COMPLETION = (MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup)
"""Built-in groups, which admit new work only when a callback completes."""

MAX_BATCH_SIZE = 1000
"""Most items of one entity that run on the thread that spins before the other entities are served."""


class Work(NamedTuple):
    """A callback that has begun for its group and is to be run."""

    entity: Entity | None
    taken: Any
    """The result of the entity's `take`; without entity, a Task."""


class WorkQueue:
    """Selects the next callback to run, from entities and from tasks that can continue.

    Any thread may add and remove entities. The methods with an underscore are called on the thread that spins alone,
    except `_end` and `_register_task`, which any thread may call.
    """

    _runs_tasks_first = True
    """Whether tasks that are ready run before a response is taken that arrived beside them.

    What a callback has begun, as the execution of a goal, has then run when the caller's future is complete.
    """

    def __init__(self) -> None:
        self._queue = ReadyQueue()
        """Queue of the tokens that entities, tasks and `wake` post, on any thread; it has its own lock."""
        self._lock = threading.RLock()
        """Guards the registration of entities: `_entities`, `_tokens`, `_polled`."""
        self._entities: dict[int, Entity] = {}
        """The entities by token. Written under `_lock`; the thread that spins reads it without."""
        self._tokens: dict[Entity, int] = {}
        """The token of each entity. Written under `_lock`; threads of a pool read it without."""
        self._polled: list[int] = []
        """Tokens to check whenever the executor wakes. Replaced, never changed, under `_lock`."""
        self._tasks: dict[int, Task[Any]] = {}
        """The tasks that aren't complete, by token. Changed on any thread, by single operations of a dict."""
        self._numbers = count(WAKE + 1)
        """Counter of tokens; taking the next is a single operation."""
        self._ready: deque[int] = deque()
        """Tokens to check, the oldest first. Used by the thread that spins alone, as are the four below."""
        self._unadmitted: list[int] = []
        """Tokens of entities that their group, of a class of the program's own, has not admitted."""
        self._pass_left = 0
        """Number of tokens in `_ready` that belong to the present pass."""
        self._has_response = False
        """Set when a response to a client was taken, and cleared by whatever waits for one."""
        self._answered: Entity | None = None
        """The client of the last response that was taken."""
        self._timers = TimerSchedule()
        """The deadlines of timed entities."""

    def add_entity(self, entity: Entity) -> None:
        """Add an entity; nodes call this for what they create."""
        self.add_entities([entity])

    def add_entities(self, entities: Iterable[Entity]) -> None:
        """Add entities, at once, because `rclpy.spin_once` adds and removes all of a node's each time."""
        queue, tokens, by_token, numbers = self._queue, self._tokens, self._entities, self._numbers
        added: list[tuple[Entity, int]] = []
        with self._lock:
            for entity in entities:
                if entity in tokens:
                    continue
                token = next(numbers)
                tokens[entity] = token
                by_token[token] = entity
                added.append((entity, token))
                if entity.is_polled:
                    self._polled = [*self._polled, token]
        for entity, token in added:
            entity.attach(queue, token)
            if entity.refused_item is not None:  # nothing else says that there is one
                queue.post(token)

    def remove_entity(self, entity: Entity) -> None:
        """Remove an entity; its posted tokens are ignored."""
        self.remove_entities([entity])

    def remove_entities(self, entities: Iterable[Entity]) -> None:
        """Remove entities; their posted tokens are ignored."""
        tokens, by_token = self._tokens, self._entities
        with self._lock:
            for entity in entities:
                token = tokens.pop(entity, None)
                if token is None:
                    continue
                del by_token[token]
                if entity.is_polled:
                    self._polled = [polled_token for polled_token in self._polled if polled_token != token]
                entity.detach()

    def create_task(
        self, callback: Callable[..., T] | Coroutine[Any, Any, T], *args: Any, **kwargs: Any
    ) -> Task[T]:
        """Run a function or coroutine on a thread that runs callbacks; the task is the future of its result.

        Its exception is also raised by `spin`, as that of a callback is.
        """
        task: Task[T] = Task(callback, args, kwargs, executor=self)
        self._queue.post(self._register_task(task))
        return task

    def create_future(self) -> Future[Any]:
        """Return a future whose callbacks run as tasks of this executor."""
        return Future(executor=self)

    def _register_task(self, task: Task[Any]) -> int:
        """Run the steps of a task whenever it is runnable, until it is complete; return its token."""
        token = next(self._numbers)
        queue, tasks = self._queue, self._tasks

        def forget() -> None:
            tasks.pop(token, None)

        task.on_resume(lambda: queue.post(token))
        tasks[token] = task
        task.when_complete(forget)
        return token

    def wake(self) -> None:
        """Wake the thread that spins, so that it checks its conditions again."""
        self._queue.post(WAKE)

    def can_execute(self, entity: Entity) -> bool:
        """Return whether the group of an entity admits its callback."""
        group = None if self._goes_at_once(entity) else entity.callback_group
        return group is None or group.can_execute(member_of(group, entity))

    @staticmethod
    def _goes_at_once(entity: Entity) -> bool:
        """Return whether an entity is run without its group: responses, but not where the program has its own rule."""
        return not entity.goes_by_group and (
            entity.callback_group is None or type(entity.callback_group) in GROUPS_FREED_ON_COMPLETION
        )

    def _has_room(self) -> bool:
        """Return whether one more callback may run."""
        return True

    def _work_of_this_pass(self, begin: Callable[[int], Work | None]) -> Work | None:
        while self._pass_left:
            self._pass_left -= 1
            work = begin(self._ready.popleft())
            if work is not None:
                return work
        return None

    def _collect(self, end_ns: int | None, *, quiet: bool = False) -> None:
        """Wait for posts and timers, not beyond `end_ns`, and begin a new pass over all that is ready.

        With `quiet`, this includes subscriptions whose messages were pushed into a sink. Responses to clients are
        taken at once, or in the pass, after the tasks that are ready already.
        """
        # Groups of the program's own classes post nothing when they would admit a callback: ask them at each wake.
        if self._unadmitted:
            self._retry_unadmitted()
        tokens = self._queue.wait(self._wait_ns(end_ns), quiet)
        responses: list[int] = []
        for token in tokens:
            entity = self._entities.get(token)
            if entity is None:  # the token of a task, or of an entity removed since, which `_begin` ignores
                if token != WAKE:
                    self._ready.append(token)
            elif not entity.goes_by_group and self._goes_at_once(entity):
                responses.append(token)
            elif entity.is_timed and not entity.is_polled and (due_ns := entity.deadline_ns()) is not None:
                # A timer posts when its deadline has changed, not when it is due. Timers run in the order of their
                # deadlines. One without, by simulated time or cancelled, is looked at in the pass instead.
                self._timers.set(token, due_ns)
            else:
                self._ready.append(token)
        # A task that is ready may be what the callback before had begun, as the execution of a goal. Behind it in the
        # pass, the response completes its caller's future after that, as programs expect on one thread. Without a task,
        # nothing is gained by waiting for the pass.
        if responses and self._runs_tasks_first and any(token in self._tasks for token in tokens):
            self._ready.extend(responses)
        else:
            self._take_all_responses(responses)
        self._ready.extend(self._timers.take_due(time.monotonic_ns()))
        if self._polled:  # those that have posted are in the pass already
            self._ready.extend(token for token in self._polled if token not in tokens)
        # The pass ends here: an entity that had an item is appended again behind this mark, so that a full reader
        # doesn't keep the other entities from their turn.
        self._pass_left = len(self._ready)

    def _retry_unadmitted(self) -> None:
        """Move the entities that their groups admit from `_unadmitted` to `_ready`."""
        # An entity is here once for each time that it was refused, and is tried once.
        unadmitted, self._unadmitted = dict.fromkeys(self._unadmitted), []
        for token in unadmitted:
            entity = self._entities.get(token)
            if entity is not None:
                (self._ready if self.can_execute(entity) else self._unadmitted).append(token)

    def _take_all_responses(self, tokens: list[int]) -> None:
        for index, token in enumerate(tokens):
            try:
                self._take_responses(token)
            except BaseException:  # of a callback for feedback; the rest is for the next spin
                for other in tokens[index + 1 :]:
                    self._queue.post(other)
                raise

    def _take_responses(self, token: int) -> None:
        """Run an entity without callbacks of the program on this thread, to the end of what it has."""
        entity = self._entities.get(token)
        if entity is None:
            return
        for _ in range(MAX_BATCH_SIZE):
            taken = entity.take()
            if taken is None:
                return
            self._has_response, self._answered = True, entity
            try:
                entity.run(taken)
            except BaseException:  # of a callback for feedback, which is run before the result
                # The endpoint has posted for the responses behind this one, and won't do so again: post for it.
                self._queue.post(token)
                raise
        # Responses that arrive faster than they are taken must not keep this thread here; the next pass has the rest.
        self._queue.post(token)

    def _wait_ns(self, end_ns: int | None) -> int:
        if self._ready and self._has_room():
            return 0
        ends = [end for end in (end_ns, self._timers.wake_ns()) if end is not None]
        return max(0, min(ends) - time.monotonic_ns()) if ends else -1

    def _begin(self, token: int) -> Work | None:
        entity = self._entities.get(token)
        if entity is None:
            task = self._tasks.get(token)
            return None if task is None else Work(None, task)
        if not entity.goes_by_group and self._goes_at_once(entity):
            self._take_responses(token)
            return None
        taken = self._take(entity, token)
        return None if taken is None else Work(entity, taken)

    def _take(self, entity: Entity, token: int) -> Any:
        """Begin a callback in its group and return the work; None if it must not run yet, or there is no item."""
        group = entity.callback_group
        if group is not None and type(group) not in GROUPS_FREED_ON_COMPLETION:
            return self._take_with_consent(group, entity, token)
        # The group is occupied before the item is taken, because an item that was taken can't go back to its reader.
        if group is not None and not group.beginning_execution(entity):
            self._park(group, entity, token)
            return None
        taken = None
        try:
            taken = entity.take_next()
        finally:
            # There was no item; or `take` has raised, as a program's Waitable may. No callback runs that would end it.
            if taken is None:
                self._end(entity)
        self._reschedule(entity, token, taken)
        return taken

    def _park(self, group: CallbackGroup, entity: Entity, token: int) -> None:
        """Post an entity again when a callback of its group completes."""
        group.park(entity, lambda: self._queue.post(token))
        # The callback that occupied the group may have completed on another thread between the refusal and `park`, and
        # have released the parked entities too early for this one. Nothing else would post it again.
        if group.can_execute(entity):
            group.release_parked()

    def _take_with_consent(self, group: CallbackGroup, entity: Entity, token: int) -> Any:
        """As `_take`, for a group of the program's own class: begin a callback only if there is an item.

        A refused entity is tried again each time the executor wakes, because the group may admit it at any time.
        """
        # Ask before an item is taken: until then it waits in its reader, where the history depth limits the number.
        if not group.can_execute(entity.member):
            self._unadmitted.append(token)
            return None
        # An item that the group refused earlier is older than those in the reader.
        was_refused = entity.refused_item is not None
        taken = entity.take_next()
        if not was_refused:
            self._reschedule(entity, token, taken)
        # The answer may differ from that of `can_execute`. The item then stays at the entity, and not here, because the
        # program may add the node to another executor before the group admits it.
        if taken is not None and not group.beginning_execution(entity.member):
            entity.refused_item = taken
            self._unadmitted.append(token)
            return None
        return taken

    def _reschedule(self, entity: Entity, token: int, taken: Any) -> None:
        if entity.is_timed:
            self._timers.set(token, entity.deadline_ns())
        elif taken is not None:
            self._ready.append(token)

    def _end(self, entity: Entity) -> None:
        group = entity.callback_group
        if group is not None:
            group.ending_execution(member_of(group, entity))
            group.release_parked()
            if self._unadmitted and type(group) not in GROUPS_FREED_ON_COMPLETION:
                self.wake()  # this may be another thread, and the group may admit now what it has refused


def member_of(group: CallbackGroup, entity: Entity) -> Any:
    """Return what a group is asked about: the program's object, where the class of the group is the program's own."""
    return entity if type(group) in GROUPS_FREED_ON_COMPLETION else entity.member
