"""The client library of ROS 2, on tfloom."""

from importlib import import_module as _import_module

from tfloom.node import *
from tfloom.node import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rclpy import (
        callback_groups,
        client,
        clock,
        context,
        duration,
        exceptions,
        executors,
        logging,
        node,
        parameter,
        publisher,
        qos,
        service,
        signals,
        subscription,
        task,
        time,
        timer,
        utilities,
    )
else:

    def __getattr__(name):
        """Import a module of rclpy when it is named: programs write `rclpy.time.Time` after `import rclpy` alone."""
        if not name.startswith("_"):
            try:
                return _import_module(f"{__name__}.{name}")
            except ModuleNotFoundError as error:
                if error.name != f"{__name__}.{name}":
                    raise
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
