"""Futures, and the tasks that an executor runs."""

from __future__ import annotations

import threading
import weakref
from collections.abc import Callable, Coroutine, Generator, Iterable, Mapping
from contextlib import AbstractContextManager, nullcontext
from enum import Enum
from typing import Any, Generic, Protocol, TypeVar, cast

from tfloom.common.terminal import report
from tfloom.common.text import given_text
from tfloom.node.executing.asyncio_wait import is_driven_by_asyncio, step, wait_in_asyncio
from tfloom.node.values.callback_errors import call_all, print_error
from tfloom.ros_imports.guard import ros_repr

__all__ = ["Future", "FutureState", "Task", "TaskRunner", "future_error"]

T = TypeVar("T")


class TaskRunner(Protocol):
    """The method of an executor that a future calls."""

    def create_task(self, callback: Callable[..., Any], /, *args: Any) -> Any:
        """Call `callback(*args)` on a thread that runs callbacks."""


def future_error(future: object) -> TypeError | None:
    """Return the error of what `spin_until_future_complete` got in place of a future, or None if it is one."""
    if hasattr(future, "when_complete") and not isinstance(future, type):
        return None
    given = "None" if future is None else given_text(future)
    return TypeError(f"spin_until_future_complete() needs a future, as `call_async` returns it, got {given}")


class FutureState(Enum):
    """Whether a future is complete."""

    PENDING = "PENDING"
    CANCELLED = "CANCELLED"
    FINISHED = "FINISHED"


def _no_executor() -> None:
    """Stand for the weak reference to an executor where there is none."""


class Future(Generic[T]):
    """The result of a call that isn't complete yet.

    Coroutines may await it, in an executor and in asyncio. In asyncio, cancelling the task that awaits it cancels the
    future, and a cancelled future raises `asyncio.CancelledError`; in an executor it returns None.

    Methods may be called from any thread. A callback of `add_done_callback` runs as a task of `executor` if there is
    one; otherwise at once, on the thread that completes the future.
    """

    def __init__(self, *, executor: TaskRunner | None = None) -> None:
        self._done = False
        self._cancelled = False
        self._result: T | None = None
        self._exception: BaseException | None = None
        self._exception_fetched = False
        self._callbacks: list[Callable[[Future[T]], Any]] = []
        self._resumers: list[Callable[[], None]] = []
        self._lock = threading.RLock()
        """Guards the outcome and the lists of callbacks; the outcome is read without it."""
        self._executor: Callable[[], TaskRunner | None] = _no_executor
        self.set_executor(executor)

    def __repr__(self) -> str:
        return ros_repr(self)

    def __del__(self) -> None:
        if self._exception is not None and not self._exception_fetched:
            report(f"The following exception was never retrieved: {self._exception}")

    def __await__(self) -> Generator[Any, None, T]:
        if not self._done:
            if is_driven_by_asyncio():
                yield from wait_in_asyncio(self)
            else:
                yield from self._wait_in_executor()
        return self.result()

    def _wait_in_executor(self) -> Generator[Future[T], None, None]:
        # The task that runs the coroutine is resumed by a callback of the future that is yielded here.
        while not self._done and not self._cancelled:
            yield self

    def cancel(self) -> None:
        """Cancel the future and schedule its callbacks, unless it is complete already."""
        with self._lock:
            if self._done or self._cancelled:
                return
            self._cancelled = True
        self._schedule_or_invoke_done_callbacks()

    def _pending(self) -> bool:
        """Return whether it is neither complete nor cancelled."""
        return not self._done and not self._cancelled

    @property
    def _state(self) -> FutureState:
        """The state, by rclpy's name, which executors of other projects read."""
        if self._done:
            return FutureState.FINISHED
        return FutureState.CANCELLED if self._cancelled else FutureState.PENDING

    def cancelled(self) -> bool:
        """Return whether it was cancelled before it had a result."""
        return self._cancelled

    def done(self) -> bool:
        """Return whether there is a result or an exception."""
        return self._done

    def result(self) -> T:
        """Return the result; None while there is none, and after cancellation.

        Its type is that of the result, because programs read it once the future is done.

        Raises:
            BaseException: the exception the future was completed with.
        """
        if self._exception is not None:
            self._exception_fetched = True
            raise self._exception
        return cast("T", self._result)

    def exception(self) -> BaseException | None:
        """Return the exception the future was completed with, or None."""
        self._exception_fetched = True
        return self._exception

    def set_result(self, result: T) -> None:
        """Complete the future and schedule its callbacks."""
        with self._lock:
            self._result = result
            self._done = True
            self._cancelled = False
        self._schedule_or_invoke_done_callbacks()

    def set_exception(self, exception: BaseException) -> None:
        """Complete the future with an exception, which `result` raises."""
        with self._lock:
            self._exception = exception
            self._exception_fetched = False
            self._done = True
            self._cancelled = False
        self._schedule_or_invoke_done_callbacks()

    def add_done_callback(self, callback: Callable[[Future[T]], Any]) -> None:
        """Call `callback(future)` when the future completes or is cancelled; at once if that has happened."""
        with self._lock:
            if not self._done and not self._cancelled:
                self._callbacks.append(callback)
                return
        self._run_callback(callback)

    def remove_done_callback(self, callback: Callable[[Future[T]], Any]) -> bool:
        """Undo one `add_done_callback`; return False for a callback that wasn't added, or was called."""
        with self._lock:
            if callback not in self._callbacks:
                return False
            self._callbacks.remove(callback)
            return True

    def when_complete(self, resume: Callable[[], None]) -> None:
        """Call `resume()` on completion, at once if it is complete, on the completing thread; once if added twice.

        For executors and tasks, because those must not wait for another task; programs use `add_done_callback`.
        """
        with self._lock:
            if not self._done and not self._cancelled:
                if resume not in self._resumers:
                    self._resumers.append(resume)
                return
        resume()

    def set_executor(self, executor: TaskRunner | None) -> None:
        """Run callbacks as tasks of `executor`; None: at once, on the thread that completes the future."""
        self._executor = _no_executor if executor is None else weakref.ref(executor)

    _set_executor = set_executor

    # This one and others of the private names are rclpy's, because executors of other projects use them.
    def _schedule_or_invoke_done_callbacks(self) -> None:
        # Taken out under the lock, so that each is called once; called without it, because a callback may wait for a
        # thread that uses this future.
        with self._lock:
            callbacks, self._callbacks = self._callbacks, []
            resumers, self._resumers = self._resumers, []
        try:
            call_all(resumers)
        finally:  # what one of them raises reaches the thread that completes the future, and holds up nobody else
            for callback in callbacks:
                self._run_callback(callback)

    def _run_callback(self, callback: Callable[[Future[T]], Any]) -> None:
        executor = self._executor()
        if executor is not None:
            executor.create_task(callback, self)
            return
        try:
            callback(self)
        except Exception as error:  # the next callback must run, and the completing thread must continue
            print_error(error, "An exception was raised in a done callback of a future:")


