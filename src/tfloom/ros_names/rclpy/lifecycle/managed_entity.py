"""Managed entities, which follow the transitions of a lifecycle node."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.lifecycle.managed_entity import ManagedEntity as ManagedEntity
from tfloom.node.lifecycle.managed_entity import SimpleManagedEntity as SimpleManagedEntity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.lifecycle.managed_entity import TransitionCallbackReturn as TransitionCallbackReturn
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        TransitionCallbackReturn="tfloom.node.lifecycle.managed_entity",
    )
