"""What a service tells about its traffic."""

from tfloom.node.service_introspection import ServiceIntrospectionState

__all__ = ["ServiceIntrospectionState"]
