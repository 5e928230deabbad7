"""What actions set for later nodes in the same scope: parameters, remappings, a namespace.

They are launch configurations, so that a group with a scope restores them. Their values are lists, which are replaced
and never changed, because the scope's copy refers to the same list.
"""

from __future__ import annotations

from typing import Any, Union, cast

from tfloom.launch.core.launch_context import LaunchContext

__all__ = [
    "GlobalParameter",
    "add_global_parameters",
    "add_remapping",
    "global_parameters",
    "namespace",
    "remappings",
    "set_namespace",
]

GlobalParameter = Union[tuple[str, Any], str]
"""A name and a value, or the path of a file."""

_PARAMETERS, _REMAPPINGS, _NAMESPACE = "global_params", "ros_remaps", "ros_namespace"


def _values(context: LaunchContext) -> dict[str, Any]:
    return cast("dict[str, Any]", context.launch_configurations)


def global_parameters(context: LaunchContext) -> list[GlobalParameter]:
    """Return the parameters for all nodes, in the order in which they were set."""
    return list(_values(context).get(_PARAMETERS) or ())


def add_global_parameters(context: LaunchContext, *parameters: GlobalParameter) -> None:
    """Add parameters for all later nodes."""
    _values(context)[_PARAMETERS] = [*global_parameters(context), *parameters]


def remappings(context: LaunchContext) -> list[tuple[str, str]]:
    """Return the remappings for all nodes, in the order in which they were set."""
    return list(_values(context).get(_REMAPPINGS) or ())


def add_remapping(context: LaunchContext, name: str, replacement: str) -> None:
    """Add a remapping for all later nodes."""
    _values(context)[_REMAPPINGS] = [*remappings(context), (name, replacement)]


def namespace(context: LaunchContext) -> str | None:
    """Return the namespace of all nodes; None if there is none."""
    namespace = _values(context).get(_NAMESPACE)
    return None if namespace is None else str(namespace)


def set_namespace(context: LaunchContext, name: str) -> None:
    """Set the namespace of all later nodes."""
    _values(context)[_NAMESPACE] = name
