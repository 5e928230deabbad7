"""AsyncNode: callbacks on asyncio, without an executor, and what is left at its end."""

from __future__ import annotations

import asyncio
import gc
import random
import sys
import threading
import time
from collections.abc import Awaitable, Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.rcl_interfaces.srv import GetParameters
from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.node.base.base_classes import BaseClient, BaseClock, BaseNode, BaseSubscription, BaseTimer
from tfloom.node.context.context import Context
from tfloom.node.endpoints.content_filter import ContentFilterOptions
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.timer import TimerInfo
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.exceptions import (
    ExternalShutdownException,
    InvalidHandle,
    TimeSourceChangedError,
)
from tfloom.node.values.time import ClockType, Time

if sys.version_info < (3, 11):
    pytest.skip("AsyncNode needs asyncio.TaskGroup", allow_module_level=True)

from tfloom.node.async_node import AsyncClient, AsyncClock, AsyncNode

MakeNode = Callable[..., AsyncNode]


@pytest.fixture
def make(context: Context) -> Iterator[MakeNode]:
    nodes: list[AsyncNode] = []

    def create(name: str = "async", **options: Any) -> AsyncNode:
        nodes.append(AsyncNode(name, **{"context": context, "start_parameter_services": False, **options}))
        return nodes[-1]

    yield create
    for node in nodes:
        node.destroy_node()


def run(main: Callable[[], Awaitable[Any]]) -> Any:
    async def limited() -> Any:
        async with asyncio.timeout(30):
            return await main()

    return asyncio.run(limited())


async def until(condition: Callable[[], object]) -> None:
    while True:
        if condition():
            return
        await asyncio.sleep(0.002)


def add(request: Any, response: Any) -> Any:
    response.sum = request.a + request.b
    return response


async def slow_add(request: Any, response: Any) -> Any:
    await asyncio.sleep(0.01)
    return add(request, response)


def threads() -> set[str]:
    return {thread.name for thread in threading.enumerate()}


@pytest.mark.parametrize("callback", [add, slow_add])
def test_messages_services_and_timers(callback: Callable[..., Any], context_on_each_wire: Context) -> None:
    async def main() -> None:
        node = AsyncNode("async", context=context_on_each_wire)
        got: list[int] = []
        ticks: list[float] = []

        async def on_message(message: Int32) -> None:
            await asyncio.sleep(0)
            got.append(message.data)

        subscription = node.create_subscription(Int32, "numbers", on_message, 10)
        plain: list[Any] = []
        node.create_subscription(Int32, "numbers", lambda message, info: plain.append(info), 10)
        publisher = node.create_publisher(Int32, "numbers", 10)
        node.create_service(AddTwoInts, "add", callback)
        client = node.create_client(AddTwoInts, "add")
        node.create_timer(0.005, lambda: ticks.append(time.monotonic()))
        assert not got
        async with node:
            await client.wait_for_service()
            assert (await client.call(AddTwoInts.Request(a=2, b=3))).sum == 5
            await until(lambda: publisher.get_subscription_count() == 2)
            for number in range(5):
                publisher.publish(Int32(data=number))
            await until(lambda: len(got) == 5 == len(plain) and len(ticks) > 3)
            await node.wait_for_node("/async")
            assert subscription.topic_name == "/numbers"
        assert got == [0, 1, 2, 3, 4]

    run(main)


@pytest.mark.parametrize("concurrent", [False, True])
def test_the_next_message_waits_for_the_callback_unless_they_are_concurrent(
    concurrent: bool, make: MakeNode
) -> None:
    async def main() -> None:
        gate, begun, ended = asyncio.Event(), [], []

        async def on_message(message: Int32) -> None:
            begun.append(message.data)
            await gate.wait()
            ended.append(message.data)

        async with make() as node:
            node.create_subscription(Int32, "a", on_message, 10, concurrent=concurrent)
            publisher = node.create_publisher(Int32, "a", 10)
            other: list[int] = []
            node.create_subscription(Int32, "a", lambda message: other.append(message.data), 10)
            for number in range(3):
                publisher.publish(Int32(data=number))
            await until(lambda: len(other) == 3 and len(begun) == (3 if concurrent else 1))
            await asyncio.sleep(0.02)
            assert begun == ([0, 1, 2] if concurrent else [0])
            gate.set()
            await until(lambda: len(ended) == 3)
            assert begun == [0, 1, 2]

    run(main)


