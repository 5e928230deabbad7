"""Service introspection: which events of requests and responses are published."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ServiceIntrospectionState",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ServiceIntrospectionState="tfloom.node.endpoints.service_introspection",
    )
