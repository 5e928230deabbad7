"""Waits for what a process does."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "assert_output",
    "assert_output_sync",
    "assert_stderr",
    "assert_stderr_sync",
    "wait_for_exit",
    "wait_for_exit_sync",
    "wait_for_output",
    "wait_for_output_sync",
    "wait_for_start",
    "wait_for_start_sync",
    "wait_for_stderr",
    "wait_for_stderr_sync",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_pytest.tools import process as process
    from tfloom.launch.testing.fixtures.process import assert_output as assert_output
    from tfloom.launch.testing.fixtures.process import assert_output_sync as assert_output_sync
    from tfloom.launch.testing.fixtures.process import assert_stderr as assert_stderr
    from tfloom.launch.testing.fixtures.process import assert_stderr_sync as assert_stderr_sync
    from tfloom.launch.testing.fixtures.process import wait_for_exit as wait_for_exit
    from tfloom.launch.testing.fixtures.process import wait_for_exit_sync as wait_for_exit_sync
    from tfloom.launch.testing.fixtures.process import wait_for_output as wait_for_output
    from tfloom.launch.testing.fixtures.process import wait_for_output_sync as wait_for_output_sync
    from tfloom.launch.testing.fixtures.process import wait_for_start as wait_for_start
    from tfloom.launch.testing.fixtures.process import wait_for_start_sync as wait_for_start_sync
    from tfloom.launch.testing.fixtures.process import wait_for_stderr as wait_for_stderr
    from tfloom.launch.testing.fixtures.process import wait_for_stderr_sync as wait_for_stderr_sync
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        assert_output="tfloom.launch.testing.fixtures.process",
        assert_output_sync="tfloom.launch.testing.fixtures.process",
        assert_stderr="tfloom.launch.testing.fixtures.process",
        assert_stderr_sync="tfloom.launch.testing.fixtures.process",
        process="launch_pytest.tools",
        wait_for_exit="tfloom.launch.testing.fixtures.process",
        wait_for_exit_sync="tfloom.launch.testing.fixtures.process",
        wait_for_output="tfloom.launch.testing.fixtures.process",
        wait_for_output_sync="tfloom.launch.testing.fixtures.process",
        wait_for_start="tfloom.launch.testing.fixtures.process",
        wait_for_start_sync="tfloom.launch.testing.fixtures.process",
        wait_for_stderr="tfloom.launch.testing.fixtures.process",
        wait_for_stderr_sync="tfloom.launch.testing.fixtures.process",
    )
