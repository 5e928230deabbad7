"""Event handlers of tests."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch_testing.event_handlers import stdout_ready_listener as stdout_ready_listener
    from tfloom.launch.testing.stdout_ready_listener import StdoutReadyListener as StdoutReadyListener
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        stdout_ready_listener="launch_testing.event_handlers",
        StdoutReadyListener="tfloom.launch.testing.stdout_ready_listener",
    )
