"""Include a launch description."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription as IncludeLaunchDescription

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchDescriptionEntity="tfloom.launch.launch_description_entity",
    )
