"""A server and clients in one process: the results of queries, and their waits."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from typing import Any

import pytest
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.action_msgs.msg import GoalStatus
from tfloom.interfaces.builtin_interfaces.msg import Duration as DurationMessage
from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.tf2_msgs.action import LookupTransform
from tfloom.interfaces.tf2_msgs.msg import TF2Error
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer
from tfloom.node.context.context import Context
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.duration import Duration, Infinite
from tfloom.node.values.exceptions import ExternalShutdownException
from tfloom.node.values.time import Time
from tfloom.tf2.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from tfloom.tf2_ros import buffer_server, deadlines, geometry  # noqa: F401, geometry registers its types
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.buffer_client import BufferClient
from tfloom.tf2_ros.buffer_server import BufferServer

ACTION = "tf2_buffer_server"
LATEST = Time()
PATIENCE = Duration(seconds=20)
MakeNode = Callable[..., Node]


def at(seconds: float) -> Time:
    return Time(nanoseconds=int(seconds * SECOND))


def goal_of(source_frame: str, **options: object) -> LookupTransform.Goal:
    return LookupTransform.Goal(target_frame="world", source_frame=source_frame, **options)


@contextmanager
def spinning(executor: Executor, node: Node) -> Iterator[Node]:
    """Spin a node on a separate thread."""

    def run() -> None:
        with suppress(ExternalShutdownException):
            executor.spin()

    executor.add_node(node)
    thread = threading.Thread(target=run)
    thread.start()
    yield node
    executor.shutdown()
    thread.join()


@pytest.fixture(params=[SingleThreadedExecutor, MultiThreadedExecutor])
def server_node(
    request: pytest.FixtureRequest, local_context: Context, make_node: MakeNode
) -> Iterator[Node]:
    """A node that spins."""
    with spinning(request.param(context=local_context), make_node("tf_buffer")) as node:
        yield node


@pytest.fixture
def buffer(server_node: Node) -> Buffer:
    """The server's buffer: the world, a robot that moves in it from 1 to 3 s, and an unconnected frame."""
    buffer = Buffer()
    for stamp in range(1, 4):
        buffer.set_transform(transform_stamped("world", "robot", stamp * SECOND, (stamp, 0.0, 0.0)), "test")
    buffer.set_transform_static(transform_stamped("robot", "laser", 0, (0.0, 0.0, 0.5)), "test")
    buffer.set_transform(transform_stamped("island", "palm", 2 * SECOND), "test")
    BufferServer(buffer, server_node)
    return buffer


def connected(node: Node, **options: object) -> BufferClient:
    client = BufferClient(node, ACTION, **options)
    assert client.wait_for_server(10)
    return client


@pytest.fixture
def client(buffer: Buffer, make_node: MakeNode) -> BufferClient:
    return connected(make_node("asker"))


@pytest.fixture
def goals(buffer: Buffer, local_context: Context, make_node: MakeNode) -> Iterator[ActionClient]:
    """A plain action client whose node spins."""
    with spinning(SingleThreadedExecutor(context=local_context), make_node("goals")) as node:
        goals = ActionClient(node, LookupTransform, ACTION)
        assert goals.wait_for_server(10)
        yield goals


def where(transform: Any) -> tuple[float, float, float]:
    translation = transform.transform.translation
    return translation.x, translation.y, translation.z


def test_available_transform_is_returned_at_once(client: BufferClient) -> None:
    transform = client.lookup_transform("world", "laser", at(2.5))
    assert where(transform) == (2.5, 0.0, 0.5)
    assert (transform.header.frame_id, transform.child_frame_id) == ("world", "laser")
    assert transform.header.stamp == TimeMessage(sec=2, nanosec=500_000_000)
    assert client.lookup_transform("world", "robot", LATEST).header.stamp.sec == 3
    assert client.can_transform("world", "laser", at(2.5)) is True


