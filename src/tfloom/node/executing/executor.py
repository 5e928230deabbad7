"""What all executors are: they wait for entities that have something to do, and run their callbacks.

Entities post tokens to one queue; no set of things to wait for is built, however many there are. In each pass an
executor takes one thing from each entity that posted, and looks at an entity again as long as it had something.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Coroutine
from itertools import count
from types import CoroutineType, TracebackType
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from tfloom._native import ReadyQueue
from tfloom.node.context.context import WAKE, Context
from tfloom.node.context.utilities import get_default_context, timeout_sec_to_nsec
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from tfloom.node.executing.executor_exceptions import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
)
from tfloom.node.executing.running_work import RunningWork
from tfloom.node.executing.task import Future, Task
from tfloom.node.executing.timer_schedule import TimerSchedule

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.entity import Entity
    from tfloom.node.executing.waitable import Waitable
    from tfloom.node.node import Node

__all__ = [
    "ConditionReachedException",
    "Executor",
    "ExternalShutdownException",
    "ShutdownException",
    "TimeoutException",
    "TimeoutObject",
    "Work",
]

T = TypeVar("T")
_FREED_BY_AN_END = (MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup)
"""Groups that let others in when a callback has ended, and never else."""

MOST_AT_ONCE = 1000
"""How much an entity may have run on the thread that spins before others have their turn."""


class Work(NamedTuple):
    """A callback that may begin: its group has been told so."""

    entity: Entity | None
    taken: Any
    """What the entity gave; without entity, a Task."""


class Executor:
    """Runs the callbacks of the nodes added to it, while one of its `spin` methods is called.

    Nodes, and their entities, may come and go from any thread at any time. One thread at a time may spin.

    Args:
        context: Whose shutdown ends every spin; None: the default one.
    """

    def __init__(self, *, context: Context | None = None) -> None:
        self._context = context or get_default_context()
        self._queue = ReadyQueue()
        self._context.add_queue(self._queue)
        self._lock = threading.RLock()
        self._spinning = threading.RLock()
        self._nodes: list[Node] = []
        self._entities: dict[int, Entity] = {}
        self._tokens: dict[Entity, int] = {}
        self._polled: list[int] = []
        self._tasks: dict[int, Task[Any]] = {}
        self._numbers = count(WAKE + 1)
        self._ready: deque[int] = deque()
        self._refused: list[int] = []
        self._held: dict[int, Any] = {}
        self._pass_left = 0
        self._timers = TimerSchedule()
        self._is_shutdown = False
        self._running = RunningWork()

    @property
    def context(self) -> Context:
        """Whose shutdown ends every spin."""
        return self._context

    # Nodes and entities

    def add_node(self, node: Node) -> bool:
        """Run a node's callbacks from now on; False if they are already. A node is in one executor at a time."""
        with self._lock:
            if self._is_shutdown:
                raise ShutdownException("cannot add a node to an executor that is shut down")
            if node in self._nodes:
                return False
            self._nodes.append(node)
        node.executor = self
        for entity in node.entities():
            self.add_entity(entity)
        return True

    def remove_node(self, node: Node) -> None:
        """Run a node's callbacks no more."""
        with self._lock:
            if node not in self._nodes:
                return
            self._nodes.remove(node)
        for entity in node.entities():
            self.remove_entity(entity)
        if node.executor is self:
            node.executor = None

    def get_nodes(self) -> list[Node]:
        """Return the nodes that were added."""
        with self._lock:
            return list(self._nodes)

    def add_entity(self, entity: Entity) -> None:
        """Run an entity; nodes call it for what they create."""
        with self._lock:
            if entity in self._tokens:
                return
            token = next(self._numbers)
            self._tokens[entity] = token
            self._entities[token] = entity
            if entity.is_polled:
                self._polled = [*self._polled, token]
        entity.attach(self._queue, token)

    def remove_entity(self, entity: Entity) -> None:
        """Run an entity no more; what it has posted is ignored."""
        with self._lock:
            token = self._tokens.pop(entity, None)
            if token is None:
                return
            del self._entities[token]
            self._held.pop(token, None)
            if entity.is_polled:
                self._polled = [each for each in self._polled if each != token]
            entity.detach()

    def create_task(
        self, callback: Callable[..., T] | Coroutine[Any, Any, T], *args: Any, **kwargs: Any
    ) -> Task[T]:
        """Have a function or coroutine run; the task is a future of its result.

        An exception in it is raised from `spin` too, as a callback's is.
        """
        task: Task[T] = Task(callback, args, kwargs, executor=self)
        self._queue.post(self._keep_task(task))
        return task

    def create_future(self) -> Future[Any]:
        """Return a future whose callbacks run as tasks of this executor."""
        return Future(executor=self)

    def _keep_task(self, task: Task[Any]) -> int:
        """Have a task go on here whenever it can, until it is complete; return its token."""
        token = next(self._numbers)
        queue, tasks = self._queue, self._tasks

        def forget() -> None:
            tasks.pop(token, None)

        task.on_resume(lambda: queue.post(token))
        tasks[token] = task
        task.when_complete(forget)
        return token

    # Waiting

    def wake(self) -> None:
        """End the wait of whatever spins, for it to look again at what it waits for."""
        self._queue.post(WAKE)

    def can_execute(self, entity: Entity) -> bool:
        """Return whether the group of an entity lets its callback begin now."""
        group = entity.callback_group if entity.goes_by_group else None
        return group is None or group.can_execute(entity)

    def would_wait_for_itself(self) -> bool:
        """Return whether this is called from a callback, while nothing else takes in what comes."""
        return self._running.is_this_thread()

    def wait_for_ready_callbacks(
        self, timeout_sec: float | None = None, condition: Callable[[], bool] | None = None
    ) -> tuple[Task[Any], Entity | Waitable | None, Node | None]:
        """Wait for a callback that may begin; for executors of a program's own, which then call the task.

        The callback's group counts it as begun. A task that awaits comes again when it can go on.

        Args:
            timeout_sec: The longest wait [s]; None, negative: for ever.
            condition: Asked each time the executor wakes; where it returns True the wait ends.

        Returns:
            The task; what it is a callback of, and the node of that, or None and None for a task.

        Raises:
            TimeoutException: none came in time.
            ConditionReachedException: `condition()` is true.
            ShutdownException: the executor was shut down.
            ExternalShutdownException: its context was.
        """
        entity, taken = self._wait_for_work(timeout_sec, condition)
        if entity is None:
            return taken, None, None

        def run() -> Any:
            with self._running:
                return entity.run(taken)

        task: Task[Any] = Task(run, executor=self)
        self._keep_task(task)
        task.when_complete(lambda: self._end(entity))
        node = next((node for node in self.get_nodes() if entity in node.entities()), None)
        return task, getattr(entity, "waitable", entity), node

    def _next(
        self,
        timeout_sec: float | None,
        condition: Callable[[], bool] | None = None,
        *,
        until_response: bool = False,
    ) -> Work:
        """Wait for a callback that may begin.

        Raises:
            TimeoutException: none came in time.
            ConditionReachedException: `condition()` is true; or, if `until_response`, a response has come.
            ShutdownException: the executor was shut down.
            ExternalShutdownException: its context was.
        """
        timeout_ns = timeout_sec_to_nsec(timeout_sec)
        end_ns = None if timeout_ns < 0 else time.monotonic_ns() + timeout_ns
        waited = has_response = False
        while True:
            if self._is_shutdown:
                raise ShutdownException
            if not self._context.ok():
                raise ExternalShutdownException
            if condition is not None and condition():
                raise ConditionReachedException
            if self._has_room():
                work = self._work_of_this_pass()
                if work is not None:
                    return work
            if has_response and until_response:
                raise ConditionReachedException
            if waited and end_ns is not None and time.monotonic_ns() >= end_ns:
                raise TimeoutException
            waited = True
            has_response = self._collect(end_ns)

    def _has_room(self) -> bool:
        """Return whether one more callback may be run now."""
        return True

    def _work_of_this_pass(self) -> Work | None:
        while self._pass_left:
            self._pass_left -= 1
            work = self._begin(self._ready.popleft())
            if work is not None:
                return work
        return None

    def _collect(self, end_ns: int | None) -> bool:
        """Wait for posts and timers, not beyond `end_ns`, and begin a new pass over all that is ready.

        Returns:
            Whether responses came; they are taken in already.
        """
        has_response = False
        if self._refused:
            self._ask_again()
        tokens = self._queue.wait(self._wait_ns(end_ns))
        for token in tokens:
            entity = self._entities.get(token)
            if entity is None:
                if token != WAKE:
                    self._ready.append(token)
            elif not entity.goes_by_group:
                has_response |= self._run_here(entity, token)
            elif entity.is_timed and not entity.is_polled and (due_ns := entity.deadline_ns()) is not None:
                self._timers.set(token, due_ns)  # timers have their turns by their deadlines alone
            else:
                self._ready.append(token)
        self._ready.extend(self._timers.take_due(time.monotonic_ns()))
        if self._polled:
            self._ready.extend(token for token in self._polled if token not in tokens)
        self._pass_left = len(self._ready)
        return has_response

    def _ask_again(self) -> None:
        """Make ready again what a group refused and would let run now."""
        refused, self._refused = dict.fromkeys(self._refused), []
        for token in refused:
            entity = self._entities.get(token)
            if entity is not None:
                (self._ready if self.can_execute(entity) else self._refused).append(token)

    def _run_here(self, entity: Entity, token: int) -> bool:
        """Run what runs no callback of the program's at once, on the thread that spins; False if there is none."""
        for number in range(MOST_AT_ONCE):
            taken = entity.take()
            if taken is None:
                return number > 0
            entity.run(taken)
        self._queue.post(token)
        return True

    def _wait_ns(self, end_ns: int | None) -> int:
        if self._ready and self._has_room():
            return 0
        ends = [end for end in (end_ns, self._timers.next_ns()) if end is not None]
        return max(0, min(ends) - time.monotonic_ns()) if ends else -1

    def _begin(self, token: int) -> Work | None:
        entity = self._entities.get(token)
        if entity is None:
            task = self._tasks.get(token)
            return None if task is None else Work(None, task)
        taken = self._take(entity, token)
        return None if taken is None else Work(entity, taken)

    def _take(self, entity: Entity, token: int) -> Any:
        """Begin a callback in its group and take what it is to run with; None if it may not, or has nothing to run."""
        group = entity.callback_group
        if group is not None and type(group) not in _FREED_BY_AN_END:
            return self._take_if_asked(group, entity, token)
        if group is not None and not group.beginning_execution(entity):
            group.park(lambda: self._queue.post(token))
            if group.can_execute(entity):  # it ended in between
                group.release_parked()
            return None
        taken = None
        try:
            taken = entity.take()
        finally:
            if taken is None:
                self._end(entity)
        self._look_again(entity, token, taken)
        return taken

    def _take_if_asked(self, group: CallbackGroup, entity: Entity, token: int) -> Any:
        """Do as `_take` with a group of the program's own: it hears of beginnings only where there is something to run.

        What it refuses it is asked about again each time the executor wakes, as it may change its mind unasked.
        """
        if not group.can_execute(entity):
            self._refused.append(token)
            return None
        taken = self._held.pop(token, None)
        if taken is None:
            taken = entity.take()
            self._look_again(entity, token, taken)
        if taken is not None and not group.beginning_execution(entity):
            self._held[token] = taken
            self._refused.append(token)
            return None
        return taken

    def _look_again(self, entity: Entity, token: int, taken: Any) -> None:
        if entity.is_timed:
            self._timers.set(token, entity.deadline_ns())
        elif taken is not None:
            self._ready.append(token)

    def _end(self, entity: Entity) -> None:
        group = entity.callback_group
        if group is not None:
            group.ending_execution(entity)
            group.release_parked()

    # Running

    def _run(self, work: Work) -> None:
        """Run a callback to its end, or a coroutine to its next await; what it raises comes out."""
        try:
            with self._running:
                if self._is_shutdown:  # meanwhile: its nodes are let go of, or are about to be
                    if work.entity is not None:
                        self._end(work.entity)
                elif work.entity is None:
                    self._run_task(work.taken)
                else:
                    self._run_entity(work.entity, work.taken)
        except Exception as error:
            # A signal came amid the callback, and what it did then needs a context, as publishing does.
            if self._context.explains(error):
                raise ExternalShutdownException from error
            raise

    def _run_entity(self, entity: Entity, taken: Any) -> None:
        outcome: Any = None
        try:
            outcome = entity.run(taken)
        finally:
            if not isinstance(outcome, CoroutineType):
                self._end(entity)
        if isinstance(outcome, CoroutineType):
            self._go_on_with(entity, outcome)

    def _go_on_with(self, entity: Entity, outcome: CoroutineType[Any, Any, Any]) -> None:
        """Run the coroutine that a callback is up to where it waits; its group counts it until its end."""
        task: Task[Any] = Task(outcome, executor=self)
        task.when_complete(lambda: self._end(entity))
        self._keep_task(task)
        self._run_task(task)

    def _run_task(self, task: Task[Any]) -> None:
        task()
        if not task.done() and not task.cancelled():
            return
        exception = task.exception() if task.done() else None
        if exception is not None:
            raise exception

    # Spinning

    def spin(self) -> None:
        """Run callbacks until the context, or the executor, is shut down.

        Raises:
            ExternalShutdownException: the context was shut down by a signal, or while this waited.
            KeyboardInterrupt: Ctrl-C, on the main thread.
            Exception: whatever a callback raises.
            RuntimeError: another thread spins this executor.
        """
        self._begin_spin()
        try:
            while self._context.ok() and not self._is_shutdown:
                self.spin_once()
        finally:
            self._spinning.release()
        if self._context.is_interrupted():  # by a signal that came while a callback ran
            raise ExternalShutdownException

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback and run it, or for a response to a client and take it in.

        Returns without either after `timeout_sec` [s] (None, negative: never).
        """
        self._spin_once(timeout_sec)

    def spin_until_future_complete(self, future: Future[Any], timeout_sec: float | None = None) -> None:
        """Run callbacks until a future is done, or `timeout_sec` [s] are over (None, negative: never)."""
        self._begin_spin()
        try:
            self._spin_until(future, timeout_sec)
        finally:
            self._spinning.release()

    def _spin_until(self, future: Future[Any], timeout_sec: float | None) -> None:
        def is_over() -> bool:
            return future.done() or future.cancelled()

        future.when_complete(self.wake)
        end_s = None if timeout_sec is None or timeout_sec < 0 else time.monotonic() + timeout_sec
        while self._context.ok() and not self._is_shutdown and not is_over():
            left_s = None if end_s is None else max(0.0, end_s - time.monotonic())
            self._spin_once(left_s, is_over)
            if end_s is not None and time.monotonic() >= end_s:
                return

    def spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        """Wait for one callback and run it, or return when a future is done or after `timeout_sec` [s]."""
        future.when_complete(self.wake)
        if isinstance(timeout_sec, TimeoutObject):
            timeout_sec = timeout_sec.timeout
        self._spin_once(timeout_sec, lambda: future.done() or future.cancelled())

    def _spin_once(self, timeout_sec: float | None, condition: Callable[[], bool] | None = None) -> None:
        try:
            work = self._wait_for_work(timeout_sec, condition, until_response=True)
        except (TimeoutException, ShutdownException, ConditionReachedException):
            return
        self._run(work)

    def _wait_for_work(
        self,
        timeout_sec: float | None,
        condition: Callable[[], bool] | None,
        *,
        until_response: bool = False,
    ) -> Work:
        self._begin_spin()
        try:
            return self._next(timeout_sec, condition, until_response=until_response)
        finally:
            self._spinning.release()

    def _begin_spin(self) -> None:
        """Keep other threads from spinning.

        Raises:
            RuntimeError: one does.
        """
        if not self._spinning.acquire(blocking=False):
            raise RuntimeError("Executor is already spinning, on another thread")

    # The end

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """End every spin, wait for the callbacks that run on other threads, and let go of all nodes.

        Returns:
            False if one still runs after `timeout_sec` [s] (None: wait for ever).
        """
        self._is_shutdown = True
        self._context.remove_queue(self._queue)
        self.wake()
        if not self._running.wait(timeout_sec):
            return False
        for node in self.get_nodes():
            self.remove_node(node)
        for entity in list(self._tokens):
            self.remove_entity(entity)
        for task in list(self._tasks.values()):
            task.abandon()
        self._tasks.clear()
        return True

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.shutdown()
