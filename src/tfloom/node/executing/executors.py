"""Single- and multi-threaded executors, and the global executor that `rclpy.spin` uses."""

from __future__ import annotations

import threading
import time
import warnings
from collections import deque
from collections.abc import Callable, Coroutine, Iterable
from types import CoroutineType
from typing import TYPE_CHECKING, Any, TypeVar

from tfloom.node.context.context import Context
from tfloom.node.context.utilities import current_defaults, get_default_context
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.signals import defer_keyboard_interrupt_in, shutdown_exception
from tfloom.node.executing.task import Future
from tfloom.node.executing.work_queue import Work
from tfloom.node.values.callback_errors import print_error
from tfloom.node.values.exceptions import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
)

if TYPE_CHECKING:
    from concurrent.futures import ThreadPoolExecutor

    from tfloom.node.executing.entity import Entity

__all__ = [
    "MultiThreadedExecutor",
    "SingleThreadedExecutor",
    "WaitableEntityType",
    "await_or_execute",
    "get_global_executor",
]


WaitableEntityType = TypeVar("WaitableEntityType")

MAX_HOLD_NS = 1_000_000_000
"""How long the end of what was sent before a response is waited for at most, before the response's future is
completed [ns]: a callback may itself wait for that future."""
MAX_HOLD_BY_OTHERS_NS = 100_000_000
"""The same while other callbacks occupy all threads, or the group: those, too, may wait for that future [ns]."""
BATCH_NS = 200_000
"""How long a thread of the pool runs one callback after the other without returning to the thread that spins [ns]."""


async def await_or_execute(callback: Callable[..., Any] | Coroutine[Any, Any, Any], *args: Any) -> Any:
    """Call a function, or await a coroutine function or coroutine, and return the result."""
    outcome = callback if isinstance(callback, Coroutine) else callback(*args)
    return await outcome if isinstance(outcome, Coroutine) else outcome


class _Held:
    """What is called when an entity has nothing waiting any more, and none of its callbacks runs.

    Args:
        entity: The entity.
        then: What is called.
    """

    def __init__(self, entity: Entity, then: Callable[[], None]) -> None:
        self.entity = entity
        self.then = then
        self.end_ns = time.monotonic_ns() + MAX_HOLD_NS
        """When it is called in any case, by the steady clock."""

    def is_over(self) -> bool:
        """Return whether the wait has been as long as it may be."""
        return time.monotonic_ns() >= self.end_ns


class SingleThreadedExecutor(Executor):
    """Runs callbacks on the thread that spins."""


