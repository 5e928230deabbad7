"""Wrong arguments: the error says what was given and what was meant, near the program's line."""

from __future__ import annotations

import inspect
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

import pytest

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.std_msgs.msg import Empty, String
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.node.base.node_base import NodeBase
from tfloom.node.client_library import spin, spin_once, spin_until_future_complete
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.tf2_ros.buffer import Buffer
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
}


@pytest.mark.parametrize("name", CASES)
def test_error_says_what_was_meant_near_the_line(node: Node, name: str) -> None:
    call, error, text = CASES[name]
    with pytest.raises(error) as caught:
        call(node)
    assert text in str(caught.value)
    folder = str(Path(inspect.getfile(NodeBase)).parents[2])
    frames = [
        frame
        for frame in traceback.extract_tb(caught.value.__traceback__)
        if frame.filename.startswith(folder)
    ]
    assert 1 <= len(frames) <= 2


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
