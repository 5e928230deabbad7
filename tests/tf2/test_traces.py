"""What tf2_py of a real ROS 2 Jazzy answered, our buffer answers."""

from __future__ import annotations

from typing import Any

import pytest
from tests.tf2.replay import mismatches, traces

TRACES = traces()


@pytest.mark.parametrize("trace", TRACES, ids=[f"seed{trace['seed']}" for trace in TRACES])
def test_every_answer_is_the_recorded_one(
    trace: dict[str, Any], deviations: dict[str, dict[str, str]]
) -> None:
    assert list(mismatches(trace, deviations)) == []


def test_the_recording_is_whole() -> None:
    assert sum(len(trace["ops"]) for trace in TRACES) == 7172


def test_a_deviation_needs_its_row() -> None:
    assert any(list(mismatches(trace, ())) for trace in TRACES[:5])
