"""Large messages, for whose datagrams a writer waits until the sockets of this machine's readers have room.

Readers are stopped, killed and made again, and writers are closed, interrupted and forked while they wait. How long
they wait is tested with a clock and a kernel of its own, in tests/native/paced_senders.cpp.
"""

from __future__ import annotations

import hashlib
import signal
import socket
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import wait_until
from tests.namespaces import containers_of_a_host
from tests.rmw.conftest import Peer, tell

from tfloom.rmw.base import NodeName, Participant, Topic, Writer
from tfloom.rmw.cyclone import config
from tfloom.rmw.cyclone.config import configuration, discovery_port
from tfloom.rmw.cyclone.wire import open_participant
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.qos import HistoryPolicy, QoS, ReliabilityPolicy

# A reader that isn't run for a while misses what is sent at best effort meanwhile.
pytestmark = [
    pytest.mark.timing,
    pytest.mark.skipif(
        sys.platform != "linux", reason="the queue of another process's socket is known on Linux"
    ),
]
BEST_EFFORT = QoS(reliability=ReliabilityPolicy.BEST_EFFORT, history=HistoryPolicy.KEEP_ALL)
HEADER = b"\0\1\0\0"
IMAGE = HEADER + bytes(1_000_000)
"""Sixteen datagrams, of which a socket holds six."""
LARGE, SMALL = (f'<SocketReceiveBufferSize max="{size}"/>' for size in ("4MB", "208kB"))


