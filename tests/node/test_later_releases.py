"""Names that later releases of rclpy have: what they do."""

from __future__ import annotations

import gc
import importlib
import signal
import threading
from collections.abc import Callable
from datetime import datetime, timedelta
from functools import partial
from typing import Any
from unittest.mock import Mock

import pytest
from tests.conftest import wait_until
from tests.faults.test_threads import no_threads

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.rcl_interfaces.msg import Log
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.turtlesim.action import RotateAbsolute
from tfloom.node import client_library
from tfloom.node.action.client import ActionClient, ClientGoalHandle
from tfloom.node.action.server import ActionServer, ServerGoalHandle
from tfloom.node.clock.clock import ROSClock
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.signals import SignalHandlerOptions
from tfloom.node.executing.task import Future, FutureState
from tfloom.node.executing.timer import TimerInfo, info_parameter
from tfloom.node.executing.waitable import Waitable
from tfloom.node.lifecycle.managed_entity import LifecyclePublisher
from tfloom.node.lifecycle.node import LifecycleNode
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.endpoint_info import EndpointTypeEnum, ServiceEndpointInfo
from tfloom.node.qos.qos import DurabilityPolicy, QoSPresetProfiles, QoSProfile
from tfloom.node.values.duration import Duration, Infinite
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.node.values.time import ClockType, Time

MakeNode = Callable[..., Node]
SpinUntil = Callable[..., None]
Finish = Callable[[Future[Any]], Any]


class Holder:
    """Callbacks of a timer, and what they got."""

    def __init__(self) -> None:
        self.got: list[Any] = []

    def method(self, info: TimerInfo) -> None:
        self.got.append(info)

    def keyword(self, *, when: TimerInfo) -> None:
        self.got.append(when)

    def unannotated(self, info=None) -> None:  # type: ignore[no-untyped-def]  # the case
        self.got.append(info)

    async def coroutine(self, info: TimerInfo) -> None:
        self.got.append(info)

    def __call__(self, info: TimerInfo) -> None:
        self.got.append(info)