def test_time_and_duration_messages_are_accepted(client: BufferClient) -> None:
    transform = client.lookup_transform("world", "robot", TimeMessage(sec=2), DurationMessage(sec=1))
    assert where(transform) == (2.0, 0.0, 0.0)
    with pytest.raises(TypeError, match=r"^Must pass a rclpy\.time\.Time object\.$"):
        client.lookup_transform("world", "robot", 2.0)


def test_timeout_beyond_a_message_is_clamped(client: BufferClient) -> None:
    assert where(client.lookup_transform("world", "robot", at(2), Infinite)) == (2.0, 0.0, 0.0)


def test_full_lookup(client: BufferClient) -> None:
    query = ("robot", at(3), "robot", at(1), "world")
    assert where(client.lookup_transform_full(*query)) == (-2.0, 0.0, 0.0)
    assert client.can_transform_full(*query) is True
    assert client.can_transform_full("robot", at(3), "robot", at(1), "nowhere") is False


def test_objects_are_transformed(client: BufferClient) -> None:
    point = PointStamped()
    point.header.frame_id, point.header.stamp, point.point.x = "laser", TimeMessage(sec=2), 1.0
    moved = client.transform(point, "world")
    assert (moved.point.x, moved.point.z) == (3.0, 0.5)
    assert client.transform_full(point, "robot", at(3), "world").point.x == 0.0


@pytest.mark.parametrize(
    ("target", "source", "time", "kind"),
    [
        ("world", "nowhere", LATEST, LookupException),
        ("world", "palm", LATEST, ConnectivityException),
        ("world", "robot", at(9), ExtrapolationException),
        ("world", "robot", at(0.5), ExtrapolationException),
        ("/world", "robot", LATEST, InvalidArgumentException),
    ],
)
def test_server_errors_are_raised_at_the_client(
    client: BufferClient, buffer: Buffer, target: str, source: str, time: Time, kind: type[TransformException]
) -> None:
    with pytest.raises(kind) as there:
        buffer.lookup_transform(target, source, time)
    with pytest.raises(kind) as here:
        client.lookup_transform(target, source, time)
    assert str(here.value) == str(there.value)
    assert client.can_transform(target, source, time) is False


def test_transform_is_returned_as_soon_as_it_arrives(
    client: BufferClient, buffer: Buffer, wait_until: Callable[..., None]
) -> None:
    with ThreadPoolExecutor(1) as pool:
        answer = pool.submit(client.lookup_transform, "world", "robot", at(3.5), PATIENCE)
        wait_until(lambda: waiting(buffer) == 1)
        buffer.set_transform(transform_stamped("world", "robot", 3 * SECOND + 1), "test")
        assert not answer.done()
        buffer.set_transform(transform_stamped("world", "robot", 4 * SECOND, (4.0, 0.0, 0.0)), "test")
        assert answer.result(10).header.stamp.nanosec == 500_000_000


def waiting(buffer: Buffer) -> int:
    """Return the number of waiting lookups of servers in this process."""
    return len(deadlines._functions)


def test_timeout_raises(client: BufferClient, buffer: Buffer) -> None:
    started = time.monotonic()
    with pytest.raises(TimeoutException) as raised:
        client.lookup_transform("world", "robot", at(9), Duration(seconds=0.3))
    assert time.monotonic() - started >= 0.3
    assert str(raised.value).startswith(
        "Timed out after 0.3 s waiting for the transform from robot to world: Lookup"
    )
    assert client.can_transform("world", "robot", at(9), Duration(seconds=0.1)) is False
    assert waiting(buffer) == 0


def test_too_old_transform_is_not_waited_for(client: BufferClient, buffer: Buffer) -> None:
    for stamp in (100, 101):  # old samples are removed at the insert after the one that makes them old
        buffer.set_transform(transform_stamped("world", "robot", stamp * SECOND), "test")
    with pytest.raises(ExtrapolationException):
        client.lookup_transform("world", "robot", at(1), PATIENCE)


def test_server_times_out_in_time(goals: ActionClient) -> None:
    goal = goal_of("robot", source_time=TimeMessage(sec=9), timeout=DurationMessage(sec=1))
    handle = goals.wait_for(goals.send_goal_async(goal))
    started = time.monotonic()
    response = handle.get_result()
    assert time.monotonic() - started >= 0.9
    assert response.status == GoalStatus.STATUS_ABORTED
    assert response.result.error.error == TF2Error.TIMEOUT_ERROR


