"""Tools of tests with nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "basic_output_filter",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing_ros.tools import output as output
    from tfloom.launch.testing.ros.output import basic_output_filter as basic_output_filter
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        basic_output_filter="tfloom.launch.testing.ros.output",
        output="launch_testing_ros.tools",
    )
