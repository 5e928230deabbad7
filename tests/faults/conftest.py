"""A graph whose callbacks fail, and a check of what is left of it."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.interfaces.std_srvs.srv import Trigger
from tfloom.node.context.context import Context
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup
from tfloom.node.executing.events_executor import EventsExecutor
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.exceptions import ExternalShutdownException

EXECUTORS: dict[str, Callable[..., Executor]] = {
    "single": SingleThreadedExecutor,
    "multi": MultiThreadedExecutor,
    "events": EventsExecutor,
}
LASTING_THREADS = {"tf2_deadlines"}
"""Names of the threads that a process keeps."""
_LOCKS = (type(threading.Lock()), type(threading.RLock()))


class Injected(Exception):  # noqa: N818
    """What a callback raises."""


class Fails:
    """A callback that raises when it is called for the first time, and then does what `then` does."""

    def __init__(self, then: Callable[..., Any] = lambda *_: None) -> None:
        self.calls: list[tuple[Any, ...]] = []
        self.error = Injected()
        self._then = then

    def __call__(self, *args: Any) -> Any:
        self.calls.append(args)
        if len(self.calls) == 1:
            raise self.error
        return self._then(*args)

    def was_called(self, times: int) -> bool:
        """Return whether it was called so often, at least."""
        return len(self.calls) >= times


class World:
    """A node that a thread spins, again after each exception, with a topic and a service that must go on."""

    def __init__(self, context: Context, executor: Executor) -> None:
        self.context, self.executor = context, executor
        self.node = Node("under_test", context=context)
        self.is_local = os.environ["RMW_IMPLEMENTATION"] == "tfloom_local"
        """Whether the wire is the one inside the process."""
        self.raised: list[Exception] = []
        """What came out of spins."""
        self.reported: list[object] = []
        """What reached the hooks of threads and of destructors."""
        self._watched: list[object] = [context, executor, self.node, self.node.get_clock()]
        self._threads = set(threading.enumerate())
        self._arrived: list[int] = []
        group = MutuallyExclusiveCallbackGroup()
        self._publisher = self.node.create_publisher(Int32, "others", 10)
        self._subscription = self.node.create_subscription(
            Int32, "others", lambda message: self._arrived.append(message.data), 10, callback_group=group
        )
        self._service = self.node.create_service(
            Trigger, "others", lambda _, response: response, callback_group=group
        )
        self._client = self.node.create_client(Trigger, "others", callback_group=group)
        executor.add_node(self.node)
        self._spinner = threading.Thread(target=self._spin, name="spinner")
        self._spinner.start()

    def _spin(self) -> None:
        while self.context.ok() and not self.executor._is_shutdown:
            try:
                self.executor.spin()
            except Injected as error:
                self.raised.append(error)
            except ExternalShutdownException:
                return

    def watch(self, thing: Any) -> Any:
        """Check at the end that no lock of an object is held; return it."""
        self._watched.append(thing)
        return thing

    def connect(self, message_type: type[Any], callback: Callable[..., Any], **options: Any) -> Any:
        """Subscribe to the topic `numbers`; return a publisher that is matched with the subscription."""
        publisher = self.node.create_publisher(message_type, "numbers", 10)
        subscription = self.node.create_subscription(message_type, "numbers", callback, 10, **options)
        wait_until(lambda: publisher.get_subscription_count() and subscription.get_publisher_count())
        return publisher

    def check_others(self) -> None:
        """Check that the work of others goes on."""
        wait_until(
            lambda: self._publisher.get_subscription_count() and self._subscription.get_publisher_count()
        )
        before = len(self._arrived)
        self._publisher.publish(Int32(data=1))
        wait_until(lambda: len(self._arrived) == before + 1, what="a message of others")
        assert self._client.wait_for_service(30)
        future = self._client.call_async(Trigger.Request())
        wait_until(future.done, what="a call of others")
        assert isinstance(future.result(), Trigger.Response)

    def check_locks(self) -> None:
        """Check that no lock of the objects is held, but that of the executor's spin."""
        held: list[str] = []

        def look() -> None:
            for thing in self._watched:
                for name, lock in vars(thing).items():
                    if not isinstance(lock, _LOCKS) or name == "_spinning":
                        continue
                    if lock.acquire(timeout=5.0):
                        lock.release()
                    else:
                        held.append(f"{type(thing).__name__}.{name}")

        looker = threading.Thread(target=look)
        looker.start()
        looker.join()
        assert not held

    def close(self) -> None:
        """End all, and check that nothing is left."""
        assert self.executor.shutdown(timeout_sec=30.0), "a callback still runs"
        self._spinner.join(30.0)
        assert not self._spinner.is_alive()
        self.node.destroy_node()
        self.context.destroy()

        def left() -> set[str]:
            return {thread.name for thread in set(threading.enumerate()) - self._threads} - LASTING_THREADS

        wait_until(lambda: not left(), what="the end of all threads")


@pytest.fixture
def make_world(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., World]]:
    """Return a function that opens a world, of an executor by its name; it is closed at the end of the test."""
    worlds: list[World] = []

    def make(executor: str = "single") -> World:
        context = Context()
        context.init(["program"])
        world = World(context, EXECUTORS[executor](context=context))
        worlds.append(world)
        monkeypatch.setattr(threading, "excepthook", lambda args: world.reported.append(args.exc_value))
        monkeypatch.setattr(sys, "unraisablehook", lambda args: world.reported.append(args.exc_value))
        return world

    yield make
    for world in worlds:
        world.close()


@pytest.fixture(autouse=True)
def _local_wire(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
