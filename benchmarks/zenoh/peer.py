"""The other process of the benchmark: echoes samples, sends them at a rate, or counts them in a sink and in a callback.

Arguments: `echo`, `send RATE COUNT`, `sink COUNT` or `callback COUNT`. It prints `ready`, and CPU time a sample [us].
`bare PORT` echoes by the library alone, without tfloom's wire.
"""

from __future__ import annotations

import json
import sys
import time
from collections import deque
from typing import Any

from tfloom._native import ReadyQueue, SampleQueue
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.qos import HistoryPolicy, QoS

HASH = "RIHS01_" + "1" * 64
ASK, ANSWER, STREAM = (Topic(f"/{name}", "std_msgs/msg/String", HASH) for name in ("ask", "answer", "stream"))
ALL = QoS(history=HistoryPolicy.KEEP_ALL)
NODE = NodeName("/", "peer")


def echo() -> None:
    participant = open_participant()
    participant.add_node(NODE)
    writer, reader = participant.create_writer(NODE, ANSWER, ALL), participant.create_reader(NODE, ASK, ALL)
    queue = ReadyQueue()
    reader.notify(queue)
    print("ready", flush=True)
    while True:
        while (sample := reader.take()) is not None:
            writer.write(sample.data)
        queue.wait(-1)


class Bare:
    """One end of the library alone: it writes to a key, and queues what comes on another.

    Args:
        port: Of the end that listens.
        listens: Whether this is that end.
        keys: What it writes to, and what it reads.
    """

    def __init__(self, port: int, keys: tuple[str, str], *, listens: bool) -> None:
        import zenoh

        config = zenoh.Config()
        # As a session of tfloom: it shares no memory unless it is asked to.
        for name in (
            "scouting/multicast/enabled",
            "scouting/gossip/enabled",
            "transport/shared_memory/enabled",
        ):
            config.insert_json5(name, "false")
        ends = {"listen": listens, "connect": not listens}
        for name, is_used in ends.items():
            config.insert_json5(f"{name}/endpoints", json.dumps([f"tcp/127.0.0.1:{port}"] if is_used else []))
        self.session = zenoh.open(config)
        self.received: deque[bytes] = deque()
        self.queue = ReadyQueue()
        self.publisher = self.session.declare_publisher(
            keys[0], congestion_control=zenoh.CongestionControl.BLOCK, reliability=zenoh.Reliability.RELIABLE
        )
        self._subscriber = self.session.declare_subscriber(
            keys[1], zenoh.handlers.Callback(self._on_sample, indirect=False)
        )

    def _on_sample(self, sample: Any) -> None:
        self.received.append(sample.payload.to_bytes())
        self.queue.post(1)

    def take(self) -> bytes | None:
        return self.received.popleft() if self.received else None


def echo_bare(port: int) -> None:
    end = Bare(port, ("answer", "ask"), listens=True)
    print("ready", flush=True)
    while True:
        while (data := end.take()) is not None:
            end.publisher.put(data)
        end.queue.wait(-1)


def send(rate: float, count: int) -> None:
    participant = open_participant()
    participant.add_node(NODE)
    writer = participant.create_writer(NODE, STREAM, ALL)
    print("ready", flush=True)
    sys.stdin.readline()
    data = b"\0\1\0\0" + bytes(196)
    begun, cpu = time.monotonic(), time.process_time()
    for number in range(count):
        time.sleep(max(0.0, begun + number / rate - time.monotonic()))
        writer.write(data)
    print((time.process_time() - cpu) / count * 1e6, flush=True)
    sys.stdin.readline()
    participant.close()


def receive(kind: str, count: int) -> None:
    participant = open_participant()
    participant.add_node(NODE)
    reader = participant.create_reader(NODE, STREAM, ALL)
    sink, queue = SampleQueue(10), ReadyQueue()
    if kind == "sink":
        reader.feed(sink)
    else:
        reader.notify(queue)
    print("ready", flush=True)
    sys.stdin.readline()
    cpu, received = time.process_time(), 0
    while received < count:
        if kind == "sink":
            time.sleep(0.05)
            received = sink.pushed()
            continue
        queue.wait(100_000_000)
        while reader.take() is not None:
            received += 1
    print((time.process_time() - cpu) / count * 1e6, flush=True)
    participant.close()


if __name__ == "__main__":
    verb, *numbers = sys.argv[1:]
    if verb == "echo":
        echo()
    elif verb == "bare":
        echo_bare(int(numbers[0]))
    elif verb == "send":
        send(float(numbers[0]), int(numbers[1]))
    else:
        receive(verb, int(numbers[0]))
