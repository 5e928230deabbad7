"""Demonstration nodes for logging."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from demo_nodes_py.logging import use_logger_service as use_logger_service
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        use_logger_service="demo_nodes_py.logging",
    )
