"""Initial values of parameters, and the YAML files that hold them.

Empty lists from YAML don't have the type of their items: it is that of the node's declared parameter.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.common.text import shortened
from tfloom.node.values.scalars import parse_documents

if TYPE_CHECKING:
    from pathlib import Path

    from tfloom.interfaces.rcl_interfaces.msg import Parameter, ParameterDescriptor

__all__ = [
    "EVERY_NODE",
    "ParameterRule",
    "checked_value",
    "give_declared_types",
    "give_types",
    "read_parameter_file",
    "untyped_names",
]

# A malformed file raises ValueError, whichever Python type the value has.


EVERY_NODE = "/**"
"""The pattern that matches all nodes."""

_KEY = "ros__parameters"
_NODE = r"(/(\*\*?|[A-Za-z_][A-Za-z0-9_]*))+"


class ParameterRule(NamedTuple):
    """A parameter's value for the nodes that match a pattern."""

    node: str
    """Full name of a node; `*` matches one part of it, `**` any number of parts."""
    name: str
    value: Any

    def is_for(self, full_name: str) -> bool:
        """Return whether the pattern matches this full name."""
        if self.node == EVERY_NODE:
            return True
        parts = (
            ".*" if part == "**" else "[^/]*" if part == "*" else re.escape(part)
            for part in self.node.split("/")
        )
        return re.fullmatch("/".join(parts).replace("/.*", "(/.*)?"), full_name) is not None


def read_parameter_file(path: str | Path, *, can_be_flat: bool = False) -> list[ParameterRule]:
    """Return the parameter values in a file, in its order.

    Args:
        path: The file.
        can_be_flat: Whether it may hold names and values alone, without a node's name, which are for each node.

    Raises:
        OSError: the file can't be read.
        ValueError: it isn't a parameter file; the text has the reason and the place.
    """
    from pathlib import Path

    try:
        text = Path(path).read_text("utf-8")
    except UnicodeDecodeError:
        raise ValueError(f"{path} isn't UTF-8 text") from None
    try:
        documents = parse_documents(text)
        return [
            rule for document in documents for rule in _rules_of_document(document, can_be_flat=can_be_flat)
        ]
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None


def _rules_of_document(content: Any, *, can_be_flat: bool) -> Iterator[ParameterRule]:
    if not isinstance(content, dict):
        raise ValueError(f"it must hold a mapping of node names, not {shortened(repr(content))}")
    if can_be_flat and _is_flat(content):
        yield from _rules_of_node(EVERY_NODE, "", content)
        return
    for key, value in content.items():
        yield from _rules_below(_join_namespace("", key), value)


def _is_flat(content: Any) -> bool:
    """Return whether a mapping holds names of parameters, and none of nodes."""
    return not isinstance(content, dict) or all(
        key != _KEY and not re.match(r"/|\*", key) and _is_flat(value) for key, value in content.items()
    )


def _join_namespace(namespace: str, key: str) -> str:
    node = f"{namespace.rstrip('/')}/{key.removeprefix('/')}"
    # "/" alone may hold the names of nodes.
    if key != "/" and not re.fullmatch(_NODE, node):
        raise ValueError(
            f"'{key}' is not a name of nodes: it is a name such as /robot/camera, of which * stands for one part and "
            "** for any number"
        )
    return node


def _rules_below(node: str, content: Any) -> Iterator[ParameterRule]:
    if not isinstance(content, dict):
        raise ValueError(f"{node}: expected '{_KEY}' below it, found {shortened(repr(content))}")
    for key, value in content.items():
        if key == _KEY and node == "/":
            raise ValueError(f"'{_KEY}' is below '/', and not below the name of a node")
        if key != _KEY:
            yield from _rules_below(_join_namespace(node, key), value)
            continue
        if not isinstance(value, dict):
            raise ValueError(f"{node}: '{_KEY}' must hold names and values, not {shortened(repr(value))}")
        yield from _rules_of_node(node, "", value)


def _rules_of_node(node: str, prefix: str, content: dict[str, Any]) -> Iterator[ParameterRule]:
    for key, value in content.items():
        name = f"{prefix}{key}"
        if not key:
            raise ValueError(f"{node}: a parameter below '{prefix}' has no name")
        if isinstance(value, dict):
            yield from _rules_of_node(node, f"{name}.", value)
        else:
            yield ParameterRule(node, name, _checked_value_of(node, name, value))


def _checked_value_of(node: str, name: str, value: Any) -> Any:
    try:
        return checked_value(name, value)
    except ValueError as error:
        raise ValueError(f"{node}: {error}") from None


def checked_value(name: str, value: Any) -> Any:
    """Return a value as a parameter holds it: in a list of integers and floats, all become floats.

    Raises:
        ValueError: it is a list of several types, or of a type that parameters don't have.
    """
    if not isinstance(value, list):
        return value
    kinds = {type(item) for item in value}
    if kinds == {int, float}:
        return [float(item) for item in value]
    if len(kinds) > 1 or not kinds <= {bool, int, float, str, bytes}:
        kind_names = ", ".join(sorted(kind.__name__ for kind in kinds))
        raise ValueError(f"the list of '{name}' must be of one scalar type, not {kind_names}")
    return value


_BYTE_ARRAY = 5
"""The constant of `rcl_interfaces/msg/ParameterType`, the lowest of those of arrays."""


def untyped_names(parameters: Iterable[Parameter]) -> list[str]:
    """Return the names of those whose value is an empty list that was read from YAML, which is a BYTE_ARRAY."""
    return [parameter.name for parameter in parameters if _is_untyped(parameter)]


def give_declared_types(
    parameters: Sequence[Parameter], describe: Callable[[str], Iterable[ParameterDescriptor]]
) -> None:
    """Give the empty lists among them the types that a node has for them.

    Args:
        parameters: The parameters, which are changed.
        describe: Waits for the node's response, and returns its descriptors of a parameter. It is called for one name
            at a time, because a node returns none if one of several names isn't declared.
    """
    types: dict[str, int] = {}
    for name in untyped_names(parameters):
        types.update((descriptor.name, descriptor.type) for descriptor in describe(name))
    give_types(parameters, types)


def give_types(parameters: Iterable[Parameter], types: Mapping[str, int]) -> None:
    """Give the empty lists among them the types of a node's descriptors, by name; where there is none, they stay.

    A parameter that was declared by its type has this type there, also while it has no value.
    """
    for parameter in parameters:
        if _is_untyped(parameter):
            parameter.value.type = max(types.get(parameter.name, 0), _BYTE_ARRAY)


def _is_untyped(parameter: Parameter) -> bool:
    return parameter.value.type == _BYTE_ARRAY and not parameter.value.byte_array_value
