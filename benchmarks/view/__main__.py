"""What `tfloom view` costs: CPU of its process, and the time from publishing to a page.

100 frames at 100 Hz, then also a cloud of 100,000 points at 10 Hz, with one page open, with ten, and with none. The
page is a program that takes all that viser sends and draws nothing, because a browser without a graphics card would be
what is measured; `benchmarks.view.browser` measures one. There is no peer: RViz has no wheels. At the end, `tfloom demo
robot` drives and maps its room, and the recorded trajectory by the odometry alone, and that which the map corrects, are
compared with the truth.
"""

from __future__ import annotations

import contextlib
import json
import os
import statistics
import struct
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator

import msgspec
import numpy as np
import psutil
import zstandard
from viser import __version__
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from benchmarks.domain import DOMAIN_ID
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.sensor_msgs.msg import PointCloud2, PointField
from tfloom.node.client_library import init, shutdown
from tfloom.node.node import Node
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster

FRAMES = 100
RATE_HZ = 100.0
POINTS = 100_000
CLOUD_HZ = 10.0
SECONDS = 10.0
PAGES = 10
PORT = 8799
DRIVE_S = 60
"""How long the robot drives in its room [s]."""


class Feeder:
    """Publishes frames, and clouds while it is told so, on a thread.

    Args:
        frames: How many.
        rate_hz: How often each is published.
        points: Of a cloud.
        cloud_hz: How often a cloud is published.
    """

    def __init__(
        self,
        frames: int = FRAMES,
        rate_hz: float = RATE_HZ,
        points: int = POINTS,
        cloud_hz: float = CLOUD_HZ,
    ) -> None:
        self._frames, self._rate_hz, self._points, self._cloud_hz = frames, rate_hz, points, cloud_hz
        self.node = Node("feeder")
        self.tf = TransformBroadcaster(self.node)
        self.clouds = self.node.create_publisher(PointCloud2, "points", 10)
        self.with_clouds = False
        self.sent: dict[float, float] = {}
        """When each position of the marked frame was published [s, monotonic], by the position."""
        self.sent_clouds: dict[float, float] = {}
        """When each cloud was published [s, monotonic], by the x of its first point."""
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self) -> None:
        points = np.random.default_rng(1).normal(0.0, 3.0, (self._points, 4)).astype(np.float32)
        fields = [
            PointField(name=name, offset=4 * place, datatype=PointField.FLOAT32, count=1)
            for place, name in enumerate(("x", "y", "z", "intensity"))
        ]
        points_bytes = points.tobytes()
        cloud = PointCloud2(
            height=1,
            width=self._points,
            fields=fields,
            point_step=16,
            row_step=16 * self._points,
            data=points_bytes,
        )
        transforms = [TransformStamped(child_frame_id=f"frame_{number}") for number in range(self._frames)]
        next_s = time.monotonic()
        count = 0
        while not self._is_over.wait(max(0.0, next_s - time.monotonic())):
            next_s += 1.0 / self._rate_hz
            count += 1
            stamp = self.node.get_clock().now().to_msg()
            for number, transform in enumerate(transforms):
                transform.header.stamp, transform.header.frame_id = stamp, "world"
                transform.transform.translation.x = (
                    float(count) if number == 0 else number + 0.001 * (count % 100)
                )
            self.sent[float(count)] = time.monotonic()
            self.tf.sendTransform(transforms)
            if self.with_clouds and count % round(self._rate_hz / self._cloud_hz) == 0:
                cloud.header.stamp, cloud.header.frame_id = stamp, "world"
                # A cloud that stays is not sent again: each one's first point has another place, by which it is known.
                cloud.data = struct.pack("<f", -float(count)) + points_bytes[4:]
                self.sent_clouds[-float(count)] = time.monotonic()
                self.clouds.publish(cloud)

    def close(self) -> None:
        self._is_over.set()
        self._thread.join()
        self.node.destroy_node()