def test_concurrent_requests(make: MakeNode) -> None:
    async def main() -> None:
        waiting = 0
        all_wait = asyncio.Event()

        async def together(request: Any, response: Any) -> Any:
            nonlocal waiting
            waiting += 1
            if waiting == 3:
                all_wait.set()
            await all_wait.wait()
            return add(request, response)

        async with make() as node:
            node.create_service(AddTwoInts, "add", together, concurrent=True)
            client = node.create_client(AddTwoInts, "add")
            sums = await asyncio.gather(*(client.call(AddTwoInts.Request(a=a, b=1)) for a in range(3)))
            assert [response.sum for response in sums] == [1, 2, 3]

    run(main)


def test_arguments_of_a_timers_callback_are_counted(make: MakeNode) -> None:
    async def main() -> None:
        infos: list[Any] = []

        async def on_call(info) -> None:  # type: ignore[no-untyped-def]  # the case
            infos.append(info)

        node = make()
        timer = node.create_timer(0.002, on_call, autostart=False)
        with pytest.raises(
            RuntimeError, match=r"^Timer callback must accept zero arguments or one argument \(TimerInfo\)$"
        ):
            node.create_timer(1.0, lambda a, b: None)
        with pytest.raises(TypeError, match="needs a callback, got 3"):
            node.create_timer(1.0, 3)  # type: ignore[arg-type]
        async with node:
            await asyncio.sleep(0.01)
            assert not infos
            timer.reset()
            await until(lambda: len(infos) > 1)
        assert isinstance(infos[0], TimerInfo)
        assert infos[0].expected_call_time < infos[1].expected_call_time

    run(main)


@pytest.mark.parametrize("is_coroutine", [False, True])
def test_what_a_callback_raises_ends_the_node(is_coroutine: bool, make: MakeNode) -> None:
    node = make()

    def fail(message: Int32) -> None:
        raise ValueError("of the callback")

    async def fail_later(message: Int32) -> None:
        await asyncio.sleep(0)
        fail(message)

    async def main() -> None:
        node.create_subscription(Int32, "a", fail_later if is_coroutine else fail, 10)
        publisher = node.create_publisher(Int32, "a", 10)
        async with node:
            publisher.publish(Int32())
            await asyncio.Event().wait()  # is cancelled

    with pytest.RaisesGroup(pytest.RaisesExc(ValueError, match="of the callback"), flatten_subgroups=True):
        run(main)
    assert "tfloom_async_node" not in threads()
    with pytest.raises(RuntimeError, match=r"^Node has been destroyed and cannot be reentered$"):
        run(node.run)


def test_a_callback_that_raises_cancelled_error_ends_the_node(make: MakeNode) -> None:
    node = make()

    def fail(message: Int32) -> None:
        raise asyncio.CancelledError  # as the result of a cancelled future does

    async def main() -> None:
        node.create_subscription(Int32, "a", fail, 10)
        publisher = node.create_publisher(Int32, "a", 10)
        async with node:
            publisher.publish(Int32())
            await asyncio.Event().wait()

    with pytest.RaisesGroup(pytest.RaisesExc(RuntimeError, match="CancelledError"), flatten_subgroups=True):
        run(main)


def test_a_node_can_be_destroyed_after_its_loop_was_closed(make: MakeNode) -> None:
    node = make()
    loop = asyncio.new_event_loop()

    async def begin() -> asyncio.Task[Any]:
        await node.__aenter__()
        return asyncio.create_task(node.get_clock().sleep(60.0))

    task = loop.run_until_complete(begin())
    loop.run_until_complete(asyncio.sleep(0.01))
    loop.close()
    task._log_destroy_pending = False  # type: ignore[attr-defined]
    node.destroy_node()
    assert "tfloom_async_node" not in threads()
    with pytest.raises(InvalidHandle):
        node.get_name()


