"""Nodes for programs on asyncio: their callbacks are functions or coroutines on the loop's thread, without an executor.

How it works: an `AsyncNode` has a node inside, whose entities post to a queue as those of every node. Asyncio can't
wait for that queue, so while the node runs, a thread does, and then lets the loop run what is ready. It waits again
when the loop has. Callbacks run on the loop's thread alone, and a message stays in its reader until the callback before
it has ended.
"""

from __future__ import annotations

import asyncio
import math
import sys
import threading
from abc import ABC, abstractmethod
from collections.abc import Awaitable, Callable, Coroutine, Iterable, Sequence
from contextlib import suppress
from inspect import isawaitable
from types import CoroutineType
from typing import TYPE_CHECKING, Any, Generic

from tfloom.common.seconds import not_a_number, to_nanoseconds
from tfloom.node.base.base_classes import (
    BaseClient,
    BaseClock,
    BaseNode,
    BaseService,
    BaseSubscription,
    BaseTimer,
)
from tfloom.node.clock.clock import Clock
from tfloom.node.clock.time_jump import ANY_JUMP, SOURCE_CHANGES, TimeJump
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.endpoints.subscription import callback_error, takes_count
from tfloom.node.executing.callback_groups import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.task import Future
from tfloom.node.executing.timer import TimerInfo
from tfloom.node.executing.work_queue import MAX_BATCH_SIZE
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile, qos_profile_services_default
from tfloom.node.values.duration import S_TO_NS
from tfloom.node.values.exceptions import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeSourceChangedError,
)
from tfloom.node.values.time import ClockType, Time
from tfloom.node.values.type_support import MsgType, SrvTypeRequest, SrvTypeResponse
from tfloom.node.values.wrong_arguments import not_callable
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom.node.endpoints.client import Client
    from tfloom.node.endpoints.content_filter import ContentFilterOptions
    from tfloom.node.endpoints.service import Service
    from tfloom.node.endpoints.subscription import Subscription
    from tfloom.node.executing.timer import Timer
    from tfloom.rosidl.service import Service as ServiceType

__all__ = [
    "AsyncClient",
    "AsyncClock",
    "AsyncNode",
    "AsyncPublisher",
    "AsyncService",
    "AsyncSubscription",
    "AsyncTimer",
]

if not TYPE_CHECKING and sys.version_info < (3, 11):
    raise ImportError("AsyncNode needs Python 3.11 or later, which has asyncio.TaskGroup")

MAX_SLICE_S = 1.0
"""The longest single wait of a sleep by system time [s], because the system's clock may be set during it."""


class _LoopExecutor(Executor):
    """Runs what is ready, and no more, when it is told to."""

    def run_ready(self) -> None:
        """Run what is ready now, each callback to its first await.

        Raises:
            ExternalShutdownException, KeyboardInterrupt: the context was shut down.
            Exception: raised by a callback.
        """
        for _ in range(MAX_BATCH_SIZE):
            try:
                work = self._wait_for_work(0, None, until_response=True)
            except ConditionReachedException:  # a response was taken
                continue
            except (TimeoutException, ShutdownException):
                return
            self._run(work)
        self.wake()  # there may be more

    def wait_ns(self) -> int:
        """Return how long to wait for posts until a timer is due [ns]; negative: without limit."""
        return self._wait_ns(None)

    def wait_for_posts(self, timeout_ns: int) -> None:
        """Wait until something is posted, which stays there; called on another thread than the one that runs it."""
        for token in self._queue.wait(timeout_ns):
            self._queue.post(token)


