"""The orderly end of some processes."""

from __future__ import annotations

from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent

__all__ = ["ShutdownProcess"]


class ShutdownProcess(ProcessTargetedEvent):
    """Ends processes: by SIGINT, then SIGTERM, then SIGKILL."""

    name = "launch.events.process.ShutdownProcess"
