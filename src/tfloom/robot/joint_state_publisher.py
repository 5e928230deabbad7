"""joint_state_publisher: publish a state of each joint of a robot, from other nodes' states or a position of rest."""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor
from tfloom.interfaces.sensor_msgs.msg import JointState
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import spin
from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.node import Node
from tfloom.node.parameters.exceptions import InvalidParameterValueException
from tfloom.node.parameters.parameter import ParameterType
from tfloom.node.program import run_program
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.robot.description import Description, range_of
from tfloom.robot.mimicry import Dependence, LoopError, dependence_of, resolve
from tfloom.robot.urdf import UrdfError, parse_urdf

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.parameters.parameter import Parameter

__all__ = ["JointStatePublisher", "main"]

DESCRIPTION = "Publish the states of a robot's joints on joint_states, without hardware."
INVALID = "Invalid robot_description given, ignoring"
KINDS = ("position", "velocity", "effort")
PARAMETERS: dict[str, tuple[Any, ParameterType]] = {
    "publish_default_efforts": (False, ParameterType.BOOL),
    "publish_default_positions": (True, ParameterType.BOOL),
    "publish_default_velocities": (False, ParameterType.BOOL),
    "rate": (10, ParameterType.INTEGER),
    "source_list": ([], ParameterType.STRING_ARRAY),
    "use_mimic_tags": (True, ParameterType.BOOL),
    "use_smallest_joint_limits": (True, ParameterType.BOOL),
    "delta": (0.0, ParameterType.DOUBLE),
}
"""The parameters with their defaults; there are also `zeros.<joint>` and `dependent_joints.<joint>.<part>`."""


