"""Timers, on the steady clock and on simulated time, and rates."""

from __future__ import annotations

import gc
import threading
import time
import weakref
from collections.abc import Callable

import pytest

from tfloom._native import ReadyQueue
from tfloom.node.clock.clock import ROSClock
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.timer import Timer
from tfloom.node.executing.timer_schedule import CELL_NS, MIN_CROWD, TimerSchedule
from tfloom.node.node import Node
from tfloom.node.values.exceptions import InvalidHandle, ROSInterruptException
from tfloom.node.values.time import ClockType, Time

SpinUntil = Callable[..., None]


def ros_time(seconds: float) -> Time:
    return Time(seconds=seconds, clock_type=ClockType.ROS_TIME)


def test_timer_keeps_its_period_on_average(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    ticks: list[float] = []
    start = time.monotonic()
    node.create_timer(0.005, lambda: ticks.append(time.monotonic()))
    executor.add_node(node)
    spin_until(lambda: len(ticks) == 20)
    assert ticks[-1] - start >= 0.099


@pytest.mark.timing
def test_missed_calls_are_skipped(node: Node, executor: SingleThreadedExecutor) -> None:
    ticks: list[float] = []
    timer = node.create_timer(0.01, lambda: ticks.append(time.monotonic()))
    executor.add_node(node)
    while timer.time_until_next_call() > -35_000_000:
        time.sleep(0.001)
    executor.spin_once(timeout_sec=1)
    assert len(ticks) == 1
    assert 0 < timer.time_until_next_call() <= 10_000_000


def test_cancel_and_reset(node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil) -> None:
    ticks: list[int] = []
    timer = node.create_timer(0.001, lambda: ticks.append(1))
    executor.add_node(node)
    spin_until(lambda: ticks)
    timer.cancel()
    assert timer.is_canceled()
    assert timer.time_until_next_call() is None
    assert not timer.is_ready()
    count = len(ticks)
    executor.spin_once(timeout_sec=0.02)
    assert len(ticks) == count
    timer.reset()
    spin_until(lambda: len(ticks) > count)


def test_without_autostart_it_waits_for_reset(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    ticks: list[int] = []
    timer = node.create_timer(0.001, lambda: ticks.append(1), autostart=False)
    executor.add_node(node)
    executor.spin_once(timeout_sec=0.02)
    assert not ticks
    timer.reset()
    spin_until(lambda: ticks)


def test_destroyed_timer_stops(node: Node) -> None:
    timer = node.create_timer(1.0, print)
    assert list(node.timers) == [timer]
    assert node.destroy_timer(timer)
    assert list(node.timers) == []
    with pytest.raises(InvalidHandle), timer.handle:
        pass


def test_simulated_time_drives_a_timer(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    clock = ROSClock()
    clock.set_ros_time_override(ros_time(100))
    clock.set_ros_time_is_active(True)
    ticks: list[int] = []
    timer = node.create_timer(1.0, lambda: ticks.append(clock.now().nanoseconds), clock=clock)
    executor.add_node(node)
    executor.spin_once(timeout_sec=0.01)
    assert not ticks
    clock.set_ros_time_override(ros_time(100.9))
    executor.spin_once(timeout_sec=0.01)
    assert not ticks
    clock.set_ros_time_override(ros_time(101))
    spin_until(lambda: ticks == [101 * 10**9])
    clock.set_ros_time_override(ros_time(105.5))  # four calls are due, one is made
    spin_until(lambda: len(ticks) == 2)
    executor.spin_once(timeout_sec=0.01)
    assert len(ticks) == 2
    assert timer.time_until_next_call() == 500_000_000
    clock.set_ros_time_override(ros_time(50))  # backward: a new period begins
    assert timer.time_until_next_call() == 1_000_000_000
    clock.set_ros_time_override(ros_time(51))
    spin_until(lambda: len(ticks) == 3)


def test_activation_of_simulated_time_keeps_the_remaining_period(node: Node) -> None:
    clock = ROSClock()
    timer = node.create_timer(100.0, print, clock=clock)
    clock.set_ros_time_override(ros_time(5))
    before_ns = timer.time_until_next_call()
    clock.set_ros_time_is_active(True)
    assert abs(timer.time_until_next_call() - before_ns) < 10**9
    clock.set_ros_time_is_active(False)
    assert 90 * 10**9 < timer.time_until_next_call() <= 100 * 10**9


def test_call_that_is_due_just_now_is_not_missed(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    clock = ROSClock()
    clock.set_ros_time_override(ros_time(100))
    clock.set_ros_time_is_active(True)
    ticks: list[int] = []
    timer = node.create_timer(1.0, lambda: ticks.append(1), clock=clock)
    executor.add_node(node)
    clock.set_ros_time_override(ros_time(102))
    spin_until(lambda: len(ticks) == 2)
    assert timer.time_until_next_call() == 1_000_000_000


def test_timer_wakes_nobody_before_it_is_due_and_after_its_end(node: Node) -> None:
    clock = ROSClock()
    clock.set_ros_time_override(ros_time(100))
    clock.set_ros_time_is_active(True)
    timer, queue = node.create_timer(1.0, print, clock=clock), ReadyQueue()
    timer.attach(queue, 5)
    assert queue.wait(0) == [5]
    clock.set_ros_time_override(ros_time(100.5))
    assert queue.wait(0) == []
    clock.set_ros_time_override(ros_time(101))
    assert queue.wait(0) == [5]
    node.destroy_timer(timer)
    gone = weakref.ref(timer)
    del timer
    gc.collect()
    assert gone() is None  # the clock, which goes on, doesn't hold it


def test_rate_paces_a_loop_on_another_thread(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    rate = node.create_rate(200.0)
    executor.add_node(node)
    rounds: list[float] = []

    def loop() -> None:
        for _ in range(5):
            rate.sleep()
            rounds.append(time.monotonic())

    thread = threading.Thread(target=loop)
    start = time.monotonic()
    thread.start()
    spin_until(lambda: len(rounds) == 5)
    thread.join(10)
    assert rounds[-1] - start >= 0.02
    assert node.destroy_rate(rate)
    with pytest.raises(RuntimeError, match="destroyed"):
        rate.sleep()


def test_shutdown_wakes_a_sleeping_rate(node: Node, context: Context) -> None:
    rate = node.create_rate(0.001)
    raised = threading.Event()

    def sleep() -> None:
        with pytest.raises(ROSInterruptException):
            rate.sleep()
        raised.set()

    thread = threading.Thread(target=sleep)
    thread.start()
    context.shutdown()
    assert raised.wait(30)
    thread.join(10)


def test_a_schedule_keeps_the_last_deadline_of_each_token() -> None:
    schedule = TimerSchedule()
    for token in range(1, 1001):
        schedule.set(token, 5000 - token)
    for token in range(1, 1001):
        schedule.set(token, token)
    schedule.set(500, None)
    assert schedule.take_due(3) == [1, 2, 3]
    assert len(schedule.take_due(10_000)) == 996
    assert schedule.wake_ns() is None


def test_a_few_deadlines_are_met_exactly() -> None:
    schedule = TimerSchedule()
    assert schedule.wake_ns() is None
    for token in range(1, MIN_CROWD):
        schedule.set(token, token)
    schedule.set(MIN_CROWD, CELL_NS)  # in the next cell
    assert schedule.wake_ns() == 1
    schedule.set(1, None)
    assert schedule.wake_ns() == 2


def test_a_crowd_of_deadlines_shares_a_wake() -> None:
    schedule = TimerSchedule()
    begin_ns = 7 * CELL_NS + 10
    for token in range(MIN_CROWD):
        schedule.set(token, begin_ns + token * 100)
    last_ns = begin_ns + (MIN_CROWD - 1) * 100
    assert schedule.wake_ns() == last_ns
    schedule.set(MIN_CROWD, 8 * CELL_NS - 1)
    schedule.set(MIN_CROWD + 1, 8 * CELL_NS)
    assert schedule.wake_ns() == 8 * CELL_NS - 1
    assert schedule.take_due(last_ns) == list(range(MIN_CROWD))
    assert schedule.wake_ns() == 8 * CELL_NS - 1


def test_many_timers_run_in_the_order_of_deadlines_and_never_early(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    calls: list[tuple[int, int]] = []
    period_ns = 50_000_000

    def called(timer: Timer) -> None:
        due_ns = timer._next_ns - period_ns  # no method returns it
        calls.append((due_ns, time.monotonic_ns()))

    for _ in range(50):
        timer = node.create_timer(period_ns / 1e9, lambda: None)
        timer.callback = lambda timer=timer: called(timer)
    executor.add_node(node)
    spin_until(lambda: len(calls) == 50)
    due = [due_ns for due_ns, _ in calls]
    assert due == sorted(due)
    assert all(due_ns <= called_ns for due_ns, called_ns in calls)
