"""Wrong arguments: the error says what was given and what was meant, near the program's line."""

from __future__ import annotations

import inspect
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

import pytest

from tfloom.interfaces.geometry_msgs.msg import TransformStamped, Twist
from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.interfaces.std_msgs.msg import Empty, Header, String
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.node.base.node_base import NodeBase
from tfloom.node.client_library import spin, spin_once, spin_until_future_complete
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import TransformListener

NONE = "got None: if it is the result of a call, as of `callback()`, write `callback`, without brackets"
ANY = cast("Any", None)
CASES: dict[str, tuple[Callable[[Node], object], type[Exception], str]] = {
    "text": (
        lambda node: node.create_publisher(String, "a", 1).publish(cast("Any", "hello")),
        TypeError,
        "got <class 'str'>: publish a message, String(data='hello')",
    ),
    "nothing": (
        lambda node: node.create_publisher(String, "a", 1).publish(ANY),
        TypeError,
        "got <class 'NoneType'>: publish a message, String(data=…)",
    ),
    "fields": (
        lambda node: node.create_publisher(Twist, "a", 1).publish(cast("Any", 2.0)),
        TypeError,
        "got <class 'float'>: publish a message, Twist(linear=…, angular=…)",
    ),
    "class": (
        lambda node: node.create_publisher(String, "a", 1).publish(cast("Any", String)),
        TypeError,
        ": publish a message, String(…), not its class",
    ),
    "time of rclpy": (
        lambda node: node.create_publisher(Header, "a", 1).publish(
            Header(stamp=cast("Any", Time(seconds=1)))
        ),
        ValueError,
        "got Time(nanoseconds=1000000000, clock_type=SYSTEM_TIME) (Time): append .to_msg()",
    ),
    "array of texts": (
        lambda _node: LaserScan(ranges=cast("Any", ["far"])),
        TypeError,
        "must be real number, not str: LaserScan.ranges is float32[], got ['far'] of class list",
    ),
    "no array": (
        lambda _node: LaserScan(ranges=ANY),
        TypeError,
        "LaserScan.ranges is float32[], got None of class NoneType",
    ),
    "other message": (
        lambda node: node.create_publisher(String, "a", 1).publish(cast("Any", Twist())),
        TypeError,
        ": this topic has std_msgs.msg.String",
    ),
    "without fields": (
        lambda node: node.create_publisher(Empty, "a", 1).publish(cast("Any", "x")),
        TypeError,
        ": this topic has std_msgs.msg.Empty",
    ),
    "subscription": (lambda node: node.create_subscription(String, "a", ANY, 1), RuntimeError, NONE),
    "arguments": (
        lambda node: node.create_subscription(String, "a", lambda _a, _b, _c: None, 1),
        RuntimeError,
        "callable with one argument(to get only the message) or two (to get message and message info); got <function",
    ),
    "service": (lambda node: node.create_service(SetBool, "a", ANY), TypeError, NONE),
    "timer": (
        lambda node: node.create_timer(1.0, cast("Any", "f")),
        TypeError,
        "create_timer() needs a callback, got 'f' of class str, which can't be called",
    ),
    "before setting": (lambda node: node.add_pre_set_parameters_callback(ANY), TypeError, NONE),
    "on setting": (lambda node: node.add_on_set_parameters_callback(ANY), TypeError, NONE),
    "after setting": (lambda node: node.add_post_set_parameters_callback(ANY), TypeError, NONE),
    "type": (
        lambda node: node.create_publisher(cast("Any", "x"), "a", 1),
        AttributeError,
        "got 'x' of class str",
    ),
    "depth": (
        lambda node: node.create_publisher(String, "a", cast("Any", "10")),
        TypeError,
        "received <class 'str'>: a depth is a number, as 10",
    ),
    "topic": (lambda node: node.create_publisher(String, "a b", 1), ValueError, "Invalid topic name"),
    "no name": (lambda node: node.create_publisher(String, ANY, 1), TypeError, "a topic name must be a str"),
    "subscribed": (
        lambda node: node.create_subscription(String, "a b", print, 1),
        ValueError,
        "Invalid topic name",
    ),
    "served": (
        lambda node: node.create_service(SetBool, "a b", print),
        ValueError,
        "Invalid service name",
    ),
    "client": (lambda node: node.create_client(SetBool, "a b"), ValueError, "Invalid service name"),
    "node name": (lambda node: Node("a b", context=node.context), ValueError, "Invalid node name"),
    "no node name": (lambda node: Node(ANY, context=node.context), TypeError, "a node name must be a str"),
    "parameter": (
        lambda node: node.declare_parameter("p", {"a": 1}),
        TypeError,
        "DOUBLE_ARRAY, STRING_ARRAY'. It is {'a': 1} of class dict.",
    ),
    "spin": (lambda _node: spin(ANY), TypeError, "spin() needs a node, got None: does the function"),
    "spin for seconds": (
        lambda node: spin(node, cast("Any", 5)),
        TypeError,
        "spin() needs an executor, got 5 of class int",
    ),
    "spin by a class": (
        lambda node: spin_once(node, executor=cast("Any", SingleThreadedExecutor)),
        TypeError,
        "spin_once() needs an executor, got the class SingleThreadedExecutor: write SingleThreadedExecutor()",
    ),
    "spin until, for seconds": (
        lambda node: spin_until_future_complete(node, Future(), cast("Any", 5)),
        TypeError,
        "spin_until_future_complete() needs an executor, got 5 of class int",
    ),
    "spin once": (lambda _node: spin_once(ANY), TypeError, "spin_once() needs a node"),
    "future": (
        lambda node: spin_until_future_complete(node, ANY),
        TypeError,
        "needs a future, as `call_async` returns it, got None",
    ),
    "no node": (lambda _node: spin_until_future_complete(ANY, ANY), TypeError, "needs a node, got None"),
    "listener": (
        lambda node: TransformListener(node, node),
        TypeError,
        "TransformListener(buffer, node) needs a tf2_ros.Buffer first",
    ),
    "transform": (
        lambda _node: Buffer().set_transform(None, "me"),
        TypeError,
        "set_transform() needs a geometry_msgs.msg.TransformStamped, got None",
    ),
    "static transform": (
        lambda _node: Buffer().set_transform_static("x", "me"),
        TypeError,
        "set_transform_static() needs a geometry_msgs.msg.TransformStamped, got 'x'",
    ),
    "authority": (
        lambda _node: Buffer().set_transform(TransformStamped(), ANY),
        TypeError,
        "the name of a frame or a publisher must be a str, not None of class NoneType",
    ),
    "broadcaster": (
        lambda _node: TransformBroadcaster(ANY),
        TypeError,
        "TransformBroadcaster(node) needs the node that publishes, got None",
    ),
    "static broadcaster": (
        lambda _node: StaticTransformBroadcaster(cast("Any", "x")),
        TypeError,
        "StaticTransformBroadcaster(node) needs the node that publishes, got 'x'",
    ),
    "sent": (
        lambda node: TransformBroadcaster(node).sendTransform(ANY),
        TypeError,
        "sendTransform() needs a geometry_msgs.msg.TransformStamped, or several, got None of class NoneType",
    ),
    "sent statically": (
        lambda node: StaticTransformBroadcaster(node).sendTransform(
            [TransformStamped(), cast("Any", Twist())]
        ),
        TypeError,
        "of class Twist",
    ),
    "rate": (
        lambda node: node.create_rate(cast("Any", "x")),
        TypeError,
        "create_rate() needs a frequency in Hz, as 0.5, got 'x' of class str",
    ),
    "period": (
        lambda node: node.create_timer(ANY, print),
        TypeError,
        "create_timer() needs a period in seconds, as 0.5, got None of class NoneType",
    ),
    "period as text": (
        lambda node: node.create_timer(cast("Any", "fast"), print),
        ValueError,
        "create_timer() needs a period in seconds, as 0.5, got 'fast' of class str",
    ),
    "duration": (
        lambda _node: Duration(seconds=cast("Any", "2")),
        ValueError,
        "Duration needs seconds, as 0.5, got '2' of class str",
    ),
    "frame": (
        lambda _node: Buffer().lookup_transform("a", ANY, Time()),
        TypeError,
        "the name of a frame or a publisher must be a str, not None of class NoneType",
    ),
}
TIMES: dict[str, tuple[Callable[[], object], str]] = {
    "time": (
        lambda: Buffer().lookup_transform("a", "b", 1.5),
        "got 1.5 of class float: write rclpy.time.Time(seconds=1.5), or Time() for the latest transform",
    ),
    "other time": (
        lambda: Buffer().lookup_transform_full("a", Time(), "b", "now", "c"),
        "got 'now' of class str: write rclpy.time.Time(seconds=…), or Time() for the latest transform",
    ),
    "asked time": (lambda: Buffer().can_transform("a", "b", None), "got None of class NoneType: write"),
    "awaited time": (lambda: Buffer().wait_for_transform_async("a", "b", 1), "rclpy.time.Time(seconds=1)"),
    "timeout": (
        lambda: Buffer().lookup_transform("a", "b", Time(), timeout=1.5),
        "got 1.5 of class float: write rclpy.duration.Duration(seconds=1.5)",
    ),
    "asked timeout": (
        lambda: Buffer().can_transform("a", "b", Time(), 2),
        "got 2 of class int: write rclpy.duration.Duration(seconds=2)",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_error_says_what_was_meant_near_the_line(node: Node, name: str) -> None:
    call, error, text = CASES[name]
    with pytest.raises(error) as caught:
        call(node)
    assert text in str(caught.value)
    assert 1 <= _frames_of_tfloom(caught.value) <= 2


@pytest.mark.parametrize("name", TIMES)
def test_number_in_place_of_a_time_has_a_note(name: str) -> None:
    """The text is the reference's."""
    call, note = TIMES[name]
    with pytest.raises(TypeError) as caught:
        call()
    assert str(caught.value) in {
        f"{kind} must have sec and nanosec, or nanoseconds." for kind in ("time", "duration")
    }
    (given,) = cast("Any", caught.value).__notes__
    assert note in given
    assert 1 <= _frames_of_tfloom(caught.value) <= 2


def test_wait_with_a_wrong_timeout_leaves_no_request() -> None:
    buffer = Buffer()
    with pytest.raises(TypeError):
        buffer.wait_for_transform_async("a", "b", Time(), 1.5)
    transform = TransformStamped(child_frame_id="b")
    transform.header.frame_id = "a"
    transform.transform.rotation.w = 1.0
    buffer.set_transform(transform, "me")
    assert not buffer.cancel_request(1)


def _frames_of_tfloom(error: BaseException) -> int:
    folder = str(Path(inspect.getfile(NodeBase)).parents[2])
    frames = traceback.extract_tb(error.__traceback__)
    return sum(frame.filename.startswith(folder) for frame in frames)


def test_timer_without_a_callback_warns(node: Node) -> None:
    """It is no error, because the reference accepts it; a rate has such a timer."""
    with pytest.warns(UserWarning, match="without brackets") as caught:
        node.create_timer(1.0, None)
    assert caught[0].filename == __file__
    node.create_rate(10.0)


def test_callback_of_parameters_that_returns_nothing_is_named(node: Node) -> None:
    def without_a_return(_parameters: list[Parameter]) -> None:
        pass

    node.declare_parameter("speed", 1.0)
    node.add_on_set_parameters_callback(cast("Any", without_a_return))
    with pytest.raises(AttributeError, match=r"without_a_return.* SetParametersResult\(successful=True\)"):
        node.set_parameters([Parameter("speed", value=2.0)])
    assert node.get_parameter("speed").value == 1.0
