"""What another machine can send: two network namespaces, joined by a cable, on Linux."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end

from tfloom.rmw.cyclone.config import configuration_for

INJECT = Path(__file__).parent / "programs" / "inject.py"
OURS, THEIRS = "10.77.0.1", "10.77.0.2"
TOPIC = ["/chatter", "std_msgs/msg/String", ""]
RELIABLE = [1, 2, 1, 10]
FIRST, SECOND, FORGED = "0001000001000000", "0001000002000000", "000100000f000000"

pytestmark = [
    pytest.mark.wire,
    pytest.mark.skipif(sys.platform != "linux", reason="network namespaces are Linux's"),
]


class Namespace:
    """A network namespace, as long as its process runs."""

    def __init__(
        self, start_program: Callable[..., Any], start_peer: Callable[..., Any], create: list[str]
    ) -> None:
        self.program = start_program(*create, "sh", "-c", "echo ready; exec cat", stdin=subprocess.PIPE)
        self.start_peer = start_peer
        self.program.wait_for("ready")
        pid = str(self.program.process.pid)
        self.enter = ["nsenter", "--target", pid, "--user", "--net", "--preserve-credentials"]

    def run(self, *command: str | Path) -> str:
        done = run_to_end([*self.enter, *command])
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def peer(self) -> Any:
        return self.start_peer(*self.enter)

    def inject(self, gid: str, sequence_number: int, *ports: int) -> list[bool]:
        """Send FORGED to our ports as a sample of a writer; return for each whether it is refused."""
        words = [OURS, gid, str(sequence_number), FORGED, *map(str, ports)]
        return list(json.loads(self.run(sys.executable, INJECT, *words)))


@pytest.fixture
def namespaces(
    start_program: Callable[..., Any], start_peer: Callable[..., Any]
) -> Iterator[tuple[Namespace, Namespace]]:
    """Return two namespaces in a user namespace of their own; skip the test where these are not allowed."""
    for program in ("unshare", "nsenter", "ip"):
        if shutil.which(program) is None:
            pytest.skip(f"needs the program {program}")
    tried = run_to_end(["unshare", "-Urn", "true"])
    if tried.returncode != 0:
        pytest.skip(f"user namespaces aren't allowed here: {tried.stderr.strip()}")
    ours = Namespace(start_program, start_peer, ["unshare", "-Urn"])
    theirs = Namespace(start_program, start_peer, [*ours.enter, "unshare", "-n"])
    their_pid = str(theirs.program.process.pid)
    ours.run("ip", "link", "add", "cable", "type", "veth", "peer", "name", "cable", "netns", their_pid)
    for namespace, address in ((ours, OURS), (theirs, THEIRS)):
        namespace.run("ip", "address", "add", f"{address}/24", "dev", "cable")
        namespace.run("ip", "link", "set", "cable", "up")
        namespace.run("ip", "link", "set", "lo", "up")
    yield ours, theirs
    for namespace in (theirs, ours):
        namespace.program.process.stdin.close()


class Pair:
    """A reader and a writer in two processes of one namespace, which have exchanged FIRST."""

    def __init__(self, namespace: Namespace, wait_until: Callable[..., None]) -> None:
        self.wait_until = wait_until
        self.receiving, self.sending = namespace.peer(), namespace.peer()
        self.reader, _ = self.receiving("reader", TOPIC, RELIABLE)
        self.writer, self.gid = self.sending("writer", TOPIC, RELIABLE)
        wait_until(lambda: self.receiving("matched", self.reader) and self.sending("matched", self.writer))
        self.exchange(FIRST)

    def exchange(self, sample: str) -> None:
        self.sending("write", self.writer, sample)
        self.expect(sample)

    def expect(self, sample: str) -> None:
        """Wait until the reader receives something; fail if it is anything else."""
        taken: list[str] = []

        def has_some() -> bool:
            taken.extend(self.receiving("take", self.reader))
            return bool(taken)

        self.wait_until(has_some, what=sample)
        assert taken == [sample]


def unicast_ports(domain_id: int) -> tuple[int, int]:
    """Return the ports for discovery and for data of the first participant."""
    return 7410 + 250 * domain_id, 7411 + 250 * domain_id


def test_a_forged_sample_from_another_namespace_is_refused(
    domain_id: int, namespaces: tuple[Namespace, Namespace], wait_until: Callable[..., None]
) -> None:
    ours, theirs = namespaces
    pair = Pair(ours, wait_until)
    assert theirs.inject(pair.gid, 2, *unicast_ports(domain_id)) == [True, True]
    pair.exchange(SECOND)


def test_a_forged_sample_is_taken_where_the_sockets_are_not_bound(
    domain_id: int,
    namespaces: tuple[Namespace, Namespace],
    wait_until: Callable[..., None],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("CYCLONEDDS_URI", configuration_for("LOCALHOST", []))
    ours, theirs = namespaces
    pair = Pair(ours, wait_until)
    discovery, data = unicast_ports(domain_id)
    assert theirs.inject(pair.gid, 2, data) == [False]
    pair.expect(FORGED)
    assert theirs.inject(pair.gid, 3, discovery) == [False]


@pytest.mark.parametrize("asked", ["SUBNET", "SYSTEM_DEFAULT"])
def test_another_namespace_is_met_where_the_range_includes_it(
    asked: str,
    domain_id: int,
    namespaces: tuple[Namespace, Namespace],
    wait_until: Callable[..., None],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", asked)
    ours, theirs = namespaces
    receiving, sending = ours.peer(), theirs.peer()
    reader, _ = receiving("reader", TOPIC, RELIABLE)
    writer, _ = sending("writer", TOPIC, RELIABLE)
    wait_until(lambda: receiving("matched", reader) and sending("matched", writer))
    sending("write", writer, FIRST)
    wait_until(lambda: receiving("take", reader) == [FIRST])
    assert [line.split()[1] for line in open_sockets(ours) if "00000000:" in line.split()[1]], (
        "none to all addresses"
    )


def open_sockets(namespace: Namespace) -> list[str]:
    """Return the lines of /proc/net/udp in a namespace."""
    return namespace.run("cat", "/proc/net/udp").splitlines()[1:]


def test_the_range_off_opens_no_socket(
    domain_id: int, namespaces: tuple[Namespace, Namespace], monkeypatch: pytest.MonkeyPatch
) -> None:
    ours, _ = namespaces
    ours.peer()
    assert len(open_sockets(ours)) == 3
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    peer = ours.peer()
    assert len(open_sockets(ours)) == 3
    reader, _ = peer("reader", TOPIC, RELIABLE)
    writer, _ = peer("writer", TOPIC, RELIABLE)
    peer("write", writer, FIRST)
    assert peer("take", reader) == [FIRST]
