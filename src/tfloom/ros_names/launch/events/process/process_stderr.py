"""Error output of a process."""

from tfloom.launch.events.process.process_io import ProcessIO as ProcessIO
from tfloom.launch.events.process.process_stderr import ProcessStderr as ProcessStderr
