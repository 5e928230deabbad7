"""Simulated time that a test steps by hand."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.node.builtin.time_source import CLOCK_TOPIC
from tfloom.node.clock.clock import ROSClock
from tfloom.node.values.time import ClockType, Time

if TYPE_CHECKING:
    from tfloom.testing.graph import RosGraph

__all__ = ["SimulatedTime"]

SECOND = 1_000_000_000
START_S = 100.0
MAX_WAIT_S = 5.0


class SimulatedTime:
    """Publishes /clock when it is told to, and nothing else moves the time of the graph's nodes. It starts at 100 s.

    Args:
        graph: Its nodes have the parameter `use_sim_time`, by the arguments of its context.
    """

    def __init__(self, graph: RosGraph) -> None:
        self._graph = graph
        self._now_ns = int(START_S * SECOND)
        self._publisher = graph.observer.create_publisher(Clock, CLOCK_TOPIC, 1)
        graph.when_added(self._show)
        self._show()

    @property
    def now_s(self) -> float:
        """The time [s]."""
        return self._now_ns / SECOND

    @property
    def now(self) -> Time:
        """The simulated time, as a Time of ROS time."""
        return Time(nanoseconds=self._now_ns, clock_type=ClockType.ROS_TIME)

    def step(self, seconds: float, every_s: float = 0.01) -> None:
        """Let time pass, and run all callbacks meanwhile.

        Args:
            seconds: How long [s].
            every_s: The length of each small step [s]. After each, callbacks run until none is ready. A timer runs
                at most once in a small step.

        Raises:
            ValueError: `seconds` or `every_s` is not positive.
            Exception: raised by a callback.
        """
        if not seconds > 0 or not every_s > 0:
            raise ValueError(
                f"time steps forward, by seconds > 0 and every_s > 0, not {seconds} and {every_s}; set() goes back"
            )
        end_ns, every_ns = self._now_ns + round(seconds * SECOND), max(1, round(every_s * SECOND))
        while self._now_ns < end_ns:
            self._now_ns = min(self._now_ns + every_ns, end_ns)
            self._show()

    def set(self, seconds: float) -> None:
        """Jump to a time, also back, and run all callbacks.

        Raises:
            ValueError: `seconds` is not positive, because 0 is not a time for ROS.
            Exception: raised by a callback.
        """
        if not seconds > 0:
            raise ValueError(f"simulated time is greater than 0 s, not {seconds}")
        self._now_ns = round(seconds * SECOND)
        self._show()

    def _show(self) -> None:
        self._publisher.publish(Clock(clock=self.now.to_msg()))
        self._graph.spin_until(self._is_shown, MAX_WAIT_S, f"all nodes' clocks to show {self.now_s:g} s")
        self._graph.spin_until_idle()

    def _is_shown(self) -> bool:
        clocks = [node.get_clock() for node in self._graph.executor.get_nodes()]
        return all(
            clock.now_ns() == self._now_ns
            for clock in clocks
            if isinstance(clock, ROSClock) and clock.ros_time_is_active
        )
