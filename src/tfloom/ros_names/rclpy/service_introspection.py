"""What a service tells about its traffic."""

from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState

__all__ = ["ServiceIntrospectionState"]
