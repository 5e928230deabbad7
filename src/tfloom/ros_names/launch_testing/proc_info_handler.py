"""The recorded starts and ends of processes."""

from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
from tfloom.launch.events.process.process_exited import ProcessExited as ProcessExited
from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler as ActiveProcInfoHandler
from tfloom.launch.testing.proc_info_handler import ProcInfoHandler as ProcInfoHandler
from tfloom.launch.testing.proc_lookup import NoMatchingProcessException as NoMatchingProcessException
from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