def test_negative_timeout_is_zero(client: BufferClient) -> None:
    with pytest.raises(ExtrapolationException):
        client.lookup_transform("world", "robot", at(9), Duration(seconds=-60))


def test_several_threads_query_by_one_unspun_node(client: BufferClient) -> None:
    def ask(count: int) -> float:
        return sum(where(client.lookup_transform("world", "robot", at(2)))[0] for _ in range(count))

    with ThreadPoolExecutor(4) as pool:
        assert sum(pool.map(ask, [10] * 4)) == 80.0


@pytest.mark.parametrize(
    ("goal", "code"),
    [
        (goal_of("robot"), TF2Error.NO_ERROR),
        (goal_of("nowhere"), TF2Error.LOOKUP_ERROR),
        (goal_of("x", timeout=DurationMessage(sec=-1)), TF2Error.LOOKUP_ERROR),
    ],
)
def test_goal_without_wait_succeeds_even_with_an_error(
    goals: ActionClient, goal: LookupTransform.Goal, code: int
) -> None:
    response = goals.send_goal(goal)
    assert response.status == GoalStatus.STATUS_SUCCEEDED
    assert response.result.error.error == code


def test_time_beyond_a_stamp_is_an_error(goals: ActionClient) -> None:
    """The result could not be sent."""
    late = TimeMessage(sec=2**31 - 1, nanosec=2**32 - 1)
    goal = LookupTransform.Goal(
        target_frame="robot",
        source_frame="laser",
        source_time=late,
        target_time=late,
        fixed_frame="robot",
        timeout=DurationMessage(sec=1),
    )
    for goal.advanced in (False, True):
        result = goals.send_goal(goal).result
        assert result.error.error == TF2Error.TRANSFORM_ERROR
        assert result.error.error_string == "the requested time is later than a stamp can hold"


def test_waiting_goal_can_be_cancelled(
    goals: ActionClient, buffer: Buffer, wait_until: Callable[..., None]
) -> None:
    goal = goal_of("robot", source_time=TimeMessage(sec=9), timeout=DurationMessage(sec=60))
    handles = [goals.wait_for(goals.send_goal_async(goal)) for _ in range(2)]
    wait_until(lambda: waiting(buffer) == 2)
    assert len(handles[0].cancel_goal().goals_canceling) == 1
    response = handles[0].get_result()
    assert response.status == GoalStatus.STATUS_CANCELED
    assert response.result.error.error == TF2Error.TRANSFORM_ERROR
    assert waiting(buffer) == 1
    buffer.set_transform(transform_stamped("world", "robot", 9 * SECOND, (9.0, 0.0, 0.0)), "test")
    response = handles[1].get_result()
    assert where(response.result.transform) == (9.0, 0.0, 0.0)
    assert not handles[1].cancel_goal().goals_canceling
    assert waiting(buffer) == 0


def test_many_queries_at_once(client: BufferClient, buffer: Buffer, wait_until: Callable[..., None]) -> None:
    with ThreadPoolExecutor(30) as pool:
        answers = [
            pool.submit(client.lookup_transform, "world", "robot", at(4 + n / 10), PATIENCE)
            for n in range(30)
        ]
        wait_until(lambda: waiting(buffer) == 30)
        buffer.set_transform(transform_stamped("world", "robot", 14 * SECOND, (14.0, 0.0, 0.0)), "test")
        for n, answer in enumerate(answers):
            assert where(answer.result(20))[0] == pytest.approx(4 + n / 10)


def test_missing_server_raises(make_node: MakeNode) -> None:
    client = BufferClient(make_node("asker"), "nobody")
    with pytest.raises(TimeoutException, match=r"^The BufferServer is not ready\.$"):
        client.lookup_transform("world", "robot", LATEST, PATIENCE)
    assert client.can_transform("world", "robot", LATEST) is False
    assert client.wait_for_server(0.01) is False
    client.destroy()


