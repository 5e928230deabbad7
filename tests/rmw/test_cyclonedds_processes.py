"""Processes that are killed, rejoin, are many, idle, fork, or end without closing."""

from __future__ import annotations

import os
import signal
import threading
import time

import pytest
from tests.rmw.conftest import outputs_by_end

from tfloom._native import ReadyQueue, SampleQueue
from tfloom.rmw.base import NodeName
from tfloom.rmw.cyclone.wire import open_participant
from tfloom.rmw.qos import DurabilityPolicy, QoS, ReliabilityPolicy

needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
DATA = b"\0\1\0\0data"
STRESS_S = 0.5


def test_killed_reader_can_rejoin(participant, start_peer, node, topic, wait_until) -> None:
    qos = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=1)
    writer = participant.create_writer(node, topic, qos)
    for _ in range(3):
        peer = start_peer()
        end, _ = peer("reader", topic, qos)
        writer.write(DATA)
        wait_until(lambda p=peer, e=end: p("take", e) == [DATA.hex()])
        os.kill(peer.pid, signal.SIGKILL)
        peer.program.wait()


def test_killed_writer_can_rejoin(participant, start_peer, node, topic, take_data) -> None:
    qos = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=1)
    reader = participant.create_reader(node, topic, qos)
    for i in range(3):
        peer = start_peer()
        end, _ = peer("writer", topic, qos)
        peer("write", end, (DATA + bytes([i, 0, 0, 0])).hex())
        assert take_data(reader, 1) == [DATA + bytes([i, 0, 0, 0])]
        os.kill(peer.pid, signal.SIGKILL)
        peer.program.wait()


@pytest.mark.parametrize("lease_s", [2.0, 4.0])
def test_killed_peer_leaves_the_graph_after_its_lease(
    domain_id, monkeypatch, start_peer, wait_until, lease_s: float
) -> None:
    here = open_participant(domain_id)
    monkeypatch.setenv("TFLOOM_LEASE_S", str(lease_s))  # that of the peer, which it announces
    peer = start_peer()
    wait_until(lambda: here.graph.nodes() == [NodeName("/peers", "peer_0")])
    os.kill(peer.pid, signal.SIGKILL)
    peer.program.wait()
    killed = time.monotonic()
    wait_until(lambda: here.graph.nodes() == [], timeout_s=8)
    # A lease starts with the last packet, which may have come a fifth of the lease before.
    assert time.monotonic() - killed > 0.1 * lease_s
    here.close()


def test_nodes_of_a_leaving_peer_are_removed_at_once(
    participant, start_peer, node, topic, wait_until
) -> None:
    peer = start_peer()
    peer("reader", topic, QoS())
    wait_until(lambda: len(participant.graph.nodes()) == 2 and participant.graph.endpoints())
    peer("leave")
    wait_until(lambda: participant.graph.nodes() == [node] and not participant.graph.endpoints(), timeout_s=5)


@pytest.mark.slow
def test_twenty_processes_discover_each_other(participant, start_peer, wait_until) -> None:
    peers = [start_peer() for _ in range(20)]
    everybody = sorted(["/tests/here", *(f"/peers/peer_{i}" for i in range(20))])
    for peer in peers:
        wait_until(lambda p=peer: p("nodes") == everybody)
    assert [node.full for node in participant.graph.nodes()] == everybody


def test_endpoints_join_and_leave_while_data_flows(participant, start_peer, node, topic, wait_until) -> None:
    peer = start_peer()
    stop = threading.Event()
    failures: list[BaseException] = []

    def churn(make_use_of) -> None:
        try:
            while not stop.is_set():
                make_use_of()
        except BaseException as error:
            failures.append(error)
            raise

    def feed_for_a_moment() -> None:
        reader = participant.create_reader(node, topic, QoS())
        reader.feed(SampleQueue(10))
        reader.close()

    def take_for_a_moment() -> None:
        queue = ReadyQueue()
        reader = participant.create_reader(node, topic, QoS())
        reader.notify(queue, 1)
        reader.take()
        queue.wait(1_000_000)
        reader.close()

    def write_for_a_moment() -> None:
        writer = participant.create_writer(node, topic, QoS(reliability=ReliabilityPolicy.BEST_EFFORT))
        for _ in range(20):
            writer.write(DATA)
        writer.close()

    steady = participant.create_writer(node, topic, QoS())
    threads = [
        threading.Thread(target=churn, args=[action])
        for action in (
            feed_for_a_moment,
            take_for_a_moment,
            write_for_a_moment,
            lambda: steady.write(DATA),
            participant.graph.endpoints,
        )
    ]
    end, _ = peer("reader", topic, QoS())
    for thread in threads:
        thread.start()
    stop.wait(STRESS_S)
    stop.set()
    for thread in threads:
        thread.join(30)
        assert not thread.is_alive()
    assert not failures
    wait_until(lambda: steady.write(DATA) or peer("take", end))


@pytest.mark.timing
def test_idle_process_uses_no_cpu_time(participant, start_peer, node, topic, wait_until) -> None:
    peer = start_peer()
    end, _ = peer("reader", topic, QoS())
    writer = participant.create_writer(node, topic, QoS())
    wait_until(lambda: writer.matched_count() and peer("matched", end))
    assert peer("cpu_s", 2.0) < 0.02


IMPORTS = """
import gc, sys
from tfloom._native import ReadyQueue, SampleQueue
from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.qos import QoS
"""
LEAVES_WITHOUT_A_WORD = """
participant = open_participant()
node, topic = NodeName("/", "n"), Topic("/chatter", "std_msgs/msg/String", "")
participant.add_node(node)
queue = ReadyQueue()
ends = [participant.create_reader(node, topic, QoS()) for _ in range(3)]
ends.append(participant.create_writer(node, topic, QoS()))
ends[0].feed(SampleQueue(10))
ends[1].notify(queue, 1)
participant.graph.notify(queue, 2)
for _ in range(100):
    ends[3].write(b"\\0\\1\\0\\0data")
"""


ENDS = {
    "pass": 0,
    "sys.exit(3)": 3,
    "del participant, ends": 0,
    "raise KeyboardInterrupt": -signal.SIGINT,
    "ends[0].me = ends; participant.me = participant; del ends, participant; gc.collect()": 0,
}
"""The last line of a process, and its exit code."""


@needs_fork
def test_a_process_that_closes_nothing_ends(domain_id, start_program) -> None:
    outputs = outputs_by_end(start_program, IMPORTS, LEAVES_WITHOUT_A_WORD, ENDS)
    assert [(code, lines[-1:]) for code, lines in outputs] == [
        (code, [] if code >= 0 else ["KeyboardInterrupt"]) for code in ENDS.values()
    ]


FORKS = """
import os
import signal
pid = os.fork()
if pid == 0:
    participant.close()
    for end in ends:
        end.close()
    sys.exit(7)
_, status = os.waitpid(pid, 0)
print("child", os.waitstatus_to_exitcode(status))
ends[3].write(b"\\0\\1\\0\\0data")
participant.close()
"""


@needs_fork
def test_forked_child_ends_without_effect_on_its_parent(domain_id, start_program) -> None:
    # From 3.12 on Python warns about a fork with other threads, which is tested here.
    program = start_program(
        "python", "-W", "ignore::DeprecationWarning", "-c", IMPORTS + LEAVES_WITHOUT_A_WORD + FORKS
    )
    assert program.wait() == 0
    assert program.output == "child 7"
