"""A machine whose clock is beyond what messages, or DDS, can express: the error names the clock and its value."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable
from types import SimpleNamespace

import pytest
from tests.conftest import run_to_end

from tfloom.node.log import log_output
from tfloom.node.node import Node
from tfloom.node.values import time as node_time
from tfloom.node.values.exceptions import RCLError
from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.errors import WireError

IN_2040_NS = 2_208_988_801_000_000_000
IN_1965_NS = -157_766_400_000_000_000
MAKE_NODE = "import rclpy; rclpy.init(); rclpy.create_node('late')"


@pytest.mark.parametrize("module", [node_time, log_output])
def test_after_2038_the_machines_clock_is_named(
    module: object, make_node: Callable[..., Node], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where a node declares its parameters, and where it logs."""
    node = None if module is node_time else make_node()
    monkeypatch.setattr(module, "time", SimpleNamespace(time_ns=lambda: IN_2040_NS, monotonic_ns=int))
    with pytest.raises(
        RCLError, match=r"the machine's clock says 2040-01-01 00:00:01 UTC \(2208988801 s.*19 January 2038"
    ):
        make_node() if node is None else node.get_logger().info("late")


def test_before_1970_a_participant_on_dds_names_the_machines_clock(
    monkeypatch: pytest.MonkeyPatch, domain_id: int
) -> None:
    def fail(_: object) -> None:  # as libddsc does, whose clock can't be replaced here
        raise RuntimeError("cannot write: Bad Parameter")

    monkeypatch.setattr(cyclonedds.CycloneParticipant, "_publish_nodes", fail)
    monkeypatch.setattr(cyclonedds, "time", SimpleNamespace(time_ns=lambda: IN_1965_NS))
    with pytest.raises(WireError, match="the machine's clock says 1965-01-01 00:00:00 UTC") as raised:
        cyclonedds.open_participant(domain_id)
    assert "room for no more" not in str(raised.value)


@pytest.mark.skipif(shutil.which("faketime") is None, reason="faketime isn't installed")
@pytest.mark.wire
@pytest.mark.parametrize("date", ["1965-01-01 00:00:00", "2040-01-01 00:00:00", "2110-01-01 00:00:00"])
def test_on_a_machine_with_that_clock(date: str, domain_id: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    monkeypatch.setenv("ROS_DOMAIN_ID", str(domain_id))
    ended = run_to_end(["faketime", date, sys.executable, "-c", MAKE_NODE])
    assert ended.returncode == 1
    # It goes on from there while the program starts.
    assert f"the machine's clock says {date[:10]} 00:0" in ended.stderr.splitlines()[-1]
