"""Operations that users call, in the situations for which the optimisations are made."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from time import thread_time_ns
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.tf2.peers import fill
from benchmarks.tf2.trees import START_NS, Tree, chain, humanoid
from tfloom._native import ReadyQueue
from tfloom.interfaces.geometry_msgs.msg import PoseStamped, Transform, TransformStamped
from tfloom.interfaces.sensor_msgs.msg import JointState
from tfloom.interfaces.std_msgs.msg import Header, UInt8MultiArray
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_ros.point_clouds.point_cloud import do_transform_cloud
from tfloom.tf2_ros.point_clouds.point_cloud2 import create_cloud, create_cloud_xyz32, read_points_numpy

GID = bytes(16)


class Case(NamedTuple):
    call: Callable[[], object]
    """Run the operation `count` times; return the seconds taken if it measures itself."""
    answer: Callable[[], list[float]]
    """Return the result of the operation, to be compared between both forms."""
    count: int


def lookup(tree: Tree, stamp_ns: int) -> Case:
    look_up = fill(tree).lookup
    query = tree.target_frame, tree.source_frame, stamp_ns
    count = 500

    def call() -> None:
        for _ in range(count):
            look_up(*query)

    def answer() -> list[float]:
        found = look_up(*query)
        return [found.stamp_ns, *found.transform.translation, *found.transform.rotation_xyzw]

    return Case(call, answer, count)


def middle(depth: int) -> Case:
    tree = chain(depth, 1000)
    return lookup(tree, tree.middle_ns)


def ascending(tree: Tree, count: int = 20_000) -> NDArray[np.int64]:
    return np.sort(np.random.default_rng(1).integers(tree.stamps_ns[0], tree.stamps_ns[-1], count))


def shuffled(tree: Tree) -> NDArray[np.int64]:
    return np.random.default_rng(4).permutation(ascending(tree))


def lookup_many(tree: Tree, stamps_ns: NDArray[np.int64]) -> Case:
    buffer = fill(tree)

    def call() -> Any:
        return buffer.lookup_many(tree.target_frame, tree.source_frame, stamps_ns)

    def answer() -> list[float]:
        found = call()
        return list(np.concatenate((found.positions, found.rotations_xyzw), axis=1)[::100].ravel())

    return Case(call, answer, len(stamps_ns))


def deskew() -> Case:
    """Deskew points of 0.1 s, with transforms at 100 Hz."""
    tree = chain(2, 100)
    buffer = fill(tree)
    cloud = np.random.default_rng(3).normal(size=(20_000, 3)).astype(np.float32)
    stamps = np.linspace(tree.stamps_ns[100], tree.stamps_ns[110], len(cloud)).astype(np.int64)

    def call() -> Any:
        return buffer.deskew(cloud, stamps, "f0", "f2", "f0", int(stamps[-1]))

    return Case(call, lambda: list(call()[::100].ravel().astype(float)), len(cloud))


def padded_cloud() -> Case:
    """Transform a cloud of 32 bytes a point."""
    points = np.random.default_rng(3).normal(size=(100_000, 3)).astype(np.float32)
    cloud = create_cloud(Header(), create_cloud_xyz32(Header(), points).fields, points, point_step=32)
    transform = Transform()
    transform.translation.x, transform.rotation.z, transform.rotation.w = 1.0, 0.6, 0.8

    def call() -> Any:
        return do_transform_cloud(cloud, transform)

    return Case(call, lambda: list(read_points_numpy(call())[::100].ravel().astype(float)), len(points))


def tf_message(
    edges: list[tuple[str, str]], stamp_ns: int = START_NS, *, is_planar: bool = False
) -> TFMessage:
    random = np.random.default_rng(7)
    message = TFMessage()
    for frame_id, child_frame_id in edges:
        stamped = TransformStamped(child_frame_id=child_frame_id)
        stamped.header.frame_id = frame_id
        stamped.header.stamp.sec, stamped.header.stamp.nanosec = divmod(stamp_ns, 1_000_000_000)
        position, rotation = stamped.transform.translation, stamped.transform.rotation
        angle = random.uniform(0, 3)
        position.x, position.y = random.normal(size=2).tolist()
        rotation.z, rotation.w = float(np.sin(angle)), float(np.cos(angle))
        if not is_planar:
            position.z = random.normal()
            rotation.x, rotation.y, rotation.z = rotation.z * 0.6, rotation.z * 0.48, rotation.z * 0.64
        message.transforms.append(stamped)
    return message


def tf_bytes(edges: list[tuple[str, str]], count: int, *, is_cold: bool = False) -> Case:
    """Push messages of /tf; with `is_cold`, other work evicts the processor's caches between them."""
    messages = [cdr.encode(tf_message(edges, START_NS + index * 10_000_000)) for index in range(count)]
    other_work = np.zeros(4_000_000 if is_cold else 0)  # 32 MB

    def push(buffer: Buffer) -> float:
        sink = buffer.tf_sink("bench", static=False)
        took_ns = 0
        for message in messages:
            other_work.sum()
            begin_ns = thread_time_ns()
            sink.push(message, 0, 0, GID)
            took_ns += thread_time_ns() - begin_ns
        return took_ns / 1e9

    def answer() -> list[float]:
        buffer = Buffer()
        push(buffer)
        numbers: list[float] = []
        for edge in buffer.edges():
            found = buffer.lookup(edge.frame_id, edge.child_frame_id, 0).transform
            numbers += [edge.newest_ns, edge.sample_count, *found.translation, *found.rotation_xyzw]
        return numbers

    return Case(lambda: push(Buffer()), answer, len(edges) * count)


