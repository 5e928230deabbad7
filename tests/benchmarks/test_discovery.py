"""benchmarks/rmw/discovery.py: graphs of both wires are complete, and the picture shows the numbers."""

from __future__ import annotations

import pytest
from benchmarks.rmw import discovery
from tests.docs.page import DOCS
from tests.zenoh_ports import hold_zenoh_port
from tools.discovery_plot import read_curves


def test_each_process_knows_all_nodes_by_zenoh(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")
    with hold_zenoh_port() as port:
        monkeypatch.setattr(discovery, "PORT", port)
        is_complete, time_s, cpu_s = discovery.measure("zenoh", 25)
    assert is_complete
    assert 0 < time_s < discovery.TIMEOUT_S
    assert cpu_s > 0


@pytest.mark.slow
def test_each_of_twenty_processes_knows_two_hundred_nodes_by_zenoh(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")
    with hold_zenoh_port() as port:
        monkeypatch.setattr(discovery, "PORT", port)
        assert discovery.measure("zenoh", 200)[0]


def test_a_graph_that_lacks_a_node_is_not_complete(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")
    with hold_zenoh_port():
        is_complete = discovery.join_zenoh(0, 2, 3)
        assert not is_complete()
        opened = next(
            cell.cell_contents for cell in is_complete.__closure__ if isinstance(cell.cell_contents, list)
        )[0]
        opened.close()


def test_numbers_of_the_page_have_all_sizes() -> None:
    curves = read_curves((DOCS / "pictures" / "benchmark_discovery.txt").read_text("utf-8"))
    assert set(curves) == set(discovery.WIRES)
    assert all(tuple(row[0] for row in rows) == discovery.SIZES for rows in curves.values())
    drawn = (DOCS / "pictures" / "discovery.svg").read_text("utf-8")
    assert all(wire in drawn for wire in curves)
