"""A program of a user that ends at a random moment: all that it does, and how it ends, follows from its argument.

`python random_end.py NUMBER`, or `python random_end.py NUMBER what` to print what it would do.
"""

from __future__ import annotations

import os
import random
import signal
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any

WIRES = ("tfloom_local", "rmw_cyclonedds_cpp")
EXECUTORS = ("SingleThreadedExecutor", "MultiThreadedExecutor", "EventsExecutor")
ENDS = ("returns", "exits", "raises", "is interrupted", "raises in a callback")
EXIT_CODE = 7
LONG_S = 1.2
"""Longer than the interpreter's end waits for callbacks."""

NUMBER = int(sys.argv[1])
WIRE = WIRES[NUMBER % 2]
EXECUTOR = EXECUTORS[NUMBER // 2 % 3]
END = ENDS[NUMBER // 6 % 5]
CHOICES = random.Random(NUMBER)
IS_SPUN_BY_A_THREAD = END != "raises in a callback" and CHOICES.random() < 0.6
DELAY_S = CHOICES.choice([0.0, 0.02, 0.1, 0.4]) * CHOICES.random()
SHUTS_DOWN = CHOICES.random() < 0.3
PARTS = CHOICES.sample(
    ["topic", "transforms", "calls", "goals", "codec", "long callback", "long notice"], CHOICES.randint(1, 5)
)

os.environ["RMW_IMPLEMENTATION"] = WIRE
signal.signal(
    signal.SIGINT, signal.default_int_handler
)  # a shell's job in the background inherits that it is ignored

import rclpy  # noqa: E402  # after the selection of the wire
from example_interfaces.action import Fibonacci  # noqa: E402
from example_interfaces.srv import AddTwoInts  # noqa: E402
from geometry_msgs.msg import TransformStamped  # noqa: E402
from rclpy.action import ActionClient, ActionServer  # noqa: E402
from rclpy.callback_groups import ReentrantCallbackGroup  # noqa: E402
from rclpy.duration import Duration  # noqa: E402
from rclpy.node import Node  # noqa: E402
from rclpy.time import Time  # noqa: E402
from sensor_msgs.msg import Imu  # noqa: E402


class OwnError(Exception):
    """What the program raises to end."""


def start(function: Callable[[], object]) -> None:
    """Run a function on a daemon thread, until it raises, as where the context ends."""

    def run() -> None:
        with suppress(Exception):
            while True:
                function()

    threading.Thread(target=run, daemon=True).start()


def add_topic(node: Node) -> None:
    """Publish messages with arrays, whose classes import numpy at their first use, and receive them."""
    publisher = node.create_publisher(Imu, "imu", 10)
    node.create_subscription(Imu, "imu", lambda message: str(message.orientation_covariance), 10)
    node.create_timer(0.002, lambda: publisher.publish(Imu()))


def add_codec(_: Node) -> None:
    """Write and read messages, and make matrices, on a thread."""
    from rclpy.serialization import deserialize_message, serialize_message

    from tfloom import tf2

    def convert() -> None:
        deserialize_message(serialize_message(Imu()), Imu)
        tf2.Transform().matrix()

    start(convert)


def transform(stamp: Any) -> TransformStamped:
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id = "map", "base"
    message.header.stamp = stamp
    message.transform.rotation.w = 1.0
    return message


def add_transforms(node: Node, wait_s: float = 0.0) -> None:
    """Broadcast transforms and wait for them; the wire's thread calls back, for `wait_s`."""
    from tf2_ros import Buffer, TransformBroadcaster, TransformListener

    buffer = Buffer()
    listener = TransformListener(buffer, node)
    broadcaster = TransformBroadcaster(node)
    group = ReentrantCallbackGroup()

    def wait_anew(_: object = None) -> None:
        if _ is not None:
            time.sleep(wait_s)
            buffer.all_frames_as_yaml()
        stamp = Time(nanoseconds=node.get_clock().now().nanoseconds + 1_000_000)
        buffer.wait_for_transform_async("map", "base", stamp).add_done_callback(wait_anew)

    def broadcast() -> None:
        broadcaster.sendTransform(transform(node.get_clock().now().to_msg()))
        buffer.can_transform("map", "base", Time(), Duration(seconds=0))

    node.create_timer(0.002, broadcast, callback_group=group)
    node.listener = listener  # type: ignore[attr-defined]
    wait_anew()


def add_calls(node: Node) -> None:
    """Call a service on a thread."""

    def answer(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        return response

    group = ReentrantCallbackGroup()
    node.create_service(AddTwoInts, "add", answer, callback_group=group)
    client = node.create_client(AddTwoInts, "add", callback_group=group)
    start(lambda: client.wait_for_service() and client.call(AddTwoInts.Request(a=1, b=2)))


def add_goals(node: Node) -> None:
    """Send a goal after the other, with feedback."""
    group = ReentrantCallbackGroup()

    def execute(goal: Any) -> Fibonacci.Result:
        for _ in range(10):
            goal.publish_feedback(Fibonacci.Feedback(sequence=[1, 2]))
            time.sleep(0.002)
        goal.succeed()
        return Fibonacci.Result(sequence=[1, 2, 3])

    node.server = ActionServer(node, Fibonacci, "count", execute, callback_group=group)  # type: ignore[attr-defined]
    client = ActionClient(node, Fibonacci, "count", callback_group=group)

    def send(_: object = None) -> None:
        goal = client.send_goal_async(Fibonacci.Goal(order=3), feedback_callback=str)
        goal.add_done_callback(lambda future: future.result().get_result_async().add_done_callback(send))

    first = node.create_timer(0.001, lambda: first.cancel() or send(), callback_group=group)


def add_long_callback(node: Node) -> None:
    timer = node.create_timer(
        0.001, lambda: timer.cancel() or time.sleep(LONG_S), callback_group=ReentrantCallbackGroup()
    )


ADDED: dict[str, Callable[[Node], None]] = {
    "topic": add_topic,
    "transforms": add_transforms,
    "calls": add_calls,
    "goals": add_goals,
    "codec": add_codec,
    "long callback": add_long_callback,
    "long notice": lambda node: add_transforms(node, LONG_S),
}


def fail() -> None:
    raise OwnError("raised by the program")


def main() -> None:
    rclpy.init()
    node = Node("ends", namespace=f"/p{os.getpid()}")
    executor = getattr(
        __import__(
            "rclpy.experimental" if EXECUTOR == "EventsExecutor" else "rclpy.executors", fromlist=["x"]
        ),
        EXECUTOR,
    )()
    executor.add_node(node)
    for part in PARTS:
        ADDED[part](node)
    if END == "raises in a callback":
        node.create_timer(DELAY_S, fail)
    if END == "is interrupted":
        timer = threading.Timer(DELAY_S, os.kill, (os.getpid(), signal.SIGINT))
        timer.daemon = True
        timer.start()
    end = time.monotonic() + (30.0 if END in {"is interrupted", "raises in a callback"} else DELAY_S)
    if IS_SPUN_BY_A_THREAD:
        start(executor.spin)
        while (left := end - time.monotonic()) > 0:
            time.sleep(left)
    while (left := end - time.monotonic()) > 0:
        executor.spin_once(timeout_sec=left)
    if SHUTS_DOWN:
        rclpy.shutdown()
    if END == "exits":
        sys.exit(EXIT_CODE)
    if END == "raises":
        fail()


if sys.argv[2:] == ["what"]:
    print(
        f"{WIRE}, {EXECUTOR}, {END} after {DELAY_S:.3f} s, thread: {IS_SPUN_BY_A_THREAD}, {', '.join(PARTS)}"
    )
else:
    main()
