"""Simulated time: a node's parameter `use_sim_time`, and the topic /clock."""

from __future__ import annotations

import weakref
from functools import partial
from typing import TYPE_CHECKING

from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.interfaces.rosgraph_msgs import msg as rosgraph_msg
from tfloom.node.clock.clock import ROSClock
from tfloom.node.log.rcutils_logger import ThrottledWarning
from tfloom.node.parameters.parameter import Parameter, ParameterType
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy
from tfloom.node.values.callback_errors import call_all
from tfloom.node.values.time import ClockType, Time
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from tfloom.node.base.node_base import NodeBase
    from tfloom.node.clock.clock import Clock
    from tfloom.node.endpoints.subscription import Subscription
    from tfloom.node.executing.timer import Timer

__all__ = ["CLOCK_TOPIC", "USE_SIM_TIME_NAME", "TimeSource"]

CLOCK_TOPIC = "/clock"
WARN_AFTER_S = 5.0
"""How long nothing may come on /clock before a warning [s]."""
USE_SIM_TIME_NAME = "use_sim_time"


class TimeSource:
    """Sets ROS clocks from /clock while the node's parameter `use_sim_time` is true.

    Args:
        node: Attached at once, if given.
    """

    def __init__(self, *, node: NodeBase | None = None) -> None:
        self._node: NodeBase | None = None
        # These names are rclpy's, because tests of other people's programs look at them.
        self._associated_clocks: set[ROSClock] = (
            set()
        )  # copied to be looked through: another thread may add one
        self._clock_sub: Subscription[rosgraph_msg.Clock] | None = None
        self._last_time_set = Time(clock_type=ClockType.ROS_TIME)
        self._ros_time_is_active = False
        self._warning: ThrottledWarning | None = None
        self._wait: Timer | None = None
        """Runs until the first time has come."""
        self._is_late = False
        """Whether there is a publisher, and the time of a first wait is over."""
        if node is not None:
            self.attach_node(node)

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def _node_weak_ref(self) -> weakref.ref[NodeBase] | None:
        """The attached node, by rclpy's name."""
        return None if self._node is None else weakref.ref(self._node)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clocks return simulated time."""
        return self._ros_time_is_active

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled: bool) -> None:
        if enabled == self._ros_time_is_active:
            return
        self._ros_time_is_active = enabled
        # A jump callback may raise: the other clocks are set nevertheless, and /clock is heard.
        calls = [partial(clock.set_ros_time_is_active, enabled) for clock in list(self._associated_clocks)]
        call_all([*calls, self._subscribe if enabled else self._unsubscribe])

    def attach_node(self, node: NodeBase) -> None:
        """Follow a node's `use_sim_time`, declare it if necessary, and subscribe to /clock on that node.

        Raises:
            InvalidParameterTypeException: the parameter's first value isn't a bool.
            TypeError: it isn't a node.
        """
        if not hasattr(node, "add_on_set_parameters_callback"):
            raise TypeError(f"Node must be of type Node, not {type(node).__name__}")
        if self._node is not None:
            self.detach_node()
        self._node = node
        self._warning = ThrottledWarning(node.get_logger())
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False)
        node.add_on_set_parameters_callback(self._on_parameters)
        self.ros_time_is_active = bool(node.get_parameter(USE_SIM_TIME_NAME).value)

    def detach_node(self) -> None:
        """Leave the node; the clocks return system time again."""
        if self._node is not None:
            self.ros_time_is_active = False
            self._node.remove_on_set_parameters_callback(self._on_parameters)
            self._node = None

    def attach_clock(self, clock: Clock) -> None:
        """Add a clock to those that are set.

        Raises:
            ValueError: it is not a ROS clock.
        """
        if not isinstance(clock, ROSClock):
            raise ValueError("Only clocks with type ROS_TIME can be attached.")
        clock.set_ros_time_override(self._last_time_set)
        clock.set_ros_time_is_active(self._ros_time_is_active)
        self._associated_clocks.add(clock)

    def clock_callback(self, msg: rosgraph_msg.Clock) -> None:
        """Set the clocks to the time of a message; drop a time before 0, which clocks can't hold."""
        if msg.clock.sec < 0:
            if self._warning is not None:
                self._warning.log(f"Dropped a time on {CLOCK_TOPIC} that is before 0: {msg.clock.sec} s")
            return
        self._end_wait()
        self._last_time_set = Time.from_msg(msg.clock)
        call_all(
            [
                partial(clock.set_ros_time_override, self._last_time_set)
                for clock in list(self._associated_clocks)
            ]
        )

    def _on_parameters(self, parameters: list[Parameter]) -> rcl_msg.SetParametersResult:
        for parameter in parameters:
            if parameter.name != USE_SIM_TIME_NAME:
                continue
            if parameter.type_ is not ParameterType.BOOL:
                reason = f"{USE_SIM_TIME_NAME} parameter set to something besides a bool"
                return rcl_msg.SetParametersResult(successful=False, reason=reason)
            self.ros_time_is_active = parameter.value
        return rcl_msg.SetParametersResult(successful=True)

    def _subscribe(self) -> None:
        if self._node is not None and self._clock_sub is None:
            qos = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
            self._clock_sub = self._node.create_subscription(
                rosgraph_msg.Clock, CLOCK_TOPIC, self.clock_callback, qos
            )
            self._is_late = False
            self._wait = self._node._start_internal_timer(WARN_AFTER_S, self._on_silence)

    def _on_silence(self) -> None:
        """Warn, once, that there is no time; of a publisher that is there, only after a second period.

        The node may have been spun late, and its first time may be about to be taken.
        """
        if self._node is None or self._clock_sub is None:
            return
        publishers = self._clock_sub.get_publisher_count()
        if publishers and not self._is_late:
            self._is_late = True
            return
        self._end_wait()
        source = f"its publishers ({publishers}) have sent none" if publishers else "nothing publishes it"
        self._node.get_logger().warning(
            f"{USE_SIM_TIME_NAME} is true, and no time has come on {CLOCK_TOPIC}: {source}. The node's clock stands "
            "still, and its timers wait. Start the simulator, or `ros2 bag play --clock`, or set "
            f"{USE_SIM_TIME_NAME} to false"
        )

    def _end_wait(self) -> None:
        if self._wait is not None and self._node is not None:
            self._node.destroy_timer(self._wait)
            self._wait = None

    def _unsubscribe(self) -> None:
        self._end_wait()
        if self._node is not None and self._clock_sub is not None:
            self._node.destroy_subscription(self._clock_sub)
            self._clock_sub = None
