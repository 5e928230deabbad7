"""Publishers that publish while their lifecycle node is active."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.endpoints.publisher import MsgType as MsgType
    from tfloom.node.endpoints.publisher import Publisher as Publisher
    from tfloom.node.lifecycle.managed_entity import SimpleManagedEntity as SimpleManagedEntity
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        MsgType="tfloom.node.endpoints.publisher",
        Publisher="tfloom.node.endpoints.publisher",
        SimpleManagedEntity="tfloom.node.lifecycle.managed_entity",
    )
