"""Tools of tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ProcessProxy",
    "basic_output_filter",
    "expect_output",
    "expected_output_from_file",
    "launch_process",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing.tools import output as output
    from launch_testing.tools import process as process
    from launch_testing.tools import text as text
    from tfloom.launch.testing.output import basic_output_filter as basic_output_filter
    from tfloom.launch.testing.output import expect_output as expect_output
    from tfloom.launch.testing.output import expected_output_from_file as expected_output_from_file
    from tfloom.launch.testing.process import ProcessProxy as ProcessProxy
    from tfloom.launch.testing.process import launch_process as launch_process
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ProcessProxy="tfloom.launch.testing.process",
        basic_output_filter="tfloom.launch.testing.output",
        expect_output="tfloom.launch.testing.output",
        expected_output_from_file="tfloom.launch.testing.output",
        launch_process="tfloom.launch.testing.process",
        output="launch_testing.tools",
        process="launch_testing.tools",
        text="launch_testing.tools",
    )