class Page:
    """Takes what viser sends to a page, and notes when each position of the marked frame, and each cloud, has come."""

    def __init__(self, feeder: Feeder) -> None:
        self._sent = feeder.sent
        self._sent_clouds = feeder.sent_clouds
        self.delays: list[float] = []
        """From publishing a frame to its arrival [s]."""
        self.cloud_delays: list[float] = []
        self.bytes = 0
        self._api = connect(f"ws://127.0.0.1:{PORT}/api", max_size=None, proxy=None)
        name = json.loads(self._api.recv())["page"]
        self._scene = connect(
            f"ws://127.0.0.1:{PORT}/scene/ws?page={name}",
            subprotocols=[f"viser-v{__version__}"],
            max_size=None,
            proxy=None,
            compression=None,
        )
        self._threads = [
            threading.Thread(target=self._take_states),
            threading.Thread(target=self._take_scene),
        ]
        for thread in self._threads:
            thread.start()

    def send(self, **command: object) -> None:
        self._api.send(json.dumps(command))

    def _take_states(self) -> None:
        with contextlib.suppress(ConnectionClosed):
            for _ in self._api:
                pass

    def _take_scene(self) -> None:
        decompress = zstandard.ZstdDecompressor().decompress
        with contextlib.suppress(ConnectionClosed):
            for data in self._scene:
                now_s = time.monotonic()
                self.bytes += len(data)
                size, packed = int.from_bytes(data[:8], "little"), int.from_bytes(data[8:16], "little")
                batch = msgspec.msgpack.decode(decompress(data[16 : 16 + packed], max_output_size=size))
                starts, at = [], 16 + packed
                for length in batch["binaryBufferLengths"]:
                    at += -at % 8
                    starts.append((at, length))
                    at += length
                for message in batch["messages"]:
                    updates = message.get("updates") or {}
                    if message.get("name") == "/frames/axes" and "batched_positions" in updates:
                        begin, length = starts[updates["batched_positions"]["__binary_index"]]
                        positions = np.frombuffer(data[begin : begin + length], np.float32).reshape(-1, 3)
                        sent_s = self._sent.get(float(positions[:, 0].max()))
                        if sent_s is not None:
                            self.delays.append(now_s - sent_s)
                    elif "points" in updates:
                        begin, _ = starts[updates["points"]["__binary_index"]]
                        (first,) = struct.unpack_from("<f", data, begin)
                        if first in self._sent_clouds:
                            self.cloud_delays.append(now_s - self._sent_clouds[first])

    def close(self) -> None:
        self._scene.close()
        self._api.close()
        for thread in self._threads:
            thread.join()


def told(delays: list[float]) -> str:
    """Return delays [s] as a text."""
    delays_ms = sorted(1000.0 * delay for delay in delays)
    return (
        f"median {statistics.median(delays_ms):.0f} ms, "
        f"9 of 10 within {delays_ms[len(delays_ms) * 9 // 10]:.0f} ms ({len(delays_ms)} pictures)"
    )


def cores(process: psutil.Process) -> float:
    """Return how many cores a process uses, over `SECONDS`."""
    before, start_s = process.cpu_times(), time.monotonic()
    time.sleep(SECONDS)
    after = process.cpu_times()
    used_s = after.user + after.system - before.user - before.system
    return used_s / (time.monotonic() - start_s)


@contextlib.contextmanager
def viewer() -> Iterator[psutil.Process]:
    """Run `tfloom view` for the block."""
    command = [sys.executable, "-m", "tfloom", "view", "--no-open", "--port", str(PORT)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        process.stdout.readline()
        try:
            yield psutil.Process(process.pid)
        finally:
            process.terminate()


def print_trajectory_errors() -> None:
    """Let the robot of the demonstration map its room, and print the errors of its trajectory before and after."""
    command = [sys.executable, "-m", "tfloom", "demo", "robot", "--seconds", str(DRIVE_S)]
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
        )
    table = done.stdout.splitlines()[-3:]
    if done.returncode != 0 or len(table) != 3 or not table[-1].startswith("corrected "):
        raise SystemExit(f"tfloom demo robot ended with {done.returncode}: {done.stdout}{done.stderr}")
    print("\n".join(["the trajectory of `tfloom demo robot`, from the truth:", *table]))


def main() -> None:
    os.environ["ROS_DOMAIN_ID"] = str(DOMAIN_ID)
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
    init()
    feeder = Feeder()
    try:
        with viewer() as process:
            time.sleep(2.0)
            print(f"no page: {cores(process):.3f} cores")
            page = Page(feeder)
            time.sleep(2.0)
            page.delays.clear()
            used = cores(process)
            print(f"one page, {FRAMES} frames at {RATE_HZ:g} Hz: {used:.3f} cores")
            print(f"from publishing a frame to the page: {told(page.delays)}")
            feeder.with_clouds = True
            page.send(op="display", topic="/points", on=True)
            time.sleep(3.0)
            before = page.bytes
            page.delays.clear()
            page.cloud_delays.clear()
            used = cores(process)
            rate = (page.bytes - before) / SECONDS / 1e6
            print(f"… and {POINTS} points at {CLOUD_HZ:g} Hz: {used:.3f} cores, {rate:.1f} MB/s to the page")
            print(f"from publishing a frame to the page: {told(page.delays)}")
            print(f"from publishing a cloud to the page: {told(page.cloud_delays)}")
            pages = [page, *(Page(feeder) for _ in range(PAGES - 1))]
            time.sleep(3.0)
            print(f"{PAGES} pages with all that: {cores(process):.3f} cores")
            for page in pages:
                page.close()
            time.sleep(2.0)
            print(f"the pages closed: {cores(process):.3f} cores")
    finally:
        feeder.close()
        shutdown()
    print_trajectory_errors()


if __name__ == "__main__":
    main()
