"""What a latched pair leaves in memory is measured: a known leak has its size, and a wire has its row."""

from __future__ import annotations

import mmap
import re
import sys

import pytest
from benchmarks.node import soak_pairs
from tests.zenoh_ports import NEEDS_ZENOH, hold_zenoh_port

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="memory is read from /proc")


def test_known_leak_has_its_size() -> None:
    # From the system, because the process may have kept what earlier tests have freed, which is used first.
    kept: list[mmap.mmap] = []

    def leak() -> None:
        kept.append(mmap.mmap(-1, 1_000_000))
        kept[-1].write(b"x" * 1_000_000)

    assert soak_pairs.grown_kb(leak, 100) == pytest.approx(977, abs=150)


def test_nodes_have_a_row(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    (line,) = soak_pairs.reports(2, 0)
    assert re.fullmatch(r"a latched publisher and subscription, by nodes: -?[\d.]+ kB a pair are left", line)


@NEEDS_ZENOH
def test_zenoh_has_a_row_for_its_library_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    with hold_zenoh_port():
        lines = soak_pairs.reports(2, 0)
    assert len(lines) == 2
    assert "by eclipse-zenoh alone: " in lines[1]
