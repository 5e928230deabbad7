"""The soak test of the benchmarks, for some seconds: processes join and leave, and no message is lost."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import Program

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[3]


def test_no_message_is_lost_while_processes_join_and_leave(
    domain_id: int, start_program: Callable[..., Program]
) -> None:
    program = start_program("python", "-m", "benchmarks.node.soak", "--seconds", "8", cwd=ROOT)
    assert program.wait(120) == 0, program.output
    messages, lives = map(
        int, re.search(r"(\d+) messages and \d+ calls; (\d+) guests", program.output).groups()
    )
    assert messages >= 200 * lives
    assert lives >= 3
    assert "0 faults" in program.output
    for name in ("stayer", "broadcaster", "listener"):
        assert re.search(rf"^{name}: (RSS|not measured)", program.output, re.MULTILINE)
