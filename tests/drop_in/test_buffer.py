"""The drop-in buffer and listener inside the real rclpy: the cases of programs/cases.py."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from tests.drop_in.conftest import PROGRAMS, Peer

CASES = re.findall(r"^def case_(\w+)", Path(PROGRAMS, "cases.py").read_text("utf-8"), re.MULTILINE)

pytestmark = pytest.mark.ros


@pytest.fixture(scope="module")
def output(module_real_ros: Peer, module_domain_id: int) -> str:
    program = module_real_ros.start("cases", domain_id=module_domain_id)
    program.wait_for("end", 300.0)
    assert program.wait() == 0
    return str(program.output)


@pytest.mark.parametrize("case", CASES)
def test_case_passes_in_the_real_rclpy(case: str, output: str) -> None:
    assert f"case_{case}: passed" in output.splitlines(), output


def test_listener_logs_by_the_real_rclpy_that_it_holds_a_transform(output: str) -> None:
    assert re.search(
        r"\[WARN\] .* \[under_test\]: The transform of 'turtle' from /clock, GID .* is stamped", output
    )


def test_listener_logs_why_it_is_a_raw_subscription(output: str) -> None:
    assert "a raw subscription of this node: ROS_DISCOVERY_SERVER is set" in output
