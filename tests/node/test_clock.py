"""Clocks, jumps and sleeping."""

from __future__ import annotations

import threading

import pytest

from tfloom.node.clock.clock import Clock, ROSClock
from tfloom.node.clock.time_jump import ClockChange, JumpThreshold, TimeJump
from tfloom.node.context.context import Context
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import NotInitializedException
from tfloom.node.values.time import ClockType, Time

ANY = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=Duration(nanoseconds=-1))


def ros_time(seconds: float) -> Time:
    return Time(seconds=seconds, clock_type=ClockType.ROS_TIME)


def test_clock_type_determines_the_class() -> None:
    assert isinstance(Clock(clock_type=ClockType.ROS_TIME), ROSClock)
    assert not isinstance(Clock(), ROSClock)
    assert Clock(clock_type=ClockType.STEADY_TIME).now().clock_type is ClockType.STEADY_TIME


def test_simulated_time_is_returned_while_active() -> None:
    clock = ROSClock()
    clock.set_ros_time_override(ros_time(5))
    assert clock.now().nanoseconds > 10**18
    clock.set_ros_time_is_active(True)
    assert clock.now() == ros_time(5)
    clock.set_ros_time_is_active(False)
    assert clock.now().nanoseconds > 10**18


def test_jump_callbacks_are_called_by_threshold() -> None:
    clock = ROSClock()
    clock.set_ros_time_override(ros_time(10))
    heard: list[tuple[str, float]] = []
    threshold = JumpThreshold(min_forward=Duration(seconds=2), min_backward=Duration(seconds=-1))

    def post(jump: TimeJump) -> None:
        heard.append((jump.clock_change.name, jump.delta.nanoseconds / 1e9))

    with clock.create_jump_callback(
        threshold, pre_callback=lambda: heard.append(("pre", 0)), post_callback=post
    ):
        clock.set_ros_time_is_active(True)
        heard.clear()
        for second in (11, 13, 12.5, 11.5):
            clock.set_ros_time_override(ros_time(second))
        assert heard == [("pre", 0), ("ROS_TIME_NO_CHANGE", 2.0), ("pre", 0), ("ROS_TIME_NO_CHANGE", -1.0)]
        heard.clear()
        clock.set_ros_time_is_active(False)
        assert heard[1] == (ClockChange.ROS_TIME_DEACTIVATED.name, 0.0)
    heard.clear()
    clock.set_ros_time_is_active(True)
    assert not heard


def test_invalid_thresholds_and_callbacks_raise() -> None:
    with pytest.raises(ValueError, match="positive"):
        JumpThreshold(min_forward=Duration(), min_backward=None)
    with pytest.raises(ValueError, match="negative"):
        JumpThreshold(min_forward=None, min_backward=Duration(seconds=1))
    with pytest.raises(ValueError, match=r"^At least one jump threshold must be enabled$"):
        JumpThreshold(min_forward=None, min_backward=None, on_clock_change=False)
    assert JumpThreshold(min_forward=None, min_backward=None).on_clock_change
    with pytest.raises(ValueError, match="One of pre_callback or post_callback"):
        Clock().create_jump_callback(ANY)
    with pytest.raises(ValueError, match="post_callback must be callable"):
        Clock().create_jump_callback(ANY, post_callback=5)  # type: ignore[arg-type]


def test_sleep_lasts_until_its_time(context: Context) -> None:
    clock = Clock(clock_type=ClockType.STEADY_TIME)
    before = clock.now()
    assert clock.sleep_for(Duration(seconds=0.01), context)
    assert clock.now() - before >= Duration(seconds=0.01)
    assert clock.sleep_until(before, context)
    with pytest.raises(ValueError, match="clock type"):
        clock.sleep_until(Time(), context)
    with pytest.raises(NotInitializedException):
        clock.sleep_until(before, Context())


def sleeper(clock: Clock, until: Time, context: Context) -> tuple[threading.Thread, list[bool]]:
    results: list[bool] = []
    thread = threading.Thread(target=lambda: results.append(clock.sleep_until(until, context)))
    thread.start()
    return thread, results


def test_sleep_by_simulated_time(context: Context) -> None:
    clock = ROSClock()
    clock.set_ros_time_override(ros_time(1))
    clock.set_ros_time_is_active(True)
    thread, results = sleeper(clock, ros_time(10), context)
    clock.set_ros_time_override(ros_time(10))
    thread.join(10)
    assert results == [True]


@pytest.mark.parametrize("end", ["shutdown", "source"])
def test_sleep_ends_early_at_shutdown_or_clock_change(end: str, context: Context) -> None:
    clock = ROSClock()
    clock.set_ros_time_is_active(True)
    thread, results = sleeper(clock, ros_time(10**9), context)
    while not clock.jump_handles():
        assert thread.is_alive()
    if end == "shutdown":
        context.shutdown()
    else:
        clock.set_ros_time_is_active(False)
    thread.join(10)
    assert results == [False]
