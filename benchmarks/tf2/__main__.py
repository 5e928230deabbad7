"""Measure lookups, inserts and points: tfloom beside its peers on the same trees in the same run.

Times are CPU times of the process, the best of several turns, because other load on the machine only adds time. Where
threads share the work, times are measured by the wall clock. Peers that are not installed are named.
"""

from __future__ import annotations

import importlib.util
import os
from collections.abc import Callable
from time import perf_counter, process_time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.tf2.debian import NAME as DEBIAN
from benchmarks.tf2.debian import measure_debian
from benchmarks.tf2.peers import PEERS, Scipy, TransformTree, fill, peers_of
from benchmarks.tf2.trees import START_NS, Tree, chain, humanoid
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.values.time import Time
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.transform import Transform
from tfloom.tf2_ros.buffer import Buffer as RosBuffer
from tfloom.tf2_ros.point_clouds.point_cloud import do_transform_cloud, transform_points
from tfloom.tf2_ros.point_clouds.point_cloud2 import create_cloud, create_cloud_xyz32, read_points_numpy

TURNS = 7
CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
TOLERANCE_M = 1e-4
"""Tolerance of the peers' answers; pytransform3d, which interpolates along a screw, differs by some micrometres."""

# Times of ROS 2 Jazzy's tf2_py on a machine of this kind.
JAZZY = "Jazzy's figure"
JAZZY_LATEST_US = {1: 6.9, 10: 7.1, 50: 11.2}
JAZZY_HISTORIC_US = 625.0
JAZZY_SET_US = 2.6
JAZZY_SHUFFLED_INSERT_US = 16.5
JAZZY_CLOUD_MS = 7.6


def best_s(
    count: int, call: Callable[..., object], *args: object, clock: Callable[[], float] = process_time
) -> float:
    """Return the time of `call(*args)` [s], the best of some turns of `count` calls."""
    times = []
    for _ in range(TURNS):
        start = clock()
        for _ in range(count):
            call(*args)
        times.append((clock() - start) / count)
    return min(times)


def best_us(count: int, call: Callable[..., object], *args: object) -> float:
    return 1e6 * best_s(count, call, *args)


def row(what: str, value: float, unit: str, peers: dict[str, float] | None = None) -> None:
    """Print tfloom's value, and each peer's in the same unit with its ratio to tfloom's."""
    start = f"{what:58} {value:9.3f} {unit:14}"
    lines = [f"{name:16} {other:10.3f} {other / value:8.1f} x" for name, other in (peers or {}).items()]
    print(start + (lines[0] if lines else ""), flush=True)
    for line in lines[1:]:
        print(" " * len(start) + line)


def check(name: str, ours: object, theirs: object) -> None:
    """Exit if the answers differ, because then their times cannot be compared."""
    difference = np.abs(np.asarray(ours, float) - np.asarray(theirs, float)).max()
    if not difference < TOLERANCE_M:
        raise SystemExit(f"the answer of {name} differs by {difference} m")


def trees() -> dict[str, Tree]:
    chains = {
        f"depth {depth}, {rate_hz} Hz": chain(depth, rate_hz)
        for depth in (1, 5, 10, 50)
        for rate_hz in (100, 1000)
    }
    return {**chains, "humanoid, 100 Hz": humanoid(100)}


def one_by_one(all_trees: dict[str, Tree], debian: dict[str, Any]) -> None:
    for where, tree in all_trees.items():
        names = tree.target_frame, tree.source_frame
        buffer = fill(tree)
        moment = buffer.lookup(*names, tree.middle_ns).translation
        peers = {name: peer for name, peer in peers_of(tree).items() if name != Scipy.name}
        for name, peer in peers.items():
            check(name, moment, peer.lookup(tree.middle_ns)[:3, 3])
        theirs = debian["trees"].get(where, {})
        if theirs:
            check(DEBIAN, moment, theirs["position"])
        for when, key, stamp, peer_stamp in (
            ("latest", "latest_us", 0, tree.newest_ns),
            ("middle", "middle_us", tree.middle_ns, tree.middle_ns),
        ):
            others = {name: best_us(peer.calls, peer.lookup, peer_stamp) for name, peer in peers.items()}
            row(f"lookup, {when}, {where}", best_us(3000, buffer.lookup, *names, stamp), "µs", others)
            if theirs:
                others = {DEBIAN: theirs[key]}
                if when == "latest" and where.endswith("1000 Hz") and len(tree.edges) in JAZZY_LATEST_US:
                    others[JAZZY] = JAZZY_LATEST_US[len(tree.edges)]
                if when == "middle" and where == "depth 10, 1000 Hz":
                    others[JAZZY] = JAZZY_HISTORIC_US
                ros, time = RosBuffer(Time(seconds=1000)), Time(nanoseconds=stamp)
                fill(tree, ros)
                ours = best_us(3000, ros.lookup_transform, *names, time)
                row(f"lookup_transform, {when}, {where}", ours, "µs", others)


