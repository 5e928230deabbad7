"""A message there and back between two processes, with one form of the extension: `trips.py EXTENSION COUNT DOMAIN`.

One message is in flight. Each carries its number, and the answer must be the same bytes. Prints the time of each trip
[µs] as a line of JSON.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from time import perf_counter_ns
from typing import Any

from benchmarks.native.worker import load

WARM_UP = 300
TIMEOUT_NS = 10_000_000_000


class End:
    """One side: a writer, and a reader whose messages it waits for."""

    def __init__(self, domain_id: int, sends: str, receives: str) -> None:
        from tfloom._native import ReadyQueue
        from tfloom.rmw.base import NodeName, Topic
        from tfloom.rmw.cyclone import wire as cyclonedds
        from tfloom.rmw.qos import QoS

        self._participant = cyclonedds.open_participant(domain_id)
        node = NodeName("/", f"trips_{os.getpid()}")
        self._participant.add_node(node)
        topics = [Topic(name, "std_msgs/msg/UInt64", "") for name in (sends, receives)]
        self.writer = self._participant.create_writer(node, topics[0], QoS())
        self._reader = self._participant.create_reader(node, topics[1], QoS())
        self._queue = ReadyQueue()
        self._reader.notify(self._queue, 1)

    def is_connected(self) -> bool:
        return self.writer.matched_count() == 1 and self._reader.matched_count() == 1

    def receive(self) -> bytes:
        while (sample := self._reader.take()) is None:
            if not self._queue.wait(TIMEOUT_NS):
                raise SystemExit("a message was lost")
        return sample.data

    def close(self) -> None:
        self._participant.close()


def answer(end: End) -> None:
    """Send every message back until an empty number arrives."""
    while any((data := end.receive())[4:]):
        end.writer.write(data)


def ask(end: End, count: int) -> list[float]:
    times_us = []
    for number in range(1, WARM_UP + count + 1):
        data = b"\0\1\0\0" + number.to_bytes(8, "little")
        begin_ns = perf_counter_ns()
        end.writer.write(data)
        if end.receive() != data:
            raise SystemExit("the answer to another message arrived")
        times_us.append((perf_counter_ns() - begin_ns) / 1e3)
    end.writer.write(b"\0\1\0\0" + bytes(8))
    return times_us[WARM_UP:]


def main() -> None:
    extension, count, domain_id = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    load(extension)
    if count == 0:
        end = End(domain_id, "/back", "/there")
        print("ready", flush=True)
        answer(end)
        end.close()
        return
    command = [sys.executable, "-m", "benchmarks.native.trips", extension, "0", str(domain_id)]
    other: Any = subprocess.Popen(command, stdout=subprocess.PIPE)
    try:
        other.stdout.readline()
        end = End(domain_id, "/there", "/back")
        while not end.is_connected():
            pass
        print(json.dumps(ask(end, count)))
        end.close()
        other.wait(10)
    finally:
        other.kill()
        other.wait()


if __name__ == "__main__":
    main()