class Task(Future[T]):
    """A function or coroutine that an executor runs; its outcome completes the future.

    Calling the task runs the function, or the coroutine to its next await.
    """

    def __init__(
        self,
        handler: Callable[..., T] | Callable[..., Coroutine[Any, Any, T]] | Coroutine[Any, Any, T],
        args: Iterable[Any] | None = None,
        kwargs: Mapping[str, Any] | None = None,
        executor: TaskRunner | None = None,
    ) -> None:
        super().__init__(executor=executor)
        self._handler: Callable[..., Any] | Coroutine[Any, Any, T] | None = handler
        """The function until it is called, and the coroutine."""
        self._args = tuple(args or ())
        self._kwargs = dict(kwargs or {})
        self._resume: Callable[[], None] | None = None
        self.step_count = 0
        """Number of steps that have begun."""
        self.during_steps: AbstractContextManager[object] = nullcontext()
        """Entered while a step runs."""
        self._task_lock = threading.Lock()
        """Held by the thread that runs a step."""

    def __call__(self) -> None:
        """Run one step; do nothing if the task is done, cancelled, or running on another thread."""
        # A thread that finds the lock held may leave: after its step, the other one waits for what the coroutine
        # awaits, and is called back at once if that is complete.
        if self._done or self._cancelled or not self._task_lock.acquire(blocking=False):
            return
        try:
            self.step_count += 1
            with self.during_steps:
                waits_for = self._step()
        finally:
            self._task_lock.release()
        # Only after the release: the awaited future may be complete, or complete on another thread right now. The
        # thread that then runs the next step must find the lock free, or the task would never go on.
        if waits_for is not None:
            waits_for.when_complete(self._notify_runnable)
        elif (
            not self._done and not self._cancelled
        ):  # it awaits what is not a future of ours, and can't be notified of its end
            self._notify_runnable()

    def on_resume(self, resume: Callable[[], None]) -> None:
        """Call `resume()`, on any thread, when a waiting coroutine can continue."""
        self._resume = resume

    def executing(self) -> bool:
        """Return whether a step is running."""
        return self._task_lock.locked()

    def cancel(self) -> None:
        """Cancel the task; close a waiting coroutine."""
        super().cancel()
        self.abandon()

    def abandon(self) -> None:
        """Stop running steps: close a waiting coroutine, and leave the future incomplete."""
        # Python can't close a coroutine that runs, and waiting for its step might wait for this very thread.
        if self._task_lock.acquire(blocking=False):
            try:
                if isinstance(self._handler, Coroutine):
                    self._handler.close()
            finally:
                self._task_lock.release()

    def _step(self) -> Future[Any] | None:
        """Run to the end or the next await; return the future awaited, None for any other awaitable."""
        try:
            if self._handler is not None and not isinstance(self._handler, Coroutine):
                handler, self._handler = self._handler, None  # it is called in the first step alone
                outcome = handler(*self._args, **self._kwargs)
                if not isinstance(outcome, Coroutine):
                    self.set_result(outcome)
                    return None
                self._handler = outcome
            if self._handler is not None:
                awaited = step(self._handler)
                return awaited if isinstance(awaited, Future) else None
        except StopIteration as end:
            self.set_result(end.value)
        except Exception as exc:  # the future raises it
            self.set_exception(exc)
        except (
            BaseException
        ) as exc:  # SystemExit, for example, which ends the spin: complete, the task frees its group
            self.set_exception(exc)
            self._exception_fetched = True
            raise
        return None

    def _notify_runnable(self) -> None:
        if self._resume is not None:
            self._resume()
