"""turtlesim's parameters: the background's colour, and whether turtles are holonomic."""

from __future__ import annotations

from tfloom.interfaces.rcl_interfaces.msg import IntegerRange, ParameterDescriptor, ParameterEvent
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter, ParameterType
from tfloom.node.qos.qos import QoSPolicyKind, qos_profile_parameter_events
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions
from tfloom.turtlesim.canvas import DEFAULT_BACKGROUND
from tfloom.turtlesim.world import Color

CHANNELS = ("Red", "Green", "Blue")
HOLONOMIC = "holonomic"
EVENT_OVERRIDING = QoSOverridingOptions(
    [QoSPolicyKind.DEPTH, QoSPolicyKind.DURABILITY, QoSPolicyKind.HISTORY, QoSPolicyKind.RELIABILITY]
)
"""The policies of the parameter event publisher that parameters may override, as in rclcpp."""
TYPE_NAMES = {
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
"""The names of the types in the reference's turtlesim, a C++ program."""


def declare(node: Node) -> None:
    """Declare turtlesim's parameters."""
    for channel, default in zip(CHANNELS, DEFAULT_BACKGROUND, strict=True):
        descriptor = ParameterDescriptor(
            description=f"{channel} channel of the background color",
            integer_range=[IntegerRange(from_value=0, to_value=255, step=1)],
        )
        node.declare_parameter(f"background_{channel[0].lower()}", default, descriptor)
    descriptor = ParameterDescriptor(description="If true, then turtles will be holonomic")
    node.declare_parameter(HOLONOMIC, False, descriptor)


def listen(node: Node) -> None:
    """Subscribe to /parameter_events, because the reference's turtlesim, a C++ node, shows that subscription.

    Events are ignored, because parameters are read from the node when they are needed.
    """
    node.create_subscription(
        ParameterEvent, "/parameter_events", lambda _: None, qos_profile_parameter_events, raw=True
    )


def background(node: Node) -> Color:
    """Return the background's colour."""
    red, green, blue = (int(node.get_parameter(f"background_{channel}").value) for channel in "rgb")
    return red, green, blue


def is_holonomic(node: Node) -> bool:
    """Return whether turtles are holonomic: they can move sideways."""
    return bool(node.get_parameter(HOLONOMIC).value)


def refusal(node: Node, parameter: Parameter) -> str | None:
    """Return the reference's reason for rejecting this value of a declared parameter, or None if it accepts it."""
    if not node.has_parameter(parameter.name):
        return None
    descriptor = node.describe_parameter(parameter.name)
    declared, given = ParameterType(descriptor.type), ParameterType(parameter.type_.value)
    if declared is not given and not descriptor.dynamic_typing:
        return (
            f"Wrong parameter type, parameter {{{parameter.name}}} is of type {{{TYPE_NAMES[declared]}}}, "
            f"setting it to {{{TYPE_NAMES[given]}}} is not allowed."
        )
    for allowed in descriptor.integer_range:
        if not allowed.from_value <= parameter.value <= allowed.to_value:
            return f"Parameter {{{parameter.name}}} doesn't comply with integer range."
    return None