class MultiThreadedExecutor(Executor):
    """Runs callbacks on a pool of threads, at the same time if their groups allow it.

    The thread that spins takes what is ready and hands it to a thread of the pool, which takes more time than a short
    callback. So during a spin of more than one callback, the thread of the pool continues with the messages that wait
    for the same subscription, or requests for the same service, for `BATCH_NS`, if nothing else waits for its group
    or for a thread.

    Args:
        num_threads: Number of threads; None: the number of CPUs, at least 2.
        context: As for every executor.

    Raises:
        ValueError: `num_threads` is less than 1.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        if num_threads is not None and not isinstance(num_threads, int):
            given = f"{num_threads!r} of class {type(num_threads).__name__}"
            raise TypeError(f"MultiThreadedExecutor needs a number of threads, as 4, got {given}")
        if num_threads is not None and num_threads < 1:
            raise ValueError(f"a MultiThreadedExecutor needs at least one thread, not {num_threads}")
        super().__init__(context=context)
        import os
        from concurrent.futures import thread

        # An exception between two lines of the pool's `submit` would prevent its threads from ending.
        defer_keyboard_interrupt_in(thread.ThreadPoolExecutor.submit.__code__.co_filename)
        if num_threads is None:
            num_threads = os.cpu_count() or 1
        elif num_threads == 1:
            warnings.warn(
                "MultiThreadedExecutor is used with a single thread.\nUse the SingleThreadedExecutor instead.",
                stacklevel=2,
            )
        self._num_threads = max(num_threads, 2) if num_threads != 1 else 1
        self._pool = thread.ThreadPoolExecutor(self._num_threads, thread_name_prefix="tfloom_executor")
        self._busy_lock = threading.Lock()
        self._busy = 0
        """Number of callbacks in the pool. Changed under `_busy_lock`, read without it."""
        self._errors: deque[BaseException] = deque()
        """Exceptions of callbacks, for the thread that spins. Changed by single operations, without a lock."""
        self._has_thread = False
        """Whether the pool has a thread. Set once, by the first callback that runs there, without a lock."""
        self._lacks_thread = False
        """Whether the pool's queue has a callback for which no thread could be started. Of the thread that spins."""
        self._in_pool: list[Entity | None] = []
        """The entities whose callbacks are in the pool. Changed by single operations, without a lock."""
        self._held: list[_Held] = []
        """What `run_waiting` holds back; a thread that removes one calls it. Changed without a lock."""
        self._awaited: Future[Any] | None = None
        """The future at whose completion the present spin ends. Written by the thread that spins, without a lock."""

    _returns_after_signal = True
    _runs_tasks_first = False  # they run on other threads, which may all wait for a response

    def _has_room(self) -> bool:
        # Until a thread is free, a message waits in its reader, whose history depth limits the number.
        return self._busy < self._num_threads

    def _spin_once(self, end_ns: int | None, condition: Callable[[], bool] | None = None) -> None:
        # A callback that spins is not ended by the error of another one, which the spin around it raises.
        is_nested = self._running.is_this_thread()

        def stop() -> bool:
            return bool(self._errors and not is_nested) or (condition is not None and condition())

        # A callback is in the pool's queue, and no thread to run it. Any call makes the pool try to start one again.
        if self._lacks_thread:
            self._start_thread(lambda: None)
        try:
            work = self._wait_for_work(end_ns, stop, until_response=True)
            self._submit(work)
        except (TimeoutException, ShutdownException, ConditionReachedException):
            pass
        except ExternalShutdownException as end:
            self._end_at_shutdown(end)
            return  # what callbacks raise now is of the shutdown, as of a publisher whose context has just ended
        # One error for each spin; the next one stops at once for the next error. What a callback saw of the shutdown on
        # its thread is replaced by what this thread must raise, KeyboardInterrupt on the main one after Ctrl-C.
        if self._errors and not is_nested:
            error = self._errors.popleft()
            if not isinstance(error, ExternalShutdownException):
                raise error
            self._end_at_shutdown(shutdown_exception())

    def _spin_until(self, future: Future[Any], end_ns: int | None, is_over: Callable[[], bool]) -> None:
        self._awaited = future
        try:
            super()._spin_until(future, end_ns, is_over)
        finally:
            self._awaited = None

    def _submit(self, work: Work) -> None:
        # Counted here and not on the pool's thread, which may begin late: `_has_room` would admit too many meanwhile.
        with self._busy_lock:
            self._busy += 1
        self._in_pool.append(work.entity)
        self._start_thread(lambda: self._run_in_pool(work), work)

    def _start_thread(self, run: Callable[[], None], work: Work | None = None) -> None:
        """Call `run()` on a thread of the pool, which is started if none is free.

        Where the system allows no other thread, the call is in the pool's queue nevertheless: a thread that is there
        makes it when it is free; otherwise the next spin tries again to start one.

        Raises:
            RuntimeError: there is no thread at all.
        """
        try:
            self._pool.submit(run)
            self._lacks_thread = False
        except RuntimeError as error:
            # `submit` puts the call in the queue before it starts a thread, so only the thread is missing.
            if not self._is_shutdown:
                self._lacks_thread = not self._has_thread
                if self._lacks_thread:
                    raise RuntimeError(
                        f"A MultiThreadedExecutor could not start a thread for a callback: {error}. Spin again when "
                        "there are fewer threads, or raise the limit of processes (ulimit -u)"
                    ) from error
                return
            with self._busy_lock:  # another thread has just shut this executor down: the callback isn't run
                self._busy -= work is not None
            if work is not None:
                self._in_pool.remove(work.entity)
                if work.entity is not None:
                    self._end(work.entity)

    def _run_in_pool(self, work: Work) -> None:
        self._has_thread = True
        try:
            self._run(work)
        except BaseException as error:  # raised on the thread that spins
            self._errors.append(error)
        finally:
            self._in_pool.remove(work.entity)
            with self._busy_lock:
                self._busy -= 1
            # The thread that spins may wait for a free thread of the pool, or has an error to raise.
            self.wake()

    def _run_entity(self, entity: Entity, taken: Any) -> None:
        """Run a callback, and those for what else the entity has, as far as `_may_continue` allows."""
        batch_end_ns = time.monotonic_ns() + BATCH_NS
        outcome: Any = None
        try:
            while taken is not None:
                outcome = entity.run(taken)
                taken = entity.take() if self._may_continue(entity, outcome, batch_end_ns) else None
        finally:
            if not isinstance(outcome, CoroutineType):
                self._end(entity)
        if isinstance(outcome, CoroutineType):
            self._continue_coroutine(entity, outcome)

    def _may_continue(self, entity: Entity, outcome: Any, batch_end_ns: int) -> bool:
        """Return whether this thread of the pool may run the next callback of an entity, and keep its group."""
        group, awaited = entity.callback_group, self._awaited
        # `take` may be called on one thread at a time: a mutually exclusive group, which this callback still occupies,
        # keeps the thread that spins from taking from the same entity. A reentrant one would not.
        # The rest of the conditions is about what must not wait for another callback here: the end of the spin, an
        # error, a shutdown, the removal of the entity, and callbacks that wait for a thread or for this group.
        return (
            entity.takes_on_any_thread
            and type(group) is MutuallyExclusiveCallbackGroup
            and not isinstance(outcome, CoroutineType)
            and self._is_in_long_spin
            and not (awaited is not None and (awaited.done() or awaited.cancelled()))
            and not self._errors
            and not self._is_shutdown
            and self._context.ok()
            and entity in self._tokens
            and self._has_room()
            and not group.has_parked_another(entity)
            and time.monotonic_ns() < batch_end_ns
        )

    def run_waiting(self, entity: Entity, then: Callable[[], None]) -> None:
        """Call `then` on the thread that spins, when all that an entity has waiting has run on threads of the pool.

        A callback may wait for what `then` completes, on a thread or in the group that the entity's own need: so it is
        called after `MAX_HOLD_NS` in any case. On another thread than the one that spins, it is called at once.
        """
        if not self._try_to_spin():
            then()
            return
        try:
            held = _Held(entity, then)
            self._held.append(held)
            self._release_if_over(held)
        finally:
            self._end_spin()

    def _collect(self, end_ns: int | None, *, quiet: bool = False) -> None:
        if not self._held:
            super()._collect(end_ns, quiet=quiet)
            return
        for held in list(self._held):
            self._release_if_over(held)
        # A released one may have completed the future that this spin waits for: `_next` looks at it before it waits.
        hold_ends = [time.monotonic_ns()] if self._has_response else [held.end_ns for held in self._held]
        super()._collect(min(hold_ends if end_ns is None else [end_ns, *hold_ends]), quiet=quiet)

    def _release_if_over(self, held: _Held) -> None:
        """Hand what an entity has waiting to the pool; call what is held back, if nothing is left."""
        entity, token = held.entity, self._tokens.get(held.entity)
        # None: the entity was removed, and `remove_entities` may have looked for what is held back before it was there.
        while token is not None and not self._is_shutdown and not held.is_over():
            # Asked first, because only this thread begins callbacks: what is admitted now and not taken isn't there.
            may_run = self._has_room() and self.can_execute(entity)
            taken = self._take(entity, token) if may_run else None
            if taken is not None:
                self._submit(Work(entity, taken))
            elif entity in self._in_pool:  # the end of the callback wakes this thread
                return
            elif may_run:
                break
            elif not (
                self._has_room() and self.can_execute(entity)
            ):  # or else one has just ended: look again
                held.end_ns = min(held.end_ns, time.monotonic_ns() + MAX_HOLD_BY_OTHERS_NS)
                return
        self._release(held)

    def _release(self, held: _Held) -> None:
        try:
            self._held.remove(held)
        except ValueError:  # another thread has been faster
            return
        self._has_response = True
        held.then()

    def remove_entities(self, entities: Iterable[Entity]) -> None:
        """Remove entities; what waits for their callbacks is held back no longer."""
        removed = list(entities)
        super().remove_entities(removed)
        for held in [held for held in self._held if held.entity in removed]:
            self._release(held)

    @property
    def _executor(self) -> ThreadPoolExecutor:
        """The pool of threads, by rclpy's name, which programs read."""
        return self._pool

    def would_wait_for_itself(self) -> bool:
        """Return False, because the thread that spins receives data while callbacks run on other threads."""
        return False

    def shutdown(self, timeout_sec: float | None = None, *, wait_for_threads: bool = True) -> bool:
        """End every spin and wait for running callbacks; see `Executor.shutdown`.

        Args:
            timeout_sec: The longest wait for callbacks [s]; None: no limit.
            wait_for_threads: Whether to wait also for the end of the pool's threads, which then run nothing. With a
                timeout, and in a callback on one of them, it is not waited for.
        """
        if not super().shutdown(timeout_sec):
            return False
        waits = wait_for_threads and timeout_sec is None and not self._running.is_this_thread()
        self._pool.shutdown(wait=waits)
        while self._errors:  # of callbacks that ended after the last spin
            error = self._errors.popleft()
            if not isinstance(
                error, (ExternalShutdownException, KeyboardInterrupt)
            ):  # which a spin has raised once
                print_error(error, "An exception was raised in a callback, and no spin has raised it:")
        return True


_global_lock = threading.Lock()
"""Held by the thread that creates the executor of a default context."""


def get_global_executor() -> Executor:
    """Return the executor on the default context that `rclpy.spin` and its variants use if none is given."""
    defaults = current_defaults()
    executor: Executor | None = defaults.executor
    # The usual case needs no lock; under it, all is checked again, because another thread may have been faster.
    if executor is not None and executor.context is defaults.context and not executor.is_shutdown:
        return executor
    with _global_lock:
        executor = defaults.executor
        context = get_default_context()
        if executor is None or executor.context is not context or executor.is_shutdown:
            if executor is not None:  # a callback of it that still runs isn't waited for
                executor.shutdown(0.0)
            executor = SingleThreadedExecutor(context=context)
            executor._returns_after_shutdown = True  # noqa: SLF001  # of the class that this file completes
            defaults.executor = executor
        return executor
