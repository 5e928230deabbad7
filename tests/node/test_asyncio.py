"""Futures awaited in asyncio, and executors that spin beside asyncio and inside it."""

from __future__ import annotations

import asyncio
import gc
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import suppress

import pytest

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.node.context.context import Context
from tfloom.node.endpoints.client import Client
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.values.exceptions import ExternalShutdownException

LIMIT_S = 30.0


def add(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
    response.sum = request.a + request.b
    return response


@pytest.fixture
def client(node: Node) -> Client:
    node.create_service(AddTwoInts, "add", add)
    return node.create_client(AddTwoInts, "add")


@pytest.fixture
def spun(context: Context, node: Node) -> Iterator[SingleThreadedExecutor]:
    """Spin the node on a thread."""
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)

    def spin() -> None:
        with suppress(ExternalShutdownException):
            executor.spin()

    thread = threading.Thread(target=spin)
    thread.start()
    yield executor
    executor.shutdown()
    thread.join(LIMIT_S)
    assert not thread.is_alive()


async def result_of(future: Future) -> object:
    return await future


def test_a_response_is_awaited_while_another_thread_spins(
    client: Client, spun: SingleThreadedExecutor
) -> None:
    async def main() -> list[int]:
        first = await client.call_async(AddTwoInts.Request(a=1, b=2))
        others = await asyncio.gather(*(client.call_async(AddTwoInts.Request(a=n, b=n)) for n in range(3)))
        last = await asyncio.wait_for(client.call_async(AddTwoInts.Request(a=first.sum, b=1)), LIMIT_S)
        return [first.sum, *(other.sum for other in others), last.sum]

    assert asyncio.run(main()) == [3, 0, 2, 4, 4]


def test_the_loop_runs_other_coroutines_and_does_not_poll() -> None:
    future: Future[int] = Future()
    turns: list[str] = []

    async def main() -> int:
        loop = asyncio.get_running_loop()
        waiting = asyncio.create_task(result_of(future))
        await asyncio.sleep(0)  # it waits from here on
        passes = 0
        run_once = loop._run_once

        def counted() -> None:
            nonlocal passes
            passes += 1
            run_once()

        loop._run_once = counted
        await asyncio.sleep(0.2)
        turns.append("meanwhile")
        assert passes < 5
        threading.Thread(target=future.set_result, args=(5,)).start()
        return await waiting

    assert asyncio.run(main()) == 5
    assert turns == ["meanwhile"]


def test_a_complete_future_is_awaited_at_once() -> None:
    done: Future[int] = Future()
    done.set_result(3)
    assert asyncio.run(result_of(done)) == 3


def test_an_exception_is_raised_where_the_future_is_awaited(capsys: pytest.CaptureFixture[str]) -> None:
    async def main() -> None:
        early: Future[int] = Future()
        early.set_exception(KeyError("early"))
        with pytest.raises(KeyError, match="early"):
            await early
        late: Future[int] = Future()
        threading.Thread(target=late.set_exception, args=(KeyError("late"),)).start()
        with pytest.raises(KeyError, match="late"):
            await late

    asyncio.run(main())
    gc.collect()
    assert "never retrieved" not in capsys.readouterr().err


def test_cancelling_the_task_cancels_the_request(client: Client) -> None:
    async def main() -> Future:
        future = client.call_async(AddTwoInts.Request())  # nothing spins: no response comes
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(future, 0.01)
        return future

    future = asyncio.run(main())
    assert future.cancelled()
    assert client._pending == {}


def test_a_shielded_future_outlives_the_task_that_awaits_it() -> None:
    future: Future[int] = Future()

    async def main() -> int:
        inner = asyncio.ensure_future(future)
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(asyncio.shield(inner), 0.01)
        assert not future.cancelled()
        future.set_result(6)
        return await inner

    assert asyncio.run(main()) == 6


def test_a_cancelled_future_raises_cancelled_error() -> None:
    early: Future[int] = Future()
    early.cancel()
    late: Future[int] = Future()

    async def main() -> None:
        with pytest.raises(asyncio.CancelledError):
            await early
        threading.Thread(target=late.cancel).start()
        with pytest.raises(asyncio.CancelledError):
            await late

    asyncio.run(main())


def test_a_result_after_the_cancellation_is_not_lost_on_the_loop() -> None:
    future: Future[int] = Future()

    async def main() -> int:
        waiting = asyncio.create_task(result_of(future))
        await asyncio.sleep(0)
        future.cancel()
        future.set_result(7)  # as a server of goals may: the result wins
        return await waiting

    assert asyncio.run(main()) == 7


