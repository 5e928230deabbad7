"""Demonstration nodes for events of publishers and subscriptions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from demo_nodes_py.events import matched_event_detect as matched_event_detect
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        matched_event_detect="demo_nodes_py.events",
    )
