"""Event handlers of tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "StdoutReadyListener",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing.event_handlers import stdout_ready_listener as stdout_ready_listener
    from tfloom.launch.testing.stdout_ready_listener import StdoutReadyListener as StdoutReadyListener
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        StdoutReadyListener="tfloom.launch.testing.stdout_ready_listener",
        stdout_ready_listener="launch_testing.event_handlers",
    )
