"""Services and clients."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import pytest

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.service_msgs.msg import ServiceEventInfo
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.node.action.client import ActionClient
from tfloom.node.context.context import Context
from tfloom.node.endpoints import client as client_module
from tfloom.node.endpoints.client import Client, NoResponseError
from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
from tfloom.node.executing.callback_groups import ReentrantCallbackGroup
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.exceptions import InvalidHandle

MakeNode = Callable[..., Node]
SpinUntil = Callable[..., None]


def add(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
    response.sum = request.a + request.b
    return response


@pytest.fixture
def client(node: Node, executor: SingleThreadedExecutor) -> Client:
    executor.add_node(node)
    node.create_service(AddTwoInts, "add", add)
    client = node.create_client(AddTwoInts, "add")
    assert client.wait_for_service(timeout_sec=5)
    return client


def test_request_receives_its_response(client: Client, executor: SingleThreadedExecutor) -> None:
    future = client.call_async(AddTwoInts.Request(a=2, b=3))
    executor.spin_until_future_complete(future, timeout_sec=5)
    assert future.result().sum == 5
    assert client.service_name == "/add"


@pytest.mark.parametrize("kind", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_spin_once_returns_after_a_response(
    kind: type[Executor], make_node: MakeNode, executor: SingleThreadedExecutor, context: Context
) -> None:
    """Programs check between two calls of it whether their future is done."""
    server, node = make_node("server"), make_node("asker")
    server.create_service(AddTwoInts, "add", add)
    client = node.create_client(AddTwoInts, "add")
    assert client.wait_for_service(timeout_sec=5)
    future = client.call_async(AddTwoInts.Request(a=2, b=3))
    executor.add_node(server)
    with kind(context=context) as asking:
        asking.add_node(node)
        returned = threading.Event()

        def spin() -> None:
            while not future.done():
                asking.spin_once()
            returned.set()

        thread = threading.Thread(target=spin)
        thread.start()
        executor.spin_once(timeout_sec=5)
        assert returned.wait(30)
        assert future.result().sum == 5
        thread.join()


def test_each_of_many_clients_receives_its_responses(
    make_node: MakeNode, executor: SingleThreadedExecutor
) -> None:
    server = make_node("server")
    server.create_service(AddTwoInts, "add", add)
    executor.add_node(server)
    clients: list[Client] = []
    for index in range(20):
        node = make_node(f"client_{index}")
        executor.add_node(node)
        clients.append(node.create_client(AddTwoInts, "add"))
        assert clients[-1].wait_for_service(timeout_sec=5)
    for number in range(10):
        futures = [
            client.call_async(AddTwoInts.Request(a=1000 * index, b=number))
            for index, client in enumerate(clients)
        ]
        for index, future in enumerate(futures):
            executor.spin_until_future_complete(future, timeout_sec=5)
            assert future.result().sum == 1000 * index + number


def test_coroutine_can_await_a_call(client: Client, node: Node, executor: SingleThreadedExecutor) -> None:
    async def twice(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        inner = await client.call_async(request)
        response.sum = 2 * inner.sum
        return response

    node.create_service(AddTwoInts, "twice", twice, callback_group=ReentrantCallbackGroup())
    future = node.create_client(AddTwoInts, "twice").call_async(AddTwoInts.Request(a=2, b=3))
    executor.spin_until_future_complete(future, timeout_sec=5)
    assert future.result().sum == 10


def test_call_waits_while_another_thread_spins(client: Client, context: Context) -> None:
    executor: Executor = client._executor()
    end: Future[None] = Future()
    thread = threading.Thread(target=lambda: executor.spin_until_future_complete(end, timeout_sec=20))
    thread.start()
    try:
        assert client.call(AddTwoInts.Request(a=1, b=1), timeout_sec=5).sum == 2
    finally:
        end.set_result(None)
        thread.join(10)


def test_call_in_a_callback_of_a_single_threaded_executor_raises(
    client: Client, node: Node, executor: SingleThreadedExecutor
) -> None:
    node.create_timer(0.0, lambda: client.call(AddTwoInts.Request()))
    with pytest.raises(RuntimeError, match="would never end"):
        executor.spin()


class Served(NamedTuple):
    """A service of a node that a separate thread spins."""

    client: Client
    """A client of a node that no executor spins."""
    asked: list[AddTwoInts.Request]
    go_on: threading.Event
    """Lets the response to a request with a negative number depart."""


@pytest.fixture
def served(context_on_each_wire: Context) -> Iterator[Served]:
    server, caller = (Node(name, context=context_on_each_wire) for name in ("server", "caller"))
    client = caller.create_client(AddTwoInts, "add")
    served = Served(client, [], threading.Event())

    def add_in_time(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        served.asked.append(request)
        if request.a < 0:
            served.go_on.wait(30)
        return add(request, response)

    server.create_service(AddTwoInts, "add", add_in_time, callback_group=ReentrantCallbackGroup())
    end: Future[None] = Future()
    with MultiThreadedExecutor(4, context=context_on_each_wire) as executor:
        executor.add_node(server)
        thread = threading.Thread(target=lambda: executor.spin_until_future_complete(end, timeout_sec=60))
        thread.start()
        assert client.wait_for_service(timeout_sec=10)
        yield served
        served.go_on.set()
        end.set_result(None)
        thread.join(10)
    caller.destroy_node()
    server.destroy_node()


def test_call_receives_its_response_although_nobody_spins(served: Served) -> None:
    for number in range(20):
        assert served.client.call(AddTwoInts.Request(a=1, b=number), timeout_sec=10).sum == 1 + number
    assert not served.client._pending


def test_one_call_receives_the_responses_of_others(served: Served, wait_until: Callable[..., None]) -> None:
    sums: list[int] = []

    def call(a: int) -> None:
        sums.append(served.client.call(AddTwoInts.Request(a=a), timeout_sec=20).sum)

    asynchronous = served.client.call_async(AddTwoInts.Request(a=-1))
    first = threading.Thread(target=call, args=[-2])
    first.start()
    wait_until(lambda: len(served.asked) == 2)
    second = threading.Thread(target=call, args=[3])
    second.start()  # its response wakes the first thread
    second.join(10)
    assert sums == [3]
    assert not asynchronous.done()
    served.go_on.set()
    first.join(10)
    assert sums == [3, -2]
    # Nobody spins, so calls alone receive the response to the asynchronous request.
    wait_until(lambda: served.client.call(AddTwoInts.Request(), timeout_sec=10) and asynchronous.done())
    assert asynchronous.result().sum == -1


def test_the_next_call_takes_over_when_the_first_has_ended(
    served: Served, wait_until: Callable[..., None]
) -> None:
    assert served.client.call(AddTwoInts.Request(a=-1), timeout_sec=0.01) is None
    sums: list[int] = []
    threads = [
        threading.Thread(
            target=lambda a=a: sums.append(served.client.call(AddTwoInts.Request(a=a), timeout_sec=20).sum)
        )
        for a in (-2, -3)
    ]
    for count, thread in enumerate(threads, 2):
        thread.start()
        wait_until(lambda count=count: len(served.asked) == count)
    served.go_on.set()
    for thread in threads:
        thread.join(10)
    assert sorted(sums) == [-3, -2]


def test_an_executor_receives_again_after_a_call(served: Served, context_on_each_wire: Context) -> None:
    client = served.client
    with SingleThreadedExecutor(context=context_on_each_wire) as executor:
        executor.add_node(client.owner)
        assert client.call(AddTwoInts.Request(a=1), timeout_sec=10).sum == 1
        future = client.call_async(AddTwoInts.Request(a=2))
        executor.spin_until_future_complete(future, timeout_sec=10)
        assert future.result().sum == 2


@pytest.mark.parametrize("is_added_before", [True, False])
def test_spin_once_returns_after_a_response_that_came_with_a_change_of_the_servers(
    node: Node,
    make_node: MakeNode,
    executor: SingleThreadedExecutor,
    context: Context,
    is_added_before: bool,
) -> None:
    server = make_node("server")
    server.create_service(AddTwoInts, "add", add)
    client = node.create_client(AddTwoInts, "add")
    executor.add_node(server)
    future = client.call_async(AddTwoInts.Request(a=2, b=3))
    with SingleThreadedExecutor(context=context) as asking:
        if is_added_before:
            asking.add_node(node)
        executor.spin_once(timeout_sec=5)
        assert client.server_watch.take() is None  # looks at the servers, and receives the response before
        assert future.done()
        if not is_added_before:
            asking.add_node(node)
        began_s = time.monotonic()
        asking.spin_once(timeout_sec=20)
        assert time.monotonic() - began_s < 15
        asking.spin_once(timeout_sec=0)
        assert not client._was_completed_elsewhere


def test_spin_once_returns_after_a_response_that_a_call_has_received(
    served: Served, context_on_each_wire: Context, wait_until: Callable[..., None]
) -> None:
    client, returned = served.client, threading.Event()
    calling = threading.Thread(target=client.call, args=[AddTwoInts.Request(a=-1)])
    calling.start()
    wait_until(lambda: served.asked)
    with SingleThreadedExecutor(context=context_on_each_wire) as executor:
        executor.add_node(client.owner)

        def spin() -> None:
            executor.spin_once()
            returned.set()

        spinning = threading.Thread(target=spin)
        spinning.start()
        wait_until(lambda: client.call_async(AddTwoInts.Request(a=5)) and returned.wait(0.1))
        spinning.join()
    served.go_on.set()
    calling.join(20)


def test_spin_once_returns_after_a_failure_that_a_call_has_noticed(
    context_on_each_wire: Context, wait_until: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    server, caller = (Node(name, context=context_on_each_wire) for name in ("server", "caller"))
    server.create_service(AddTwoInts, "add", add)
    client = caller.create_client(AddTwoInts, "add")
    assert client.wait_for_service(timeout_sec=10)
    future = client.call_async(AddTwoInts.Request(a=1))
    monkeypatch.setattr(client.server_watch, "take", lambda: None)  # so that the call's look is the first

    def call() -> None:
        with pytest.raises(NoResponseError):
            client.call(AddTwoInts.Request(a=2))

    calling = threading.Thread(target=call)
    calling.start()
    wait_until(lambda: len(client._pending) == 2)
    with SingleThreadedExecutor(context=context_on_each_wire) as executor:
        executor.add_node(caller)
        server.destroy_node()
        while not future.done():
            began_s = time.monotonic()
            executor.spin_once(timeout_sec=20)
            assert time.monotonic() - began_s < 15
        assert isinstance(future.exception(), NoResponseError)
    calling.join(20)
    caller.destroy_node()


def test_call_fails_when_the_server_leaves_although_nobody_spins(
    context_on_each_wire: Context, wait_until: Callable[..., None]
) -> None:
    server, caller = (Node(name, context=context_on_each_wire) for name in ("server", "caller"))
    server.create_service(AddTwoInts, "add", add)
    client = caller.create_client(AddTwoInts, "add")
    assert client.wait_for_service(timeout_sec=10)
    failures: list[NoResponseError] = []

    def call() -> None:
        with pytest.raises(NoResponseError, match="its server left the graph") as raised:
            client.call(AddTwoInts.Request(a=1))
        failures.append(raised.value)

    thread = threading.Thread(target=call)
    thread.start()
    wait_until(lambda: client._pending)
    server.destroy_node()
    thread.join(20)
    assert failures
    caller.destroy_node()


def test_a_request_during_the_look_at_the_servers_is_no_orphan(
    node: Node, make_node: MakeNode, monkeypatch: pytest.MonkeyPatch
) -> None:
    make_node("server").create_service(AddTwoInts, "add", add)
    client = node.create_client(AddTwoInts, "add")
    assert client.take_orphans() == []
    first = client.call_async(AddTwoInts.Request(a=1))
    later: list[Future[AddTwoInts.Response]] = []

    def connected() -> frozenset[str]:
        later.append(client.call_async(AddTwoInts.Request(a=2)))
        return frozenset()

    monkeypatch.setattr(client.wire_endpoint, "connected_servers", connected)
    assert client.take_orphans() == [first]
    assert [pending.future for pending in client._pending.values()] == later
    assert len(later) == 1


def test_call_from_a_callback_works_with_threads(make_node: MakeNode, context: Context) -> None:
    server, caller = make_node("server"), make_node("caller")
    server.create_service(AddTwoInts, "add", add)
    client = caller.create_client(AddTwoInts, "add")
    done: Future[int] = Future()

    def call() -> None:
        if not done.done():
            done.set_result(client.call(AddTwoInts.Request(a=20, b=22), timeout_sec=5).sum)

    caller.create_timer(0.001, call)
    with MultiThreadedExecutor(2, context=context) as executor:
        executor.add_node(server)
        executor.add_node(caller)
        executor.spin_until_future_complete(done, timeout_sec=10)
    assert done.result() == 42


def test_call_without_response_times_out(node: Node) -> None:
    client = node.create_client(AddTwoInts, "nobody")
    assert not client.service_is_ready()
    assert not client.wait_for_service(timeout_sec=0.01)
    assert client.call(AddTwoInts.Request(), timeout_sec=0.01) is None
    assert client.call(AddTwoInts.Request(), timeout_sec=0) is None
    assert not client._pending


def test_request_without_a_server_fails_by_name(
    node: Node, executor: SingleThreadedExecutor, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(client_module, "MAX_WAIT_FOR_SERVER_S", 0.2)
    executor.add_node(node)
    client = node.create_client(AddTwoInts, "nobody")
    future = client.call_async(AddTwoInts.Request())
    executor.spin_until_future_complete(future, timeout_sec=30)
    with pytest.raises(NoResponseError, match=r"^no response from /nobody: no server came.*wait_for_service"):
        future.result()
    with pytest.raises(NoResponseError):
        client.call(AddTwoInts.Request())
    assert not client._pending
    assert not client._unsent
    assert client.unsent_timer is not None
    assert client.unsent_timer.is_canceled()
    assert list(node.timers) == []


def test_requests_just_before_the_server_appears_are_answered(
    context_on_each_wire: Context, wait_until: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two requests that find no server, of which the first is given up; and one by `call`, on another thread."""
    monkeypatch.setattr(client_module, "MAX_WAIT_FOR_SERVER_S", 60.0)
    context = context_on_each_wire
    caller, server = (Node(name, context=context) for name in ("caller", "server"))
    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(caller)
        client = caller.create_client(AddTwoInts, "add")
        dropped, future = (client.call_async(AddTwoInts.Request(a=40, b=number)) for number in (1, 2))
        dropped.cancel()
        answers: list[Any] = []
        other = caller.create_client(AddTwoInts, "add")
        thread = threading.Thread(target=lambda: answers.append(other.call(AddTwoInts.Request(a=1, b=2))))
        thread.start()
        wait_until(lambda: other._unsent)
        received: list[int] = []

        def count(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
            received.append(request.b)
            return add(request, response)

        server.create_service(AddTwoInts, "add", count)
        executor.add_node(server)
        executor.spin_until_future_complete(future, timeout_sec=30)
        assert future.result().sum == 42
        end_s = time.monotonic() + 30
        while thread.is_alive() and time.monotonic() < end_s:
            executor.spin_once(timeout_sec=0.05)
        thread.join(1)
        assert answers == [AddTwoInts.Response(sum=3)]
        assert received == [2, 2]
    caller.destroy_node()
    server.destroy_node()


def test_a_client_destroyed_before_its_server_came_cancels_its_request(node: Node) -> None:
    client = node.create_client(AddTwoInts, "nobody")
    future = client.call_async(AddTwoInts.Request())
    assert not future.done()
    node.destroy_client(client)
    assert future.cancelled()


def test_request_to_later_servers_waits_for_them(
    make_node: MakeNode, executor: SingleThreadedExecutor
) -> None:
    latched = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    caller, server = make_node("caller"), make_node("server")
    client = caller.create_client(AddTwoInts, "late", qos_profile=latched)
    future = client.call_async(AddTwoInts.Request(a=1, b=2))
    assert not future.done()
    server.create_service(AddTwoInts, "late", add, qos_profile=latched)
    executor.add_node(caller)
    executor.add_node(server)
    executor.spin_until_future_complete(future, timeout_sec=10)
    assert future.result().sum == 3


def test_destroyed_client_cancels_its_requests(make_node: MakeNode) -> None:
    caller, server = make_node("caller"), make_node("server")
    server.create_service(SetBool, "s", lambda request, response: response)
    client = caller.create_client(SetBool, "s")
    future = client.call_async(SetBool.Request())
    caller.destroy_client(client)
    assert future.cancelled()
    assert not future.done()


def test_call_during_shutdown_returns_none(node: Node, make_node: MakeNode, context: Context) -> None:
    make_node("server").create_service(AddTwoInts, "unspun", lambda request, response: response)
    client = node.create_client(AddTwoInts, "unspun")
    context.shutdown()
    answers: list[object] = ["none yet"]
    thread = threading.Thread(target=lambda: answers.append(client.call(AddTwoInts.Request())), daemon=True)
    thread.start()
    thread.join(10.0)
    assert answers[1:] == [None]


def test_wait_for_service_ends_when_the_service_appears(make_node: MakeNode) -> None:
    client = make_node("client").create_client(SetBool, "late")
    is_ready: list[bool] = []
    thread = threading.Thread(target=lambda: is_ready.append(client.wait_for_service(timeout_sec=10)))
    thread.start()
    make_node("server").create_service(SetBool, "late", lambda request, response: response)
    thread.join(10)
    assert is_ready == [True]


def test_wait_for_service_ends_at_shutdown(node: Node, context: Context) -> None:
    client = node.create_client(SetBool, "never")
    is_ready: list[bool] = []
    thread = threading.Thread(target=lambda: is_ready.append(client.wait_for_service()))
    thread.start()
    context.shutdown()
    thread.join(10)
    assert is_ready == [False]


def test_invalid_arguments_raise(node: Node, executor: SingleThreadedExecutor) -> None:
    text = f"The service type provided is not valid ({AddTwoInts.Request}), this might be a message or action"
    with pytest.raises(RuntimeError, match=re.escape(text)):
        node.create_client(AddTwoInts.Request, "x")  # type: ignore[arg-type]
    with pytest.raises(RuntimeError, match=re.escape(text)):
        node.create_service(AddTwoInts.Request, "x", add)  # type: ignore[arg-type]
    executor.add_node(node)
    node.create_service(SetBool, "wrong", lambda request, response: None)
    node.create_client(SetBool, "wrong").call_async(SetBool.Request())
    with pytest.raises(TypeError, match="callback of /wrong must return a SetBool_Response, not NoneType"):
        executor.spin()


def test_undecodable_request_is_dropped(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil, capsys: pytest.CaptureFixture[str]
) -> None:
    executor.add_node(node)
    node.create_service(AddTwoInts, "add", add)
    client = node.create_client(AddTwoInts, "add")
    assert client.wait_for_service(timeout_sec=5)
    client._endpoint.send(b"\0\1\0\0\1")
    good = client.call_async(AddTwoInts.Request(a=1))
    executor.spin_until_future_complete(good, timeout_sec=5)
    assert good.result().sum == 1
    text = (
        "Dropped a request of 5 bytes to /add that is not a valid example_interfaces/srv/AddTwoInts_Request"
    )
    assert text in capsys.readouterr().err


def test_destroyed_client_and_service_leave_the_graph(node: Node, client: Client) -> None:
    (service,) = (service for service in node.services if service.service_name == "/add")
    assert list(node.clients) == [client]
    assert node.destroy_service(service)
    assert not client.service_is_ready()
    assert node.destroy_client(client)
    assert not node.destroy_client(client)
    action_client = ActionClient(node, Fibonacci, "fibonacci")
    assert not node.destroy_client(action_client)  # type: ignore[arg-type]  # as programs do
    action_client.destroy()
    for gone in (client, service):
        with pytest.raises(InvalidHandle) as caught, gone.handle:
            pass
        assert isinstance(caught.value, RuntimeError)


def test_introspection_publishes_all_four_events(
    client: Client, node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    (service,) = (service for service in node.services if service.service_name == "/add")
    clock, qos = node.get_clock(), QoSProfile(depth=10)
    client.configure_introspection(clock, qos, ServiceIntrospectionState.METADATA)
    service.configure_introspection(clock, qos, ServiceIntrospectionState.CONTENTS)
    events: list[AddTwoInts.Event] = []
    node.create_subscription(AddTwoInts.Event, "/add/_service_event", events.append, 10)
    client.call_async(AddTwoInts.Request(a=2, b=3))
    spin_until(lambda: len(events) == 4)
    by_type = {event.info.event_type: event for event in events}
    assert not by_type[ServiceEventInfo.REQUEST_SENT].request
    assert by_type[ServiceEventInfo.REQUEST_RECEIVED].request[0].b == 3
    assert by_type[ServiceEventInfo.RESPONSE_SENT].response[0].sum == 5
    assert {event.info.sequence_number for event in events} == {1}
    service.configure_introspection(clock, qos, ServiceIntrospectionState.OFF)
    client.configure_introspection(clock, qos, ServiceIntrospectionState.OFF)
    assert node.count_publishers("/add/_service_event") == 0


def test_server_destroyed_during_a_call_leaves_the_client_usable(
    make_node: MakeNode, executor: SingleThreadedExecutor
) -> None:
    server, caller = make_node("server"), make_node("caller")
    gate: Future[None] = Future(executor=executor)

    async def never(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        await gate
        return response

    server.create_service(SetBool, "s", never)
    client = caller.create_client(SetBool, "s")
    executor.add_node(server)
    executor.add_node(caller)
    lost = client.call_async(SetBool.Request())
    executor.spin_once(timeout_sec=1)
    server.destroy_node()
    assert not client.service_is_ready()
    again = make_node("server")
    again.create_service(SetBool, "s", lambda request, response: response)
    executor.add_node(again)
    assert client.wait_for_service(timeout_sec=5)
    future = client.call_async(SetBool.Request())
    executor.spin_until_future_complete(future, timeout_sec=5)
    assert future.result() is not None
    assert isinstance(lost.exception(), NoResponseError)
    assert str(lost.exception()) == "no response from /s: its server left the graph without one"
    client.remove_pending_request(lost)


def test_a_request_after_the_shutdown_fails_at_once(node: Node, context: Context) -> None:
    client = node.create_client(AddTwoInts, "nobody")
    context.shutdown()
    future = client.call_async(AddTwoInts.Request())
    assert isinstance(future.exception(), NoResponseError)
    assert not client._unsent