@pytest.mark.parametrize("how", ["method", "keyword", "coroutine", "__call__", "partial", "object"])
def test_a_timers_callback_gets_the_times_of_its_call(
    how: str, node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    holder = Holder()
    ways = {"partial": partial(Holder.method, holder), "object": holder}
    callback = ways.get(how) or getattr(holder, how)
    begin = node.get_clock().now()
    node.create_timer(0.01, callback)
    executor.add_node(node)
    spin_until(lambda: len(holder.got) > 1)
    first, second = holder.got[:2]
    assert begin < first.expected_call_time <= first.actual_call_time <= second.actual_call_time
    assert first.expected_call_time.clock_type is ClockType.ROS_TIME
    period = second.expected_call_time - first.expected_call_time
    # Whole periods, but for what passes between two looks at two clocks.
    assert abs((period.nanoseconds + 5_000_000) % 10_000_000 - 5_000_000) < 4_000_000


def test_a_timers_times_are_those_of_simulated_time(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    clock = ROSClock()
    clock.set_ros_time_is_active(True)
    clock.set_ros_time_override(Time(seconds=10, clock_type=ClockType.ROS_TIME))
    holder = Holder()
    node.create_timer(1.0, holder.method, clock=clock)
    executor.add_node(node)
    clock.set_ros_time_override(Time(seconds=11.25, clock_type=ClockType.ROS_TIME))
    spin_until(lambda: holder.got)
    [info] = holder.got
    assert info.expected_call_time.nanoseconds == 11_000_000_000
    assert info.actual_call_time.nanoseconds == 11_250_000_000


def test_only_an_annotated_parameter_gets_the_times() -> None:
    holder = Holder()
    assert info_parameter(holder.unannotated) is None
    assert info_parameter(holder.keyword) == "when"
    assert info_parameter(print) is None
    assert info_parameter(None) is None

    def plain(count: int = 1, info: object = None) -> None:
        """Be annotated below."""

    assert info_parameter(plain) is None
    for annotation in (TimerInfo, "rclpy.timer.TimerInfo", "'TimerInfo'"):
        plain.__annotations__["info"] = annotation
        assert info_parameter(plain) == "info"
    plain.__annotations__ = {"return": TimerInfo}
    assert info_parameter(plain) is None
    assert info_parameter(partial(partial(holder.method), 1)) == "info"


def test_a_block_ends_what_a_node_has_created(make_node: MakeNode) -> None:
    node = make_node("blocks")
    ends: list[Any] = [
        node.create_publisher(String, "texts", 1),
        node.create_subscription(String, "texts", print, 1),
        node.create_client(AddTwoInts, "add"),
        node.create_service(AddTwoInts, "add", lambda _, response: response),
        node.create_timer(10.0, print),
    ]
    for end in ends:
        with end as same:
            assert same is end
        with pytest.raises(InvalidHandle), end.handle:
            pass


def test_generic_classes_take_the_types_of_annotations() -> None:
    """At run time, too, where type variables have no defaults."""
    types = (Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback)
    for generic in (ActionClient, ClientGoalHandle):
        assert generic[types].__args__ == (*types, Any, Any)  # type: ignore[index]
        with pytest.raises(TypeError, match="Too many"):
            generic[(*types, *types)]  # type: ignore[index]

    class Own(ActionClient[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]):
        """A class of a program."""

    class OwnWaitable(Waitable[int]):
        """Another one."""

    assert issubclass(Own, ActionClient)
    assert issubclass(OwnWaitable, Waitable)
    assert ActionServer[types].__args__ == types  # type: ignore[index]


def test_a_mock_is_a_timers_callback(make_node: MakeNode) -> None:
    callback = Mock()  # has each attribute that it is asked for, `func` of `func` too
    assert info_parameter(callback) is None
    timer = make_node("mocked").create_timer(1.0, callback)
    timer.run(True)
    callback.assert_called_once_with()


def test_wrong_times_of_a_call_are_refused() -> None:
    with pytest.raises(ValueError, match=r"^call time values must not be negative$"):
        TimerInfo(actual_call_time=-1)
    with pytest.raises(TypeError, match=r"^Clock type must be a ClockType enum$"):
        TimerInfo(clock_type=2)  # type: ignore[arg-type]
    assert TimerInfo(expected_call_time=5).expected_call_time == Time(nanoseconds=5)


def test_log_records_have_the_qos_that_the_node_was_given(make_node: MakeNode) -> None:
    profile = QoSProfile(depth=7, durability=DurabilityPolicy.VOLATILE)
    node = make_node("volatile", rosout_qos_profile=profile)
    counted = make_node("counted", rosout_qos_profile=3)
    usual = make_node("usual")
    infos = {info.node_name: info.qos_profile for info in node.get_publishers_info_by_topic("/rosout")}
    assert infos["volatile"].durability is DurabilityPolicy.VOLATILE
    assert infos["counted"].depth in {0, 3}  # where the wire tells it
    assert infos["usual"].durability is DurabilityPolicy.TRANSIENT_LOCAL
    late: list[Log] = []
    node.get_logger().info("missed")
    usual.get_logger().info("kept")
    watcher = make_node("watcher")
    kept = QoSPresetProfiles.get_from_short_key("rosout_default")
    assert (kept.depth, kept.lifespan.nanoseconds) == (1000, 10_000_000_000)
    watcher.create_subscription(Log, "/rosout", late.append, kept)
    with SingleThreadedExecutor(context=watcher.context) as executor:
        executor.add_node(watcher)
        while "kept" not in [record.msg for record in late]:
            executor.spin_once(timeout_sec=5)
    assert "missed" not in [record.msg for record in late]
    for wrong, error in (("x", TypeError), (-1, ValueError), (True, TypeError)):
        with pytest.raises(error):
            make_node("wrong", rosout_qos_profile=wrong)
    assert "wrong" not in counted.get_node_names()


def test_arithmetic_of_durations() -> None:
    second = Duration(seconds=1)
    assert second + second * 0.5 - Duration(nanoseconds=1) == Duration(nanoseconds=1_499_999_999)
    assert Duration(nanoseconds=-3) * 0.5 == Duration(nanoseconds=-1)
    assert Duration(nanoseconds=2**62) * -2 == Duration(nanoseconds=-(2**63))
    assert second * float("inf") == Infinite
    for wrong in (float("nan"), float("-inf")):
        with pytest.raises(ValueError, match=f"^Can't multiply duration with {wrong}$"):
            second * wrong
    for too_large in (lambda: Infinite + second, lambda: Infinite * 2, lambda: second * 1e30):
        with pytest.raises(OverflowError):
            too_large()
    for text in ("second * 'a'", "second + 1", "second - Time(nanoseconds=1)", "second * None"):
        with pytest.raises(TypeError):
            eval(text, {"second": second, "Time": Time})


def test_a_duration_is_multiplied_by_a_number_of_numpy() -> None:
    numpy = pytest.importorskip("numpy")
    assert Duration(seconds=3) * numpy.int32(2) == Duration(seconds=6)
    assert Duration(seconds=3) * numpy.float32(0.5) == Duration(seconds=1.5)


def test_a_time_as_local_date_and_time() -> None:
    now = datetime.now().replace(microsecond=123456)  # noqa: DTZ005  # naive, as what is tested
    time = Time(nanoseconds=int(now.timestamp()) * 10**9 + 123_456_999)
    assert time.to_datetime() == now
    assert time.to_datetime().tzinfo is None
    later = Time(nanoseconds=time.nanoseconds + 3600 * 10**9, clock_type=ClockType.ROS_TIME).to_datetime()
    assert later - now in {
        timedelta(hours=hours) for hours in (0, 1, 2)
    }  # the clocks may be changed just then
    with pytest.raises(
        TypeError, match=r"^Time object's clock type should be either ROS_TIME or SYSTEM_TIME$"
    ):
        Time(nanoseconds=1, clock_type=ClockType.STEADY_TIME).to_datetime()


def test_types_of_parameters_are_numbers_with_names() -> None:
    assert Parameter.Type.INTEGER == 2
    assert f"{Parameter.Type.INTEGER} {Parameter.Type.INTEGER!s}" == "Type.INTEGER Type.INTEGER"
    assert {2: "x"}[Parameter.Type.INTEGER] == "x"
    assert Parameter[int]("count", value=3).value == 3
    with pytest.raises(TypeError):
        Parameter("count", 2, 3)  # type: ignore[arg-type]


@pytest.fixture
def node_on_each_wire(context_on_each_wire: Context) -> Node:
    return Node("server", context=context_on_each_wire, start_parameter_services=False)


def test_ends_of_services_on_the_graph(node_on_each_wire: Node, context_on_each_wire: Context) -> None:
    node = node_on_each_wire
    client_node = Node("caller", namespace="/far", context=context_on_each_wire)
    node.create_service(AddTwoInts, "add", lambda request, response: response)
    node.create_service(AddTwoInts, "other", lambda request, response: response)
    clients = [client_node.create_client(AddTwoInts, "/add") for _ in range(2)]
    wait_until(lambda: len(node.get_clients_info_by_service("add")) == 2)
    [server] = client_node.get_servers_info_by_service("/add")
    assert (server.node_name, server.node_namespace) == ("server", "/")
    assert (server.service_type, server.endpoint_type) == (
        "example_interfaces/srv/AddTwoInts",
        EndpointTypeEnum.SERVER,
    )
    is_zenoh = server.endpoint_count == 1
    assert server.endpoint_count == len(server.qos_profiles) == len(server.endpoint_gids) == 2 - is_zenoh
    callers = node.get_clients_info_by_service("add")
    assert {info.node_namespace for info in callers} == {"/far"}
    assert {info.endpoint_type for info in callers} == {EndpointTypeEnum.CLIENT}
    gids = [tuple(gid) for info in (*callers, server) for gid in info.endpoint_gids]
    assert len(set(gids)) == len(gids) == 3 * server.endpoint_count
    assert {tuple(client.wire_endpoint.gid) for client in clients} <= set(gids) | {
        tuple(client.wire_endpoint.client_gid) for client in clients
    }
    assert "Endpoint type: SERVER" in str(server)
    assert str(server).count("GID: ") == server.endpoint_count
    assert server == client_node.get_servers_info_by_service("/add")[0] != callers[0]
    assert client_node.get_servers_info_by_service("add") == []  # in its own namespace
    by_wire_name = node.get_servers_info_by_service("rq/addRequest", no_mangle=True)
    assert by_wire_name == ([] if is_zenoh else [server])
    with pytest.raises(TypeError, match="'topic_type' is not a property of an endpoint"):
        ServiceEndpointInfo(topic_type="x")


def test_each_server_of_a_participant_has_its_own_responses(node_on_each_wire: Node) -> None:
    for _ in range(3):
        node_on_each_wire.create_service(AddTwoInts, "add", lambda request, response: response)
    infos = node_on_each_wire.get_servers_info_by_service("add")
    assert len(infos) == 3
    assert len({tuple(map(tuple, info.endpoint_gids)) for info in infos}) == 3


def test_actions_of_a_node(make_node: MakeNode) -> None:
    server_node, client_node = make_node("serves"), make_node("calls")
    ActionServer(server_node, Fibonacci, "count", lambda handle: Fibonacci.Result())
    ActionClient(client_node, Fibonacci, "count")
    expected = [("/count", ["example_interfaces/action/Fibonacci"])]
    assert server_node.get_action_names_and_types() == expected
    assert client_node.get_action_server_names_and_types_by_node("serves", "/") == expected
    assert client_node.get_action_server_names_and_types_by_node("calls", "/") == []
    assert client_node.get_action_client_names_and_types_by_node("calls", "/") == expected


@pytest.mark.parametrize("with_callback", [True, False])
def test_a_server_without_an_execute_callback(
    with_callback: bool,
    make_node: MakeNode,
    executor: SingleThreadedExecutor,
    finish: Finish,
    capfd: pytest.CaptureFixture[str],
) -> None:
    node = make_node()

    def execute(handle: ServerGoalHandle) -> Fibonacci.Result:
        handle.succeed()
        return Fibonacci.Result(sequence=[7])

    accept: dict[str, Any] = (
        {"handle_accepted_callback": lambda handle: handle.execute(execute)} if with_callback else {}
    )
    ActionServer(node, Fibonacci, "count", None, **accept)
    client = ActionClient(node, Fibonacci, "count")
    executor.add_node(node)
    goal = finish(client.send_goal_async(Fibonacci.Goal()))
    outcome = finish(goal.get_result_async())
    if with_callback:
        assert list(outcome.result.sequence) == [7]
    else:  # the goal fails, not the server
        assert outcome.status == 6
        assert "give handle_accepted_callback a function that calls" in capfd.readouterr().err
        assert finish(client.send_goal_async(Fibonacci.Goal())).accepted


def test_states_of_a_future() -> None:
    future: Future[int] = Future()
    assert future._state is FutureState.PENDING
    future.cancel()
    assert future._state is FutureState.CANCELLED
    future.set_result(1)
    assert future._state is FutureState.FINISHED


def test_an_executor_knows_that_it_spins(node: Node, executor: SingleThreadedExecutor) -> None:
    seen: list[bool] = []
    node.create_timer(0.001, lambda: seen.append(executor.is_spinning))
    executor.add_node(node)
    assert not executor.is_spinning
    executor.spin_once(timeout_sec=5)
    # The callback runs after the wait; a longer spin lasts meanwhile.
    executor.spin_until_future_complete(Future(), timeout_sec=0.05)
    assert seen[-1]
    assert not executor.is_spinning
    raised: list[BaseException] = []

    def spin() -> None:
        try:
            executor.spin_once(timeout_sec=0)
        except RuntimeError as error:
            raised.append(error)

    executor.create_task(lambda: None)
    thread = threading.Thread(target=spin)
    with executor._long_spin():
        thread.start()
        thread.join()
    assert str(raised[0]).startswith("Executor is already spinning")


@pytest.mark.parametrize("waits", [True, False])
def test_the_end_of_an_executors_threads_is_waited_for(waits: bool, node: Node, context: Context) -> None:
    executor = MultiThreadedExecutor(2, context=context)
    threads: list[threading.Thread] = []
    done: Future[None] = Future()

    def note() -> None:
        threads.append(threading.current_thread())
        done.set_result(None)

    node.create_timer(0.001, note)
    executor.add_node(node)
    executor.spin_until_future_complete(done, timeout_sec=5)
    assert executor.shutdown(wait_for_threads=waits)
    if waits:
        assert not threads[0].is_alive()
    else:
        wait_until(lambda: not threads[0].is_alive())
    assert executor.shutdown()  # again


def test_an_executor_is_shut_down_on_a_thread_of_its_own(node: Node, context: Context) -> None:
    executor = MultiThreadedExecutor(2, context=context)
    ended: Future[bool] = Future()
    node.create_timer(0.001, lambda: ended.done() or ended.set_result(executor.shutdown()))
    executor.add_node(node)
    executor.spin_until_future_complete(ended, timeout_sec=5)
    wait_until(ended.done)
    assert ended.result() is True


class Tracked:
    """Something that a context destroys."""

    def __init__(self) -> None:
        self.ends = 0

    def destroy_node(self) -> None:
        self.ends += 1
        raise RuntimeError("while destroyed")


def test_tracked_nodes_are_destroyed_at_shutdown(capfd: pytest.CaptureFixture[str]) -> None:
    context = Context()
    context.init(["program"])
    kept, removed, dropped = Tracked(), Tracked(), Tracked()
    for _ in range(2):
        context.track_node(kept)
    context.track_node(removed)
    context.track_node(dropped)
    context.untrack_node(removed)
    context.untrack_node(removed)
    del dropped
    gc.collect()
    context.shutdown()
    assert (kept.ends, removed.ends) == (1, 0)
    assert capfd.readouterr().err.count("RuntimeError: while destroyed") == 1
    context.destroy()
    assert kept.ends == 1
    with pytest.raises(TypeError):
        context.track_node(None)  # type: ignore[arg-type]


class Counting(LifecyclePublisher[String]):
    """A publisher of a program's own."""


def test_a_lifecycle_publisher_of_ones_own_class(context: Context) -> None:
    node = LifecycleNode("cycle", context=context)
    publisher = node.create_lifecycle_publisher(String, "a", 1, publisher_class=Counting)
    assert type(publisher) is Counting
    assert type(node.create_lifecycle_publisher(String, "b", 1)) is LifecyclePublisher
    for wrong in (Node, 3):
        with pytest.raises(TypeError, match="a publisher_class that derives from LifecyclePublisher"):
            node.create_lifecycle_publisher(String, "c", 1, publisher_class=wrong)  # type: ignore[arg-type]
    node.destroy_node()


@pytest.mark.parametrize("options", [SignalHandlerOptions.NO, SignalHandlerOptions.SIGINT])
def test_init_tells_whether_it_has_installed_handlers(options: SignalHandlerOptions) -> None:
    context = Context()
    before = signal.getsignal(signal.SIGINT)
    with client_library.init(args=[], context=context, signal_handler_options=options) as started:
        assert started.context is context
        assert started.installed_signal_handlers is (options != SignalHandlerOptions.NO)
    assert signal.getsignal(signal.SIGINT) == before
    assert not context.ok()


def test_a_context_that_was_initialised_is_entered() -> None:
    context = Context()
    context.init(["program"], domain_id=3)
    with context as same:
        assert same is context
        assert context.get_domain_id() == 3
    assert not context.ok()
    with pytest.raises(RuntimeError, match="must only be called once"), context:
        pass


def test_what_is_destroyed_by_itself_leaves_its_node(node: Node, executor: SingleThreadedExecutor) -> None:
    publisher = node.create_publisher(String, "words", 1)
    subscription = node.create_subscription(String, "words", print, 1)
    timer, guard = node.create_timer(0.001, lambda: None), node.create_guard_condition(lambda: None)
    service = node.create_service(AddTwoInts, "add", lambda _, response: response)
    client = node.create_client(AddTwoInts, "add")
    lists: list[tuple[Any, Callable[[], Any], Callable[[Any], bool]]] = [
        (publisher, lambda: node.publishers, node.destroy_publisher),
        (subscription, lambda: node.subscriptions, node.destroy_subscription),
        (timer, lambda: node.timers, node.destroy_timer),
        (guard, lambda: node.guards, node.destroy_guard_condition),
        (service, lambda: node.services, node.destroy_service),
        (client, lambda: node.clients, node.destroy_client),
    ]
    handlers = [*publisher.event_handlers, *subscription.event_handlers]
    for end, owned, destroy in lists:
        assert end in [*owned()]
        end.destroy()
        assert end not in [*owned()]
        end.destroy()
        assert not destroy(end)
    assert not {*handlers} & {*node.waitables}
    assert node.count_publishers("words") == node.count_subscribers("words") == 0
    with node.create_timer(0.001, lambda: None) as timer:
        assert timer in [*node.timers]
    assert timer not in [*node.timers]
    executor.spin_once(timeout_sec=0.01)


class Told:
    """The numbers that a callback of new data was called with."""

    def __init__(self) -> None:
        self.counts: list[int] = []
        self.fails = False

    def __call__(self, count: int) -> None:
        self.counts.append(count)
        if self.fails:
            raise ValueError("of the callback")


def test_messages_are_told_of_and_taken_once(
    node_on_each_wire: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    node = node_on_each_wire
    reported: list[Any] = []
    monkeypatch.setattr(threading, "excepthook", lambda failure: reported.append(failure.exc_value))
    got: list[str] = []
    subscription = node.create_subscription(String, "words", lambda message: got.append(message.data), 3)
    publisher = node.create_publisher(String, "words", 10)
    wait_until(lambda: publisher.get_subscription_count() == 1)
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)

        def send(*words: str) -> None:
            for word in words:
                publisher.publish(String(data=word))

        def spin_until(condition: Callable[[], bool]) -> None:
            wait_until(lambda: executor.spin_once(timeout_sec=0.01) or condition())

        send("a")
        told = Told()
        wait_until(subscription.has_next)
        subscription.handle.set_on_new_message_callback(told)
        wait_until(lambda: sum(told.counts) == 1)  # what was there before
        for number, word in enumerate(
            ("b", "c", "d", "e"), 2
        ):  # one by one: a reader may replace what nobody takes
            send(word)
            wait_until(lambda number=number: sum(told.counts) == number)
        assert got == []
        spin_until(lambda: got[-1:] == ["e"])
        assert got == ["c", "d", "e"]  # of which its depth keeps three
        told.fails = True
        send("f")
        spin_until(lambda: got[-1:] == ["f"])
        wait_until(lambda: sum(told.counts) == 6)
        wait_until(lambda: [str(error) for error in reported] == ["of the callback"])
        other = Told()
        subscription.handle.set_on_new_message_callback(other)
        send("g")
        spin_until(lambda: got[-1:] == ["g"])
        wait_until(lambda: other.counts == [1])
        subscription.handle.clear_on_new_message_callback()
        subscription.handle.clear_on_new_message_callback()
        send("h")
        spin_until(lambda: got[-1:] == ["h"])
        assert (sum(told.counts), other.counts) == (6, [1])
        # A filter that is set later doesn't end it.
        subscription.handle.set_on_new_message_callback(other)
        subscription.set_content_filter("data = 'i'", [])
        send("x", "i")
        spin_until(lambda: got[-1:] == ["i"])
        assert "x" not in got
        wait_until(lambda: other.counts == [1, 1])
    with pytest.raises(TypeError, match="must be callable"):
        subscription.handle.set_on_new_message_callback(3)
    with no_threads(), pytest.raises(RCLError, match="can't start new thread"):
        subscription.handle.set_on_new_message_callback(Told())
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        publisher.publish(String(data="i"))
        wait_until(lambda: executor.spin_once(timeout_sec=0.01) or got[-2:] == ["i", "i"])
    before = threading.active_count()
    subscription.handle.set_on_new_message_callback(other)
    node.destroy_subscription(subscription)
    wait_until(lambda: threading.active_count() <= before)
    with pytest.raises(InvalidHandle):
        subscription.handle.set_on_new_message_callback(other)


def test_requests_and_responses_are_told_of(node_on_each_wire: Node) -> None:
    node = node_on_each_wire

    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    service, client = node.create_service(AddTwoInts, "add", add), node.create_client(AddTwoInts, "add")
    requests, responses = Told(), Told()
    service.handle.set_on_new_request_callback(requests)
    client.handle.set_on_new_response_callback(responses)
    executor = MultiThreadedExecutor(2, context=node.context)
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    try:
        assert client.wait_for_service(10.0)
        for number in range(5):
            response: Any = client.call(AddTwoInts.Request(a=number, b=1), timeout_sec=10.0)
            assert response is not None
            assert response.sum == number + 1
        wait_until(lambda: sum(requests.counts) == sum(responses.counts) == 5)
        service.handle.clear_on_new_request_callback()
        client.handle.clear_on_new_response_callback()
        response = client.call(AddTwoInts.Request(a=1, b=1), timeout_sec=10.0)
        assert response.sum == 2
        assert sum(requests.counts) == sum(responses.counts) == 5
    finally:
        executor.shutdown()
        thread.join()


def test_resets_of_a_timer_are_told_of(make_node: MakeNode) -> None:
    timer = make_node("ticks").create_timer(100.0, lambda: None)
    timer.reset()
    timer.reset()
    told = Told()
    timer.handle.set_on_reset_callback(told)
    assert told.counts == [2]
    timer.reset()
    assert told.counts == [2, 1]
    timer.handle.clear_on_reset_callback()
    timer.reset()
    assert told.counts == [2, 1]
    with pytest.raises(TypeError, match="must be callable"):
        timer.handle.set_on_reset_callback(None)


def test_classes_have_the_bases_of_rosidl_pycommon() -> None:
    bases: Any = importlib.import_module("rosidl_pycommon.interface_base_classes")
    assert issubclass(String, bases.BaseMessage)
    assert issubclass(AddTwoInts, bases.BaseService)
    for action in (Fibonacci, RotateAbsolute):
        assert issubclass(action, bases.BaseAction)
        assert issubclass(action.Impl, bases.BaseImpl)
        assert not issubclass(action.Impl, bases.BaseAction)