def test_what_the_body_raises_leaves_it(make: MakeNode) -> None:
    async def main() -> None:
        async with make():
            raise LookupError("of the body")

    # As an asyncio.TaskGroup has it.
    with pytest.RaisesGroup(pytest.RaisesExc(LookupError, match="of the body"), flatten_subgroups=True):
        run(main)
    assert "tfloom_async_node" not in threads()


def test_second_lives(make: MakeNode) -> None:
    node = make()

    async def main() -> None:
        async with node:
            with pytest.raises(RuntimeError, match=r"^Node is already running$"):
                await node.run()
            assert node.get_name() == "async"
        for again in (node.run, node.__aenter__):
            with pytest.raises(RuntimeError, match=r"^Node has been destroyed and cannot be reentered$"):
                await again()
        creations: dict[str, Callable[[], object]] = {
            "publisher": lambda: node.create_publisher(Int32, "a", 1),
            "subscription": lambda: node.create_subscription(Int32, "a", print, 1),
            "service": lambda: node.create_service(AddTwoInts, "a", add),
            "client": lambda: node.create_client(AddTwoInts, "a"),
            "timer": lambda: node.create_timer(1.0, print),
        }
        for what, create in creations.items():
            with pytest.raises(RuntimeError, match=rf"^Cannot create {what} on a destroyed node$"):
                create()
        with pytest.raises(RuntimeError, match=r"^Cannot sleep on a destroyed clock$"):
            await node.get_clock().sleep(1)
        with pytest.raises(InvalidHandle):
            await node.wait_for_node("/nobody")
        node.destroy_node()  # again

    run(main)


def test_run_lasts_until_the_node_is_destroyed(make: MakeNode) -> None:
    async def main() -> None:
        node = make()
        node.create_timer(0.005, node.destroy_node)  # on the task of the node itself
        await node.run()
        other = make("other")

        async def end() -> None:
            await asyncio.sleep(0.005)
            other.destroy_node()

        other.create_timer(0.005, end)
        await other.run()
        third = make("third")
        task = asyncio.create_task(third.run())
        await asyncio.sleep(0.01)
        third.destroy_node()
        await task
        fourth = make("fourth")
        task = asyncio.create_task(fourth.run())
        await asyncio.sleep(0.01)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        with pytest.raises(InvalidHandle):
            fourth.get_name()

    run(main)
    assert "tfloom_async_node" not in threads()


def test_a_shutdown_ends_the_node(make: MakeNode, context: Context) -> None:
    async def main() -> None:
        node = make()
        node.create_timer(0.005, context.shutdown)
        await node.run()

    with pytest.raises(ExternalShutdownException):
        run(main)


def test_entities_end_by_themselves(make: MakeNode) -> None:
    async def main() -> None:
        node = make()
        entities = [
            node.create_subscription(
                Int32, "a", print, 1, content_filter_options=ContentFilterOptions("data > 1", [])
            ),
            node.create_service(AddTwoInts, "a", add),
            node.create_client(AddTwoInts, "a"),
            node.create_timer(1.0, print),
        ]
        for entity in entities:
            with entity as same:
                assert same is entity
            with pytest.raises(InvalidHandle), entity.handle:
                pass
            entity.destroy()
        others: list[Any] = [
            (node.destroy_subscription, node.create_subscription(Int32, "a", print, 1)),
            (node.destroy_service, node.create_service(AddTwoInts, "a", add)),
            (node.destroy_client, node.create_client(AddTwoInts, "a")),
            (node.destroy_timer, node.create_timer(1.0, print)),
            (node.destroy_publisher, node.create_publisher(Int32, "a", 1)),
        ]
        assert [(destroy(entity), destroy(entity)) for destroy, entity in others] == [(True, False)] * 5

    run(main)


