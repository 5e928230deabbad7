"""Assertions on processes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "EXIT_OK",
    "EXIT_SIGINT",
    "EXIT_SIGKILL",
    "EXIT_SIGQUIT",
    "EXIT_SIGSEGV",
    "NO_CMD_ARGS",
    "SequentialTextChecker",
    "assertDefaultStream",
    "assertExitCodes",
    "assertInStderr",
    "assertInStdout",
    "assertInStream",
    "assertSequentialStdout",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing.asserts import assert_exit_codes as assert_exit_codes
    from launch_testing.asserts import assert_output as assert_output
    from launch_testing.asserts import assert_sequential_output as assert_sequential_output
    from tfloom.launch.testing.assert_exit_codes import EXIT_OK as EXIT_OK
    from tfloom.launch.testing.assert_exit_codes import EXIT_SIGINT as EXIT_SIGINT
    from tfloom.launch.testing.assert_exit_codes import EXIT_SIGKILL as EXIT_SIGKILL
    from tfloom.launch.testing.assert_exit_codes import EXIT_SIGQUIT as EXIT_SIGQUIT
    from tfloom.launch.testing.assert_exit_codes import EXIT_SIGSEGV as EXIT_SIGSEGV
    from tfloom.launch.testing.assert_exit_codes import assertExitCodes as assertExitCodes
    from tfloom.launch.testing.assert_output import assertDefaultStream as assertDefaultStream
    from tfloom.launch.testing.assert_output import assertInStderr as assertInStderr
    from tfloom.launch.testing.assert_output import assertInStdout as assertInStdout
    from tfloom.launch.testing.assert_output import assertInStream as assertInStream
    from tfloom.launch.testing.assert_sequential_output import SequentialTextChecker as SequentialTextChecker
    from tfloom.launch.testing.assert_sequential_output import assertSequentialStdout as assertSequentialStdout
    from tfloom.launch.testing.proc_lookup import NO_CMD_ARGS as NO_CMD_ARGS
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        EXIT_OK="tfloom.launch.testing.assert_exit_codes",
        EXIT_SIGINT="tfloom.launch.testing.assert_exit_codes",
        EXIT_SIGKILL="tfloom.launch.testing.assert_exit_codes",
        EXIT_SIGQUIT="tfloom.launch.testing.assert_exit_codes",
        EXIT_SIGSEGV="tfloom.launch.testing.assert_exit_codes",
        NO_CMD_ARGS="tfloom.launch.testing.proc_lookup",
        SequentialTextChecker="tfloom.launch.testing.assert_sequential_output",
        assertDefaultStream="tfloom.launch.testing.assert_output",
        assertExitCodes="tfloom.launch.testing.assert_exit_codes",
        assertInStderr="tfloom.launch.testing.assert_output",
        assertInStdout="tfloom.launch.testing.assert_output",
        assertInStream="tfloom.launch.testing.assert_output",
        assertSequentialStdout="tfloom.launch.testing.assert_sequential_output",
        assert_exit_codes="launch_testing.asserts",
        assert_output="launch_testing.asserts",
        assert_sequential_output="launch_testing.asserts",
    )
