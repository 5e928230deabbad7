"""The report that tests can begin."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.actions.ready import ReadyToTest as ReadyToTest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        LaunchContext="tfloom.launch.launch_context",
        LaunchDescriptionEntity="tfloom.launch.launch_description_entity",
    )
