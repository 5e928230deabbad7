"""Which processes hold the ports of a domain, and the wait for those that have not answered."""

from __future__ import annotations

import os
import signal
import socket
import sys
from pathlib import Path

import pytest

from tfloom.rmw.base import NodeName
from tfloom.rmw.cyclone import ports as cyclone_ports
from tfloom.rmw.cyclone.config import discovery_port
from tfloom.rmw.cyclone.ports import bound_indices, process_count
from tfloom.rmw.cyclone.wire import open_participant

CROWD = Path(__file__).parent / "programs" / "crowd.py"
linux = pytest.mark.skipif(sys.platform != "linux", reason="bound ports are read from /proc/net/udp")


@linux
def test_stopped_process_keeps_the_graph_incomplete(participant, start_peer, wait_until) -> None:
    peer = start_peer()
    here = NodeName("/peers", "peer_0")
    wait_until(lambda: here in participant.graph.nodes() and participant.graph.is_whole())
    os.kill(peer.pid, signal.SIGSTOP)
    try:
        late = open_participant(participant.domain_id)
        wait_until(lambda: bound_indices(participant.domain_id) == {0, 1})
        wait_until(lambda: len(late.graph._native.snapshot()[0]) >= 2)  # its own and that of this process
        assert here not in late.graph.nodes()
        assert not late.graph.is_whole()
    finally:
        os.kill(peer.pid, signal.SIGCONT)
    wait_until(late.graph.is_whole)
    assert here in late.graph.nodes()
    late.close()


@linux
def test_killed_process_is_not_waited_for(domain_id, start_peer, wait_until) -> None:
    first = start_peer()
    start_peer()
    assert bound_indices(domain_id) == {0, 1}
    os.kill(first.pid, signal.SIGKILL)
    first.program.wait()
    late = open_participant(domain_id)
    wait_until(late.graph.is_whole)
    assert late.graph.nodes() == [NodeName("/peers", "peer_1")]
    assert bound_indices(domain_id) == {0, 1}  # the second's, and this process's in place of the first's
    late.close()


@linux
def test_index_counts_if_both_its_ports_are_bound(domain_id: int) -> None:
    port = discovery_port(domain_id, 5)
    with socket.socket(type=socket.SOCK_DGRAM) as one, socket.socket(type=socket.SOCK_DGRAM) as other:
        one.bind(("127.0.0.1", port))
        assert bound_indices(domain_id) == set()
        other.bind(("0.0.0.0", port + 1))
        assert bound_indices(domain_id) == {5}
        assert bound_indices(domain_id + 100) == set()  # a domain that no test uses


@linux
@pytest.mark.parametrize(
    ("variable", "value"),
    [("CYCLONEDDS_URI", "<CycloneDDS/>"), ("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET")],
)
def test_ports_say_nothing_in_another_configuration(
    participant, monkeypatch, variable: str, value: str
) -> None:
    assert bound_indices(participant.domain_id) == {0}
    monkeypatch.setenv(variable, value)
    assert bound_indices(participant.domain_id) == set()


def test_system_without_a_table_of_sockets_has_no_indices(monkeypatch, tmp_path: Path) -> None:
    monkeypatch.setattr(cyclone_ports, "_SOCKETS", tmp_path / "none")
    assert bound_indices(0) == set()


def test_participants_of_one_process_count_once() -> None:
    cyclone = [bytes.fromhex(text) + bytes(11) + b"\xc1" for text in ("0110aaaa", "0110aaaa", "0110bbbb")]
    others = [bytes.fromhex("010faaaa") + bytes(11) + bytes([number]) for number in (1, 2)]
    assert process_count([]) == 0
    assert process_count(cyclone) == 2
    assert process_count([*cyclone, *others]) == 4


@linux
@pytest.mark.slow
def test_119_processes_fit_a_domain_and_the_next_has_a_sentence(domain_id: int, start_program) -> None:
    crowd = start_program("python", CROWD, str(domain_id))
    assert crowd.wait(timeout_s=240) == 0, crowd.output
    assert "joined: 119" in crowd.lines
    assert "the first and the last have discovered each other: True" in crowd.lines
    assert "a stopped one holds its port: True" in crowd.lines
    assert crowd.lines[-1].startswith("the next: cannot open DDS domain")
    assert "choose another ROS_DOMAIN_ID if 119 are on this domain" in crowd.lines[-1]