def patient(node: Node) -> BufferClient:
    return connected(node, timeout_padding=Duration(seconds=30))


def padded(node: Node) -> BufferClient:
    return connected(node, timeout_padding=Duration(seconds=0.1))


def test_server_without_response_raises_timeout(server_node: Node, make_node: MakeNode) -> None:
    asked = threading.Event()

    async def never(_handle: Any) -> Any:
        asked.set()
        await buffer_server.Future()

    ActionServer(server_node, LookupTransform, ACTION, never)
    text = r"did not come back in the specified time\. Something is likely wrong with the server\.$"
    with pytest.raises(TimeoutException, match=text):
        padded(make_node("asker")).lookup_transform("world", "robot", LATEST, Duration(seconds=0.1))
    assert asked.is_set()


def test_rejected_goal_raises(server_node: Node, make_node: MakeNode) -> None:
    from tfloom.node.action.server import GoalResponse

    ActionServer(
        server_node, LookupTransform, ACTION, lambda _: None, goal_callback=lambda _: GoalResponse.REJECT
    )
    client = connected(make_node("asker"), timeout_padding=Duration(seconds=10))
    with pytest.raises(TimeoutException, match="did not come back with accepted status"):
        client.lookup_transform("world", "robot", LATEST)


def test_timeout_of_the_reference_server_raises(server_node: Node, make_node: MakeNode) -> None:
    """The reference's server aborts with an empty result of NO_ERROR."""

    def give_up(handle: Any) -> LookupTransform.Result:
        handle.abort()
        return LookupTransform.Result()

    ActionServer(server_node, LookupTransform, ACTION, give_up)
    with pytest.raises(
        TimeoutException, match=r"Timed out after 0\.5 s waiting for the transform from robot to world"
    ):
        patient(make_node("asker")).lookup_transform("world", "robot", LATEST, Duration(seconds=0.5))


def test_unknown_error_code_raises_transform_exception(server_node: Node, make_node: MakeNode) -> None:
    def fail(handle: Any) -> LookupTransform.Result:
        handle.succeed()
        return LookupTransform.Result(error=TF2Error(error=77, error_string="odd"))

    ActionServer(server_node, LookupTransform, ACTION, fail)
    with pytest.raises(TransformException, match=r"^odd$") as raised:
        patient(make_node("asker")).lookup_transform("world", "robot", LATEST)
    assert type(raised.value) is TransformException


def test_client_with_a_node_spun_elsewhere(goals: ActionClient, buffer: Buffer) -> None:
    assert where(connected(goals._node).lookup_transform("world", "robot", at(2)))[0] == 2.0


def test_query_in_a_callback_of_a_single_threaded_executor_raises(
    buffer: Buffer, make_node: MakeNode
) -> None:
    node = make_node("asker")
    client = connected(node)
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        task = executor.create_task(client.lookup_transform, "world", "robot", at(9), PATIENCE)
        with pytest.raises(RuntimeError, match="Use a MultiThreadedExecutor, or a Buffer of your own"):
            executor.spin_until_future_complete(task, 10)
    assert waiting(buffer) == 0  # no request was sent


def test_query_in_a_callback_of_a_multi_threaded_executor(buffer: Buffer, make_node: MakeNode) -> None:
    node = make_node("asker")
    client = connected(node)
    with MultiThreadedExecutor(2, context=node.context) as executor:
        executor.add_node(node)
        task = executor.create_task(client.lookup_transform, "world", "robot", at(2), PATIENCE)
        executor.spin_until_future_complete(task, 10)
        assert where(task.result())[0] == 2.0


def test_shutdown_ends_a_query(client: BufferClient, buffer: Buffer, wait_until: Callable[..., None]) -> None:
    with ThreadPoolExecutor(1) as pool:
        answer = pool.submit(client.lookup_transform, "world", "robot", at(9), Duration(seconds=600))
        wait_until(lambda: waiting(buffer) == 1)
        client.node.context.shutdown()
        with pytest.raises((TimeoutException, ExternalShutdownException)):
            answer.result(20)
