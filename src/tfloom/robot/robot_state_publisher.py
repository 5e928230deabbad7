"""robot_state_publisher: publish a robot's frames, from its description and the states of its joints."""

from __future__ import annotations

import sys
import weakref
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from tfloom.interfaces.sensor_msgs.msg import JointState
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.client_library import spin
from tfloom.node.clock.clock import ROSClock
from tfloom.node.clock.time_jump import ANY_JUMP
from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.cpp_nodes import (
    EVENT_OVERRIDING,
    STATIC_OVERRIDING,
    listen_to_parameter_events,
    wrong_type,
)
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.program import run_program
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.rmw.errors import ClosedError
from tfloom.robot.description import Description
from tfloom.robot.mended_xml import decoded
from tfloom.robot.robot_transforms import RobotTransforms
from tfloom.robot.urdf import UrdfError, parse_urdf
from tfloom.robot.urdf_faults import Remarks
from tfloom.ros_imports import ros_distro
from tfloom.ros_imports.ros_distro import removal
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from tfloom.node.context.context import Context

__all__ = ["RobotStatePublisher", "StartError", "main"]

DESCRIPTION = "Publish the frames of the robot that the parameter robot_description describes, in URDF."
MAX_RATE_HZ = 1000.0
MAX_PERIOD_MS = 2**62 // 1_000_000
"""The longest period [ms]: a stamp and such a period add up to less than 2^63 ns."""
INVALID = "Unable to initialize urdf::model from robot description"
BY_FILE = (
    "No robot_description parameter, but command-line argument available.  Assuming argument is name of URDF file.  "
    "This backwards compatibility fallback will be removed in the future."
)
LOG_PERIOD_S = 1.0
"""The shortest time between two lines about states of joints."""
ONE_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class StartError(Exception):
    """The node can't start, for a reason that it has logged."""


