"""A node that JSON lines on stdin control; tfloom and the real rclpy run it unchanged: `end.py NAME --ros-args …`.

Each line is a verb of `End` with its arguments; each answer is a line `= JSON`. Ends with its input.
"""

from __future__ import annotations

import array
import contextlib
import json
import queue
import sys
import threading
import time
import traceback
import zlib
from typing import Any

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.time import Time


class Text:
    """std_msgs/msg/String: its text."""

    def __init__(self) -> None:
        from std_msgs.msg import String

        self.type = String

    def make(self, value: str) -> Any:
        return self.type(data=value)

    def read(self, message: Any) -> str:
        return message.data


class Number:
    """std_msgs/msg/Int64: its number."""

    def __init__(self) -> None:
        from std_msgs.msg import Int64

        self.type = Int64

    def make(self, value: int) -> Any:
        return self.type(data=value)

    def read(self, message: Any) -> int:
        return message.data


class Octets:
    """std_msgs/msg/UInt8MultiArray: a number and a size; read as both with the checksum of the octets."""

    def __init__(self) -> None:
        from std_msgs.msg import UInt8MultiArray

        self.type = UInt8MultiArray

    def make(self, value: list[int]) -> Any:
        number, size = value
        octets = (bytes(range(256)) * (size // 256 + 1))[number % 256 :][:size]
        message = self.type(data=array.array("B", octets))
        message.layout.data_offset = number
        return message

    def read(self, message: Any) -> list[int]:
        return [message.layout.data_offset, len(message.data), zlib.crc32(bytes(message.data))]


class Transforms:
    """tf2_msgs/msg/TFMessage: of each transform its frames, its stamp [ns] and its x."""

    def __init__(self) -> None:
        from tf2_msgs.msg import TFMessage

        self.type = TFMessage

    def make(self, value: list[list[Any]]) -> Any:
        return self.type(transforms=[transform(*item) for item in value])

    def read(self, message: Any) -> list[list[Any]]:
        return [
            [
                stamped.header.frame_id,
                stamped.child_frame_id,
                Time.from_msg(stamped.header.stamp).nanoseconds,
                stamped.transform.translation.x,
            ]
            for stamped in message.transforms
        ]


class Clock:
    """rosgraph_msgs/msg/Clock: its time [ns]."""

    def __init__(self) -> None:
        from rosgraph_msgs.msg import Clock as ClockMessage

        self.type = ClockMessage

    def make(self, value: int) -> Any:
        return self.type(clock=Time(nanoseconds=value).to_msg())

    def read(self, message: Any) -> int:
        return Time.from_msg(message.clock).nanoseconds


KINDS = {"text": Text, "number": Number, "octets": Octets, "transforms": Transforms, "clock": Clock}


def transform(frame_id: str, child_frame_id: str, stamp_ns: int, x: float) -> Any:
    """Return a geometry_msgs/msg/TransformStamped without a rotation."""
    from geometry_msgs.msg import TransformStamped

    message = TransformStamped(child_frame_id=child_frame_id)
    message.header.frame_id = frame_id
    message.header.stamp = Time(nanoseconds=stamp_ns).to_msg()
    message.transform.translation.x = x
    message.transform.rotation.w = 1.0
    return message


def profile(reliability: str = "RELIABLE", durability: str = "VOLATILE", depth: int = 10) -> QoSProfile:
    """Return a profile from the names of its policies."""
    return QoSProfile(
        reliability=ReliabilityPolicy[reliability],
        durability=DurabilityPolicy[durability],
        history=HistoryPolicy.KEEP_LAST,
        depth=depth,
    )


class End:
    """The node, its publishers and subscriptions by their keys, and what it has received."""

    def __init__(self, node: Node) -> None:
        self.node = node
        self._kinds: dict[str, Any] = {}
        self._ends: dict[str, Any] = {}
        self._received: dict[str, list[Any]] = {}
        self._incompatible: dict[str, list[str]] = {}
        self._stop_stream = threading.Event()
        self._streams: list[threading.Thread] = []

    def publisher(self, key: str, kind: str, topic: str, qos: dict[str, Any]) -> None:
        self._kinds[key] = KINDS[kind]()
        events = PublisherEventCallbacks(incompatible_qos=self._on_incompatible(key))
        self._ends[key] = self.node.create_publisher(
            self._kinds[key].type, topic, profile(**qos), event_callbacks=events
        )

    def subscription(self, key: str, kind: str, topic: str, qos: dict[str, Any]) -> None:
        self._kinds[key] = KINDS[kind]()
        received = self._received[key] = []
        events = SubscriptionEventCallbacks(incompatible_qos=self._on_incompatible(key))
        read = self._kinds[key].read
        self._ends[key] = self.node.create_subscription(
            self._kinds[key].type,
            topic,
            lambda message: received.append(read(message)),
            profile(**qos),
            event_callbacks=events,
        )

    def _on_incompatible(self, key: str) -> Any:
        policies = self._incompatible[key] = []
        return lambda info: policies.append(info.last_policy_kind.name.removeprefix("RMW_QOS_POLICY_"))

    def close(self, key: str) -> None:
        end = self._ends.pop(key)
        if hasattr(end, "publish"):
            self.node.destroy_publisher(end)
        else:
            self.node.destroy_subscription(end)

    def matches(self, key: str) -> int:
        end = self._ends[key]
        return end.get_subscription_count() if hasattr(end, "publish") else end.get_publisher_count()

    def incompatible(self, key: str) -> list[str]:
        return self._incompatible[key]

    def publish(self, key: str, *values: Any) -> None:
        for value in values:
            self._ends[key].publish(self._kinds[key].make(value))

    def acknowledged(self, key: str, timeout_s: float) -> bool:
        return self._ends[key].wait_for_all_acked(Duration(seconds=timeout_s))

    def stream(self, key: str, hz: float, count: int | None = None) -> None:
        """Publish numbers from 0 at a rate, on a thread, `count` of them or without an end."""

        def run() -> None:
            start = time.monotonic()
            number = 0
            while number != count and not self._stop_stream.wait(
                max(0.0, start + number / hz - time.monotonic())
            ):
                self.publish(key, number)
                number += 1

        self._streams.append(threading.Thread(target=run))
        self._streams[-1].start()

    def end_streams(self) -> None:
        self._stop_stream.set()
        for stream in self._streams:
            stream.join()

    def received(self, key: str) -> list[Any]:
        return self._received[key]

    def count(self, key: str) -> int:
        return len(self._received[key])

    def forget(self, key: str) -> None:
        self._received[key].clear()

    def nodes(self) -> list[str]:
        names = self.node.get_node_names_and_namespaces()
        return sorted(f"{namespace.rstrip('/')}/{name}" for name, namespace in names)

    def topics(self) -> dict[str, list[str]]:
        return dict(self.node.get_topic_names_and_types())

    def endpoints(self, topic: str) -> list[dict[str, Any]]:
        both = (self.node.get_publishers_info_by_topic, self.node.get_subscriptions_info_by_topic)
        return [
            {
                "kind": info.endpoint_type.name,
                "node": f"{info.node_namespace.rstrip('/')}/{info.node_name}",
                "type": info.topic_type,
                "hash": str(info.topic_type_hash),
                "reliability": info.qos_profile.reliability.name,
                "durability": info.qos_profile.durability.name,
            }
            for get in both
            for info in get(topic)
        ]

    def now_ns(self) -> int:
        return self.node.get_clock().now().nanoseconds

    def listen_to_transforms(self) -> None:
        from tf2_ros import Buffer, TransformListener

        self._buffer = Buffer()
        self._listener = TransformListener(self._buffer, self.node)

    def look_up(self, target: str, source: str, stamp_ns: int = 0) -> float | None:
        """Return the x of a transform; None while it is unknown."""
        stamp = Time(nanoseconds=stamp_ns)
        if not self._buffer.can_transform(target, source, stamp):
            return None
        return self._buffer.lookup_transform(target, source, stamp).transform.translation.x

    def broadcast(self, transforms: list[list[Any]], static: bool = False) -> None:
        from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

        kind = StaticTransformBroadcaster if static else TransformBroadcaster
        name = kind.__name__
        if name not in self._ends:
            self._ends[name] = kind(self.node)
        self._ends[name].sendTransform([transform(*item) for item in transforms])


def answer(end: End, line: str) -> None:
    """Run a line's verb and print its answer."""
    verb, *arguments = json.loads(line)
    try:
        result = getattr(end, verb)(*arguments)
    except Exception:  # noqa: BLE001  # the other side shows it
        result = {"error": traceback.format_exc()}
    sys.stdout.write(f"= {json.dumps(result)}\n")
    sys.stdout.flush()


def main() -> None:
    rclpy.init(args=sys.argv)
    node = Node(sys.argv[1])
    end = End(node)
    lines: queue.SimpleQueue[str] = queue.SimpleQueue()

    def run_lines() -> None:
        """Answer the lines that have arrived; after `hold`, also those up to `resume`, without spinning."""
        holding = False
        while holding or not lines.empty():
            line = lines.get()
            if not line:
                rclpy.try_shutdown()
                return
            verb = json.loads(line)[0]
            if verb in {"hold", "resume"}:
                holding = verb == "hold"
                print("= null", flush=True)
            else:
                answer(end, line)

    arrived = node.create_guard_condition(run_lines)

    def read_lines() -> None:
        for line in sys.stdin:
            lines.put(line)
            arrived.trigger()
        lines.put("")
        arrived.trigger()

    threading.Thread(target=read_lines, daemon=True).start()
    print("= null", flush=True)
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node)
    end.end_streams()
    node.destroy_node()
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
