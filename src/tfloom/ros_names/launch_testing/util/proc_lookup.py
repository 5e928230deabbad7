"""The processes that a test names."""

from tfloom.launch.testing.proc_lookup import NO_CMD_ARGS as NO_CMD_ARGS
from tfloom.launch.testing.proc_lookup import NoMatchingProcessException as NoMatchingProcessException
from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
