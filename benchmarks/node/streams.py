"""Streams of large messages at best effort, from one process to another at the rate of a camera.

tfloom and the real rclpy run the same programs. Each message carries its number and the octets that were sent; some
are compared as a whole. `python -m benchmarks.node.streams --soak SECONDS` runs one stream of 8 MB for a time, and
fails if the memory of a process grows after the first minute.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from typing import Any, NamedTuple

from benchmarks.node.memory import Memory
from benchmarks.node.processes import PEER, background

RATE_HZ = 30.0
SIZES = {"0.92 MB": 640 * 480 * 3, "2.8 MB": 2_800_000, "8 MB": 8_000_000}
"""The first is an image of 640 x 480 in colour."""
BUFFERS = {"208 kB": 90, "4 MB": 180}
"""What a socket requests, by default of Linux and by tfloom's own, and the messages of a stream to such sockets."""
UNPACED = {"TFLOOM_FASTDDS_SERVICES": "0"}
"""Switches off what sees the packets of the library, and so the waits for room."""
BY_UDP = {"FASTDDS_BUILTIN_TRANSPORTS": "UDPv4"}
COMPARED_EVERY = 10
SOAK_WARM_UP_S = 60.0
SOCKETS = "BENCHMARKS_SOCKETS"
"""The variable that has the size which tfloom's sockets request, one of BUFFERS."""
STALLS_AT, STALL_S = 300, 1.0
"""The message at which a soak's receiver stops once, so that its queue is full, as it may be at any time."""
LEAST_RECEIVED = 0.9
"""Of a soak's messages: on a busy machine a receiver that is not run for a while misses some."""


class End(NamedTuple):
    """What a process did in a stream."""

    messages: int
    """Sent, or received."""
    cpu_ms: float
    """CPU time of a message that was sent."""
    peak_mb: float
    """The greatest resident memory."""


class Stream(NamedTuple):
    sent: End
    received: End


def octets_of(size: int) -> bytes:
    return bytes(range(250)) * (size // 250)


def quality() -> Any:
    from rclpy.qos import QoSProfile, ReliabilityPolicy

    return QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)


def peak_mb() -> float:
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


class Receiver:
    """Counts the messages of a stream, and checks them."""

    def __init__(self, node: Any, size: int, stalls_at: int) -> None:
        from std_msgs.msg import UInt8MultiArray

        self.count = 0
        self._stalls_at = stalls_at
        self._last = -1
        self._octets = octets_of(size)
        node.create_subscription(UInt8MultiArray, "bench_stream", self._on_message, quality())

    def _on_message(self, message: Any) -> None:
        number = message.layout.data_offset
        if number <= self._last or len(message.data) != len(self._octets):
            raise ValueError(f"message {number} of {len(message.data)} octets arrived after {self._last}")
        if number % COMPARED_EVERY == 0 and memoryview(message.data) != memoryview(self._octets):
            raise ValueError(f"message {number} arrived with other octets than were sent")
        self._last = number
        self.count += 1
        if self.count == self._stalls_at:
            time.sleep(STALL_S)


def receive(size: int, count: int, stalls_at: int = 0) -> None:
    """Receive until a line comes on stdin, and print what was received; stop once for STALL_S at a message."""
    import threading

    import rclpy

    rclpy.init()
    node = rclpy.create_node("receives")
    receiver = Receiver(node, size, stalls_at)
    is_over = threading.Event()

    def wait_for_end() -> None:
        sys.stdin.readline()
        is_over.set()

    threading.Thread(target=wait_for_end, daemon=True).start()
    print("ready", flush=True)
    started_s = time.process_time()
    while not is_over.is_set():
        rclpy.spin_once(node, timeout_sec=0.1)
    cpu_ms = (time.process_time() - started_s) / count * 1e3
    print(json.dumps(End(receiver.count, cpu_ms, peak_mb())), flush=True)
    rclpy.shutdown()


