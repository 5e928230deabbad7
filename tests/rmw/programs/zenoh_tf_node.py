"""A node that sends /tf, or hears it, at one end of a link; argument: `sender` or `receiver`.

A line on stdin is a command; its answer begins with the same word.

- sender: `send N TRANSFORMS PERIOD` sends N messages with a period [s], each with a number in its first translation,
  and prints `send FIRST`, the number of the first; `tick` sends one each 10 ms from now on. /tf_static is sent once.
- receiver: `count FIRST` prints `count N LOST`: the messages that came since that number, and what the event
  `message_lost` has counted; `tree` waits for a chain over /tf_static and a new /tf, and prints `tree SECONDS`.
"""

from __future__ import annotations

import sys
import threading
import time
from typing import Any

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformException, TransformListener

DEPTH = 100


class Sender:
    """Sends numbered messages."""

    def __init__(self, node: Node) -> None:
        self._clock = node.get_clock()
        self._publisher = node.create_publisher(TFMessage, "/tf", DEPTH)
        self._static = StaticTransformBroadcaster(node)
        self._static.sendTransform(self._transform("map", "odom", 0))
        self._number = 0
        self._message = TFMessage()
        """Sent again and again, with the number and the time in its first transform."""

    def _transform(self, parent: str, child: str, number: int) -> TransformStamped:
        transform = TransformStamped(child_frame_id=child)
        transform.header.frame_id = parent
        transform.header.stamp = self._clock.now().to_msg()
        transform.transform.translation.x = float(number)
        return transform

    def _send_one(self, count: int) -> None:
        self._number += 1
        transforms = self._message.transforms
        if len(transforms) != count:
            transforms[:] = [self._transform("odom", f"base_{index}", 0) for index in range(count)]
        transforms[0] = self._transform("odom", "base_0", self._number)
        self._publisher.publish(self._message)

    def send(self, count: str, transforms: str, period_s: str) -> None:
        first, start_s = self._number + 1, time.monotonic()
        for index in range(int(count)):
            self._send_one(int(transforms))
            time.sleep(max(0.0, start_s + (index + 1) * float(period_s) - time.monotonic()))
        print("send", first, flush=True)

    def tick(self) -> None:
        threading.Thread(target=self._tick, daemon=True).start()
        print("tick", flush=True)

    def _tick(self) -> None:
        while True:
            self._send_one(10)
            time.sleep(0.01)


class Receiver:
    """Counts messages, and has a buffer of them."""

    def __init__(self, node: Node) -> None:
        self._clock = node.get_clock()
        self._numbers: list[int] = []
        self._lost = 0
        self._buffer = Buffer()
        self._listener = TransformListener(self._buffer, node)
        events = SubscriptionEventCallbacks(message_lost=self._on_lost)
        self._subscription = node.create_subscription(
            TFMessage, "/tf", self._on_message, DEPTH, event_callbacks=events
        )

    def _on_message(self, message: TFMessage) -> None:
        self._numbers.append(int(message.transforms[0].transform.translation.x))

    def _on_lost(self, event: Any) -> None:
        self._lost = event.total_count

    def count(self, first: str) -> None:
        print("count", sum(number >= int(first) for number in self._numbers), self._lost, flush=True)

    def tree(self) -> None:
        start_s, start = time.monotonic(), self._clock.now()
        while True:
            try:
                found = self._buffer.lookup_transform("map", "base_0", Time())
                if Time.from_msg(found.header.stamp) > start:
                    break
            except TransformException:
                pass
            time.sleep(0.01)
        print("tree", time.monotonic() - start_s, flush=True)


rclpy.init()
node = rclpy.create_node(sys.argv[1])
role = {"sender": Sender, "receiver": Receiver}[sys.argv[1]](node)
executor = SingleThreadedExecutor()
executor.add_node(node)
threading.Thread(target=executor.spin, daemon=True).start()
print("ready", flush=True)
for line in sys.stdin:
    verb, *words = line.split()
    getattr(role, verb)(*words)
