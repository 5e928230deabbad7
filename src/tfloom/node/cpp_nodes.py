"""What nodes of rclcpp show, for tfloom's programs that stand for programs in C++: parameters, endpoints, texts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent
from tfloom.node.parameters.parameter import Parameter, ParameterType
from tfloom.node.qos.qos import QoSPolicyKind, qos_profile_parameter_events
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["EVENT_OVERRIDING", "STATIC_OVERRIDING", "listen_to_parameter_events", "wrong_type"]

EVENT_OVERRIDING = QoSOverridingOptions(
    [QoSPolicyKind.DEPTH, QoSPolicyKind.DURABILITY, QoSPolicyKind.HISTORY, QoSPolicyKind.RELIABILITY]
)
"""The policies of the parameter event publisher that parameters may override, as in rclcpp."""
STATIC_OVERRIDING = QoSOverridingOptions(
    [QoSPolicyKind.DEPTH, QoSPolicyKind.HISTORY, QoSPolicyKind.RELIABILITY]
)
"""Those of a StaticTransformBroadcaster; a TransformBroadcaster has those of EVENT_OVERRIDING."""

_TYPE_NAMES = {
    ParameterType.NOT_SET: "not set",
    ParameterType.BOOL: "bool",
    ParameterType.INTEGER: "integer",
    ParameterType.DOUBLE: "double",
    ParameterType.STRING: "string",
    ParameterType.BYTE_ARRAY: "byte_array",
    ParameterType.BOOL_ARRAY: "bool_array",
    ParameterType.INTEGER_ARRAY: "integer_array",
    ParameterType.DOUBLE_ARRAY: "double_array",
    ParameterType.STRING_ARRAY: "string_array",
}
"""The names of the types in rclcpp."""


def listen_to_parameter_events(node: Node) -> None:
    """Subscribe to /parameter_events, because nodes in C++ show that subscription.

    Events are ignored, because parameters are read from the node when they are needed.
    """
    node.create_subscription(
        ParameterEvent, "/parameter_events", lambda _: None, qos_profile_parameter_events, raw=True
    )


def wrong_type(node: Node, parameter: Parameter) -> str | None:
    """Return rclcpp's reason for rejecting a declared parameter's value because of its type, or None."""
    if not node.has_parameter(parameter.name):
        return None
    descriptor = node.describe_parameter(parameter.name)
    declared_type, given_type = ParameterType(descriptor.type), ParameterType(parameter.type_.value)
    if declared_type is given_type or descriptor.dynamic_typing:
        return None
    return (
        f"Wrong parameter type, parameter {{{parameter.name}}} is of type {{{_TYPE_NAMES[declared_type]}}}, "
        f"setting it to {{{_TYPE_NAMES[given_type]}}} is not allowed."
    )
