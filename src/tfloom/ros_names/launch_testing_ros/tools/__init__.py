"""Tools of tests with nodes."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch_testing_ros.tools import output as output
    from tfloom.launch.testing.ros.output import basic_output_filter as basic_output_filter
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        output="launch_testing_ros.tools",
        basic_output_filter="tfloom.launch.testing.ros.output",
    )
