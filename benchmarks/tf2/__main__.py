"""Lookups, inserts and points: tfloom beside its peers on the same trees in the same run.

Times are of the process's CPU, the best of several turns: what else the machine does only ever adds. Peers that are
not installed are named as such.
"""

from __future__ import annotations

from collections.abc import Callable
from time import process_time

import numpy as np

from benchmarks.tf2.peers import PEERS, fill, optional
from benchmarks.tf2.trees import START_NS, Chain, chain
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.time import Time
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_ros.buffer import Buffer as RosBuffer

TURNS = 7
# What ROS 2 Jazzy's tf2_py took on a machine of this kind [µs].
JAZZY_LATEST_US = {1: 6.9, 10: 7.1, 50: 11.2}
JAZZY_HISTORIC_US = 625.0
JAZZY_SET_US = 2.6
JAZZY_SHUFFLED_INSERT_US = 16.5
JAZZY_CLOUD_MS = 7.6


def best_s(count: int, call: Callable[..., object], *args: object) -> float:
    """Return the seconds of CPU that `call(*args)` takes, the best of some turns of `count`."""
    times = []
    for _ in range(TURNS):
        start = process_time()
        for _ in range(count):
            call(*args)
        times.append((process_time() - start) / count)
    return min(times)


def line(what: str, value: float, unit: str, reference: float | None = None, name: str = "Jazzy") -> None:
    ratio = "" if reference is None else f"{name} {reference:8.2f} {unit}   {reference / value:8.1f} x"
    print(f"{what:58} {value:8.3f} {unit:12} {ratio}")


def scalar() -> None:
    for depth in (1, 5, 10, 50):
        for rate_hz in (100, 1000):
            tree = chain(depth, rate_hz)
            buffer = fill(tree)
            names = tree.target_frame, tree.source_frame
            where = f"depth {depth}, {rate_hz} Hz"
            line(f"lookup, latest, {where}", 1e6 * best_s(5000, buffer.lookup, *names), "µs")
            historic = 1e6 * best_s(5000, buffer.lookup, *names, tree.middle_ns)
            is_measured = (depth, rate_hz) == (10, 1000)
            line(f"lookup, mid history, {where}", historic, "µs", JAZZY_HISTORIC_US if is_measured else None)
    for depth, reference in JAZZY_LATEST_US.items():
        ros = ros_buffer(chain(depth, 100))
        value = 1e6 * best_s(5000, ros.lookup_transform, "f0", f"f{depth}", Time())
        line(f"lookup_transform, latest, depth {depth}", value, "µs", reference)


def ros_buffer(tree: Chain) -> RosBuffer:
    buffer = RosBuffer()
    for link in range(tree.depth):
        buffer.set_many(
            f"f{link}",
            f"f{link + 1}",
            tree.stamps_ns,
            tree.positions[link],
            tree.rotations_xyzw[link],
            "bench",
        )
    return buffer


def many() -> None:
    random = np.random.default_rng(1)
    for depth in (1, 5, 10):
        tree = chain(depth, 1000)
        buffer = fill(tree)
        stamps = np.sort(random.integers(tree.stamps_ns[0], tree.stamps_ns[-1], 100_000))
        for order, asked in (("ascending", stamps), ("shuffled", random.permutation(stamps))):
            ours = best_s(1, buffer.lookup_many, "f0", tree.source_frame, asked)
            per_edge = 1e9 / len(asked) / depth
            line(f"lookup_many, {order}, depth {depth}", ours * per_edge, "ns/edge/stamp")
            for name, peer in PEERS.items():
                if optional(name) is None:
                    line(f"  {name} is not installed", 0.0, "")
                    continue
                other = peer(tree)
                few = asked[:10_000]
                theirs = best_s(1, other.lookup_many, few) * len(asked) / len(few)
                line("", ours * per_edge, "ns/edge/stamp", theirs * per_edge, peer.name)


def inserts() -> None:
    count = 20_000
    messages = [TransformStamped(child_frame_id="b") for _ in range(count)]
    for index, message in enumerate(messages):
        message.header.frame_id = "a"
        message.header.stamp.sec, message.header.stamp.nanosec = divmod(
            START_NS + index * 100_000, 1_000_000_000
        )

    def set_all() -> None:
        buffer = RosBuffer()
        for message in messages:
            buffer.set_transform(message, "bench")

    line("set_transform with a message", 1e6 * best_s(1, set_all) / count, "µs", JAZZY_SET_US)

    batches = [cdr.encode(TFMessage(transforms=messages[i : i + 100])) for i in range(0, count, 100)]
    gid = bytes(16)

    def push_all() -> None:
        sink = Buffer().tf_sink("bench", static=False)
        for batch in batches:
            sink.push(batch, 0, 0, gid)

    line("/tf bytes into the buffer, 100 a message", 1e9 * best_s(1, push_all) / count, "ns/transform")

    order = START_NS + np.random.default_rng(2).permutation(10_000) * 1_000_000

    def shuffled() -> None:
        buffer = Buffer(None)
        for stamp in order.tolist():
            buffer.set("a", "b", stamp, (1.0, 2.0, 3.0), (0.0, 0.0, 0.0, 1.0))

    value = 1e6 * best_s(1, shuffled) / len(order)
    line("insert into 10,000 samples in random order", value, "µs", JAZZY_SHUFFLED_INSERT_US)
    tree = chain(1, 10_000)
    line("memory", fill(tree).memory / len(tree.stamps_ns), "B/transform")


def points() -> None:
    tree = chain(2, 1000)
    buffer = fill(tree)
    cloud = np.random.default_rng(3).normal(size=(100_000, 3)).astype(np.float32)
    stamps = np.linspace(tree.stamps_ns[100], tree.stamps_ns[200], len(cloud)).astype(np.int64)
    line(
        "100,000 float32 points at one time",
        1e3 * best_s(10, buffer.transform_points, cloud, "f0", "f2", tree.middle_ns),
        "ms",
        JAZZY_CLOUD_MS,
    )
    line(
        "the same, deskewed with a stamp each",
        1e3 * best_s(3, buffer.deskew, cloud, stamps, "f0", "f2", "f0", int(stamps[-1])),
        "ms",
    )


def main() -> None:
    scalar()
    many()
    inserts()
    points()


main()