def test_a_call_ends_with_its_client(make: MakeNode) -> None:
    async def main() -> None:
        async with make() as node:
            node.create_service(AddTwoInts, "add", lambda request, response: asyncio.Event().wait())
            client = node.create_client(AddTwoInts, "add")
            call = asyncio.create_task(client.call(AddTwoInts.Request()))
            await asyncio.sleep(0.02)
            client.destroy()
            with pytest.raises(asyncio.CancelledError):
                await call
            with pytest.raises(InvalidHandle):
                await client.call(AddTwoInts.Request())

    run(main)


def test_a_hundred_tasks_that_are_cancelled_leave_nothing(context_on_each_wire: Context) -> None:
    seed = random.randrange(2**32)
    print("seed", seed)
    drawn = random.Random(seed)
    outcomes: list[str] = []

    async def answer(request: Any, response: Any) -> Any:
        await asyncio.sleep(drawn.random() * 0.02)
        return add(request, response)

    async def call(client: AsyncClient[Any, Any], number: int) -> None:
        try:
            response = await client.call(AddTwoInts.Request(a=number, b=1))
        except asyncio.CancelledError:
            outcomes.append("cancelled")
            raise
        assert response.sum == number + 1
        outcomes.append("answered")

    async def main() -> None:
        node = AsyncNode("async", context=context_on_each_wire)
        node.create_service(AddTwoInts, "add", answer, concurrent=True)
        client = node.create_client(AddTwoInts, "add")
        async with node:
            await client.wait_for_service()
            tasks = [asyncio.create_task(call(client, number)) for number in range(100)]
            for task in drawn.sample(tasks, 60):
                await asyncio.sleep(drawn.random() * 0.001)
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
            assert len(outcomes) + sum(task.cancelled() for task in tasks) >= 100
            assert client.entity._pending == {}
            assert client.entity._unsent == []
            assert (await client.call(AddTwoInts.Request(a=1, b=1))).sum == 2
        assert len(asyncio.all_tasks()) == 1

    def leftovers() -> tuple[int, set[str]]:
        gc.collect()
        descriptors = Path("/proc/self/fd")
        return len(list(descriptors.iterdir())) if descriptors.is_dir() else 0, threads()

    first = Node("first", context=context_on_each_wire)  # opens the wire
    before = leftovers()
    run(main)
    wait_until(lambda: leftovers()[1] <= before[1] and leftovers()[0] <= before[0])
    assert "answered" in outcomes
    first.destroy_node()


def test_parameters_and_their_services(make: MakeNode, context: Context) -> None:
    async def main() -> None:
        node = make(start_parameter_services=True)
        node.declare_parameter("speed", 3)
        assert node.set_parameters([Parameter("speed", value=4)])[0].successful
        asking = make("asking")
        client = asking.create_client(GetParameters, "/async/get_parameters")
        async with node, asking:
            await client.wait_for_service()
            response = await client.call(GetParameters.Request(names=["speed"]))
            assert response.values[0].integer_value == 4

    run(main)


def test_sleep_for_what_is_no_time() -> None:
    async def main() -> None:
        clock = AsyncClock()
        for seconds in (float("inf"), float("nan"), float("-inf")):
            with pytest.raises(ValueError, match=f"a finite number of seconds, got {seconds}"):
                await clock.sleep(seconds)
        with pytest.raises(TypeError, match=r"needs a number of seconds, as 0\.5, got 'x'"):
            await clock.sleep("x")  # type: ignore[arg-type]

    run(main)


