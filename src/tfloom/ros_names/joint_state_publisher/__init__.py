"""The states of a robot's joints, without hardware."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.ros_guard import claim

claim("joint_state_publisher")

TYPE_CHECKING = False
if TYPE_CHECKING:
    from joint_state_publisher import joint_state_publisher as joint_state_publisher
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        joint_state_publisher="joint_state_publisher",
    )
