"""A participant in a separate process, controlled by lines of JSON on stdin, with one reply line for each."""

from __future__ import annotations

import hashlib
import json
import os
import random
import sys
import time

from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Participant, Reader, Topic, Writer
from tfloom.rmw.cyclone import config
from tfloom.rmw.qos import QoS

if receive_buffer := os.environ.get("PEER_RECEIVE_BUFFER"):
    config._RECEIVE_BUFFER = receive_buffer


class Peer:
    def __init__(self) -> None:
        self.participant: Participant | None = None
        self.node = NodeName("/", "peer")
        self.ends: list[Writer | Reader] = []

    def open(self, name: str) -> int:
        self.participant = open_participant()
        self.node = NodeName("/peers", name)
        self.participant.add_node(self.node)
        return os.getpid()

    def writer(self, topic: list[str], qos: list[int]) -> list:
        self.ends.append(self.participant.create_writer(self.node, Topic(*topic), QoS(*qos)))
        return [len(self.ends) - 1, self.ends[-1].gid.hex()]

    def reader(self, topic: list[str], qos: list[int]) -> list:
        self.ends.append(self.participant.create_reader(self.node, Topic(*topic), QoS(*qos)))
        return [len(self.ends) - 1, self.ends[-1].gid.hex()]

    def write(self, end: int, payload: str) -> None:
        self.ends[end].write(bytes.fromhex(payload))

    def write_random(self, end: int, seed: int, size: int) -> None:
        self.ends[end].write(b"\0\1\0\0" + random.Random(seed).randbytes(size))

    def assert_liveliness(self, end: int, for_s: float, every_s: float) -> None:
        until = time.monotonic() + for_s
        while time.monotonic() < until:
            self.ends[end].assert_liveliness()
            time.sleep(every_s)

    def matched(self, end: int) -> int:
        return self.ends[end].matched_count()

    def take(self, end: int) -> list[str]:
        return [sample.data.hex() for sample in iter(self.ends[end].take, None)]

    def take_digests(self, end: int) -> list[str]:
        return [hashlib.sha256(sample.data).hexdigest() for sample in iter(self.ends[end].take, None)]

    def close(self, end: int) -> None:
        self.ends[end].close()

    def nodes(self) -> list[str]:
        return [node.full for node in self.participant.graph.nodes()]

    def cpu_s(self, during_s: float) -> float:
        """Return the CPU time of all threads during an idle period."""
        before = time.process_time()
        time.sleep(during_s)
        return time.process_time() - before

    def leave(self) -> None:
        self.participant.close()


def main() -> None:
    peer = Peer()
    for line in sys.stdin:
        verb, *arguments = json.loads(line)
        print(json.dumps(getattr(peer, verb)(*arguments)), flush=True)


main()