def send(size: int, count: int) -> None:
    """Send a stream, and print what was sent."""
    import rclpy
    from std_msgs.msg import UInt8MultiArray

    from benchmarks.node.processes import wait_for

    rclpy.init()
    node = rclpy.create_node("sends")
    publisher = node.create_publisher(UInt8MultiArray, "bench_stream", quality())
    message = UInt8MultiArray(data=octets_of(size))
    wait_for(lambda: publisher.get_subscription_count() == 1)
    time.sleep(0.5)  # the receiver may know this publisher later than it is known here
    started_s, begin_s = time.process_time(), time.monotonic()
    for number in range(count):
        time.sleep(max(0.0, begin_s + number / RATE_HZ - time.monotonic()))
        message.layout.data_offset = number
        publisher.publish(message)
    cpu_ms = (time.process_time() - started_s) / count * 1e3
    print(json.dumps(End(count, cpu_ms, peak_mb())), flush=True)
    sys.stdin.readline()
    rclpy.shutdown()


def request_size() -> None:
    """Have tfloom's sockets request the size of SOCKETS; otherwise they are those of any program.

    A CYCLONEDDS_URI would do so, too, but with one they aren't bound to the loopback interface.
    """
    if size := os.environ.get(SOCKETS):
        from tfloom.rmw.cyclone import config

        before = config._RECEIVE_BUFFER  # noqa: SLF001  # nobody else has to change it
        assert "4MB" in before, "tfloom requests another size than 4 MB"
        config._RECEIVE_BUFFER = before.replace("4MB", size.replace(" ", ""))  # noqa: SLF001  # as above


def measure(size: int, count: int, api: str = "tfloom", variables: dict[str, str] | None = None) -> Stream:
    """Return what both ends did in a stream of `count` messages of `size` octets."""
    chosen: Any = {"api": api, "variables": variables}
    with (
        background("streams", "receive", size, count, **chosen) as receiver,
        background("streams", "send", size, count, **chosen) as sender,
    ):
        receiver.stdout.readline()
        sent = End(*json.loads(sender.stdout.readline()))
        time.sleep(0.5)  # what was sent last is under way
        receiver.stdin.write("end\n")
        receiver.stdin.flush()
        return Stream(sent, End(*json.loads(receiver.stdout.readline())))


def measure_all(apis: tuple[str, ...], size: int, buffer: str) -> dict[str, Stream]:
    """Return the streams of tfloom, of tfloom without waits, and of rclpy with its transports and by UDP."""
    count, variables = BUFFERS[buffer], {SOCKETS: buffer}
    streams = {
        "tfloom": measure(size, count, variables=variables),
        "unpaced": measure(size, count, variables=variables | UNPACED),
    }
    if PEER in apis:
        streams[PEER] = measure(size, count, PEER)
        streams["by UDP"] = measure(size, count, PEER, BY_UDP)
    return streams


def soak(seconds: float) -> int:
    """Run a stream of 8 MB for a time; return 0 if the memory of both processes is constant after a minute."""
    size, count = SIZES["8 MB"], int(seconds * RATE_HZ)
    with (
        background("streams", "receive", size, count, STALLS_AT) as receiver,
        background("streams", "send", size, count) as sender,
    ):
        receiver.stdout.readline()
        warm_up = min(SOAK_WARM_UP_S / seconds, 0.5)
        memories = {
            name: Memory(process.pid, seconds, warm_up)
            for name, process in (("receiver", receiver), ("sender", sender))
        }
        begin_s = time.monotonic()
        while (progress := (time.monotonic() - begin_s) / seconds) < 1.0:
            for name, process in (("receiver", receiver), ("sender", sender)):
                if process.poll() is not None:
                    print(f"the {name} ended with {process.returncode} after {progress * seconds:.0f} s")
                    return 1
                memories[name].note(progress)
            time.sleep(min(1.0, seconds / 100))
        sent = End(*json.loads(sender.stdout.readline()))
        receiver.stdin.write("end\n")
        receiver.stdin.flush()
        received = End(*json.loads(receiver.stdout.readline()))
    for name, memory in memories.items():
        print(f"{name}: {memory.report()}")
    print(f"{received.messages} of {sent.messages} messages were received")
    arrived = received.messages >= LEAST_RECEIVED * sent.messages
    return 0 if arrived and all(memory.is_flat() for memory in memories.values()) else 1


def main() -> int:
    if sys.argv[1:2] in (["receive"], ["send"]):
        request_size()
        {"receive": receive, "send": send}[sys.argv[1]](*map(int, sys.argv[2:]))
        return 0
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node.streams", description=__doc__)
    parser.add_argument("--soak", type=float, metavar="SECONDS", required=True)
    return soak(parser.parse_args().soak)


if __name__ == "__main__":
    sys.exit(main())
