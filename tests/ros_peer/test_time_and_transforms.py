"""/tf, /tf_static and /clock between tfloom and the real rclpy, which has the messages of tf2 but no tf2_ros."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from tools.ros_peer import RosPeer

from .conftest import FROM_US, OURS, THEIRS, TO_US, End, Ends, StartEnd

pytestmark = pytest.mark.ros

LIVE = {"depth": 100}
STATIC = {"depth": 1, "durability": "TRANSIENT_LOCAL"}
SECOND_NS = 1_000_000_000
STAMP_NS = 1_700_000_000 * SECOND_NS + 123_456_789
SIM_TIME = ("--ros-args", "-p", "use_sim_time:=true")


@pytest.fixture
def tf_peer(peer: RosPeer) -> None:
    """Skip the test if the messages of tf2 are not compiled for the peer."""
    if not peer.has("tf2_msgs"):
        pytest.skip("tf2_msgs is not compiled for the real rclpy: `make ros-peer` says why")


@pytest.fixture
def both(start_end: StartEnd) -> dict[str, End]:
    return {vendor: start_end(vendor, f"node_{number}") for number, vendor in enumerate((OURS, THEIRS))}


@pytest.mark.usefixtures("tf_peer")
@pytest.mark.row("transforms", direction=TO_US)
def test_buffer_is_filled_from_fast_dds(both: dict[str, End], wait_until: Callable[..., None]) -> None:
    ours, theirs = both[OURS], both[THEIRS]
    theirs("publisher", "tf_static", "transforms", "/tf_static", STATIC)
    theirs("publish", "tf_static", [["map", "odom", STAMP_NS, 0.5]])
    ours("listen_to_transforms")
    theirs("publisher", "tf", "transforms", "/tf", LIVE)
    wait_until(lambda: theirs("matches", "tf") == 1, what="a match")
    wait_until(
        lambda: "PUBLISHER" in {endpoint["kind"] for endpoint in ours("endpoints", "/tf")}, what="a match"
    )
    for second in range(3):
        theirs("publish", "tf", [["odom", "base", STAMP_NS + second * SECOND_NS, float(second)]])
    middle_ns = STAMP_NS + 3 * SECOND_NS // 2
    wait_until(lambda: ours("look_up", "map", "base") == 2.5, what="the latest transform")
    assert ours("look_up", "map", "base", middle_ns) == 2.0


@pytest.mark.usefixtures("tf_peer")
@pytest.mark.row("transforms", direction=FROM_US)
def test_broadcast_transforms_reach_fast_dds(both: dict[str, End], wait_until: Callable[..., None]) -> None:
    ours, theirs = both[OURS], both[THEIRS]
    latched = [["map", "odom", STAMP_NS, 0.5], ["base", "laser", STAMP_NS, 0.1]]
    moving: list[list[Any]] = [["odom", "base", STAMP_NS, 1.0], ["base", "wheel", STAMP_NS, 0.25]]
    ours("broadcast", latched, True)
    theirs("subscription", "tf_static", "transforms", "/tf_static", STATIC)  # after it was sent
    theirs("subscription", "tf", "transforms", "/tf", LIVE)
    wait_until(lambda: theirs("received", "tf_static") == [latched], what="the static transforms")

    def is_received() -> bool:
        ours("broadcast", moving)  # repeated, because the broadcaster does not tell whether it has matched
        return bool(theirs("received", "tf"))

    wait_until(is_received, what="a transform")
    assert theirs("received", "tf")[0] == moving


@pytest.mark.row("/clock")
def test_simulated_time_is_that_of_the_other_vendor(
    direction: str, start_end: StartEnd, wait_until: Callable[..., None]
) -> None:
    teller, told = (OURS, THEIRS) if direction == FROM_US else (THEIRS, OURS)
    ends = Ends(start_end(teller, "simulator"), start_end(told, "robot", *SIM_TIME))
    ends.writer("publisher", "clock", "clock", "/clock", {"depth": 10})
    assert ends.reader("now_ns") == 0

    def is_told(time_ns: int) -> bool:
        ends.writer("publish", "clock", time_ns)  # repeated, because the subscription is of best effort
        return bool(ends.reader("now_ns") == time_ns)

    for time_ns in (5 * SECOND_NS, 6 * SECOND_NS + 1, 4 * SECOND_NS):  # a simulator may be reset
        wait_until(lambda time_ns=time_ns: is_told(time_ns), what=f"{time_ns} ns")
