"""Assertions on exit codes."""

from tfloom.launch.testing.assert_exit_codes import EXIT_FORCED as EXIT_FORCED
from tfloom.launch.testing.assert_exit_codes import EXIT_OK as EXIT_OK
from tfloom.launch.testing.assert_exit_codes import EXIT_SIGINT as EXIT_SIGINT
from tfloom.launch.testing.assert_exit_codes import EXIT_SIGKILL as EXIT_SIGKILL
from tfloom.launch.testing.assert_exit_codes import EXIT_SIGQUIT as EXIT_SIGQUIT
from tfloom.launch.testing.assert_exit_codes import EXIT_SIGSEGV as EXIT_SIGSEGV
from tfloom.launch.testing.assert_exit_codes import assertExitCodes as assertExitCodes
from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
