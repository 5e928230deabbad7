"""Hosts of a test's own: network namespaces of Linux, joined by cables, each with shared memory of its own."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import Program, run_to_end

SNIFF = Path(__file__).parent / "programs" / "sniff.py"
LOSSY_LINK = Path(__file__).parent / "programs" / "lossy_link.py"
CABLE = "cable"
"""The name of a host's interface, besides lo."""
QUEUE_S = 0.2
"""How long a packet waits for its turn on a lossy link [s], before it is dropped."""

MARK = "88b5" + "6d61726b"
"""The protocol and the content of a frame that marks a time, in hex. The protocol is for local use (IEEE 802)."""

_ENTERED = ("--user", "--net", "--mount", "--preserve-credentials")
_CREATED = ("unshare", "--net", "--mount")


def why_impossible() -> str:
    """Return why namespaces can't be made here; empty if they can."""
    if sys.platform != "linux":
        return "network namespaces are Linux's"
    for program in ("unshare", "nsenter", "ip", "mount"):
        if shutil.which(program) is None:
            return f"needs the program {program}"
    command = ["unshare", "-Urnm", "mount", "-t", "tmpfs", "tmpfs", "/dev/shm"]  # a mount point
    tried = run_to_end(command)
    return f"namespaces aren't allowed here: {tried.stderr.strip()}" if tried.returncode else ""


class Host:
    """A network namespace, with an empty /dev/shm, as long as its process runs.

    Args:
        start_program: Starts that process.
        create: The command by which it is made, in front of another one.
        address: The address of its cable; None: it has none.
    """

    def __init__(
        self, start_program: Callable[..., Program], create: tuple[str, ...], address: str | None = None
    ) -> None:
        script = "mount -t tmpfs tmpfs /dev/shm && echo ready && exec cat"
        self.program = start_program(*create, "sh", "-c", script, stdin=subprocess.PIPE)
        self.program.wait_for("ready")
        self.address = address
        self.pid = str(self.program.process.pid)
        self.enter = ("nsenter", "--target", self.pid, *_ENTERED)
        """The words in front of a command that runs it on this host."""
        self.run("ip", "link", "set", "lo", "up")

    def run(self, *command: str | Path) -> str:
        """Run a command on this host and return its output; fail the test if it fails."""
        done = run_to_end([*self.enter, *command])
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def set_up(self, interface: str, address: str) -> None:
        """Give an interface an address, and set it up, without IPv6, which sends by itself."""
        self.run("sysctl", "-eqw", f"net.ipv6.conf.{interface}.disable_ipv6=1")
        self.run("ip", "address", "add", f"{address}/24", "dev", interface)
        self.run("ip", "link", "set", interface, "up")

    def sniff(self, start_program: Callable[..., Program]) -> Program:
        """Start a program on this host that prints each packet on the cable, and return it when it listens."""
        program = start_program(*self.enter, sys.executable, SNIFF, CABLE)
        program.wait_for("listening")
        return program


def packets_so_far(host: Host, sniffing: Program) -> list[str]:
    """Return what the host's `sniff` has seen: all that was sent before a frame that is sent now."""
    host.run(sys.executable, SNIFF, CABLE, MARK)
    sniffing.wait_for(MARK)
    marked = next(number for number, line in enumerate(sniffing.lines) if MARK in line)
    return sniffing.lines[1:marked]


def hosts_on_a_subnet(start_program: Callable[..., Program]) -> tuple[Host, Host]:
    """Return two hosts, 10.77.0.1 and 10.77.0.2, at the ends of a cable; skip the test where this isn't allowed.

    A packet without another route, as one to a multicast address, goes by the cable.
    """
    near, far = _two_hosts(start_program)
    near.run("ip", "link", "add", CABLE, "type", "veth", "peer", "name", CABLE, "netns", far.pid)
    _set_up_cable(near, far)
    return near, far


def hosts_on_a_lossy_link(
    start_program: Callable[..., Program], delay_s: float, loss: float, rate: float, seed: int = 1
) -> tuple[Host, Host, Program]:
    """Return two hosts as `hosts_on_a_subnet` has them, whose cable delays, loses and slows, and the program that does.

    Skip the test where this isn't allowed.

    Args:
        start_program: Starts the processes.
        delay_s: The delay of each way [s].
        loss: The share of packets that are lost.
        rate: The rate of each way [bit/s].
        seed: Of the losses.
    """
    near, far = _two_hosts(start_program)
    if not os.access("/dev/net/tun", os.R_OK | os.W_OK):
        pytest.skip("needs /dev/net/tun")
    words = (far.pid, CABLE, delay_s, loss, rate, QUEUE_S, seed)
    link = start_program(*near.enter, sys.executable, LOSSY_LINK, *map(str, words), stdin=subprocess.PIPE)
    link.wait_for("linked")
    _set_up_cable(near, far)
    return near, far, link


def _two_hosts(start_program: Callable[..., Program]) -> tuple[Host, Host]:
    _skip_if_impossible()
    near = Host(start_program, ("unshare", "-Urnm"), "10.77.0.1")
    return near, Host(start_program, (*near.enter, *_CREATED), "10.77.0.2")


def _set_up_cable(*hosts: Host) -> None:
    for host in hosts:
        assert host.address is not None
        host.set_up(CABLE, host.address)
        host.run("ip", "route", "add", "default", "dev", CABLE)


def containers_of_a_host(start_program: Callable[..., Program]) -> tuple[Host, Host]:
    """Return two hosts that share a network and have shared memory of their own, as with `docker --network host`."""
    _skip_if_impossible()
    first = Host(start_program, ("unshare", "-Urnm"), "127.0.0.1")
    return first, Host(start_program, (*first.enter, "unshare", "--mount"), "127.0.0.1")


def hosts_behind_a_router(start_program: Callable[..., Program]) -> tuple[Host, Host]:
    """Return two hosts on two subnets, 10.77.1.2 and 10.77.2.2, with a router between, which forwards no multicast.

    Skip the test where this isn't allowed.
    """
    _skip_if_impossible()
    router = Host(start_program, ("unshare", "-Urnm"))
    router.run("sysctl", "-qw", "net.ipv4.ip_forward=1")
    hosts = []
    for number in (1, 2):
        host = Host(start_program, (*router.enter, *_CREATED), f"10.77.{number}.2")
        port = f"port{number}"
        router.run("ip", "link", "add", port, "type", "veth", "peer", "name", CABLE, "netns", host.pid)
        router.set_up(port, f"10.77.{number}.1")
        host.set_up(CABLE, f"10.77.{number}.2")
        host.run("ip", "route", "add", "default", "via", f"10.77.{number}.1")
        hosts.append(host)
    return hosts[0], hosts[1]


def _skip_if_impossible() -> None:
    if reason := why_impossible():
        pytest.skip(reason)