@pytest.fixture
def small_sockets(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Have peers' sockets hold as much as Linux allows by default: six datagrams of 64 kB."""
    # Without a CYCLONEDDS_URI, as in most programs: then they are bound to the loopback interface.
    assert LARGE in configuration(domain_id)
    monkeypatch.setattr(config, "_RECEIVE_BUFFER", SMALL)
    monkeypatch.setenv("PEER_RECEIVE_BUFFER", SMALL)


@pytest.fixture
def unbound_small_sockets(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """As `small_sockets`, open to other machines, as with a CYCLONEDDS_URI."""
    monkeypatch.setenv("CYCLONEDDS_URI", configuration(domain_id).replace(LARGE, SMALL))


def numbered(count: int, mark: bytes = b"") -> list[bytes]:
    """Return messages of 2 MB, each other than the others."""
    return [HEADER + mark + bytes([number]) * 2_000_000 for number in range(count)]


def digests(messages: list[bytes]) -> list[str]:
    return [hashlib.sha256(message).hexdigest() for message in messages]


class Sender:
    """A participant of this process that writes to readers in other ones."""

    def __init__(
        self,
        domain_id: int,
        start_peer: Callable[..., Peer],
        node: NodeName,
        topic: Topic,
        qos: QoS = BEST_EFFORT,
    ) -> None:
        self.participant: Participant = open_participant(domain_id)
        self.participant.add_node(node)
        self._start_peer, self._node, self._topic, self._qos = start_peer, node, topic, qos
        self.writer = self.new_writer()
        self.peer, self.reader = self.new_peer()

    def new_writer(self) -> Writer:
        return self.participant.create_writer(self._node, self._topic, self._qos)

    def new_peer(self) -> tuple[Peer, int]:
        """Return another process and its reader, when that and the writer are matched."""
        peer = self._start_peer()
        return peer, self.new_reader(peer)

    def new_reader(self, peer: Peer) -> int:
        reader, gid = peer("reader", self._topic, self._qos)
        writer: Any = self.writer

        def is_matched() -> bool:
            return gid in {matched.hex() for matched, _ in writer.matched()} and peer("matched", reader) > 0

        wait_until(is_matched)
        return int(reader)

    def write_and_take(self, messages: list[bytes]) -> list[str]:
        """Write messages at once, and return the digests of those that arrive, in their order."""
        for message in messages:
            self.writer.write(message)
        return self.take_until_last(digests(messages))

    def take_until_last(self, sent: list[str]) -> list[str]:
        """Return which of these arrive before a message that is written from now on."""
        last = HEADER + b"last" * 500_000
        received: list[str] = []

        def all_have_come() -> bool:
            received.extend(self.peer("take_digests", self.reader))
            if digests([last])[0] in received:
                return True
            self.writer.write(last)
            return False

        wait_until(all_have_come, what="the message that is written after all others")
        return [digest for digest in received if digest in sent]

    def stop_reading(self) -> None:
        """Stop the reader's process, when it has read all that was sent, so that the next writer waits for it."""
        self.peer.program.signal(signal.SIGCONT)
        self.take_until_last([])
        self.peer.program.pause()


@pytest.fixture
def sender(
    domain_id: int, small_sockets: None, start_peer: Callable[..., Peer], node: NodeName, topic: Topic
) -> Iterator[Sender]:
    sender = Sender(domain_id, start_peer, node, topic)
    yield sender
    sender.participant.close()


class Loop:
    """A thread that writes images, one after the other, until it is told to end, or a write raises an error."""

    def __init__(self, writer: Writer, message: bytes = IMAGE) -> None:
        self._writer, self._message = writer, message
        self._is_over = False
        self.count = 0
        self.error: Exception | None = None
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        try:
            while not self._is_over:
                self._writer.write(self._message)
                self.count += 1
        except ClosedError as error:
            self.error = error

    def wait_for_writes(self, more: int = 3) -> None:
        least = self.count + more
        wait_until(lambda: self.count >= least or self.error is not None, what=f"{more} writes")

    def end(self) -> None:
        self._is_over = True
        self.join()

    def join(self) -> None:
        self._thread.join(30)
        assert not self._thread.is_alive(), "a write never returned"


@pytest.mark.parametrize("sockets", ["small_sockets", "unbound_small_sockets"])
@pytest.mark.parametrize(
    ("qos", "least"),
    [
        (QoS(history=HistoryPolicy.KEEP_ALL), 20),
        # A reader that is not scheduled for longer than a writer waits loses some; without waits it gets two or three.
        (BEST_EFFORT, 10),
    ],
    ids=["reliable", "best effort"],
)
def test_large_messages_arrive_in_small_sockets(
    domain_id, start_peer, node, topic, qos, least, sockets, request
) -> None:
    request.getfixturevalue(sockets)
    sender = Sender(domain_id, start_peer, node, topic, qos)
    sent = digests(messages := numbered(20))
    arrived = sender.write_and_take(messages)
    sender.participant.close()
    assert arrived == [digest for digest in sent if digest in arrived]
    assert len(arrived) >= least


def test_stopped_reader_does_not_stop_its_writer(sender: Sender) -> None:
    sender.peer.program.pause()
    begin_s = time.monotonic()
    for _ in range(30):
        sender.writer.write(IMAGE)
    took_s = time.monotonic() - begin_s
    sender.peer.program.signal(signal.SIGCONT)
    assert took_s < 5.0  # a wait for each of its 480 datagrams would take 24 s
    sent = numbered(20)
    assert len(sender.write_and_take(sent)) >= 10


def test_reader_that_is_made_again_in_its_process_is_waited_for(sender: Sender) -> None:
    sender.peer.program.pause()
    sender.writer.write(IMAGE)
    sender.peer.program.signal(signal.SIGCONT)
    sender.peer("close", sender.reader)
    wait_until(lambda: sender.writer.matched_count() == 0)
    sender.writer.write(IMAGE)  # to nobody
    sender.reader = sender.new_reader(sender.peer)
    assert len(sender.write_and_take(numbered(20))) >= 10


def test_reader_that_is_killed_while_a_writer_waits_has_a_successor(domain_id: int, sender: Sender) -> None:
    loop = Loop(sender.writer)
    loop.wait_for_writes()
    sender.peer.program.pause()
    loop.wait_for_writes()
    sender.peer.program.signal(signal.SIGKILL)
    sender.peer.program.wait()
    loop.wait_for_writes(100)
    # Its port belongs to a program that reads nothing, and isn't of DDS.
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(("127.0.0.1", discovery_port(domain_id, 1) + 1))
        loop.wait_for_writes(100)
        assert stranger.recv(1000, socket.MSG_DONTWAIT), "this is not the port that was written to"
    # The next process gets that port. The writer writes to it all the time, also before there is a socket.
    sender.peer, sender.reader = sender.new_peer()
    loop.end()
    assert len(sender.write_and_take(numbered(20))) >= 10


def test_other_threads_run_while_a_writer_waits(sender: Sender) -> None:
    steps = 0
    is_over = False

    def step() -> None:
        nonlocal steps
        while not is_over:
            steps += 1
            time.sleep(0.0005)

    thread = threading.Thread(target=step)
    thread.start()

    def ran_meanwhile() -> bool:
        sender.stop_reading()
        before = steps
        sender.writer.write(IMAGE)
        return steps - before >= 10

    try:
        wait_until(ran_meanwhile, what="ten steps of another thread during a write")
    finally:
        is_over = True
        thread.join()
    sender.peer.program.signal(signal.SIGCONT)


@pytest.mark.parametrize("what", ["writer", "participant"])
def test_writer_is_closed_while_it_waits(sender: Sender, what: str) -> None:
    for delay_s in (0.0, 0.01, 0.02, 0.04):
        sender.stop_reading()
        loop = Loop(sender.writer)
        time.sleep(delay_s)
        getattr(sender, what).close()
        loop.join()
        assert loop.error is not None, loop.count
        if what == "participant":
            return
        sender.peer.program.signal(signal.SIGCONT)
        sender.writer = sender.new_writer()
        wait_until(lambda: sender.writer.matched_count() == 1)


def test_two_writers_at_once(sender: Sender) -> None:
    writers = [sender.writer, sender.new_writer()]
    wait_until(lambda: all(writer.matched_count() == 1 for writer in writers))
    wait_until(lambda: sender.peer("matched", sender.reader) == 2)
    sent = [numbered(10, b"aaaa"), numbered(10, b"bbbb")]

    def write_all(writer: Writer, messages: list[bytes]) -> None:
        for message in messages:
            writer.write(message)

    threads = [threading.Thread(target=write_all, args=pair) for pair in zip(writers, sent, strict=True)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(30)
        assert not thread.is_alive()
    arrived = sender.take_until_last(digests(sent[0] + sent[1]))
    for messages in sent:
        of_writer = [digest for digest in arrived if digest in digests(messages)]
        assert of_writer == [digest for digest in digests(messages) if digest in of_writer]
        assert of_writer  # how many, depends on what else the machine does
    sender.peer.program.pause()
    loops = [Loop(writer) for writer in writers]
    for loop in loops:
        loop.wait_for_writes()
        loop.end()
    sender.peer.program.signal(signal.SIGCONT)


INTERRUPTED = """
import sys, threading, time
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

rclpy.init()
node = rclpy.create_node("camera")
publisher = node.create_publisher(Image, "chatter", qos_profile_sensor_data)
image = Image(data=bytes(1_000_000))
while publisher.get_subscription_count() == 0:
    rclpy.spin_once(node, timeout_sec=0.01)
print("matched", flush=True)
sys.stdin.readline()

def await_wait():
    time.sleep(0.01)  # the first publish waits for longer
    print("waits", flush=True)
    if sys.argv[1] == "shutdown":
        rclpy.shutdown()

threading.Thread(target=await_wait).start()
try:
    while rclpy.ok():
        publisher.publish(image)
except KeyboardInterrupt:
    pass
except Exception as error:
    print(f"{type(error).__name__}: {error}", flush=True)
print("ended", flush=True)
"""


@pytest.mark.parametrize("end", ["interrupt", "shutdown"])
def test_program_ends_while_it_waits_for_a_reader(
    start_peer: Callable[..., Peer], start_program: Callable[..., Any], end: str
) -> None:
    peer = start_peer()
    peer("reader", Topic("/chatter", "sensor_msgs/msg/Image", ""), BEST_EFFORT)
    program = start_program("python", "-c", INTERRUPTED, end, stdin=subprocess.PIPE)
    program.wait_for("matched")
    peer.program.pause()
    tell(program, "go")
    program.wait_for("waits")
    if end == "interrupt":
        program.signal(signal.SIGINT)
    program.wait_for("ended")
    assert program.wait() == 0, program.output
    refused = "RCLError: Failed to publish: publisher's context is invalid"
    assert [line for line in program.lines if line != refused] == ["matched", "waits", "ended"]
    peer.program.signal(signal.SIGCONT)


FORKS = """
import os, sys, time
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.cyclone.wire import open_participant
from tfloom.rmw.qos import QoS, ReliabilityPolicy

best_effort = QoS(reliability=ReliabilityPolicy.BEST_EFFORT)
topic = Topic("/chatter", "std_msgs/msg/String", "RIHS01_" + "0" * 64)

def write(mark):
    participant = open_participant(int(os.environ["ROS_DOMAIN_ID"]))
    node = NodeName("/tests", mark)
    participant.add_node(node)
    writer = participant.create_writer(node, topic, best_effort)
    while not writer.matched_count():
        time.sleep(0.001)
    print(mark, "matched", flush=True)
    sys.stdin.readline()
    write_images(writer, mark)
    return participant, writer

def write_images(writer, mark):
    for _ in range(12):
        writer.write(b"\\0\\1\\0\\0" + mark.encode() + bytes(2_000_000))

parent = write("parent")
child = os.fork()
if child == 0:
    participant, _ = write("child")
    participant.close()
    os._exit(0)
assert os.waitpid(child, 0)[1] == 0
write_images(parent[1], "again")
"""


def test_forked_child_waits_for_readers_too(
    domain_id: int,
    small_sockets: None,
    node: NodeName,
    topic: Topic,
    start_program: Callable[..., Any],
) -> None:
    participant = open_participant(domain_id)
    participant.add_node(node)
    reader = participant.create_reader(node, topic, BEST_EFFORT)
    program = start_program("python", "-W", "ignore::DeprecationWarning", "-c", FORKS, stdin=subprocess.PIPE)
    for count, mark in enumerate(("parent", "child"), start=1):
        program.wait_for(f"{mark} matched")
        wait_until(lambda count=count: reader.matched_count() == count)
        tell(program, "go")
    assert program.wait() == 0, program.output
    marks = Counter(sample.data[4:8] for sample in iter(reader.take, None))
    participant.close()
    assert set(marks) == {b"pare", b"chil", b"agai"}
    assert all(count >= 6 for count in marks.values()), marks


def test_writer_in_a_container_waits_for_a_reader_in_another_one(
    domain_id: int,
    small_sockets: None,
    start_peer: Callable[..., Peer],
    start_program: Callable[..., Any],
    topic: Topic,
) -> None:
    receiving, sending = (start_peer(*host.enter) for host in containers_of_a_host(start_program))
    reader, _ = receiving("reader", topic, BEST_EFFORT)
    writer, _ = sending("writer", topic, BEST_EFFORT)
    wait_until(lambda: receiving("matched", reader) and sending("matched", writer))
    for seed in range(20):
        sending("write_random", writer, seed, 2_000_000)
    received: list[str] = []

    def enough() -> bool:
        received.extend(receiving("take_digests", reader))
        return len(received) >= 10

    wait_until(enough, what="half of the messages")
