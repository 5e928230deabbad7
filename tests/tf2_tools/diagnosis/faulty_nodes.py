"""Nodes that publish transforms with one fault each, for the tests of `tfloom tf doctor`.

As a program, `faulty_nodes.py [FAULT ...]` runs the named faults, all, or `none`, until its input ends. Each fault
belongs to a node `/faults/FAULT`, or to several whose names begin so, and has frames below `FAULT/`: all can share
one tree.
"""

from __future__ import annotations

import math
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from itertools import count

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Participant, Writer
from tfloom.rmw.qos import DurabilityPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr

TICK_S = 0.02
"""Period of the faults' steps [s]."""
S = 1_000_000_000
LATCHED = QoS(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
Steps = Iterator[None]
Rotation = tuple[float, float, float, float]


class Node:
    """A named node that writes transforms, whatever they hold."""

    def __init__(self, participant: Participant, name: str) -> None:
        self.participant = participant
        self.name = NodeName("/faults", name)
        participant.add_node(self.name)
        self._writers: dict[str, Writer] = {}

    def writer(self, topic: str, message_class: type = TFMessage, qos: QoS | None = None) -> Writer:
        """Return the node's writer of a topic; the first call decides its type and quality."""
        if topic not in self._writers:
            profile = qos or (LATCHED if topic == "/tf_static" else QoS(depth=100))
            self._writers[topic] = self.participant.create_writer(
                self.name, topic_of(message_class, topic), profile
            )
        return self._writers[topic]

    def send(self, *transforms: TransformStamped, topic: str = "/tf", qos: QoS | None = None) -> None:
        """Write one message."""
        self.writer(topic, qos=qos).write(cdr.encode(TFMessage(transforms=list(transforms))))


def edge(
    parent: str,
    child: str,
    *,
    stamp_ns: int | None = None,
    x: float | None = None,
    rotation: Rotation = (0.0, 0.0, 0.0, 1.0),
) -> TransformStamped:
    """Return a transform stamped now that moves slowly, unless `x` fixes it."""
    stamp_ns = time.time_ns() if stamp_ns is None else stamp_ns
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id = parent, child
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(stamp_ns, S)
    message.transform.translation.x = math.sin(time.time()) if x is None else x
    r = message.transform.rotation
    r.x, r.y, r.z, r.w = rotation
    return message


def send_steadily(
    node: Node, *edges: tuple[str, str], topic: str = "/tf", qos: QoS | None = None, **options: object
) -> Steps:
    """Publish edges at each step, which move unless `options` fix them."""
    while True:
        node.send(*(edge(*arguments, **options) for arguments in edges), topic=topic, qos=qos)  # type: ignore[arg-type]
        yield


def write_steadily(writer: Writer, data: bytes) -> Steps:
    """Write the same bytes at each step."""
    while True:
        writer.write(data)
        yield


def scan_in(frame: str) -> bytes:
    """Return a scan in this frame, as bytes."""
    scan = LaserScan()
    scan.header.frame_id = frame
    return cdr.encode(scan)


def clean(participant: Participant) -> Steps:
    """Publish a sound tree with the frames of REP 105, and data in one of its frames."""
    node = Node(participant, "clean")
    node.send(edge("base_link", "laser", x=0.2), topic="/tf_static")
    scans = node.writer("/clean_scan", LaserScan)
    for _ in send_steadily(node, ("earth", "map"), ("map", "odom"), ("odom", "base_link")):
        scans.write(scan_in("laser"))
        yield


def trunk(participant: Participant) -> Steps:
    """Join the trees of `clean` and of the faults."""
    Node(participant, "trunk").send(edge("world", "earth", x=0.0), topic="/tf_static")
    while True:
        yield


def several_publishers(participant: Participant) -> Steps:
    """Publish one frame from two nodes."""
    nodes = [Node(participant, f"several_publishers_{letter}") for letter in "ab"]
    while True:
        for x, node in enumerate(nodes):
            node.send(edge("world", "several_publishers/base", x=x + math.sin(time.time())))
        yield


def static_and_dynamic(participant: Participant) -> Steps:
    """Publish one edge on both topics, from two nodes."""
    mounting = Node(participant, "static_and_dynamic_mounting")
    mounting.send(edge("world", "static_and_dynamic/arm", x=1.0), topic="/tf_static")
    return send_steadily(Node(participant, "static_and_dynamic_joint"), ("world", "static_and_dynamic/arm"))


def reparenting(participant: Participant) -> Steps:
    """Change the parent of a frame at each step."""
    node = Node(participant, "reparenting")
    anchors = [f"reparenting/{letter}" for letter in "ab"]
    node.send(*(edge("world", anchor, x=0.0) for anchor in anchors), topic="/tf_static")
    for step in count():
        node.send(edge(anchors[step % 2], "reparenting/cup"))
        yield


def loop(participant: Participant) -> Steps:
    """Publish three frames in a ring."""
    a, b, c = (f"loop/{letter}" for letter in "abc")
    return send_steadily(Node(participant, "loop"), (a, b), (b, c), (c, a))


def disconnected(participant: Participant) -> Steps:
    """Publish a frame that hangs on no other's root."""
    return send_steadily(
        Node(participant, "disconnected"),
        ("world", "disconnected/here"),
        ("disconnected/island", "disconnected/there"),
    )


def self_transform(participant: Participant) -> Steps:
    """Publish a frame as its own parent."""
    return send_steadily(Node(participant, "self_transform"), ("self_transform/a", "self_transform/a"))


def empty_frame_id(participant: Participant) -> Steps:
    """Publish a transform without a child."""
    return send_steadily(Node(participant, "empty_frame_id"), ("world", ""))


def leading_slash(participant: Participant) -> Steps:
    """Publish frame ids of ROS 1's form."""
    return send_steadily(Node(participant, "leading_slash"), ("/world", "/leading_slash/base"))


def rep105_order(participant: Participant) -> Steps:
    """Publish a robot's map below its odom."""
    odom, outer, base = (f"rep105_order/{name}" for name in ("odom", "map", "base_link"))
    return send_steadily(Node(participant, "rep105_order"), ("world", odom), (odom, outer), (outer, base))


def rep105_name(participant: Participant) -> Steps:
    """Publish a base frame in another spelling."""
    return send_steadily(Node(participant, "rep105_name"), ("world", "rep105_name/Base-Link"))


def not_finite(participant: Participant) -> Steps:
    """Publish a NaN in every other message."""
    node = Node(participant, "not_finite")
    for step in count():
        node.send(edge("world", "not_finite/base", x=math.nan if step % 2 else None))
        yield


def not_unit(participant: Participant) -> Steps:
    """Publish a quaternion without its w."""
    return send_steadily(
        Node(participant, "not_unit"), ("world", "not_unit/base"), rotation=(0.0, 0.0, 0.3, 0.0)
    )


def teleport(participant: Participant) -> Steps:
    """Move a frame by 30 m from one step to the next, each second."""
    node = Node(participant, "teleport")
    for step in count():
        node.send(edge("world", "teleport/base", x=30.0 * (step // 50 % 2) + 0.01 * math.sin(time.time())))
        yield


def zero_stamps(participant: Participant) -> Steps:
    """Publish a moving frame without a stamp."""
    return send_steadily(Node(participant, "zero_stamps"), ("world", "zero_stamps/base"), stamp_ns=0)


def ahead(participant: Participant) -> Steps:
    """Publish one of two frames with stamps 2 s ahead."""
    node = Node(participant, "ahead")
    while True:
        node.send(edge("world", "ahead/now"))
        node.send(edge("world", "ahead/predicted", stamp_ns=time.time_ns() + 2 * S))
        yield


def skew(participant: Participant) -> Steps:
    """Publish all frames with stamps 3 s late."""
    node = Node(participant, "skew")
    while True:
        late_ns = time.time_ns() - 3 * S
        node.send(edge("world", "skew/base", stamp_ns=late_ns), edge("world", "skew/arm", stamp_ns=late_ns))
        yield


def send_in_bursts(participant: Participant, name: str, length: int, period: int) -> Steps:
    """Publish a frame in the first `length` steps of each `period` of them."""
    node = Node(participant, name)
    for step in count():
        if step % period < length:
            node.send(edge("world", f"{name}/base"))
        yield


def low_rate(participant: Participant) -> Steps:
    """Publish a frame each 0.6 s."""
    return send_in_bursts(participant, "low_rate", 1, 30)


def jitter(participant: Participant) -> Steps:
    """Publish in five of sixteen steps in a row, then not."""
    return send_in_bursts(participant, "jitter", 5, 16)


def gap(participant: Participant) -> Steps:
    """Publish with a pause of 1 s in every 1.4 s."""
    return send_in_bursts(participant, "gap", 20, 70)


def old_data(participant: Participant) -> Steps:
    """Publish in between transforms of 20 s ago."""
    node = Node(participant, "old_data")
    for step in count():
        node.send(edge("world", "old_data/base"))
        if step % 10 == 9:
            node.send(edge("world", "old_data/base", stamp_ns=time.time_ns() - 20 * S))
        yield


def time_jump(participant: Participant) -> Steps:
    """Publish stamps that go back by a minute each second, and on from there."""
    node = Node(participant, "time_jump")
    for step in count():
        node.send(edge("world", "time_jump/base", stamp_ns=time.time_ns() - 60 * S * (step // 50)))
        yield


def static_on_tf(participant: Participant) -> Steps:
    """Publish a fixed mounting on /tf."""
    return send_steadily(Node(participant, "static_on_tf"), ("world", "static_on_tf/camera"), x=0.5)


def dynamic_on_tf_static(participant: Participant) -> Steps:
    """Publish a moving frame on /tf_static."""
    node = Node(participant, "dynamic_on_tf_static")
    return send_steadily(node, ("world", "dynamic_on_tf_static/base"), topic="/tf_static")


def volatile_static(participant: Participant) -> Steps:
    """Publish a fixed mounting on /tf_static without keeping it for late subscriptions."""
    node, edge_ids = Node(participant, "volatile_static"), ("world", "volatile_static/camera")
    return send_steadily(node, edge_ids, topic="/tf_static", qos=QoS(depth=100), x=0.5)


def best_effort(participant: Participant) -> Steps:
    """Publish a moving frame at best effort."""
    lossy = QoS(depth=100, reliability=ReliabilityPolicy.BEST_EFFORT)
    return send_steadily(Node(participant, "best_effort"), ("world", "best_effort/base"), qos=lossy)


def volatile_reader(participant: Participant) -> Steps:
    """Subscribe to /tf_static without asking for what was published before."""
    node = Node(participant, "volatile_reader")
    reader = participant.create_reader(node.name, topic_of(TFMessage, "/tf_static"), QoS(depth=100))
    while True:
        reader.take()
        yield


def unreadable(participant: Participant) -> Steps:
    """Publish bytes that are not a TFMessage."""
    writer = Node(participant, "unreadable").writer("/tf")
    return write_steadily(writer, bytes((0, 1, 0, 0)) + b"\xff" * 16)


def other_type(participant: Participant) -> Steps:
    """Publish texts on /tf."""
    writer = Node(participant, "other_type").writer("/tf", String)
    return write_steadily(writer, cdr.encode(String(data="no transform")))


def unknown_header(participant: Participant) -> Steps:
    """Publish scans in a frame that nobody publishes."""
    writer = Node(participant, "unknown_header").writer("/unknown_header_scan", LaserScan)
    return write_steadily(writer, scan_in("unknown_header/laser"))


def listener(participant: Participant) -> Steps:
    """Subscribe to both topics as tf2's listeners do."""
    node = Node(participant, "listener")
    readers = [
        participant.create_reader(node.name, topic_of(TFMessage, "/tf"), QoS(depth=100)),
        participant.create_reader(node.name, topic_of(TFMessage, "/tf_static"), LATCHED),
    ]
    while True:
        for reader in readers:
            while reader.take():
                pass
        yield


SOUND: dict[str, Callable[[Participant], Steps]] = {
    scene.__name__: scene for scene in (clean, trunk, listener)
}
"""What every run has."""

FAULTS: dict[str, Callable[[Participant], Steps]] = {
    scene.__name__: scene
    for scene in (
        *(several_publishers, static_and_dynamic, reparenting, loop, disconnected, self_transform),
        *(empty_frame_id, leading_slash, rep105_order, rep105_name, not_finite, not_unit, teleport),
        *(zero_stamps, ahead, skew, low_rate, jitter, gap, old_data, time_jump, static_on_tf),
        *(dynamic_on_tf_static, volatile_static, best_effort, volatile_reader, unreadable, other_type),
        unknown_header,
    )
}


def main(names: list[str]) -> None:
    """Run faults until standard input ends."""
    participant = open_participant()
    started = [(SOUND | FAULTS)[name](participant) for name in (*SOUND, *names)]
    ended = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.read(), ended.set()), daemon=True).start()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: ended.set())
    print("ready", flush=True)
    next_s = time.monotonic()
    while not ended.is_set():
        for steps in started:
            next(steps)
        next_s = max(next_s + TICK_S, time.monotonic())
        ended.wait(next_s - time.monotonic())
    participant.close()


if __name__ == "__main__":
    main([name for name in sys.argv[1:] or FAULTS if name != "none"])
