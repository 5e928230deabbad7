"""The base of executors, which run the callbacks of their nodes while a thread spins."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Container, Iterator
from contextlib import ExitStack, contextmanager
from types import CoroutineType, TracebackType
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.common.seconds import checked_timeout, timeout_error
from tfloom.node.context.context import Context
from tfloom.node.context.utilities import get_default_context, timeout_sec_to_nsec
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup
from tfloom.node.executing.offered_work import OfferedWork
from tfloom.node.executing.running_work import RunningWork
from tfloom.node.executing.signals import shutdown_exception
from tfloom.node.executing.task import Future, Task, future_error
from tfloom.node.executing.temporarily_added import TemporarilyAdded
from tfloom.node.executing.work_queue import MAX_BATCH_SIZE, Work
from tfloom.node.values.callback_errors import report_exception
from tfloom.node.values.duration import S_TO_NS
from tfloom.node.values.exceptions import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
)
from tfloom.node.values.wrong_arguments import node_error
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom.node.clock.clock import Clock
    from tfloom.node.executing.entity import Entity
    from tfloom.node.log.rcutils_logger import RcutilsLogger

__all__ = ["Executor", "SpunNode", "executor_of"]

NESTED_HINT_NS = 1_000_000_000
"""How long a callback that spins may keep others of its group from running before a hint is logged [ns]."""
NESTED_HINT = (
    "A callback spins, and others that are ready can't run before it returns, because they are in its callback "
    "group. Await the future in an async callback, or give one of them its own callback group"
)
ENDLESS_HINT_NS = 5_000_000_000
"""How long a callback may spin without a limit, and without anything to run, before a hint is logged [ns]."""
ENDLESS_HINT = (
    "A callback spins without a timeout, and nothing that it may run has become ready for some seconds. Until it "
    "returns, nothing of its callback group runs, nor its own timer or subscription again: if it waits for one of "
    "these, it waits for ever. Pass a timeout, or await a future in an async callback"
)


OWN_SPIN_S = 0.05
"""The longest `spin_once` of a program's class between two looks at a future [s]."""


class SpunNode(Protocol):
    """The methods of a node that an executor calls."""

    @property
    def executor(self) -> Executor | None:
        """The executor that the node was added to last."""

    def _enter_executor(self, executor: Executor) -> list[Entity]:
        """Store the executor that has added the node, leave the former one, and return what it is to run."""

    def _leave_executor(self, executor: Executor) -> list[Entity]:
        """Forget the executor, unless it is the former one, and return what it is no longer to run."""

    @property
    def context(self) -> Context:
        """The context that the node belongs to."""

    def get_name(self) -> str:
        """Return the node's name."""

    def get_namespace(self) -> str:
        """Return the node's namespace."""

    def get_fully_qualified_name(self) -> str:
        """Return namespace and name."""

    def get_logger(self) -> RcutilsLogger:
        """Return the node's logger."""

    def get_clock(self) -> Clock:
        """Return the node's clock."""

    def destroy_node(self) -> None:
        """Leave the executor and the graph."""


def executor_of(node: SpunNode) -> Executor | None:
    """Return the executor that has a node now. `Node.executor` is also one that it was removed from."""
    executor = node.executor
    return executor if executor is not None and node in executor.get_nodes() else None