def set_many(*, is_shuffled: bool = False) -> Case:
    tree = chain(1, 2000)
    order = np.arange(len(tree.stamps_ns))
    if is_shuffled:
        order = np.random.default_rng(2).permutation(order)
    columns = tree.stamps_ns[order], tree.positions[0][order], tree.rotations_xyzw[0][order]

    def call() -> Buffer:
        buffer = Buffer(None)
        buffer.set_many("f0", "f1", *columns)
        return buffer

    def answer() -> list[float]:
        return list(np.concatenate(call().to_arrays("f0", "f1")[1:], axis=1)[::100].ravel())

    return Case(call, answer, len(tree.stamps_ns))


def set_one() -> Case:
    stamps = (START_NS + np.arange(2000) * 1_000_000).tolist()

    def call() -> Buffer:
        buffer = Buffer(None)
        for stamp in stamps:
            buffer.set("a", "b", stamp, (1.0, 2.0, 3.0), (0.0, 0.6, 0.0, 0.8))
        return buffer

    return Case(call, lambda: list(call().to_arrays("a", "b")[2].ravel()), len(stamps))


def decode(message: Any, count: int) -> Case:
    kind, data = type(message), cdr.encode(message)

    def call() -> None:
        for _ in range(count):
            cdr.decode(kind, data)

    return Case(call, lambda: list(cdr.encode(cdr.decode(kind, data))), count)


def decode_held(message: Any, held: int) -> Case:
    """Decode messages that the program holds for a while, as a queue of images does."""
    kind, data = type(message), cdr.encode(message)

    def call() -> None:
        messages = [cdr.decode(kind, data) for _ in range(held)]
        messages.clear()

    return Case(call, lambda: list(hashlib.sha256(cdr.encode(cdr.decode(kind, data))).digest()), held)