def test_a_future_that_completes_after_the_loop_was_closed_is_no_error(
    capsys: pytest.CaptureFixture[str],
) -> None:
    future: Future[int] = Future()
    called: list[Future] = []
    loop = asyncio.new_event_loop()
    waiting = loop.create_task(result_of(future))
    waiting._log_destroy_pending = False
    loop.run_until_complete(asyncio.sleep(0))
    loop.close()
    future.add_done_callback(called.append)
    future.set_result(1)
    assert called == [future]
    assert not waiting.done()
    assert capsys.readouterr() == ("", "")


def test_an_executor_task_is_awaited_in_asyncio(spun: SingleThreadedExecutor) -> None:
    gate: Future[int] = Future()

    async def in_executor() -> tuple[int, str]:
        return await gate, threading.current_thread().name

    async def main() -> tuple[int, str]:
        task = spun.create_task(in_executor)
        gate.set_result(4)
        return await task

    value, thread = asyncio.run(main())
    assert value == 4
    assert thread != threading.current_thread().name


@pytest.mark.parametrize("kind", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_coroutines_of_an_executor_that_spins_inside_asyncio(
    kind: type[SingleThreadedExecutor], context: Context, node: Node, client: Client
) -> None:
    """Both kinds of coroutine await the same future: each is run on by what runs it."""
    gate: Future[int] = Future()

    async def in_executor() -> int:
        response = await client.call_async(AddTwoInts.Request(a=await gate, b=1))
        return response.sum

    async def main(executor: SingleThreadedExecutor) -> tuple[int, int]:
        here = asyncio.create_task(result_of(gate))
        task = executor.create_task(in_executor)
        while not task.done():
            executor.spin_once(timeout_sec=0.01)
            await asyncio.sleep(0)
            if not gate.done():
                gate.set_result(20)
        return await here, await task

    with kind(context=context) as executor:
        executor.add_node(node)
        assert asyncio.run(asyncio.wait_for(main(executor), LIMIT_S)) == (20, 21)


def test_asyncio_inside_a_callback(
    context: Context, node: Node, client: Client, spun: SingleThreadedExecutor
) -> None:
    """A callback on another executor's thread runs its own loop, in a function and in a coroutine."""

    async def ask(number: int) -> int:
        return (await client.call_async(AddTwoInts.Request(a=number, b=1))).sum

    def function() -> int:
        return asyncio.run(ask(1))

    async def coroutine() -> int:
        before = await client.call_async(AddTwoInts.Request(a=1, b=1))
        inside = asyncio.run(ask(before.sum))
        return inside + (await client.call_async(AddTwoInts.Request(a=0, b=1))).sum

    with SingleThreadedExecutor(context=context) as other:
        for handler, expected in ((function, 2), (coroutine, 4)):
            task = other.create_task(handler)
            other.spin_until_future_complete(task, LIMIT_S)
            assert task.result() == expected


def test_a_callback_of_the_loop_may_spin(context: Context, node: Node, client: Client) -> None:
    """Inside `call_soon` and `add_reader` no task of asyncio runs: what is awaited there is the executor's."""

    async def in_executor() -> int:
        return (await client.call_async(AddTwoInts.Request(a=1, b=1))).sum

    async def main(executor: SingleThreadedExecutor) -> int:
        loop = asyncio.get_running_loop()
        task = executor.create_task(in_executor)

        def spin() -> None:
            executor.spin_once(timeout_sec=0)
            if not task.done():
                loop.call_later(0.001, spin)

        loop.call_soon(spin)
        return await task

    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        assert asyncio.run(asyncio.wait_for(main(executor), LIMIT_S)) == 2


def test_spin_until_future_complete_inside_asyncio(context: Context, node: Node, client: Client) -> None:
    async def main(executor: SingleThreadedExecutor) -> int:
        future = client.call_async(AddTwoInts.Request(a=2, b=2))
        executor.spin_until_future_complete(future, LIMIT_S)
        return (await future).sum

    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        assert asyncio.run(main(executor)) == 4


def test_by_hand_a_coroutine_yields_the_future() -> None:
    """Executors of programs' own drive coroutines by `send`."""
    future: Future[int] = Future()
    coroutine = result_of(future)
    assert coroutine.send(None) is future
    future.set_result(2)
    with pytest.raises(StopIteration) as end:
        coroutine.send(None)
    assert end.value.value == 2


def test_asyncio_is_not_loaded_by_futures() -> None:
    code = (
        "import sys; from tfloom.node.executing.task import Future, Task; f = Future()\n"
        "async def main(): return await f\n"
        "task = Task(main); task(); f.set_result(1); task(); assert task.result() == 1\n"
        "sys.exit('asyncio' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