def many() -> None:
    random = np.random.default_rng(1)
    cases = {
        "depth 1": chain(1, 1000), "depth 10": chain(10, 1000), "depth 50": chain(50, 1000),
        "humanoid": humanoid(100),
    }  # fmt: skip
    for where, tree in cases.items():
        links = sum(map(len, tree.branches()))
        buffer = fill(tree)
        peers = peers_of(tree)
        ascending = np.sort(random.integers(tree.stamps_ns[0], tree.stamps_ns[-1], 100_000))
        for order, asked in (("ascending", ascending), ("shuffled", random.permutation(ascending))):
            per_edge = 1e9 / len(asked) / links
            look_up = buffer.lookup_many, tree.target_frame, tree.source_frame
            positions = buffer.lookup_many(tree.target_frame, tree.source_frame, asked).positions
            others = {}
            for name, peer in peers.items():
                step = 1 if name == TransformTree.name else 10 * links  # fewer stamps for slow peers
                part = asked[::step]
                check(name, positions[::step], peer.lookup_many(part))
                others[name] = best_s(1, peer.lookup_many, part) * step * per_edge
            row(
                f"lookup_many, {order}, {where}",
                best_s(1, *look_up, asked) * per_edge,
                "ns/edge/stamp",
                others,
            )
            scaling(f"lookup_many, {order}, {where}", buffer, tree, np.repeat(asked, 5), per_edge / 5)


def scaling(what: str, buffer: Buffer, tree: Tree, asked: NDArray[np.int64], per_edge: float) -> None:
    def look_up(workers: int) -> object:
        return buffer.lookup_many(tree.target_frame, tree.source_frame, asked, workers=workers)

    one, every = (best_s(1, look_up, workers, clock=perf_counter) for workers in (1, CORES))
    row(
        f"{what}, {CORES} cores, by the clock",
        every * per_edge,
        "ns/edge/stamp",
        {"one core": one * per_edge},
    )
    # The sum of the threads' CPU times shows their contention on a busy machine, unlike the wall clock.
    one, every = (best_s(1, look_up, workers) for workers in (1, CORES))
    row(f"{what}, {CORES} cores, their CPU", every * per_edge, "ns/edge/stamp", {"one core": one * per_edge})


def transforms(count: int) -> list[TransformStamped]:
    messages = [TransformStamped(child_frame_id="b") for _ in range(count)]
    for index, message in enumerate(messages):
        message.header.frame_id = "a"
        message.header.stamp.sec, message.header.stamp.nanosec = divmod(
            START_NS + index * 100_000, 1_000_000_000
        )
    return messages


def inserts(debian: dict[str, Any]) -> None:
    count = 20_000
    messages = transforms(count)

    def set_all() -> None:
        buffer = RosBuffer()
        for message in messages:
            buffer.set_transform(message, "bench")

    others = {JAZZY: JAZZY_SET_US}
    if debian["trees"]:
        others[DEBIAN] = min(tree["set_us"] for tree in debian["trees"].values())
    row("set_transform with a message", best_us(1, set_all) / count, "µs", others)

    batches = [cdr.encode(TFMessage(transforms=messages[i : i + 100])) for i in range(0, count, 100)]
    gid = bytes(16)

    def push_all() -> None:
        sink = Buffer().tf_sink("bench", static=False)
        for batch in batches:
            sink.push(batch, 0, 0, gid)

    def decode_all() -> None:
        buffer = RosBuffer()
        for batch in batches:
            for message in cdr.decode(TFMessage, batch).transforms:
                buffer.set_transform(message, "bench")

    ours = 1e3 * best_us(1, push_all) / count
    others = {"by messages": 1e3 * best_us(1, decode_all) / count}
    row("/tf bytes into the buffer, 100 a message", ours, "ns/transform", others)