def take(message: Any) -> Case:
    """Take a message as a subscription does, from a writer of the same process."""
    from benchmarks.domain import DOMAIN_ID
    from tfloom.rmw.base import NodeName, Topic
    from tfloom.rmw.cyclone.wire import open_participant
    from tfloom.rmw.qos import QoS

    kind, data = type(message), cdr.encode(message)
    participant = open_participant(DOMAIN_ID)
    node, topic = NodeName("/", "takes"), Topic("/taken", "std_msgs/msg/UInt8MultiArray", "")
    participant.add_node(node)
    reader = participant.create_reader(node, topic, QoS())
    writer = participant.create_writer(node, topic, QoS())

    def taken() -> Any:
        sample = reader.take_decoded(kind)
        assert sample is not None
        return cdr.decode(kind, sample.data) if type(sample.data) is bytes else sample.data

    def call() -> float:
        writer.write(data)
        begin_ns = thread_time_ns()
        taken()
        return (thread_time_ns() - begin_ns) / 1e9

    def answer() -> list[float]:
        writer.write(data)
        return list(hashlib.sha256(cdr.encode(taken())).digest())

    return Case(call, answer, 1)


def encode(message: Any, count: int) -> Case:
    def call() -> None:
        for _ in range(count):
            cdr.encode(message)

    return Case(call, lambda: list(cdr.encode(message)), count)


def posts() -> Case:
    """Post tokens to an executor that is busy with others."""
    queue = ReadyQueue()
    tokens = range(10)

    def call() -> list[int]:
        for token in tokens:
            queue.post(token)
        return queue.wait(0)

    def many() -> None:
        for _ in range(50):
            call()

    return Case(many, lambda: [float(token) for token in call()], 50 * len(tokens))


ROBOT = humanoid(100).edges
JOINTS = JointState(name=[f"joint_{index}" for index in range(30)], position=[0.5] * 30)

CASES: dict[str, Callable[[], Case]] = {
    "lookup, latest, depth 1": lambda: lookup(chain(1, 1000), 0),
    "lookup, latest, depth 10": lambda: lookup(chain(10, 1000), 0),
    "lookup, latest, depth 50": lambda: lookup(chain(50, 1000), 0),
    "lookup, latest, humanoid": lambda: lookup(humanoid(100), 0),
    "lookup, middle, depth 10": lambda: middle(10),
    "lookup_many, ascending, depth 10, 20 a sample": lambda: lookup_many(
        chain(10, 100), ascending(chain(10, 100))
    ),
    "lookup_many, ascending, depth 10, 2 a sample": lambda: lookup_many(
        chain(10, 1000), ascending(chain(10, 1000))
    ),
    "lookup_many, shuffled, depth 1": lambda: lookup_many(chain(1, 1000), shuffled(chain(1, 1000))),
    "lookup_many, shuffled, depth 10": lambda: lookup_many(chain(10, 1000), shuffled(chain(10, 1000))),
    "deskew, a point": deskew,
    "do_transform_cloud, a padded point": padded_cloud,
    "/tf of 100 frames, a transform": lambda: tf_bytes(ROBOT, 50),
    "/tf of 100 frames, a transform, cold caches": lambda: tf_bytes(ROBOT, 50, is_cold=True),
    "set_many, a transform": set_many,
    "set_many, shuffled, a transform": lambda: set_many(is_shuffled=True),
    "set": set_one,
    "decode TFMessage x 100": lambda: decode(tf_message(ROBOT), 2),
    "decode TFMessage x 100, in a plane": lambda: decode(tf_message(ROBOT, is_planar=True), 2),
    "decode TFMessage x 1": lambda: decode(tf_message(ROBOT[:1]), 300),
    "decode PoseStamped": lambda: decode(PoseStamped(), 300),
    "decode JointState of 30": lambda: decode(JOINTS, 100),
    "decode 8 MB, five held": lambda: decode_held(UInt8MultiArray(data=bytes(8_000_000)), 5),
    "take a message of 8 MB": lambda: take(UInt8MultiArray(data=bytes(8_000_000))),
    "encode TFMessage x 1": lambda: encode(tf_message(ROBOT[:1]), 500),
    "post to a busy executor": posts,
}
