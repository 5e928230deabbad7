"""The buffer's results equal those recorded from tf2_py of a real ROS 2 Jazzy."""

from __future__ import annotations

from typing import Any

import pytest
from tests.tf2.replay import mismatches, traces

TRACES = traces()


@pytest.mark.parametrize("trace", TRACES, ids=[f"seed{trace['seed']}" for trace in TRACES])
def test_every_result_matches_the_recording(
    trace: dict[str, Any], deviations: dict[str, dict[str, str]]
) -> None:
    assert list(mismatches(trace, deviations)) == []


def test_recording_is_complete() -> None:
    assert sum(len(trace["ops"]) for trace in TRACES) == 7172


def test_deviation_requires_a_row() -> None:
    assert any(list(mismatches(trace, ())) for trace in TRACES[:5])
