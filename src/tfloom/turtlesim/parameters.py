"""turtlesim's parameters: the background's colour, and whether turtles are holonomic."""

from __future__ import annotations

from tfloom.interfaces.rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from tfloom.node.cpp_nodes import wrong_type
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.turtlesim.canvas import DEFAULT_BACKGROUND
from tfloom.turtlesim.world import Color

CHANNELS = ("Red", "Green", "Blue")
HOLONOMIC = "holonomic"


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


def background(node: Node) -> Color:
    """Return the background's colour."""
    red, green, blue = (int(node.get_parameter(f"background_{channel}").value) for channel in "rgb")
    return red, green, blue


def is_holonomic(node: Node) -> bool:
    """Return whether turtles are holonomic: they can move sideways."""
    return bool(node.get_parameter(HOLONOMIC).value)


def rejection_reason(node: Node, parameter: Parameter) -> str | None:
    """Return the reference's reason for rejecting this value of a declared parameter, or None if it accepts it."""
    if reason := wrong_type(node, parameter):
        return reason
    if not node.has_parameter(parameter.name):
        return None
    descriptor = node.describe_parameter(parameter.name)
    for allowed in descriptor.integer_range:
        if not allowed.from_value <= parameter.value <= allowed.to_value:
            return f"Parameter {{{parameter.name}}} doesn't comply with integer range."
    return None
