"""Simulated time by /clock, on both wires."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.rosgraph_msgs.msg import Clock as ClockMessage
from tfloom.node.builtin import time_source
from tfloom.node.clock.clock import Clock, ROSClock
from tfloom.node.clock.time_jump import ClockChange, JumpThreshold, TimeJump
from tfloom.node.context.context import Context
from tfloom.node.executing.events_executor import EventsExecutor
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import ExternalShutdownException
from tfloom.node.values.time import ClockType, Time


@pytest.fixture
def context(context_on_each_wire: Context) -> Context:
    return context_on_each_wire


class Simulation:
    """A node on simulated time that spins on a thread, and the publisher of /clock."""

    def __init__(self, context: Context, make_node: Callable[..., Node]) -> None:
        on = [Parameter("use_sim_time", value=True)]
        self.node = make_node("simulated", parameter_overrides=on)
        self.clock = self.node.get_clock()
        self._driver = make_node("driver")
        self._publisher = self._driver.create_publisher(ClockMessage, "/clock", 10)
        self._executor = EventsExecutor(context=context)
        self._executor.add_node(self.node)
        self._thread = threading.Thread(target=self._spin)
        self._thread.start()
        wait_until(lambda: self._publisher.get_subscription_count() == 1)

    def _spin(self) -> None:
        with suppress(ExternalShutdownException):
            self._executor.spin()

    def set(self, seconds: float) -> None:
        """Publish a time on /clock, and wait until the node has received it."""
        stamp = Time(seconds=seconds, clock_type=ClockType.ROS_TIME)
        self._publisher.publish(ClockMessage(clock=stamp.to_msg()))
        wait_until(lambda: self.clock.now() == stamp)

    def end(self) -> None:
        self._executor.shutdown(10)
        self._thread.join(10)
        assert not self._thread.is_alive()


@pytest.fixture
def simulation(context: Context, make_node: Callable[..., Node]) -> Iterator[Simulation]:
    simulation = Simulation(context, make_node)
    yield simulation
    simulation.end()


def test_timer_follows_simulated_time_forward_and_backward(simulation: Simulation) -> None:
    calls: list[float] = []
    simulation.set(100.0)
    simulation.node.create_timer(1.0, lambda: calls.append(simulation.clock.now().nanoseconds / 1e9))
    for now in (100.5, 101.0):
        simulation.set(now)
    wait_until(lambda: calls == [101.0])
    simulation.set(105.5)  # four periods at once are one call
    wait_until(lambda: calls == [101.0, 105.5])
    simulation.set(106.0)
    wait_until(lambda: calls == [101.0, 105.5, 106.0])
    simulation.set(10.0)  # backward: a new period begins
    simulation.set(10.5)
    simulation.set(11.0)
    wait_until(lambda: len(calls) == 4)
    assert calls[3] == 11.0


@pytest.mark.timing
def test_paused_clock_uses_no_cpu_time(simulation: Simulation) -> None:
    simulation.set(5.0)
    simulation.node.create_timer(0.001, lambda: None)
    before, start = time.process_time(), time.monotonic()
    wait_until(lambda: time.monotonic() > start + 0.3)
    assert time.process_time() - before < 0.1
    assert simulation.clock.now().nanoseconds == 5_000_000_000


def test_sleep_until_a_simulated_time(simulation: Simulation, context: Context) -> None:
    simulation.set(50.0)
    results: list[bool] = []
    handles = len(simulation.clock.jump_handles())
    until = simulation.clock.now() + Duration(seconds=2)

    def sleep() -> None:
        results.append(simulation.clock.sleep_until(until, context))
        results.append(simulation.clock.sleep_for(Duration(seconds=1), context))

    thread = threading.Thread(target=sleep)
    thread.start()
    wait_until(lambda: len(simulation.clock.jump_handles()) > handles)
    simulation.set(51.0)
    assert results == []
    simulation.set(52.0)
    wait_until(lambda: results == [True])
    wait_until(lambda: len(simulation.clock.jump_handles()) > handles)
    simulation.set(60.0)
    thread.join(10)
    assert results == [True, True]


def test_rate_uses_simulated_time(simulation: Simulation) -> None:
    simulation.set(1.0)
    rate = simulation.node.create_rate(2.0)
    woken = threading.Event()

    def sleep() -> None:
        rate.sleep()
        woken.set()

    thread = threading.Thread(target=sleep)
    thread.start()
    simulation.set(1.4)
    assert not woken.is_set()
    simulation.set(1.5)
    assert woken.wait(30)
    thread.join(10)


def test_jump_callbacks_are_called_also_when_simulated_time_ends(simulation: Simulation) -> None:
    jumps: list[tuple[ClockChange, float]] = []
    before: list[float] = []

    def after(jump: TimeJump) -> None:
        jumps.append((jump.clock_change, jump.delta.nanoseconds / 1e9))

    simulation.set(20.0)
    clock = simulation.clock
    assert isinstance(clock, ROSClock)
    threshold = JumpThreshold(
        min_forward=Duration(seconds=5), min_backward=Duration(seconds=-1), on_clock_change=True
    )
    with clock.create_jump_callback(
        threshold, pre_callback=lambda: before.append(clock.now().nanoseconds / 1e9), post_callback=after
    ):
        for now in (21.0, 27.0, 26.5, 20.0):
            simulation.set(now)
        assert jumps == [
            (ClockChange.ROS_TIME_NO_CHANGE, 6.0),
            (ClockChange.ROS_TIME_NO_CHANGE, -6.5),
        ]
        assert before == [21.0, 26.5]
        simulation.node.set_parameters([Parameter("use_sim_time", value=False)])
        assert jumps[2][0] is ClockChange.ROS_TIME_DEACTIVATED
        assert not clock.ros_time_is_active
        assert abs(clock.now().nanoseconds - time.time_ns()) < 5e9
        simulation.node.set_parameters([Parameter("use_sim_time", value=True)])
        assert jumps[3] == (ClockChange.ROS_TIME_ACTIVATED, 0.0)
    simulation.node.set_parameters([Parameter("use_sim_time", value=False)])
    assert len(jumps) == 4, "the handle is unregistered"


def test_sleep_ends_when_the_clock_source_changes(simulation: Simulation, context: Context) -> None:
    simulation.set(1.0)
    results: list[bool] = []
    handles = len(simulation.clock.jump_handles())
    until = simulation.clock.now() + Duration(seconds=1)
    thread = threading.Thread(target=lambda: results.append(simulation.clock.sleep_until(until, context)))
    thread.start()
    wait_until(lambda: len(simulation.clock.jump_handles()) > handles)
    simulation.node.set_parameters([Parameter("use_sim_time", value=False)])
    thread.join(10)
    assert results == [False]


class Silence:
    """A node on simulated time that is spun until it has warned that /clock is silent."""

    def __init__(
        self, node: Node, executor: SingleThreadedExecutor, capfd: pytest.CaptureFixture[str]
    ) -> None:
        self.node = node
        self._executor = executor
        self._capfd = capfd
        self._lines: list[str] = []
        executor.add_node(node)

    def spin_until(self, condition: Callable[[], object]) -> None:
        wait_until(lambda: (self._executor.spin_once(timeout_sec=0.01), condition())[1])

    def warnings(self) -> list[str]:
        """Return the warnings that were logged so far."""
        self._lines += self._capfd.readouterr().err.splitlines()
        return [line for line in self._lines if "no time has come on /clock" in line]


@pytest.fixture
def silence(
    make_node: Callable[..., Node],
    context: Context,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> Iterator[Silence]:
    monkeypatch.setattr(time_source, "WARN_AFTER_S", 0.2)
    with SingleThreadedExecutor(context=context) as executor:
        yield Silence(make_node("simulated"), executor, capfd)


def set_sim_time(node: Node, is_used: bool) -> None:
    assert node.set_parameters([Parameter("use_sim_time", value=is_used)])[0].successful


def test_a_silent_clock_is_warned_of_once(silence: Silence) -> None:
    ticks: list[float] = []
    silence.node.create_timer(
        0.05, lambda: ticks.append(time.monotonic()), clock=Clock(clock_type=ClockType.STEADY_TIME)
    )
    silence.spin_until(lambda: len(ticks) > 8)
    assert silence.warnings() == []  # without simulated time
    set_sim_time(silence.node, True)
    assert len(list(silence.node.timers)) == 1
    silence.spin_until(silence.warnings)
    (line,) = silence.warnings()
    assert "[WARN]" in line
    assert "[simulated]: use_sim_time is true" in line
    assert "nothing publishes it" in line
    ticks.clear()
    silence.spin_until(lambda: len(ticks) > 8)
    assert len(silence.warnings()) == 1
    # The next time that it is set, the wait begins anew.
    set_sim_time(silence.node, False)
    set_sim_time(silence.node, True)
    silence.spin_until(lambda: len(silence.warnings()) == 2)


def test_a_clock_that_shows_time_is_not_warned_of(silence: Silence, make_node: Callable[..., Node]) -> None:
    publisher = make_node("driver").create_publisher(ClockMessage, "/clock", 10)
    set_sim_time(silence.node, True)
    wait_until(lambda: publisher.get_subscription_count() == 1)
    time.sleep(0.3)  # the time is over when the node is spun for the first time
    publisher.publish(ClockMessage(clock=Time(seconds=5).to_msg()))
    silence.spin_until(lambda: silence.node.get_clock().now().nanoseconds == 5 * 10**9)
    end_s = time.monotonic() + 0.6
    silence.spin_until(lambda: time.monotonic() > end_s)
    assert silence.warnings() == []


def test_publishers_that_send_no_time_are_counted(silence: Silence, make_node: Callable[..., Node]) -> None:
    make_node("driver").create_publisher(ClockMessage, "/clock", 10)
    set_sim_time(silence.node, True)
    silence.spin_until(silence.warnings)
    (line,) = silence.warnings()
    assert "its publishers (1) have sent none" in line


def test_a_node_that_ends_is_not_warned_of(silence: Silence, make_node: Callable[..., Node]) -> None:
    set_sim_time(silence.node, True)
    silence.node.destroy_node()
    end_s = time.monotonic() + 0.4
    silence.spin_until(lambda: time.monotonic() > end_s)
    assert silence.warnings() == []


def test_a_clock_may_be_attached_on_another_thread_while_time_comes() -> None:
    source = time_source.TimeSource()
    source.ros_time_is_active = True
    first, second = ROSClock(), ROSClock()
    others = [second]

    class Watched(ROSClock):
        """A clock that is set while another thread attaches one."""

        @property
        def set_ros_time_override(self) -> Callable[[Time], None]:  # type: ignore[override]
            while others:
                source.attach_clock(others.pop())
            return super().set_ros_time_override

    source.attach_clock(first)
    first.__class__ = Watched
    source.clock_callback(ClockMessage(clock=Time(seconds=5).to_msg()))
    assert [clock.now().nanoseconds for clock in (first, second)] == [5_000_000_000] * 2
