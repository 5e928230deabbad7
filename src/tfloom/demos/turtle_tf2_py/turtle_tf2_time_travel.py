"""turtle_tf2_time_travel: turtle2 follows the pose that another frame had five seconds ago."""

from __future__ import annotations

from tfloom.demos.turtle_tf2_py.turtle_tf2_listener import FOLLOWER, FrameListener
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.client_library import spin
from tfloom.node.parameters.exceptions import InvalidParameterValueException
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time

MAX_DURATION_S = 1e9
"""The longest delay [s]."""


class TimeTraveller(FrameListener):
    """As the listener, but follows the target's past pose.

    The world is the fixed frame between the target's past time and the follower's present.
    """

    def __init__(self) -> None:
        super().__init__()
        delay_s = float(self.declare_parameter("delay", 5.0).value)
        if not 0.0 <= delay_s <= MAX_DURATION_S:
            reason = f"must be a number of seconds from 0 to {MAX_DURATION_S:g}"
            raise InvalidParameterValueException("delay", delay_s, reason)
        self.delay = Duration(seconds=delay_s)

    def look_up(self) -> TransformStamped:
        """Return the target's past pose in the follower's present frame."""
        then = self.get_clock().now() - self.delay
        return self.buffer.lookup_transform_full(FOLLOWER, Time(), self.target_frame, then, "world")


def main(args: list[str] | None = None) -> int:
    """Follow until stopped; return the exit code."""
    expect_no_arguments(
        "turtle_tf2_time_travel",
        "Drive turtle2 to a frame's past pose: --ros-args -p target_frame:=turtle1 -p delay:=5.0 [s].",
        args,
    )
    return run_program(args, lambda: spin(TimeTraveller()))
