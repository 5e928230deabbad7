"""Service introspection: which events of requests and responses are published."""

from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState

__all__ = ["ServiceIntrospectionState"]