class JointStatePublisher(Node):
    """Publishes the states of a robot's joints at a rate.

    Args:
        urdf_file: Path of the description; None: the parameter `robot_description`, else the topic of that name.
        context: The node's context; None: the default one.
        parameter_overrides: Values of parameters, before those of the command line.

    Raises:
        OSError, UrdfError: the file can't be read, or is not a valid description.
        InvalidParameterValueException: a parameter is out of range.

    Attributes:
        joint_list: Names of the joints, in the order of the description.
        free_joints: By name `min`, `max`, `zero`, and what is published of `position`, `velocity` and `effort`.
        dependent_joints: By name `parent`, `factor` and `offset`.
        delta: How far each joint moves for each message, back and forth between its limits; 0: not.
        robot: The description; None while there is none.
        zeros: Where joints begin, by name, which the parameters `zeros.<joint>` say [rad] or [m].
    """

    def __init__(
        self,
        urdf_file: str | None = None,
        *,
        context: Context | None = None,
        parameter_overrides: Sequence[Parameter] = (),
    ) -> None:
        super().__init__(
            "joint_state_publisher",
            context=context,
            parameter_overrides=list(parameter_overrides),
            automatically_declare_parameters_from_overrides=True,
        )
        for name, (default, kind) in PARAMETERS.items():
            if not self.has_parameter(name):
                self.declare_parameter(name, default, ParameterDescriptor(type=kind.value))
        self.robot: Description | None = None
        self.free_joints: dict[str, dict[str, Any]] = {}
        self.joint_list: list[str] = []
        self._given = self._given_dependences()
        self._resolved: dict[str, Dependence] = {}
        self.dependent_joints: dict[str, dict[str, Any]] = {}
        zeros = self.get_parameters_by_prefix("zeros")
        self.zeros = {name: self._number(f"zeros.{name}", zero.value) for name, zero in zeros.items()}
        self.robot_description_update_cb: Callable[[], object] | None = None
        self.source_update_cb: Callable[[], object] | None = None
        self.delta = float(self.get_parameter("delta").value)
        rate = self.get_parameter("rate").value
        if not rate > 0:
            raise InvalidParameterValueException(
                "rate", rate, "must be a positive number of messages a second"
            )
        self._find_description(urdf_file)
        self.sources = [
            self.create_subscription(JointState, source, self.source_cb, 10)
            for source in self.get_parameter("source_list").value or []
        ]
        self.pub = self.create_publisher(JointState, "joint_states", 10)
        self.timer = self.create_timer(1.0 / rate, self.timer_callback)

    def set_source_update_cb(self, user_cb: Callable[[], object]) -> None:
        """Call a function after each message of a source."""
        self.source_update_cb = user_cb

    def set_robot_description_update_cb(self, user_cb: Callable[[], object]) -> None:
        """Call a function after each description."""
        self.robot_description_update_cb = user_cb

    def configure_robot(self, description: str) -> None:
        """Use a description; log why if it is not valid, and keep the former one."""
        try:
            robot = parse_urdf(description, is_nested=True)
        except UrdfError as error:
            self.get_logger().warning(f"{INVALID}: {error}")
            return
        self._use(robot)

    def source_cb(self, msg: JointState) -> None:
        """Take the states that a source has of free joints."""
        for kind in KINDS:
            values = getattr(msg, kind)
            if not len(values):
                continue
            if len(values) != len(msg.name):
                reason = (
                    f"Ignored the {kind} of joints, because there are {len(values)} for {len(msg.name)} names"
                )
                self.get_logger().warning(reason, throttle_duration_sec=1.0)
                continue
            for name, value in zip(msg.name, values, strict=True):
                if name in self.free_joints:
                    self.free_joints[name][kind] = float(value)
        if self.source_update_cb is not None:
            self.source_update_cb()

    def timer_callback(self) -> None:
        """Publish the states, if there are joints."""
        if self.delta > 0:
            self.update(self.delta)
        if not self.joint_list:
            return
        message = JointState(name=list(self.joint_list))
        message.header.stamp = self.get_clock().now().to_msg()
        for kind in KINDS:
            is_known = any(kind in joint for joint in self.free_joints.values())
            if is_known or (kind == "position" and self.dependent_joints):
                setattr(message, kind, [self.value(name, kind) for name in self.joint_list])
        self.pub.publish(message)

    def update(self, delta: float) -> None:
        """Move each free joint by a step. At its limit it turns; a continuous one goes on from the other."""
        for joint in self.free_joints.values():
            if "position" not in joint:
                continue
            forward = joint.get("forward", True)
            position = joint["position"] + (delta if forward else -delta)
            if position > joint["max"] and joint.get("continuous"):
                position = joint["min"]
            elif not joint["min"] <= position <= joint["max"]:
                position = joint["max"] if forward else joint["min"]
                joint["forward"] = not forward
            joint["position"] = position

    def value(self, name: str, kind: str = "position") -> float:
        """Return what is published of a joint: its `position` [rad] or [m], `velocity` or `effort`."""
        source, factor, offset = self._resolved.get(name, Dependence(name))
        value = self.free_joints.get(source, {}).get(kind)
        if value is None:
            return 0.0
        if kind == "effort":
            return float(value)
        return float(value * factor + (offset if kind == "position" else 0.0))

    def _given_dependences(self) -> dict[str, Dependence]:
        """Return the parameters `dependent_joints.<joint>.parent`, `.factor` and `.offset`."""
        parts: dict[str, dict[str, Any]] = {}
        for key, parameter in self.get_parameters_by_prefix("dependent_joints").items():
            name, _, part = key.rpartition(".")
            if not name or part not in {"parent", "factor", "offset"}:
                reason = "must be named dependent_joints.<joint>.parent, .factor or .offset"
                raise InvalidParameterValueException(f"dependent_joints.{key}", parameter.value, reason)
            value = parameter.value
            parts.setdefault(name, {})[part] = (
                value if part == "parent" else self._number(f"dependent_joints.{key}", value)
            )
        for name, dependence in parts.items():
            if not isinstance(dependence.get("parent"), str):
                reason = "All dependent_joints must at least have a parent"
                raise InvalidParameterValueException(f"dependent_joints.{name}", dependence, reason)
        return {name: Dependence(**dependence) for name, dependence in parts.items()}

    @staticmethod
    def _number(parameter: str, value: Any) -> float:
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
            raise InvalidParameterValueException(parameter, value, "must be a finite number")
        return float(value)

    def _find_description(self, urdf_file: str | None) -> None:
        robot_description = (
            self.get_parameter("robot_description").value if self.has_parameter("robot_description") else ""
        )
        if urdf_file is not None or robot_description:
            text = robot_description if urdf_file is None else Path(urdf_file).read_bytes()
            self._use(parse_urdf(text, is_nested=True))
            return
        self.get_logger().info(
            "Waiting for robot_description to be published on the robot_description topic..."
        )
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(
            String, "robot_description", lambda message: self.configure_robot(message.data), kept
        )

    def _use(self, robot: Description) -> None:
        for remark in robot.remarks:
            self.get_logger().warning(f"robot_description, {remark}")
        use_mimic = bool(self.get_parameter("use_mimic_tags").value)
        use_soft_limits = bool(self.get_parameter("use_smallest_joint_limits").value)
        dependences = dict(self._given)
        names = []
        free: dict[str, dict[str, Any]] = {}
        for joint in robot.joints.values():
            limits = range_of(joint, self.zeros, use_soft_limits=use_soft_limits)
            if limits is None:
                continue
            names.append(joint.name)
            mimicked = dependence_of(joint) if use_mimic else None
            if mimicked is not None:
                dependences[joint.name] = mimicked
            elif joint.name not in dependences:
                free[joint.name] = self._free_joint(*limits)
                if joint.type == "continuous":
                    free[joint.name]["continuous"] = True
        self._resolve(names, free, dependences)
        self.robot = robot
        if self.robot_description_update_cb is not None:
            self.robot_description_update_cb()

    def _free_joint(self, least: float, greatest: float, zero: float) -> dict[str, Any]:
        joint = {"min": least, "max": greatest, "zero": zero}
        starts = {
            "positions": ("position", zero),
            "velocities": ("velocity", 0.0),
            "efforts": ("effort", 0.0),
        }
        for parameter, (kind, start) in starts.items():
            if self.get_parameter(f"publish_default_{parameter}").value:
                joint[kind] = start
        return joint

    def _resolve(
        self, names: list[str], free: dict[str, dict[str, Any]], dependences: dict[str, Dependence]
    ) -> None:
        """Use joints, once what each depends on is found."""
        used = {name: dependences[name] for name in names if name in dependences}
        try:
            resolved = {name: dependence for name, dependence in resolve(dependences).items() if name in used}
        except LoopError as error:
            self.get_logger().error(str(error))
            sys.exit(1)
        for name, dependence in resolved.items():
            if dependence.parent not in free:
                parent = dependence.parent
                reason = f"The joint '{name}' stays at 0: it depends on '{parent}', which is not a free joint"
                self.get_logger().warning(reason)
        self.joint_list, self.free_joints, self._resolved = names, free, resolved
        self.dependent_joints = {name: dependence._asdict() for name, dependence in used.items()}


def main(args: list[str] | None = None) -> int:
    """Publish until stopped; return the exit code."""
    words = remove_ros_args(sys.argv[1:] if args is None else args)
    parser = argparse.ArgumentParser("joint_state_publisher", description=DESCRIPTION)
    parser.add_argument("urdf_file", help="URDF file to use", nargs="?", default=None)
    file = parser.parse_args(words).urdf_file
    return run_program(args, partial(_publish, file))


def _publish(file: str | None) -> int:
    try:
        node = JointStatePublisher(file)
    except UrdfError as error:
        report(f"joint_state_publisher: {file or 'robot_description'}: {error}")
        return 1
    except OSError as error:
        report(f"joint_state_publisher: can't read {file}: {error.strerror or error}")
        return 1
    spin(node)
    return 0