class RobotStatePublisher(Node):
    """Publishes the transforms of a robot's joints, and its description.

    Args:
        files: Paths on the command line; the first is read if the parameter `robot_description` is empty. With
            `use_robot_description_topic`, the robot comes from the topic `robot_description`, now or later, instead.
        context: The node's context; None: the default one.
        parameter_overrides: Values of parameters, before those of the command line.

    Raises:
        StartError: there is no valid description, or a parameter is out of range.
    """

    _parameter_event_overriding = EVENT_OVERRIDING

    def __init__(
        self,
        files: list[str] | None = None,
        *,
        context: Context | None = None,
        parameter_overrides: Sequence[Parameter] = (),
    ) -> None:
        super().__init__(
            "robot_state_publisher", context=context, parameter_overrides=list(parameter_overrides)
        )
        listen_to_parameter_events(self)
        is_from_topic = self._takes_topic()
        text = str(self.declare_parameter("robot_description", "").value)
        if not text and not is_from_topic:
            text = self._from_file(files or [])
        frequency = float(self.declare_parameter("publish_frequency", 20.0).value)
        if not 0.0 <= frequency <= MAX_RATE_HZ:
            self._stop("publish_frequency must be between 0 and 1000")
        self.declare_parameter("ignore_timestamp", False)
        self.declare_parameter("frame_prefix", "")
        self._parsed: tuple[str, Description] | None = None
        try:
            if text:
                self._parse(text)
        except UrdfError as error:
            self._stop(f"{INVALID}: {error}")
        self._tf = self.create_publisher(TFMessage, "/tf", 100, qos_overriding_options=EVENT_OVERRIDING)
        self._tf_static = self.create_publisher(
            TFMessage, "/tf_static", ONE_KEPT, qos_overriding_options=STATIC_OVERRIDING
        )
        self._description = (
            None if is_from_topic else self.create_publisher(String, "robot_description", ONE_KEPT)
        )
        self._states = self.create_subscription(
            JointState,
            "joint_states",
            lambda _: None,  # a sink receives the messages
            qos_profile_sensor_data,
            qos_overriding_options=QoSOverridingOptions.with_default_policies(),
        )
        self._sink: Any = None
        if text:
            self._follow_parameters()
            self._show_robot()
        self._jump_handle = self.get_clock().create_jump_callback(
            ANY_JUMP, post_callback=_weakly(self._follow_clock)
        )
        self.add_on_set_parameters_callback(self._check)
        self.add_post_set_parameters_callback(self._apply)
        if is_from_topic:
            self.create_subscription(String, "robot_description", self._take_description, ONE_KEPT)

    def _takes_topic(self) -> bool:
        """Declare `use_robot_description_topic`, which nodes have from Lyrical on, and return its value.

        Before Lyrical it is declared if a value is given, so that a list of the parameters is Jazzy's.
        """
        name = "use_robot_description_topic"
        if not (ros_distro.since("lyrical") or name in self._parameter_overrides):
            return False
        descriptor = ParameterDescriptor(
            read_only=True, description="Take the robot from the topic robot_description"
        )
        return bool(self.declare_parameter(name, False, descriptor).value)

    def _take_description(self, message: String) -> None:
        """Make a published description that of the robot; one that is not valid changes nothing."""
        result = self.set_parameters([Parameter("robot_description", value=message.data)])[0]
        if not result.successful:
            self.get_logger().error(f"Ignored a description on robot_description: {result.reason}")

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Set all parameters, or none of them if one is rejected, with the reference's reason."""
        for parameter in parameter_list:
            if reason := wrong_type(self, parameter):
                return SetParametersResult(successful=False, reason=reason)
        return super().set_parameters_atomically(parameter_list)

    def _from_file(self, files: list[str]) -> str:
        if not files:
            self._stop("robot_description parameter must not be empty")
        self.get_logger().warning(removal("the URDF argument of robot_state_publisher") or BY_FILE)
        remarks = Remarks()
        try:
            text = decoded(Path(files[0]).read_bytes(), remarks)
        except OSError as error:
            self._stop(f"Failed to open URDF file: {files[0]}: {error.strerror}")
        for remark in remarks.collected():
            self.get_logger().warning(f"{files[0]}, {remark}")
        self.set_parameters([Parameter("robot_description", value=text)])
        return text

    def _stop(self, reason: str) -> None:
        self.get_logger().fatal(reason)
        raise StartError(reason)

    def _parse(self, text: str) -> Description:
        if self._parsed is None or self._parsed[0] != text:
            self._parsed = text, parse_urdf(text)
            for remark in self._parsed[1].remarks:
                self.get_logger().warning(f"robot_description, {remark}")
        return self._parsed[1]

    def _check(self, parameters: list[Parameter]) -> SetParametersResult:
        """Return whether values are valid."""
        for parameter in parameters:
            if reason := self._fault(parameter):
                return SetParametersResult(successful=False, reason=reason)
        return SetParametersResult(successful=True)

    def _fault(self, parameter: Parameter) -> str:
        if parameter.name == "publish_frequency" and not 0.0 <= parameter.value <= MAX_RATE_HZ:
            return "publish_frequency must be between 0.0 and 1000.0"
        if parameter.name != "robot_description":
            return ""
        if not parameter.value:
            return "Empty URDF is not allowed"
        try:
            self._parse(parameter.value)
        except UrdfError as error:
            self.get_logger().warning(f"{INVALID}: {error}")
            return INVALID
        return ""

    def _apply(self, parameters: list[Parameter]) -> None:
        """Use the new values of parameters: publish what depends on them anew."""
        names = {parameter.name for parameter in parameters}
        if names & {"robot_description", "frame_prefix", "publish_frequency", "ignore_timestamp"}:
            self._follow_parameters()
        if "robot_description" in names:
            self._show_robot()
        elif "frame_prefix" in names and self._sink is not None:
            self._publish_static()

    def _follow_parameters(self) -> None:
        if not self.get_parameter("robot_description").value:  # none has come on the topic so far
            return
        text, prefix, frequency, ignores = (
            self.get_parameter(name).value
            for name in ("robot_description", "frame_prefix", "publish_frequency", "ignore_timestamp")
        )
        # Whole milliseconds, as in the reference.
        interval_ns = int(min(1000.0 / frequency, MAX_PERIOD_MS)) * 1_000_000 if frequency else 0
        self._transforms = RobotTransforms(self._parse(text), prefix)
        self._sink = self._transforms.states.sink(
            None if ignores else interval_ns,
            _weakly(self._publish),
            _weakly(self._report),
            getattr(self._tf.wire_endpoint, "native", None),  # on DDS, transforms are sent without Python
        )
        # The sink must know the time before it gets messages. Feeding it replaces the former sink, which then gets no
        # more.
        self._follow_clock()
        self._states.feed(self._sink)

    def _show_robot(self) -> None:
        text = self.get_parameter("robot_description").value
        for joint in self._parse(text).joints.values():
            if joint.type == "floating":
                frames = f"from {joint.parent} to {joint.child}"
                self.get_logger().info(f"Floating joint. Not adding segment {frames}.")
        if self._description is not None:
            self._description.publish(String(data=text))
        self._publish_static()
        self.get_logger().info("Robot initialized")

    def _publish_static(self) -> None:
        self._tf_static.publish(self._transforms.static_message(self.get_clock().now().to_msg()))

    def _follow_clock(self, _: object = None) -> None:
        """Tell the sink the time while it is simulated, because native code can't read the node's clock."""
        if self._sink is None:
            return
        clock = self.get_clock()
        simulated = isinstance(clock, ROSClock) and clock.ros_time_is_active
        self._sink.set_simulated_time(clock.now().nanoseconds if simulated else None)

    def _publish(self, data: bytes) -> None:
        # The node may be destroyed, or its context shut down, while a message is on its way.
        with suppress(InvalidHandle, RCLError, ClosedError):
            self._tf.publish(data)

    def _report(self, what: str, data: bytes) -> None:
        """Log what was wrong with a message."""
        if what == "moved back":
            self.get_logger().warning("Moved backwards in time, re-publishing joint transforms!")
        elif what == "left out":
            reason = (
                f"The joint '{data.decode()}' is not published, because its position is not a finite number"
            )
            self.get_logger().warning(reason, throttle_duration_sec=LOG_PERIOD_S)
        else:
            self._refuse(data)

    def _refuse(self, data: bytes) -> None:
        """Log why a message is ignored."""
        try:
            state = cdr.decode(JointState, data)
        except cdr.DecodeError as error:
            self.get_logger().error(
                f"Ignored an unreadable message: {error}", throttle_duration_sec=LOG_PERIOD_S
            )
            return
        if state.name and not len(state.position):
            reason = (
                f'Robot state publisher ignored a JointState message about joint(s) "{state.name[0]}"(,...) whose '
                "position member was empty."
            )
            self.get_logger().warning(reason, throttle_duration_sec=LOG_PERIOD_S)
        else:
            reason = "Robot state publisher ignored an invalid JointState message"
            self.get_logger().error(reason, throttle_duration_sec=LOG_PERIOD_S)


def _weakly(method: Callable[..., object]) -> Callable[..., None]:
    """Return a function that calls a method as long as its object exists."""
    reference = weakref.WeakMethod(method)

    def call(*values: object) -> None:
        if (living := reference()) is not None:
            living(*values)

    return call


def main(args: list[str] | None = None) -> int:
    """Publish until stopped; return the exit code."""
    files = _files(remove_ros_args(sys.argv[1:] if args is None else args))

    def body() -> int:
        try:
            node = RobotStatePublisher(files)
        except StartError:
            return 1
        spin(node)
        return 0

    return run_program(args, body)


def _files(words: list[str]) -> list[str]:
    if not words:
        return []
    import argparse

    parser = argparse.ArgumentParser("robot_state_publisher", description=DESCRIPTION)
    parser.add_argument(
        "file", nargs="?", help="URDF, if there is no parameter robot_description (deprecated)"
    )
    return [file for file in [parser.parse_args(words).file] if file]
