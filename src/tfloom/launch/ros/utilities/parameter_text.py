"""Values of parameters as texts on a command line and in parameter files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

__all__ = ["parameter_file_text", "parameter_rule", "untyped_items", "untyped_value"]


def untyped_value(text: str) -> Any:
    """Return the value that a text without a type has by rcl's rules; a text without a value stays one.

    In a list of texts, as `[x, y, z]`, the letters `y` and `n` are not bools, because a list has one type.

    Raises:
        ValueError: it is not valid YAML, or a part of it has no value.
    """
    from tfloom.node.values.scalars import parse_value

    value = parse_value(text, nothing=text)
    return parse_value(text, letters=False) if _has_bools_among_texts(value) else value


def untyped_items(texts: Sequence[str]) -> list[Any]:
    """Return the values of a list's items, each of which is a text without a type; see `untyped_value`."""
    from tfloom.node.values.scalars import parse_value

    values = [parse_value(text, nothing=text) for text in texts]
    if _has_bools_among_texts(values):
        return [parse_value(text, nothing=text, letters=False) for text in texts]
    return values


def _has_bools_among_texts(value: Any) -> bool:
    return isinstance(value, list) and {type(item) for item in value} == {bool, str}


def parameter_rule(name: str, value: Any) -> str:
    """Return `name:=value` for the option -p, such that the value is read with its type.

    Python's text is used where the same value is read from it, also by a node of a stock ROS 2: there, XML is YAML.
    """
    from tfloom.node.values.scalars import is_markup, parse_value
    from tfloom.node.values.value_text import value_text

    plain = list(value) if isinstance(value, tuple) else value
    text = str(plain)
    if is_markup(text):
        return f"{name}:={value_text(plain)}"
    try:
        read = parse_value(text, nothing=None)
    except ValueError:
        read = None
    # As texts, in which True and 1 differ, also within a list, and NaN is equal to itself.
    return f"{name}:={text if repr(read) == repr(plain) else value_text(plain)}"


def parameter_file_text(node: str, parameters: Mapping[str, Any]) -> str:
    """Return the content of a file with the parameters of a node; the node `/**` is each one."""
    from tfloom.node.values.value_text import tree_text

    return tree_text({node: {"ros__parameters": parameters}})
