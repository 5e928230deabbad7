"""The live watch: publishers by node name, of any quality of service, on both wires."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import closing

import pytest
from tests.tf2_tools.recordings import recorded, transform

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Participant, Writer
from tfloom.rmw.local import wire as local
from tfloom.rmw.qos import DurabilityPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.top.rows import Health, Rates, rows_of
from tfloom.tf2_tools.watch.live import LiveWatch
from tfloom.tf2_tools.watch.model import Observation

ROBOT = NodeName("/robot", "driver")
WATCHER = NodeName("/", "_watcher")
PATIENCE_S = 10.0
LATCHED = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL)
BEST_EFFORT = QoS(reliability=ReliabilityPolicy.BEST_EFFORT)


def message(parent: str, child: str) -> bytes:
    """Return the bytes of a message with one transform, stamped now."""
    return recorded(0, transform(parent, child, time.time_ns()))[2]


def observed(
    watch: LiveWatch, is_done: Callable[[Observation], bool], act: Callable[[], None] = lambda: None
) -> Observation:
    """Return the first observation for which `is_done` is true; `act` is called before each."""
    end_s = time.monotonic() + PATIENCE_S
    while time.monotonic() < end_s:
        act()
        watch.wait(time.monotonic() + 0.05)
        if is_done(seen := watch.observation()):
            return seen
    pytest.fail(f"not observed within {PATIENCE_S:g} s: {watch.observation()}")


@pytest.fixture(params=["rmw_cyclonedds_cpp", "tfloom_local"])
def participant(
    request: pytest.FixtureRequest, domain_id: int, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Participant]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", request.param)
    with closing(open_participant(domain_id)) as opened:
        opened.add_node(ROBOT)
        opened.add_node(WATCHER)
        yield opened


def open_writer(participant: Participant, topic: str, qos: QoS) -> Writer:
    """Open a writer of transforms for the robot's node."""
    return participant.create_writer(ROBOT, topic_of(TFMessage, topic), qos)


def test_edges_name_the_node_that_publishes_them(participant: Participant) -> None:
    static = open_writer(participant, "/tf_static", LATCHED)
    static.write(message("base", "laser"))
    moving = open_writer(participant, "/tf", QoS())
    buffer = Buffer()
    with closing(LiveWatch(participant, WATCHER, buffer=buffer)) as watch:
        seen = observed(
            watch,
            lambda seen: len(seen.edges) == 2 and all(edge.publisher.node for edge in seen.edges),
            lambda: moving.write(message("odom", "base")),
        )
        by_child = {edge.child: edge for edge in seen.edges}
        assert by_child["laser"].publisher.name == by_child["base"].publisher.name == "/robot/driver"
        assert (by_child["laser"].is_static, by_child["base"].is_static) == (True, False)
        assert by_child["laser"].publisher.qos is not None
        assert by_child["base"].publisher.gid == moving.gid
        assert {end.gid for end in seen.endpoints} == {static.gid, moving.gid}
        assert buffer.can("odom", "laser", 0)
        moving.close()
        left = observed(watch, lambda seen: any(publisher.has_left for publisher in seen.publishers))
        assert [publisher.name for publisher in left.publishers if publisher.has_left] == ["/robot/driver"]


def test_publishers_of_another_quality_are_recorded(participant: Participant) -> None:
    weak = open_writer(participant, "/tf", BEST_EFFORT)
    unlatched = open_writer(participant, "/tf_static", QoS())
    with closing(LiveWatch(participant, WATCHER)) as watch:

        def write() -> None:
            weak.write(message("odom", "base"))
            unlatched.write(message("base", "laser"))

        seen = observed(watch, lambda seen: len(seen.edges) == 2, write)
        assert {(edge.child, edge.publisher.gid) for edge in seen.edges} == {
            ("base", weak.gid),
            ("laser", unlatched.gid),
        }


def test_one_transform_is_counted_once(participant: Participant) -> None:
    weak = open_writer(participant, "/tf", BEST_EFFORT)
    strong = open_writer(participant, "/tf", QoS())
    with closing(LiveWatch(participant, WATCHER)) as watch:
        observed(watch, lambda seen: bool(seen.edges), lambda: weak.write(message("odom", "base")))
        observed(watch, lambda _: strong.matched_count() == 2)
        for _ in range(5):
            strong.write(message("odom", "wheel"))
        seen = observed(
            watch, lambda seen: any(edge.statistics.count >= 5 for edge in seen.edges_of("wheel"))
        )
        assert [edge.statistics.count for edge in seen.edges_of("wheel")] == [5]


@pytest.fixture
def simulated() -> Iterator[tuple[LiveWatch, Writer, Writer]]:
    """A watch by simulated time, a writer of moving transforms, and one of /clock."""
    with closing(local.open_participant(0, "/")) as opened:
        opened.add_node(ROBOT)
        opened.add_node(WATCHER)
        writer = open_writer(opened, "/tf", QoS())
        clock = opened.create_writer(ROBOT, topic_of(Clock, "/clock"), QoS())
        with closing(LiveWatch(opened, WATCHER, simulated=True)) as watch:
            yield watch, writer, clock


def test_simulated_time_replaces_that_of_receipt(simulated: tuple[LiveWatch, Writer, Writer]) -> None:
    watch, writer, clock = simulated
    writer.write(message("odom", "base"))
    assert watch.now_ns() == 0
    (edge,) = watch.observation().edges
    assert edge.statistics.delay.count == 0
    now_s = int(time.time()) + 5
    clock.write(cdr.encode(Clock(clock=Time(sec=now_s, nanosec=7))))
    writer.write(message("odom", "base"))
    seen = watch.observation()
    assert seen.edges[0].statistics.delay.greatest == pytest.approx(5.0, abs=1.5)
    assert watch.now_ns() == now_s * 1_000_000_000 + 7
    assert seen.started_ns <= seen.edges[0].statistics.last_received_ns <= seen.taken_ns
    assert seen.taken_ns <= time.time_ns()


def test_rows_of_simulated_time_have_no_delay_of_years(simulated: tuple[LiveWatch, Writer, Writer]) -> None:
    watch, writer, clock = simulated
    for step in range(10):
        stamp_ns = 100_000_000_000 + step * 1000
        clock.write(cdr.encode(Clock(clock=Time(sec=100, nanosec=step * 1000))))
        writer.write(recorded(0, transform("odom", "base", stamp_ns))[2])
    rates, seen = Rates(), watch.observation()
    rates.add(seen)
    row = rows_of(seen, watch.now_ns(), rates)[-1]
    assert (row.child, row.health) == ("base", Health.OK)
    assert row.delay_s == pytest.approx(0.0, abs=1e-9)
    assert row.age_s == pytest.approx(0.0, abs=1e-5)
