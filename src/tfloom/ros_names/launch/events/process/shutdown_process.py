"""The orderly end of some processes."""

from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent as ProcessTargetedEvent
from tfloom.launch.events.process.shutdown_process import ShutdownProcess as ShutdownProcess
