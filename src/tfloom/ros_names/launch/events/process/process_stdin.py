"""Input for some processes."""

from typing import TYPE_CHECKING

from tfloom.launch.events.process.process_stdin import ProcessStdin as ProcessStdin

if TYPE_CHECKING:
    from tfloom.launch.events.process.process_io import ProcessIO as ProcessIO
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ProcessIO="tfloom.launch.events.process.process_io",
    )
