"""/tf between two hosts whose routers are joined by a link that loses and delays packets (`lossy_link.py`)."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from tests.conftest import Program, wait_until
from tests.namespaces import CABLE, QUEUE_S, Host, hosts_on_a_lossy_link
from tests.rmw.conftest import ask
from tests.zenoh_ports import hold_zenoh_port

pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")

NODE = Path(__file__).parent / "programs" / "zenoh_tf_node.py"
DELAY_S = 0.04
LOSS = 0.02
RATE = 10e6
SLOW_RATE = 2e6
LEASE_S = 2.0
RESTART_S = 5.0
DATAGRAMS = 400
LOSS_OF_DATAGRAMS = 0.2
RECEIVE = """
import socket, struct, time
receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
receiver.bind(("", 4000))
print("bound", flush=True)
while True:
    packet = receiver.recv(2000)
    print(time.monotonic() - struct.unpack_from("d", packet)[0], flush=True)
"""
SEND = """
import socket, struct, sys, time
sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for _ in range(int(sys.argv[2])):
    sender.sendto(struct.pack("d", time.monotonic()) + bytes(int(sys.argv[3])), (sys.argv[1], 4000))
    time.sleep(0.0005)
"""


class Network:
    """Two hosts, each with a router, on a lossy link."""

    def __init__(self, start_program: Callable[..., Program], port: int, rate: float) -> None:
        self._start = start_program
        self.near, self.far, self.link = hosts_on_a_lossy_link(start_program, DELAY_S, LOSS, rate)
        self._far_end = f"tcp/{self.near.address}:{port}"
        self._listen = ("-l", f"tcp/127.0.0.1:{port}", "-l", self._far_end)
        self.start_near_router()
        self.start_router(self.far, "-e", self._far_end)

    def start_router(self, host: Host, *words: str) -> Program:
        router = self._start(*host.enter, sys.executable, "-m", "tfloom", "zenoh", "router", *words)
        router.wait_for("listening on")
        return router

    def start_near_router(self) -> None:
        """Start the router that the other one connects to."""
        self.near_router = self.start_router(self.near, *self._listen)

    def node(self, host: Host, role: str) -> Program:
        node = self._start(*host.enter, sys.executable, NODE, role, stdin=subprocess.PIPE)
        node.wait_for("ready")
        return node


@contextmanager
def network(start_program: Callable[..., Program], rate: float) -> Iterator[Network]:
    """Make the hosts, on their own port."""
    with hold_zenoh_port() as port, pytest.MonkeyPatch.context() as patch:
        patch.setenv("TFLOOM_LEASE_S", str(LEASE_S))
        patch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
        yield Network(start_program, port, rate)


def send(sender: Program, count: int, transforms: int, period_s: float) -> int:
    """Send messages, and return the number of the first."""
    return int(ask(sender, "send", count, transforms, period_s)[1])


def count(receiver: Program, first: int) -> tuple[int, int]:
    """Return how many messages have come since a number, and how many have been told as lost, in all."""
    _, came, lost = ask(receiver, "count", first)
    return int(came), int(lost)


def packets(link: Program) -> tuple[int, int, int]:
    """Return how many packets went into the link, were lost by chance, and had no room."""
    _, sent, _, lost, _, late = ask(link, "?", answer="packets")
    return int(sent), int(lost), int(late)


def wait_for_one(sender: Program, receiver: Program) -> int:
    """Send single messages until one has come, and return the number of the last one sent."""
    first = last = send(sender, 1, 1, 0.2)

    def has_come() -> bool:
        nonlocal last
        # A message needs the delay, and sometimes a few retransmissions: the next one is sent when it has had time.
        last = send(sender, 1, 1, 0.2)
        return count(receiver, first)[0] > 0

    wait_until(has_come)
    return last


def test_nothing_is_lost_within_the_rate(start_program: Callable[..., Program]) -> None:
    with network(start_program, RATE) as net:
        sender, receiver = net.node(net.near, "sender"), net.node(net.far, "receiver")
        wait_for_one(sender, receiver)
        before = packets(net.link)[1]
        first = send(sender, 200, 10, 0.01)
        wait_until(lambda: count(receiver, first)[0] >= 200)
        assert count(receiver, first) == (200, 0)
        assert packets(net.link)[1] > before


def test_what_is_lost_beyond_the_rate_is_told(start_program: Callable[..., Program]) -> None:
    with network(start_program, SLOW_RATE) as net:
        sender, receiver = net.node(net.near, "sender"), net.node(net.far, "receiver")
        wait_for_one(sender, receiver)
        first = send(sender, 150, 200, 0.01)  # ten times what the link carries
        # A gap is told by the next message: those after the queues have emptied close the last one.
        last = wait_for_one(sender, receiver)
        wait_until(lambda: send(sender, 1, 1, 0.1) and sum(count(receiver, first)) > last - first)
        sent = send(sender, 1, 1, 0.2) - first + 1
        wait_until(lambda: sum(count(receiver, first)) == sent)
        came, lost = count(receiver, first)
        assert 0 < lost < sent
        assert came == sent - lost


@pytest.mark.timing
def test_the_tree_is_complete_again_after_a_restart_of_a_router(
    start_program: Callable[..., Program],
) -> None:
    with network(start_program, RATE) as net:
        sender, receiver = net.node(net.near, "sender"), net.node(net.far, "receiver")
        ask(sender, "tick")
        ask(receiver, "tree")
        net.near_router.end()
        net.start_near_router()
        restarted_s = time.monotonic()
        newcomer = net.node(net.far, "receiver")
        ask(receiver, "tree")
        ask(newcomer, "tree")  # has its /tf_static from a sender beyond the new router
        assert time.monotonic() - restarted_s < RESTART_S


def test_the_link_delays_and_loses_and_leaves_no_interface(start_program: Callable[..., Program]) -> None:
    """Each packet comes after the delay, or is counted as lost."""
    near, far, link = hosts_on_a_lossy_link(start_program, DELAY_S, LOSS_OF_DATAGRAMS, RATE)
    receiver = start_program(*far.enter, sys.executable, "-c", RECEIVE)
    receiver.wait_for("bound")
    near.run(sys.executable, "-c", SEND, str(far.address), str(DATAGRAMS), "10")
    wait_until(lambda: packets(link)[0] >= DATAGRAMS)
    sent, lost, late = packets(link)
    assert (sent, late) == (DATAGRAMS, 0)
    # The standard deviation of a binomial distribution: five of them.
    assert (
        abs(lost - sent * LOSS_OF_DATAGRAMS) < 5 * (sent * LOSS_OF_DATAGRAMS * (1 - LOSS_OF_DATAGRAMS)) ** 0.5
    )
    wait_until(lambda: len(receiver.lines) == 1 + sent - lost)
    assert min(map(float, receiver.lines[1:])) >= DELAY_S
    assert all(CABLE in host.run("ip", "-br", "link") for host in (near, far))
    os.kill(link.process.pid, signal.SIGKILL)
    wait_until(lambda: not any(CABLE in host.run("ip", "-br", "link") for host in (near, far)))


def test_the_link_has_a_rate(start_program: Callable[..., Program]) -> None:
    """Packets take their time, one after the other, and those without room are dropped."""
    near, far, link = hosts_on_a_lossy_link(start_program, 0.0, 0.0, SLOW_RATE / 2)
    receiver = start_program(*far.enter, sys.executable, "-c", RECEIVE)
    receiver.wait_for("bound")
    near.run(sys.executable, "-c", SEND, str(far.address), "200", "1000")
    wait_until(lambda: packets(link)[0] >= 200)
    sent, lost, late = packets(link)
    assert lost == 0
    assert 0 < late < sent
    wait_until(lambda: len(receiver.lines) == 1 + sent - late)
    assert max(map(float, receiver.lines[1:])) >= QUEUE_S
