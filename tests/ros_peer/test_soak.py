"""A soak test of mixed vendors, on its own host, whose cable must remain silent."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import Program
from tests.namespaces import hosts_on_a_subnet, packets_so_far
from tools.ros_peer import RosPeer

pytestmark = [pytest.mark.ros, pytest.mark.slow]

ROOT = Path(__file__).parents[2]
SECONDS = 60


def test_nothing_is_lost_beside_killed_processes_of_both_vendors(
    peer: RosPeer, domain_id: int, start_program: Callable[..., Program]
) -> None:
    host, _ = hosts_on_a_subnet(start_program)
    sniffing = host.sniff(start_program)
    words = ("-m", "benchmarks.node.soak_vendors", "--seconds", str(SECONDS), "--domain", str(domain_id))
    soak = start_program(*host.enter, "env", f"--chdir={ROOT}", sys.executable, *words)
    assert soak.wait(SECONDS + 180) == 0, soak.output
    assert "; 0 faults" in soak.output
    assert packets_so_far(host, sniffing) == []