class Executor(OfferedWork):
    """Runs the callbacks of the nodes added to it, while one of its `spin` methods is called.

    Any thread may add and remove nodes and entities at any time. One thread at a time may spin.

    Args:
        context: Context whose shutdown ends every spin; None: the default one.
    """

    _returns_after_signal = False
    """Whether a spin also returns when a signal has shut the context down, but for Ctrl-C on the main thread."""

    def __init__(self, *, context: Context | None = None) -> None:
        super().__init__()
        self._context = context or get_default_context()
        self._context.add_queue(self._queue)
        self._spinning = threading.RLock()
        """Lock held by the thread that spins."""
        self._spin_depth = 0
        """How many spins that thread is in, one inside the other. Guarded by `_spinning`, as the next two."""
        self._spinner = 0
        """The thread that spins, or did last."""
        self._is_spun_by_callback = False
        """Whether that thread runs a callback of this executor meanwhile."""
        self._followers: list[threading.Event] = []
        """Events of the threads that wait while another one spins. Changed by single operations, without a lock."""
        self._is_in_long_spin = False
        """Whether the spin continues after one callback. Written by the thread that spins, without a lock."""
        self._nodes: list[SpunNode] = []
        """The nodes that were added. Guarded by `_lock`."""
        self._is_shutdown = False
        """Set once, by `shutdown`, without a lock."""
        self._returns_after_shutdown = False
        """Whether a spin returns when the context is shut down without a signal. Written before the first spin."""
        self._has_returned = False
        """Whether a single spin has returned because of the context's shutdown. Set once, without a lock."""
        self._running = RunningWork()
        """The threads that run callbacks now."""
        self._blocked_since_ns: int | None = None
        """When callbacks were first found blocked by one that spins. Of the thread that spins alone, as all below."""
        self._endless_since_ns: int | None = None
        """When the present wait of a callback that spins without a limit began."""
        self._has_hinted = False

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def context(self) -> Context:
        """Context whose shutdown ends every spin."""
        return self._context

    @property
    def is_shutdown(self) -> bool:
        """Whether `shutdown` was called."""
        return self._is_shutdown

    @property
    def is_spinning(self) -> bool:
        """Whether a thread is in one of the `spin` methods, or waits for callbacks."""
        return self._spin_depth > 0

    # Nodes and entities

    def add_node(self, node: SpunNode) -> bool:
        """Add a node; return False if it was added before. A node in another executor is removed from that one."""
        if (error := node_error("add_node", node)) is not None:
            raise error
        _ = node.executor  # raises, before anything is changed, where the node's `__init__` has not run
        with self._lock:
            if self._is_shutdown:
                raise ShutdownException("cannot add a node to an executor that is shut down")
            if node in self._nodes:
                return False
            self._nodes.append(node)
        entities = node._enter_executor(self)
        self.add_entities(entities)
        return True

    def remove_node(self, node: SpunNode) -> None:
        """Stop running a node's callbacks."""
        with self._lock:
            if node not in self._nodes:
                return
            self._nodes.remove(node)
        entities = node._leave_executor(self)
        self.remove_entities(entities)

    def get_nodes(self) -> list[SpunNode]:
        """Return the nodes that were added."""
        with self._lock:
            return list(self._nodes)

    # Waiting

    def would_wait_for_itself(self) -> bool:
        """Return whether this is called from a callback on the only thread that receives data.

        A program's own executor may run callbacks on other threads than the one that spins it.
        """
        return self._running.is_this_thread() and self._spinner == threading.get_ident()

    def wait_for_ready_callbacks(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        nodes: list[SpunNode] | None = None,
        condition: Callable[[], bool] | None = None,
    ) -> tuple[Task[Any], Any, SpunNode | None]:
        """Wait for a callback that may begin; executors of a program's own then call the returned task, on any thread.

        The task takes the message and begins the callback in its group; where the group runs another one by then, it
        does nothing, and another task is returned later. A task that has not begun is returned again. One that awaits
        is returned when it can continue.

        Args:
            timeout_sec: The longest wait [s]; None, negative: no limit.
            nodes: The nodes whose callbacks are waited for, also if they were not added; None: all that were.
            condition: Called each time the executor wakes; the wait ends when it returns True.

        Returns:
            The task, its entity and the entity's node; the last two are None for a program's own task.

        Raises:
            TimeoutException: none was ready in time; or, in a callback, another thread that spins has begun one.
            ConditionReachedException: `condition()` is true.
            ShutdownException: the executor was shut down.
            ExternalShutdownException: its context was shut down.
        """
        if (error := timeout_error("wait_for_ready_callbacks", _seconds(timeout_sec))) is not None:
            raise error
        for node in nodes or ():
            if (error := node_error("wait_for_ready_callbacks", node)) is not None:
                raise error
        with ExitStack() as stack:
            for node in nodes or ():
                stack.enter_context(TemporarilyAdded(node, self))
            entity, task = self._wait_for_work(
                _end_ns(timeout_sec), condition, for_nodes=nodes, is_begun=False
            )
        return task, None if entity is None else entity.member, None if entity is None else entity.owner

    def _call(self, entity: Entity, taken: Any) -> Any:
        with self._running:
            return entity.run(taken)

    def _register_task(self, task: Task[Any]) -> int:
        task.during_steps = self._running
        return super()._register_task(task)

    def _next(
        self,
        end_ns: int | None,
        condition: Callable[[], bool] | None = None,
        *,
        until_response: bool = False,
        for_nodes: Container[SpunNode] | None = None,
        is_begun: bool = True,
    ) -> Work:
        """Wait for a callback that may begin, until `end_ns` by the steady clock; None: without limit.

        With `is_begun`, it has begun for its group, and its item is taken; otherwise a task does so.

        Raises:
            TimeoutException: none was ready in time.
            ConditionReachedException: `condition()` is true; or, if `until_response`, a response has arrived.
            ShutdownException: the executor was shut down.
            ExternalShutdownException: its context was shut down.
        """
        waited = False
        self._endless_since_ns = None
        begin = self._begin_wait(for_nodes, is_begun=is_begun)
        while True:
            self._check_wait(condition)
            # While all threads of a pool are busy, the rest of the pass stays in `_ready`; a thread that becomes free
            # wakes this one.
            if self._has_room():
                work = self._work_of_this_pass(begin)
                if work is None and waited and not is_begun:
                    work = self._offered_again(end_ns)
                if work is not None:
                    self._note_begun()
                    return work
            # A response completes its future on this thread, without a callback that could be returned here. The
            # program's `spin_once` must return nevertheless, so that it can look at its future.
            if self._has_response and until_response:
                self._note_begun()
                raise ConditionReachedException
            # The time is checked only after one look at the queue, so that a timeout of 0 finds what was posted before.
            if waited and end_ns is not None and time.monotonic_ns() >= end_ns:
                raise TimeoutException
            waited = True
            # Messages for a sink need no callback, so a long spin ignores them. A spin in a callback may wait for them.
            quiet = not self._is_in_long_spin or self._running.is_this_thread()
            look_ns = end_ns if is_begun else self._look_again_ns(end_ns)
            self._collect(self._end_of_nested_wait(look_ns, has_end=end_ns is not None), quiet=quiet)

    def _check_wait(self, condition: Callable[[], bool] | None) -> None:
        """Raise what ends a wait. Nothing begins after a shutdown, even if it is ready."""
        if self._is_shutdown:
            raise ShutdownException
        if not self._context.ok():
            raise shutdown_exception()
        if condition is not None and condition():
            raise ConditionReachedException

    def _note_begun(self) -> None:
        """Tell the threads that wait in a nested `spin_once` that a callback has begun, or a response was taken."""
        self._running.note_begun()
        self._wake_followers()

    def _wake_followers(self) -> None:
        for event in list(self._followers):
            event.set()

    def wake(self) -> None:
        """Wake the threads that spin, so that they check their conditions again."""
        super().wake()
        self._wake_followers()

    def _end_of_nested_wait(self, end_ns: int | None, *, has_end: bool) -> int | None:
        """Return when to wake from a wait until `end_ns` to log a hint: a callback that spins may wait for itself.

        Either callbacks of its group are ready and can't run before it returns; or it waits without a limit, and
        nothing is ready. The hint comes once, because the wait may be for something else.
        """
        if self._has_hinted or not RunningWork.is_any_on_this_thread():
            return end_ns
        entities = list(self._entities.values())  # a copy, because other threads add and remove entities
        now_ns = time.monotonic_ns()
        entity = next((entity for entity in entities if _is_blocked_by_group(entity)), None)
        if entity is not None:
            # The time counts over several waits, because the callback may spin in a loop with short timeouts.
            since_ns = self._blocked_since_ns = self._blocked_since_ns or now_ns
            hint, hint_ns = NESTED_HINT, since_ns + NESTED_HINT_NS
        else:
            self._blocked_since_ns = None
            # Where no callback of these entities runs, none of them waits for the callback that spins.
            entity = None if has_end else next(filter(_is_running, entities), None)
            if entity is None:
                return end_ns
            since_ns = self._endless_since_ns = self._endless_since_ns or now_ns
            hint, hint_ns = ENDLESS_HINT, since_ns + ENDLESS_HINT_NS
        if now_ns < hint_ns:
            # Nothing is posted when the hint is due, so the wait ends then, and this is called again.
            return hint_ns if end_ns is None else min(end_ns, hint_ns)
        self._has_hinted = True
        entity.owner.get_logger().warning(hint)
        return end_ns

    # Running

    def run_waiting(self, entity: Entity, then: Callable[[], None]) -> None:
        """Run the callbacks for all that an entity has waiting, as far as its group admits them; then call `then`.

        To be called where a response was taken. It runs no callback while another thread spins. What a callback raises
        is raised after `then` was called.
        """
        try:
            self._run_all_of(entity)
        finally:
            then()

    def _run_all_of(self, entity: Entity) -> None:
        token = self._tokens.get(entity)
        # `_take` uses what belongs to the thread that spins alone. If that is another one, the posts of the entity have
        # told it, and it runs these callbacks itself.
        if token is None or not self._try_to_spin():
            return
        try:
            # Bounded, so that a publisher that is faster than the callback doesn't hold up the caller for ever.
            for _ in range(MAX_BATCH_SIZE):
                taken = self._take(entity, token)
                if taken is None:
                    return
                self._run(Work(entity, taken))
        finally:
            self._end_spin()

    def _run(self, work: Work) -> None:
        """Run a callback to its end, or a coroutine to its next await, and raise its exception, if any."""
        try:
            with self._running:
                if self._is_shutdown:  # shut down during the wait: its nodes are being removed
                    if work.entity is not None:
                        self._end(work.entity)
                elif work.entity is None:
                    self._run_task(work.taken)
                else:
                    self._run_entity(work.entity, work.taken)
        except Exception as error:
            # A signal arrived during the callback, which then used the context, by publishing for example.
            if self._context.is_caused_by_signal(error):
                raise shutdown_exception() from error
            raise

    def _run_entity(self, entity: Entity, taken: Any) -> None:
        outcome: Any = None
        try:
            outcome = entity.run(taken)
        finally:
            if not isinstance(outcome, CoroutineType):
                self._end(entity)
        if isinstance(outcome, CoroutineType):
            self._continue_coroutine(entity, outcome)

    def _continue_coroutine(self, entity: Entity, outcome: CoroutineType[Any, Any, Any]) -> None:
        """Run a callback's coroutine to its first await; it occupies its group until it completes."""
        task: Task[Any] = Task(outcome, executor=self)
        task.when_complete(lambda: self._end(entity))
        self._register_task(task)
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
            ExternalShutdownException: the context was shut down by a signal, or while this waited; not by a
                MultiThreadedExecutor, nor, without a signal, by the one that `rclpy.spin` uses: they return.
            KeyboardInterrupt: Ctrl-C, on the main thread.
            Exception: raised by a callback.
            RuntimeError: another thread is spinning this executor.
        """
        with self._long_spin():
            while self._context.ok() and not self._is_shutdown:
                self.spin_once()
        if self._context.is_interrupted():  # by a signal that arrived while a callback ran
            self._end_at_shutdown(shutdown_exception())

    def spin_on_own_thread(self) -> None:
        """Run callbacks as `spin` does, on a thread that the library has started, whose end nobody would notice.

        The exception of a callback is reported by `threading.excepthook`, and the next callback runs: if the thread
        ended, the program would go on without the transforms, or the timers of a launch, that it waits for.

        Raises:
            RuntimeError: another thread is spinning this executor.
        """
        with self._long_spin():
            while self._context.ok() and not self._is_shutdown:
                try:
                    self.spin_once()
                except ExternalShutdownException:
                    return
                except Exception:  # of a program's callback
                    report_exception()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback and run it, for a response to a client, or for a transform of a TransformListener.

        Return without either after `timeout_sec` [s] (None, negative: no limit).
        """
        if (error := timeout_error("spin_once", timeout_sec)) is not None:
            raise error
        self._spin_once(_end_ns(timeout_sec))

    def spin_until_future_complete(self, future: Future[Any], timeout_sec: float | None = None) -> None:
        """Run callbacks until a future is done, or for `timeout_sec` [s] (None, negative: no limit)."""
        error = future_error(future) or timeout_error("spin_until_future_complete", timeout_sec)
        if error is not None:
            raise error

        def is_over() -> bool:
            return future.done() or future.cancelled()

        end_ns = _end_ns(timeout_sec)
        # Another thread may complete the future, which posts nothing to the queue that this one waits on.
        future.when_complete(self.wake)
        with self._long_spin(end_ns, is_over) as may_spin:
            if may_spin:
                self._spin_until(future, end_ns, is_over)

    def _spin_until(self, future: Future[Any], end_ns: int | None, is_over: Callable[[], bool]) -> None:
        own_spin_once = self._own_spin_once(future)
        while self._context.ok() and not self._is_shutdown and not is_over():
            if own_spin_once is None:
                self._spin_once(end_ns, is_over)
            else:
                own_spin_once(None if end_ns is None else max(0, end_ns - time.monotonic_ns()) / S_TO_NS)
            if end_ns is not None and time.monotonic_ns() >= end_ns:
                return

    def _own_spin_once(self, future: Future[Any]) -> Callable[[float | None], None] | None:
        """Return how the class of a program spins once, for at most some seconds; None if it leaves that to this class.

        Its callbacks may run on its own threads, and may wait there for what this thread receives.
        """
        own_class = type(self)
        if own_class.spin_once_until_future_complete is not Executor.spin_once_until_future_complete:
            return lambda left_s: self.spin_once_until_future_complete(future, left_s)
        if own_class.spin_once is not Executor.spin_once:
            # It doesn't know the future, which may be done without another callback.
            return lambda left_s: self.spin_once(OWN_SPIN_S if left_s is None else min(left_s, OWN_SPIN_S))
        return None

    def spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        """Wait for one callback and run it, or return when a future is done or after `timeout_sec` [s]."""
        if (error := timeout_error("spin_once_until_future_complete", _seconds(timeout_sec))) is not None:
            raise error
        future.when_complete(self.wake)
        self._spin_once(_end_ns(timeout_sec), lambda: future.done() or future.cancelled())

    def _spin_once(self, end_ns: int | None, condition: Callable[[], bool] | None = None) -> None:
        try:
            work = self._wait_for_work(end_ns, condition, until_response=True)
        except (TimeoutException, ShutdownException, ConditionReachedException):
            return
        except ExternalShutdownException as error:
            self._end_at_shutdown(error)
            return
        self._run(work)

    def _end_at_shutdown(self, error: BaseException) -> None:
        """Raise `error`, the end of a spin by the context's shutdown, or return if the spin is to return.

        It returns once: a program that spins again and again without asking `rclpy.ok()` must see its end.
        """
        returns = self._returns_after_signal or (
            self._returns_after_shutdown and not self._context.is_interrupted()
        )
        is_external = isinstance(error, ExternalShutdownException)  # and not KeyboardInterrupt
        if not returns or not is_external or not self._context.is_over() or self._has_returned:
            raise error
        self._has_returned = not self._is_in_long_spin

    def _wait_for_work(
        self,
        end_ns: int | None,
        condition: Callable[[], bool] | None,
        *,
        until_response: bool = False,
        for_nodes: Container[SpunNode] | None = None,
        is_begun: bool = True,
    ) -> Work:
        if not self._begin_spin(end_ns, condition, until_begun=True):
            if condition is not None and condition():
                raise ConditionReachedException
            if self._is_shutdown:
                raise ShutdownException
            raise TimeoutException
        try:
            return self._next(
                end_ns, condition, until_response=until_response, for_nodes=for_nodes, is_begun=is_begun
            )
        finally:
            self._end_spin()

    @contextmanager
    def _long_spin(
        self, end_ns: int | None = None, is_over: Callable[[], bool] | None = None
    ) -> Iterator[bool]:
        """Hold the right to spin for more than one callback; False: another thread held it until the wait was over."""
        if not self._begin_spin(end_ns, is_over):
            yield False
            return
        outer, self._is_in_long_spin = self._is_in_long_spin, True
        try:
            yield True
        finally:
            self._is_in_long_spin = outer
            self._end_spin()

    def _begin_spin(
        self,
        end_ns: int | None = None,
        is_over: Callable[[], bool] | None = None,
        *,
        until_begun: bool = False,
    ) -> bool:
        """Acquire the right to spin; `_end_spin` releases it.

        A callback on another thread than the one that spins waits until it has the right, because that one runs what
        the callback spins for; so does a thread that finds a callback spinning. The arguments end this wait.

        Args:
            end_ns: When it ends at most, by the steady clock; None: no limit.
            is_over: Called at each wake; True ends it.
            until_begun: Whether the next callback that the other thread begins ends it.

        Returns:
            False if the wait ended without the right.

        Raises:
            RuntimeError: another thread is spinning, and neither is in a callback of this executor.
            ExternalShutdownException: the context was shut down meanwhile.
            ForkedProcessError: this process is a fork of the one that created the executor.
        """
        self._context.check_not_from_parent_process("cannot spin")
        # The lock is reentrant, so a callback on the thread that spins may spin again.
        if self._try_to_spin():
            return not until_begun or self._still_waits()
        if not (self._is_spun_by_callback or self._running.is_this_thread()):
            raise RuntimeError("Executor is already spinning, on another thread")
        woken = threading.Event()
        self._followers.append(woken)
        try:
            while not self._try_to_spin():
                if self._is_shutdown or (is_over is not None and is_over()):
                    return False
                if not self._context.ok():
                    raise shutdown_exception()
                if until_begun and self._running.has_begun_another():
                    return False
                now_ns = time.monotonic_ns()
                if end_ns is not None and now_ns >= end_ns:
                    return False
                wake_ns = self._end_of_nested_wait(end_ns, has_end=end_ns is not None)
                woken.wait(None if wake_ns is None else max(0, wake_ns - now_ns) / S_TO_NS)
                woken.clear()
        finally:
            self._followers.remove(woken)
        return not until_begun or self._still_waits()

    def _still_waits(self) -> bool:
        """Return whether a callback that spins must wait; release the right to spin if another thread has begun one.

        What the callback waits for may have come on that thread after its last look, and nothing else may come.
        """
        if not self._running.is_this_thread() or not self._running.has_begun_another():
            return True
        self._end_spin()
        return False

    def _try_to_spin(self) -> bool:
        """Acquire the right to spin, unless another thread has it."""
        if not self._spinning.acquire(blocking=False):
            return False
        self._spin_depth += 1
        if self._spin_depth == 1:
            self._spinner = threading.get_ident()
            self._is_spun_by_callback = self._running.is_this_thread()
        return True

    def _end_spin(self) -> None:
        """Release the right to spin, to a thread that waits for it."""
        self._spin_depth -= 1
        is_over = self._spin_depth == 0
        self._spinning.release()
        if is_over:
            self._wake_followers()

    # Shutdown

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """End every spin, wait for the callbacks that run on other threads, and remove all nodes.

        Returns:
            False if a callback still runs after `timeout_sec` [s] (None: no limit).
        """
        timeout_s = checked_timeout("shutdown", timeout_sec)
        self._is_shutdown = True
        if self._context.is_from_parent_process():
            return True  # its threads, which may hold its locks, are the parent's
        self._context.remove_queue(self._queue)
        # The flag is set, so a thread that spins ends when it wakes. Nodes are removed when no callback runs any more,
        # because a callback may use them to its end.
        self.wake()
        if not self._running.wait(timeout_s):
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


def _end_ns(timeout_sec: float | TimeoutObject | None) -> int | None:
    """Return when a timeout [s] that begins now is over, by the steady clock; None: never."""
    timeout_ns = timeout_sec_to_nsec(_seconds(timeout_sec))
    return None if timeout_ns < 0 else time.monotonic_ns() + timeout_ns


def _seconds(timeout_sec: float | TimeoutObject | None) -> float | None:
    return timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec


def _is_running(entity: Entity) -> bool:
    """Return whether a callback of an entity runs, and keeps its group from running others."""
    group = entity.callback_group
    return isinstance(group, MutuallyExclusiveCallbackGroup) and group.is_running(entity)


def _is_blocked_by_group(entity: Entity) -> bool:
    """Return whether an entity has posted, and waits for a callback of another one in its group to complete."""
    group = entity.callback_group
    if not isinstance(group, MutuallyExclusiveCallbackGroup) or not group.has_parked(entity):
        return False
    # An entity is looked at again after each of its callbacks, and some when they are attached: that alone is
    # not a sign of more to run.
    if entity.posts_when_attached or group.is_running(entity) or group.can_execute(entity):
        return False
    return not entity.is_timed or entity.deadline_ns() is not None