def test_sleep_by_each_clock(make: MakeNode) -> None:
    async def main() -> None:
        for clock_type in (ClockType.SYSTEM_TIME, ClockType.STEADY_TIME, ClockType.ROS_TIME):
            clock = AsyncClock(clock_type=clock_type)
            begin = time.monotonic()
            await clock.sleep(0.02)
            assert time.monotonic() - begin > 0.019
            await clock.sleep(-1)
            assert clock.now().clock_type is clock_type
        node = make()
        clock = node.get_clock()
        inner = node._node.get_clock()
        inner.set_ros_time_is_active(True)
        task = asyncio.create_task(clock.sleep(10))
        await asyncio.sleep(0.01)
        inner.set_ros_time_override(Time(seconds=9, clock_type=ClockType.ROS_TIME))
        await asyncio.sleep(0.01)
        assert not task.done()
        thread = threading.Thread(
            target=inner.set_ros_time_override, args=(Time(seconds=11, clock_type=ClockType.ROS_TIME),)
        )
        thread.start()
        await task
        thread.join()
        task = asyncio.create_task(clock.sleep(10))
        await asyncio.sleep(0.01)
        inner.set_ros_time_is_active(False)
        with pytest.raises(TimeSourceChangedError):
            await task
        task = asyncio.create_task(clock.sleep(1000))
        await asyncio.sleep(0.01)
        node.destroy_node()
        with pytest.raises(asyncio.CancelledError):
            await task
        assert inner.jump_handles() == []

    run(main)


def test_many_messages_are_all_received(make: MakeNode) -> None:
    """Post while the thread hands over: nothing may be lost between two waits."""

    async def main() -> None:
        count = 0

        async def on_message(message: Int32) -> None:
            nonlocal count
            count += 1

        async with make() as node:
            qos = QoSProfile(depth=5000)
            node.create_subscription(Int32, "a", on_message, qos)
            publisher = node.create_publisher(Int32, "a", qos)

            def publish() -> None:
                for number in range(2000):
                    publisher.publish(Int32(data=number))

            thread = threading.Thread(target=publish)
            thread.start()
            await until(lambda: count == 2000)
            thread.join()

    run(main)


@pytest.mark.parametrize("is_own", [False, True])
def test_a_coroutine_that_has_not_begun_at_the_end_is_closed(is_own: bool, make: MakeNode) -> None:
    """End the node in the callback after the one that returns a coroutine, or in this one itself."""
    calls: list[int] = []
    begun: list[int] = []

    async def main() -> None:
        node = make()

        async def wait(number: int) -> None:
            begun.append(number)
            await asyncio.Event().wait()

        def on_message(message: Int32) -> Any:
            calls.append(message.data)
            if is_own or message.data == 1:
                node.destroy_node()
            return wait(message.data) if is_own or message.data == 0 else None

        node.create_subscription(Int32, "a", on_message, 10, concurrent=True)
        publisher = node.create_publisher(Int32, "a", 10)
        for number in range(2):
            publisher.publish(Int32(data=number))
        await node.run()

    run(main)
    gc.collect()  # a warning of a coroutine that was never awaited would fail the test
    assert calls == ([0] if is_own else [0, 1])
    assert not begun


def test_a_node_whose_thread_cannot_be_started(make: MakeNode, monkeypatch: pytest.MonkeyPatch) -> None:
    async def main() -> None:
        node = make()
        with monkeypatch.context() as patched:

            def refuse(_: object) -> None:
                raise RuntimeError("can't start new thread")

            patched.setattr(threading.Thread, "start", refuse)
            with pytest.raises(
                RuntimeError, match=r"^AsyncNode could not start its thread: can't start new thread$"
            ):
                await node.run()
        ticks: list[int] = []
        node.create_timer(0.001, lambda: ticks.append(1))
        async with node:
            await until(lambda: ticks)

    run(main)


def test_bases_of_both_families(node: Node, make: MakeNode) -> None:
    async_node = make()
    for one, base in ((node, BaseNode), (node.get_clock(), BaseClock)):
        assert isinstance(one, base)
    assert isinstance(async_node, BaseNode)
    assert isinstance(async_node.get_clock(), BaseClock)
    for one in (node, async_node):
        subscription: Any = one.create_subscription(Int32, "a", lambda message: None, 1)
        assert isinstance(subscription, BaseSubscription)
        client: Any = one.create_client(AddTwoInts, "a")
        assert isinstance(client, BaseClient)
        timer: Any = one.create_timer(1.0, lambda: None)
        assert isinstance(timer, BaseTimer)
    assert not isinstance(timer, BaseNode)
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
