"""benchmarks/rmw/discovery.py: graphs of both wires are complete, and the picture shows the numbers."""

from __future__ import annotations

import sys

import pytest
from benchmarks.rmw import discovery
from tests.docs.page import DOCS
from tests.zenoh_ports import NEEDS_ZENOH, hold_zenoh_port
from tools.discovery_plot import PANELS, read_curves

LINUX = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc and /sys")


def check(row: discovery.Row) -> None:
    """Check that a graph is complete, and that each number can be one.

    Not the bytes on the loopback interface, which other tests use meanwhile.
    """
    assert row.is_complete
    assert 0 < row.time_s < discovery.TIMEOUT_S
    assert 0 < row.join_s < discovery.TIMEOUT_S
    assert row.cpu_s > 0
    assert row.memory_bytes > 5e6  # an interpreter's own


@LINUX
@pytest.mark.parametrize("wire", [pytest.param("zenoh", marks=NEEDS_ZENOH), "cyclonedds"])
def test_each_process_knows_all_nodes(wire: str, domain_id: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(discovery, "DOMAIN_ID", domain_id)
    with hold_zenoh_port() as port:
        monkeypatch.setattr(discovery, "PORT", port)
        check(discovery.measure(wire, 12))


@LINUX
@pytest.mark.slow
@NEEDS_ZENOH
def test_each_of_twenty_processes_knows_two_hundred_nodes_by_zenoh(
    domain_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(discovery, "DOMAIN_ID", domain_id)
    with hold_zenoh_port() as port:
        monkeypatch.setattr(discovery, "PORT", port)
        check(discovery.measure("zenoh", 200))


@LINUX
@NEEDS_ZENOH
def test_a_graph_that_lacks_a_node_is_not_complete(
    domain_id: int, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """A graph in which one node is missing is reported as incomplete by every process."""
    monkeypatch.setattr(discovery, "DOMAIN_ID", domain_id)
    total, timeout_s = 12, 2
    with hold_zenoh_port() as port:
        monkeypatch.setattr(discovery, "PORT", port)
        with discovery.workers_of("zenoh") as start:
            workers = [
                start("benchmarks.rmw.discovery", "--work", number, own - number, total, timeout_s)
                for number, own in enumerate(discovery.shares_of(total))
            ]
            for worker in workers:
                worker.read()
                worker.start()
            assert [worker.result()[0] for worker in workers] == [False, False]
    assert "11_of_12_names" in capfd.readouterr().err


def test_numbers_of_the_page_have_all_sizes() -> None:
    curves = read_curves((DOCS / "pictures" / "benchmark_discovery.txt").read_text("utf-8"))
    assert set(curves) == set(discovery.WIRES)
    assert all(tuple(row["nodes"] for row in rows) == discovery.SIZES for rows in curves.values())
    drawn = (DOCS / "pictures" / "discovery.svg").read_text("utf-8")
    assert all(wire in drawn for wire in curves)
    columns = [name for name in PANELS if name in curves["zenoh"][0]]
    assert {"time [s]", "CPU [s]"} <= set(columns)
    assert all(PANELS[column] in drawn for column in columns)