class _Waker:
    """The thread that waits for the posts to an executor's queue, and then wakes a loop.

    Args:
        executor: The executor.
        loop: The loop.
    """

    def __init__(self, executor: _LoopExecutor, loop: asyncio.AbstractEventLoop) -> None:
        self._executor = executor
        self._loop = loop
        self._event = asyncio.Event()
        self._turn = threading.Event()
        """Set when the loop has run what was ready, or at the end."""
        self._timeout_ns = 0
        """How long to wait next. Written by the loop before it sets `_turn`."""
        self._is_closed = False
        self._thread = threading.Thread(target=self._run, name="tfloom_async_node", daemon=True)

    def start(self) -> None:
        """Start the thread.

        Raises:
            RuntimeError: the system allows no other thread.
        """
        self._thread.start()

    def _run(self) -> None:
        while not self._is_closed:
            self._executor.wait_for_posts(self._timeout_ns)
            try:
                self._loop.call_soon_threadsafe(self._event.set)
            except RuntimeError:  # the loop was closed without an end of the node
                return
            self._turn.wait()
            self._turn.clear()

    async def wait(self) -> None:
        """Wait until something is posted, or a timer is due."""
        await self._event.wait()
        self._event.clear()

    def go_on(self) -> None:
        """Wait for more, because what was posted has been run."""
        self._timeout_ns = self._executor.wait_ns()
        self._turn.set()

    def close(self) -> None:
        """End the thread."""
        self._is_closed = True
        self._turn.set()
        self._executor.wake()
        if self._thread.ident is not None:
            self._thread.join()


