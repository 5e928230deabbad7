"""Processes that a test starts."""

from tfloom.launch.testing.io_handler import ActiveIoHandler as ActiveIoHandler
from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler as ActiveProcInfoHandler
from tfloom.launch.testing.process import ProcessProxy as ProcessProxy
from tfloom.launch.testing.process import launch_process as launch_process
from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