def arrays(debian: dict[str, Any]) -> None:
    tree = chain(1, 10_000)
    others = {}
    if importlib.util.find_spec(TransformTree.module):
        others[TransformTree.name] = 1e3 * best_us(1, TransformTree, tree) / len(tree.stamps_ns)
    ours = 1e3 * best_us(1, fill, tree) / len(tree.stamps_ns)
    row("set_many, into a new tree", ours, "ns/transform", others)

    order = (START_NS + np.random.default_rng(2).permutation(10_000) * 1_000_000).tolist()

    def shuffled() -> None:
        buffer = Buffer(None)
        for stamp in order:
            buffer.set("a", "b", stamp, (1.0, 2.0, 3.0), (0.0, 0.0, 0.0, 1.0))

    others = {JAZZY: JAZZY_SHUFFLED_INSERT_US}
    if debian["trees"]:
        others[DEBIAN] = debian["shuffled_us"]
    row("insert into 10,000 samples in random order", best_us(1, shuffled) / len(order), "µs", others)
    row("memory", fill(tree).memory / len(tree.stamps_ns), "B/transform")


def points() -> None:
    tree = chain(2, 1000)
    buffer = fill(tree)
    cloud = np.random.default_rng(3).normal(size=(100_000, 3)).astype(np.float32)
    stamps = np.linspace(tree.stamps_ns[100], tree.stamps_ns[200], len(cloud)).astype(np.int64)
    found = buffer.lookup("f0", "f2", tree.middle_ns).transform.matrix()

    def by_numpy() -> object:
        return cloud @ found[:3, :3].T.astype(np.float32) + found[:3, 3].astype(np.float32)

    others = {"numpy by hand": 1e3 * best_s(10, by_numpy), JAZZY: JAZZY_CLOUD_MS}
    ours = 1e3 * best_s(10, buffer.transform_points, cloud, "f0", "f2", tree.middle_ns)
    row("100,000 float32 points at one time", ours, "ms", others)
    clouds(cloud, buffer.lookup("f0", "f2", tree.middle_ns).transform, ours)

    poses = buffer.lookup_many("f0", "f2", stamps)
    others = {}
    if importlib.util.find_spec(Scipy.module):
        from scipy.spatial.transform import Rotation

        scipy = Scipy(tree)

        def by_scipy() -> object:
            position, turn = scipy.poses(stamps)
            return turn.apply(cloud) + position

        expected = Rotation.from_quat(poses.rotations_xyzw).apply(cloud) + poses.positions
        check(Scipy.name, expected, by_scipy())
        others[Scipy.name] = 1e3 * best_s(1, by_scipy)
    deskew = buffer.deskew, cloud, stamps, "f0", "f2", "f0", int(stamps[-1])
    row("the same, deskewed with a stamp each", 1e3 * best_s(3, *deskew), "ms", others)

    def shared(workers: int) -> object:
        return buffer.deskew(cloud, stamps, "f0", "f2", "f0", int(stamps[-1]), workers=workers)

    one, every = (1e3 * best_s(3, shared, workers, clock=perf_counter) for workers in (1, CORES))
    row(f"deskewed, {CORES} cores, by the clock", every, "ms", {"one core": one})


def clouds(points: NDArray[np.float32], transform: Transform, points_ms: float) -> None:
    message = TransformStamped()
    position, rotation = message.transform.translation, message.transform.rotation
    position.x, position.y, position.z = transform.translation
    rotation.x, rotation.y, rotation.z, rotation.w = transform.rotation_xyzw
    packed = create_cloud_xyz32(Header(), points)
    padded = {
        f", {step} octets a point": create_cloud(Header(), packed.fields, points, point_step=step)
        for step in (16, 32)
    }
    expected = transform_points(points, message.transform)
    for what, cloud in {"": packed, **padded}.items():
        check("do_transform_cloud", read_points_numpy(do_transform_cloud(cloud, message)), expected)
        ours = 1e3 * best_s(10, do_transform_cloud, cloud, message)
        row(f"do_transform_cloud, 100,000 points{what}", ours, "ms", {"transform_points": points_ms})


def main() -> None:
    for peer in PEERS:
        if importlib.util.find_spec(peer.module) is None:
            print(f"{peer.name} is not installed: `pip install --group bench` has it")
    all_trees = trees()
    chosen = ("depth 1, 1000 Hz", "depth 10, 1000 Hz", "depth 50, 1000 Hz", "humanoid, 100 Hz")
    debian = measure_debian({where: all_trees[where] for where in chosen})
    if "absent" in debian:
        print(f"{DEBIAN} is not measured: {debian['absent']}")
    one_by_one(all_trees, debian)
    many()
    inserts(debian)
    arrays(debian)
    points()


if __name__ == "__main__":
    main()
