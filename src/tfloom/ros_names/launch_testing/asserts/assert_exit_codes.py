"""Assertions on exit codes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.assert_exit_codes import assertExitCodes as assertExitCodes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.assert_exit_codes import EXIT_FORCED as EXIT_FORCED
    from tfloom.launch.testing.assert_exit_codes import EXIT_OK as EXIT_OK
    from tfloom.launch.testing.assert_exit_codes import EXIT_SIGINT as EXIT_SIGINT
    from tfloom.launch.testing.assert_exit_codes import EXIT_SIGKILL as EXIT_SIGKILL
    from tfloom.launch.testing.assert_exit_codes import EXIT_SIGQUIT as EXIT_SIGQUIT
    from tfloom.launch.testing.assert_exit_codes import EXIT_SIGSEGV as EXIT_SIGSEGV
    from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        EXIT_FORCED="tfloom.launch.testing.assert_exit_codes",
        EXIT_OK="tfloom.launch.testing.assert_exit_codes",
        EXIT_SIGINT="tfloom.launch.testing.assert_exit_codes",
        EXIT_SIGKILL="tfloom.launch.testing.assert_exit_codes",
        EXIT_SIGQUIT="tfloom.launch.testing.assert_exit_codes",
        EXIT_SIGSEGV="tfloom.launch.testing.assert_exit_codes",
        resolveProcesses="tfloom.launch.testing.proc_lookup",
    )
