"""static_transform_publisher: keep one transform on /tf_static."""

from __future__ import annotations

import secrets
import string
import sys

from tfloom.common.terminal import report
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor
from tfloom.node.client_library import spin
from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.cpp_nodes import EVENT_OVERRIDING, STATIC_OVERRIDING
from tfloom.node.log.logging import get_logger
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_tools.static_transform import USAGE, ArgumentsError, StaticTransform, parse

READ_ONLY = ParameterDescriptor(read_only=True)


class StaticTransformPublisher(Node):
    """Broadcasts one static transform; its numbers are read-only parameters.

    Args:
        transform: The transform to broadcast.

    Raises:
        ValueError: the two frames are the same.
    """

    _parameter_event_overriding = EVENT_OVERRIDING

    def __init__(self, transform: StaticTransform) -> None:
        super().__init__(f"static_transform_publisher_{_random_name()}")
        names = [f"translation.{axis}" for axis in "xyz"] + [f"rotation.{axis}" for axis in "xyzw"]
        numbers = [
            float(self.declare_parameter(name, default, READ_ONLY).value)
            for name, default in zip(names, [*transform.translation, *transform.rotation_xyzw], strict=True)
        ]
        frame_id = self.declare_parameter("frame_id", transform.frame_id, READ_ONLY).value
        child_frame_id = self.declare_parameter("child_frame_id", transform.child_frame_id, READ_ONLY).value
        if frame_id == child_frame_id:
            self.get_logger().error(
                f"cannot publish static transform from '{frame_id}' to '{child_frame_id}', exiting"
            )
            raise ValueError("child_frame_id cannot equal frame_id")
        self._broadcaster = StaticTransformBroadcaster(self, qos_overriding_options=STATIC_OVERRIDING)
        self._broadcaster.sendTransform(self._message(str(frame_id), str(child_frame_id), numbers))
        translation, rotation = (", ".join(f"'{n:f}'" for n in part) for part in (numbers[:3], numbers[3:]))
        self.get_logger().info(
            "Spinning until stopped - publishing transform\n"
            f"translation: ({translation})\nrotation: ({rotation})\nfrom '{frame_id}' to '{child_frame_id}'"
        )

    def _message(self, frame_id: str, child_frame_id: str, numbers: list[float]) -> TransformStamped:
        message = TransformStamped(child_frame_id=child_frame_id)
        message.header.stamp = self.get_clock().now().to_msg()
        message.header.frame_id = frame_id
        translation, rotation = message.transform.translation, message.transform.rotation
        translation.x, translation.y, translation.z = numbers[:3]
        rotation.x, rotation.y, rotation.z, rotation.w = numbers[3:]
        return message


def _random_name() -> str:
    """Return 16 letters and digits, so that publishers don't share a name."""
    return "".join(secrets.choice(string.ascii_letters + string.digits) for _ in range(16))


def main(args: list[str] | None = None) -> int:
    """Publish the command line's transform until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    words = remove_ros_args(args)
    if {"-h", "--help"} & set(words):
        print(USAGE)
        return 0
    try:
        transform, is_old_form = parse(words)
    except ArgumentsError as error:
        report(f"error parsing command line arguments: {error}\n{USAGE}")
        return 1

    def publish() -> None:
        if is_old_form:
            get_logger("static_transform_publisher").warning(
                "Old-style arguments are deprecated; see --help for new-style arguments"
            )
        spin(StaticTransformPublisher(transform))

    try:
        return run_program(args, publish)
    except ValueError as error:
        report(error)
        return 1
