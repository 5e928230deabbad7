"""A robot's transforms on /tf and /tf_static: of its moving joints by their states, of its fixed ones once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom._native import StateTransforms
from tfloom.interfaces.geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.robot.description import MOVING, Description, Joint
from tfloom.robot.mimicry import followers
from tfloom.robot.model import joint_form

if TYPE_CHECKING:
    from tfloom.interfaces.builtin_interfaces.msg import Time

__all__ = ["RobotTransforms"]


class RobotTransforms:
    """The transforms of one description under one prefix. All methods may be called from any thread.

    Args:
        description: The robot.
        frame_prefix: Text before each link's name in the names of frames.
    """

    def __init__(self, description: Description, frame_prefix: str = "") -> None:
        self._prefix = frame_prefix
        joints = sorted(description.joints.values(), key=lambda joint: joint.name.encode())
        self._fixed = [joint for joint in joints if joint.type in {"fixed", "planar"}]
        moving = [joint for joint in joints if joint.type in MOVING]
        index = {joint.name: number for number, joint in enumerate(moving)}
        self.states = StateTransforms(
            [(joint.name, *self._frames(joint), joint_form(joint)) for joint in moving],
            [
                (index[name], index[mimic.joint], mimic.multiplier, mimic.offset)
                for name in followers(description.joints)
                if (mimic := description.joints[name].mimic) is not None
            ],
        )

    def static_message(self, stamp: Time) -> TFMessage:
        """Return the transforms of the joints that don't move: fixed ones, and planar ones at their origin."""
        return TFMessage(transforms=[self._static(joint, stamp) for joint in self._fixed])

    def _static(self, joint: Joint, stamp: Time) -> TransformStamped:
        frame_id, child_frame_id = self._frames(joint)
        x, y, z = joint.origin.translation
        qx, qy, qz, qw = joint.origin.rotation_xyzw
        return TransformStamped(
            header=Header(stamp=stamp, frame_id=frame_id),
            child_frame_id=child_frame_id,
            transform=Transform(
                translation=Vector3(x=x, y=y, z=z), rotation=Quaternion(x=qx, y=qy, z=qz, w=qw)
            ),
        )

    def _frames(self, joint: Joint) -> tuple[str, str]:
        return self._prefix + joint.parent, self._prefix + joint.child
