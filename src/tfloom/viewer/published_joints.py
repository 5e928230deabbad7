"""The joints of a robot that this process publishes: joint_state_publisher, with sliders on the page."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.exceptions import ExternalShutdownException, ShutdownException
from tfloom.robot.joint_state_publisher import JointStatePublisher
from tfloom.robot.robot_state_publisher import RobotStatePublisher
from tfloom.viewer.joints import JointRow, RobotJoints
from tfloom.viewer.page_command import fault_text

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["PublishedJoints", "published_joints"]

RATE_HZ = 30
"""Rate at which the joints of a file are published, so that the picture follows the hand."""


class _Robot(NamedTuple):
    """What a publisher has of its description, exchanged as a whole."""

    names: list[str]
    free: dict[str, dict[str, float]]
    """What the publisher keeps of each joint that follows no other."""
    joints: RobotJoints


class PublishedJoints:
    """The joints that a node publishes where pages move them. One thread moves them, another spins the node.

    Args:
        publisher: The node, which is not spun yet.
    """

    def __init__(self, publisher: JointStatePublisher) -> None:
        self._publisher = publisher
        self._robot: _Robot | None = None
        self._update()
        publisher.set_robot_description_update_cb(self._update)

    def _update(self) -> None:
        """Take the publisher's description, on its thread."""
        publisher = self._publisher
        if publisher.robot is None:
            return
        follows = {name: str(dependence["parent"]) for name, dependence in publisher.dependent_joints.items()}
        use_soft_limits = bool(publisher.get_parameter("use_smallest_joint_limits").value)
        joints = RobotJoints(publisher.robot, follows, publisher.zeros, use_soft_limits=use_soft_limits)
        self._robot = _Robot(list(publisher.joint_list), publisher.free_joints, joints)

    def rows(self) -> list[JointRow]:
        """Return the joints, in the order of the description; none while there is no description."""
        robot = self._robot
        if robot is None:
            return []
        return [robot.joints.row(name, self._publisher.value(name)) for name in robot.names]

    def move(self, positions: Mapping[str, float]) -> None:
        """Move joints that follow no other, by name, each within its range [rad] or [m]."""
        robot = self._robot
        for name, position in positions.items():
            if robot is not None and name in robot.free:
                robot.free[name]["position"] = position

    def about(self, link: str) -> str:
        """Return a line about the joint that a link is on; empty if it is on none."""
        robot = self._robot
        return "" if robot is None else robot.joints.about(link)


@contextmanager
def published_joints(
    description: str | None,
    on_failure: Callable[[str], object],
    *,
    args: Sequence[str] = (),
    urdf_file: str | None = None,
) -> Iterator[PublishedJoints]:
    """Publish the states of a robot's joints for the block, on a thread.

    Args:
        description: The robot, whose frames are published, too; None: the joints alone, of `urdf_file` or of what
            joint_state_publisher finds.
        on_failure: Called with a reason on that thread, if it ends before the block does.
        args: A command line with ROS arguments.
        urdf_file: Path of a description.

    Raises:
        OSError, UrdfError, StartError: the description can't be read, or is not valid.
        InvalidParameterValueException: a parameter is out of range.
        RCLError: a ROS argument can't be used.
        RuntimeError: the system has no thread.
    """
    context = Context()
    context.init(args=list(args))
    with ExitStack() as stack:
        stack.callback(context.try_shutdown)
        nodes: list[Node] = []
        if description is None:
            publisher = JointStatePublisher(urdf_file, context=context)
        else:
            robot = Parameter("robot_description", value=description)
            nodes.append(RobotStatePublisher(context=context, parameter_overrides=[robot]))
            stack.callback(nodes[0].destroy_node)
            rate = Parameter("rate", value=RATE_HZ)
            publisher = JointStatePublisher(context=context, parameter_overrides=[robot, rate])
        nodes.append(publisher)
        stack.callback(publisher.destroy_node)
        joints = PublishedJoints(publisher)
        executor = SingleThreadedExecutor(context=context)
        for node in nodes:
            executor.add_node(node)
        thread = threading.Thread(
            target=partial(_spin, executor, on_failure), name="joint states", daemon=True
        )
        try:
            thread.start()
        except RuntimeError as error:
            raise RuntimeError(f"the joints have no thread: {error}") from error
        # The thread ends before the nodes are destroyed, so that no callback runs with a node that is gone.
        stack.callback(thread.join)
        stack.callback(executor.shutdown)
        yield joints


def _spin(executor: SingleThreadedExecutor, on_failure: Callable[[str], object]) -> None:
    try:
        with suppress(ShutdownException, ExternalShutdownException):
            executor.spin_on_own_thread()
    except SystemExit:  # the node has logged why
        on_failure("joint_state_publisher has ended")
    except Exception as error:
        on_failure(f"joint_state_publisher has ended: {fault_text(error)}")