class _AsyncEntity(ABC):
    """Something that a node has created: all that is not here is that of the same thing of a Node."""

    def __init__(self, entity: Any) -> None:
        self.entity = entity

    def __getattr__(self, name: str) -> Any:
        return getattr(self.__dict__["entity"], name)

    def __repr__(self) -> str:
        return ros_repr(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.destroy()

    @abstractmethod
    def destroy(self) -> None:
        """Leave the node. Destroying again does nothing."""


class AsyncPublisher(Publisher[MsgType]):
    """Publishes messages of one type on one topic; `AsyncNode.create_publisher` creates one."""


class AsyncSubscription(_AsyncEntity, BaseSubscription, Generic[MsgType]):
    """Calls its callback with each message of one topic; `AsyncNode.create_subscription` creates one."""

    entity: Subscription[MsgType]

    def destroy(self) -> None:
        """Leave the topic. Destroying again does nothing."""
        self.entity.owner.destroy_subscription(self.entity)


class AsyncService(_AsyncEntity, BaseService, Generic[SrvTypeRequest, SrvTypeResponse]):
    """Replies to requests with the responses of its callback; `AsyncNode.create_service` creates one."""

    entity: Service[SrvTypeRequest, SrvTypeResponse]

    def destroy(self) -> None:
        """Leave the service. Destroying again does nothing."""
        self.entity.owner.destroy_service(self.entity)


class AsyncTimer(_AsyncEntity, BaseTimer):
    """Calls its callback periodically; `AsyncNode.create_timer` creates one."""

    entity: Timer

    def destroy(self) -> None:
        """Stop calling the callback. Destroying again does nothing."""
        self.entity.owner.destroy_timer(self.entity)


class AsyncClient(_AsyncEntity, BaseClient, Generic[SrvTypeRequest, SrvTypeResponse]):
    """Calls a service; `AsyncNode.create_client` creates one."""

    entity: Client[SrvTypeRequest, SrvTypeResponse]

    async def call(self, request: SrvTypeRequest) -> SrvTypeResponse:
        """Send a request and return the response, while the node runs.

        Cancelling the task that awaits it withdraws the request; `asyncio.timeout` limits the wait.

        Raises:
            NoResponseError: no server came within a second, or all that received the request have left.
            CancelledError: the client, or its node, was destroyed meanwhile.
            TypeError: `request` isn't of the service's request type.
            InvalidHandle: the client was destroyed before.
        """
        return await self.entity.call_async(request)

    async def wait_for_service(self, check_interval: float = 0.1) -> None:
        """Wait until a server is there; look each `check_interval` [s].

        Raises:
            InvalidHandle: the client was destroyed.
        """
        while True:
            if self.entity.service_is_ready():
                return
            await asyncio.sleep(check_interval)

    def destroy(self) -> None:
        """Leave the service, and cancel what awaits a response. Destroying again does nothing."""
        self.entity.owner.destroy_client(self.entity)


class AsyncClock(BaseClock):
    """A clock, by which a coroutine can sleep.

    Args:
        clock_type: Its kind; `AsyncNode.get_clock` returns the node's, which shows simulated time where that is on.
    """

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        self._clock = Clock(clock_type=clock_type)
        self._sleepers: set[asyncio.Task[Any]] = set()
        """The tasks that sleep. Used on the loop's thread alone."""
        self._is_destroyed = False

    def follow(self, clock: Clock) -> Self:
        """Show the time of another clock from now on, and return this one."""
        self._clock = clock
        return self

    def __getattr__(self, name: str) -> Any:
        return getattr(self.__dict__["_clock"], name)

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def clock_type(self) -> ClockType:
        """The kind of clock."""
        return self._clock.clock_type

    def now(self) -> Time:
        """Return the current time of this clock."""
        return self._clock.now()

    async def sleep(self, seconds: float) -> None:
        """Wait for a duration by this clock [s].

        Raises:
            TimeSourceChangedError: simulated time was switched on or off meanwhile.
            CancelledError: the clock, or its node, was destroyed meanwhile.
            RuntimeError: it was destroyed before.
            TypeError: `seconds` is not a number.
            ValueError: it is not finite.
        """
        if not isinstance(seconds, (int, float)):
            raise TypeError(f"sleep() {not_a_number('a number of seconds', seconds)}")
        if not math.isfinite(seconds):
            raise ValueError(f"sleep() needs a finite number of seconds, got {seconds}")
        if self._is_destroyed:
            raise RuntimeError("Cannot sleep on a destroyed clock")
        loop, task = asyncio.get_running_loop(), asyncio.current_task()
        woken = asyncio.Event()
        is_changed = False

        def on_jump(jump: TimeJump) -> None:  # on the thread that sets the clock
            nonlocal is_changed
            is_changed = is_changed or jump.clock_change in SOURCE_CHANGES
            with suppress(RuntimeError):  # the loop was closed
                loop.call_soon_threadsafe(woken.set)

        if task is not None:
            self._sleepers.add(task)
        try:
            with self._clock.create_jump_callback(ANY_JUMP, post_callback=on_jump):
                end_ns = self._clock.now_ns() + to_nanoseconds(seconds)
                while not is_changed and (left_ns := end_ns - self._clock.now_ns()) > 0:
                    await self._wait(woken, left_ns)
        finally:
            if task is not None:
                self._sleepers.discard(task)
        if is_changed:
            raise TimeSourceChangedError

    async def _wait(self, woken: asyncio.Event, left_ns: int) -> None:
        """Wait for a jump, or until it is time to look at the clock again."""
        timer = None
        if not getattr(self._clock, "ros_time_is_active", False):
            delay_s = min(left_ns / S_TO_NS, MAX_SLICE_S)
            timer = asyncio.get_running_loop().call_later(delay_s, woken.set)
        try:
            await woken.wait()
        finally:
            woken.clear()
            if timer is not None:
                timer.cancel()

    def destroy(self) -> None:
        """Cancel the tasks that sleep. Destroying again does nothing."""
        self._is_destroyed = True
        _cancel(list(self._sleepers))


class AsyncNode(BaseNode):
    """A node on asyncio: `async with` it, or `await` its `run()`; until then, none of its callbacks is called.

    Callbacks are functions or coroutine functions. What one raises ends the node: it leaves `async with`, or `run`, as
    the exception of an `asyncio.TaskGroup`. Methods are called on the thread of the loop. All names of `Node` that are
    not here are those of the node inside.

    Args:
        node_name: Its name.
        kwargs: As for `Node`, with the same errors.
    """

    def __init__(self, node_name: str, **kwargs: Any) -> None:
        self._node = Node(node_name, **kwargs)
        self._clock = AsyncClock(clock_type=ClockType.ROS_TIME).follow(self._node.get_clock())
        self._executor: _LoopExecutor | None = None
        """There while the node runs, as all below."""
        self._waker: _Waker | None = None
        self._group: Any = None  # an asyncio.TaskGroup, which Python 3.10 lacks
        self._ended: asyncio.Event | None = None
        self._tasks: set[asyncio.Task[Any]] = set()
        """Those of the node in the group: callbacks, and the one that runs the executor."""
        self._is_destroyed = False

    def __getattr__(self, name: str) -> Any:
        return getattr(self.__dict__["_node"], name)

    def __repr__(self) -> str:
        return ros_repr(self)

    # Running

    async def __aenter__(self) -> Self:
        if self._is_destroyed:
            raise RuntimeError("Node has been destroyed and cannot be reentered")
        if self._group is not None:
            raise RuntimeError("Node is already running")
        executor = _LoopExecutor(context=self._node.context)
        waker = _Waker(executor, asyncio.get_running_loop())
        executor.add_node(self._node)
        try:
            waker.start()
        except RuntimeError as error:
            executor.shutdown()
            raise RuntimeError(f"AsyncNode could not start its thread: {error}") from error
        self._executor, self._waker, self._ended = executor, waker, asyncio.Event()
        self._group = asyncio.TaskGroup()  # type: ignore[attr-defined]  # of Python 3.11
        await self._group.__aenter__()
        self._start(self._run_executor(executor, waker))
        return self

    async def __aexit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        group, self._group = self._group, None
        self.destroy_node()
        if group is None:
            return
        try:
            await group.__aexit__(t, v, tb)
        except Exception as error:
            # That of a shutdown is raised as by `spin`, where nothing else went wrong.
            inner: Sequence[Exception] = getattr(error, "exceptions", ())
            if inner and all(isinstance(one, ExternalShutdownException) for one in inner):
                raise inner[0] from None
            raise

    async def run(self) -> None:
        """Run the node until `destroy_node` is called.

        Raises:
            RuntimeError: it is running, or was destroyed.
            ExternalShutdownException: its context was shut down.
            ExceptionGroup: a callback raised.
        """
        async with self:
            if self._ended is not None:
                await self._ended.wait()

    async def _run_executor(self, executor: _LoopExecutor, waker: _Waker) -> None:
        while not self._is_destroyed:
            await waker.wait()
            try:
                executor.run_ready()
            except asyncio.CancelledError as error:
                # Of a callback, because nothing is awaited there. The group would take it for this task's end.
                raise RuntimeError(
                    "a callback raised CancelledError, though nobody has cancelled it"
                ) from error
            waker.go_on()

    def _start(self, coroutine: Coroutine[Any, Any, Any]) -> asyncio.Task[Any]:
        if self._group is None:  # the node has ended in a callback of this pass
            coroutine.close()
            raise RuntimeError("the node does not run")
        task: asyncio.Task[Any] = self._group.create_task(coroutine)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        if self._is_destroyed:  # by the callback that has returned this
            task.cancel()
        return task

    def destroy_node(self) -> None:
        """End the node, and cancel its callbacks that wait. Destroying again does nothing."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        self._clock.destroy()
        # The task that calls this ends by itself, as a callback of the node may.
        current = asyncio.current_task() if _is_in_loop() else None
        _cancel([task for task in self._tasks if task is not current])
        waker, self._waker = self._waker, None
        if waker is not None:
            waker.close()
        executor, self._executor = self._executor, None
        if executor is not None:
            executor.shutdown(0)
        self._node.destroy_node()
        if self._ended is not None:
            with suppress(RuntimeError):  # the loop was closed
                self._ended.set()

    # Callbacks

    def _completed(self, outcome: Any) -> Any:
        """Return what a callback has returned; a coroutine for the executor where that is to be awaited in asyncio."""
        # A coroutine itself is the task, because Python warns of one that another has not come to await.
        if isinstance(outcome, CoroutineType):
            return self._finish(self._start(outcome))
        return self._finish(self._start(_as_coroutine(outcome))) if isawaitable(outcome) else outcome

    @staticmethod
    async def _finish(task: asyncio.Task[Any]) -> Any:
        """Wait, in the executor, for a task of asyncio: until then, the group of the callback is occupied."""
        done: Future[None] = Future()
        task.add_done_callback(lambda _: done.set_result(None))
        await done
        # The exception of the task ends its group, and with it the node.
        return None if task.cancelled() or task.exception() is not None else task.result()

    def _check_exists(self, what: str) -> None:
        if self._is_destroyed:
            raise RuntimeError(f"Cannot create {what} on a destroyed node")

    # Creating

    def get_clock(self) -> AsyncClock:
        """Return its clock: ROS time."""
        return self._clock

    def create_publisher(
        self, msg_type: type[MsgType], topic: str, qos_profile: QoSProfile | int, **kwargs: Any
    ) -> AsyncPublisher[MsgType]:
        """Create a publisher; arguments and errors are those of `Node.create_publisher`.

        Raises:
            RuntimeError: the node was destroyed.
        """
        self._check_exists("publisher")
        publisher: Any = self._node.create_publisher(
            msg_type, topic, qos_profile, **{"publisher_class": AsyncPublisher, **kwargs}
        )
        created: AsyncPublisher[MsgType] = publisher
        return created

    def create_subscription(
        self,
        msg_type: type[MsgType],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        raw: bool = False,
        concurrent: bool = False,
        content_filter_options: ContentFilterOptions | None = None,
        **kwargs: Any,
    ) -> AsyncSubscription[MsgType]:
        """Create a subscription; arguments and errors are those of `Node.create_subscription`, but for these.

        Args:
            msg_type: Class of the messages.
            topic: Name of the topic.
            callback: A function or a coroutine function, called with a message, or a message and its info.
            qos_profile: QoS that it requests.
            raw: Whether the callback takes bytes rather than messages.
            concurrent: Whether the callback is called for the next message while it awaits something.
            content_filter_options: Which messages are received; None: all.
            kwargs: Further arguments of `Node.create_subscription`.

        Raises:
            RuntimeError: the node was destroyed.
        """
        self._check_exists("subscription")
        if (error := callback_error(callback)) is not None:
            raise error

        def on_message(message: Any) -> Any:
            return self._completed(callback(message))

        def on_message_with_info(message: Any, info: Any) -> Any:
            return self._completed(callback(message, info))

        subscription = self._node.create_subscription(
            msg_type,
            topic,
            on_message if takes_count(callback, 1) else on_message_with_info,
            qos_profile,
            raw=raw,
            callback_group=_group_of(concurrent),
            content_filter_options=content_filter_options,
            **kwargs,
        )
        return AsyncSubscription(subscription)

    def create_service(
        self,
        srv_type: type[ServiceType[SrvTypeRequest, SrvTypeResponse]],
        srv_name: str,
        callback: Callable[[SrvTypeRequest, SrvTypeResponse], SrvTypeResponse | Awaitable[SrvTypeResponse]],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        concurrent: bool = False,
    ) -> AsyncService[SrvTypeRequest, SrvTypeResponse]:
        """Create a service; arguments and errors are those of `Node.create_service`, but for these.

        Args:
            srv_type: Class of the service.
            srv_name: Its name.
            callback: A function or a coroutine function, called with a request and an empty response; returns the
                response.
            qos_profile: QoS of requests and responses.
            concurrent: Whether the callback is called for the next request while it awaits something.

        Raises:
            RuntimeError: the node was destroyed.
        """
        self._check_exists("service")
        if not callable(callback):
            raise TypeError(f"create_service() needs a callback, {not_callable(callback)}")
        service = self._node.create_service(
            srv_type,
            srv_name,
            lambda request, response: self._completed(callback(request, response)),
            qos_profile=qos_profile,
            callback_group=_group_of(concurrent),
        )
        return AsyncService(service)

    def create_client(
        self,
        srv_type: type[ServiceType[SrvTypeRequest, SrvTypeResponse]],
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
    ) -> AsyncClient[SrvTypeRequest, SrvTypeResponse]:
        """Create a client of a service; arguments and errors are those of `Node.create_client`.

        Raises:
            RuntimeError: the node was destroyed.
        """
        self._check_exists("client")
        return AsyncClient(self._node.create_client(srv_type, srv_name, qos_profile=qos_profile))

    def create_timer(
        self, timer_period_sec: float, callback: Callable[..., Any], autostart: bool = True
    ) -> AsyncTimer:
        """Create a timer; arguments and errors are those of `Node.create_timer`, but for these.

        Args:
            timer_period_sec: The period [s].
            callback: A function or a coroutine function, called without arguments, or with a TimerInfo.
            autostart: Whether it is started at once; otherwise by its first `reset`.

        Raises:
            RuntimeError: the node was destroyed, or `callback` takes neither zero arguments nor one.
        """
        self._check_exists("timer")
        if not callable(callback):
            raise TypeError(f"create_timer() needs a callback, {not_callable(callback)}")

        def on_call() -> Any:
            return self._completed(callback())

        def on_call_with_info(info: TimerInfo) -> Any:
            return self._completed(callback(info))

        if takes_count(callback, 0):
            own_callback: Callable[..., Any] = on_call
        elif takes_count(callback, 1):
            own_callback = on_call_with_info
        else:
            raise RuntimeError("Timer callback must accept zero arguments or one argument (TimerInfo)")
        timer = self._node.create_timer(
            timer_period_sec, own_callback, MutuallyExclusiveCallbackGroup(), autostart=autostart
        )
        return AsyncTimer(timer)

    async def wait_for_node(self, fully_qualified_node_name: str, check_interval: float = 0.1) -> None:
        """Wait until a node is on the graph; look each `check_interval` [s].

        Raises:
            InvalidHandle: this node was destroyed.
        """
        while True:
            self._node.get_name()  # raises after the end, after which no node is found
            if self._node.wait_for_node(fully_qualified_node_name, 0):
                return
            await asyncio.sleep(check_interval)

    # Destroying

    def destroy_publisher(self, publisher: AsyncPublisher[Any]) -> bool:
        """Destroy a publisher; False if it isn't this node's."""
        return self._node.destroy_publisher(publisher)

    def destroy_subscription(self, subscription: AsyncSubscription[Any]) -> bool:
        """Destroy a subscription; False if it isn't this node's."""
        return self._node.destroy_subscription(subscription.entity)

    def destroy_service(self, service: AsyncService[Any, Any]) -> bool:
        """Destroy a service; False if it isn't this node's."""
        return self._node.destroy_service(service.entity)

    def destroy_client(self, client: AsyncClient[Any, Any]) -> bool:
        """Destroy a client, and cancel what awaits a response; False if it isn't this node's."""
        return self._node.destroy_client(client.entity)

    def destroy_timer(self, timer: AsyncTimer) -> bool:
        """Destroy a timer; False if it isn't this node's."""
        return self._node.destroy_timer(timer.entity)


def _group_of(concurrent: bool) -> CallbackGroup:
    return ReentrantCallbackGroup() if concurrent else MutuallyExclusiveCallbackGroup()


def _cancel(tasks: Iterable[asyncio.Task[Any]]) -> None:
    for task in tasks:
        with suppress(RuntimeError):  # its loop was closed
            task.cancel()


async def _as_coroutine(awaitable: Awaitable[Any]) -> Any:
    return await awaitable


def _is_in_loop() -> bool:
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return False
    return True
