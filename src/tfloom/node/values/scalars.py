"""Parsing of parameter values from YAML text, by ROS's rules."""

from __future__ import annotations

import math
import re
from typing import Any

__all__ = ["parse_scalar", "parse_value"]

_TRUE = {"y", "Y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"}
_FALSE = {"n", "N", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"}
# Patterns are compiled and cached by `re` at their first use, because most programs never need them.
_INTEGER = r"[-+]?(0[xX][0-9a-fA-F]+|[0-9]+)\Z"
_MAX_DIGITS = 300
_DOUBLE = r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\Z"
_NOT_FINITE = r"([-+]?)\.(inf|Inf|INF|nan|NaN|NAN)\Z"
_BINARY = "tag:yaml.org,2002:binary"
_NEEDS_YAML = r"[\[\]{}'\"#&*!|>%@`,\n]|: |:$|^[-?] |^\s|\s$"


def parse_scalar(text: str) -> bool | int | float | str:
    """Return the value of an unquoted scalar: a bool, an integer, a float, else the text itself."""
    if text in _TRUE:
        return True
    if text in _FALSE:
        return False
    if re.match(_INTEGER, text):
        digits = text.lstrip("+-")
        is_octal = len(digits) > 1 and digits[0] == "0" and digits[1] not in "xX"
        if not is_octal:
            return _integer(text, 0)
        if set(digits) <= set("01234567"):
            return _integer(text, 8)
    if re.match(_DOUBLE, text):
        return float(text)
    special = re.match(_NOT_FINITE, text)
    return float(special.group(1) + special.group(2)) if special else text


def _integer(text: str, base: int) -> int | float:
    """Return an integer, or a float if it doesn't fit 64 bits."""
    if len(text) <= _MAX_DIGITS:
        value = int(text, base)
        return value if -(2**63) <= value < 2**63 else float(value)
    return math.copysign(math.inf, -1 if text[0] == "-" else 1)


def parse_value(text: str, *, nothing: str = "") -> Any:
    """Return the value of a piece of YAML: a scalar, a list, or a mapping with text for keys.

    Mappings of one key, given twice, are merged; of other values the last counts.

    Args:
        text: The YAML.
        nothing: Returned for text without a value: blanks, or a comment.

    Raises:
        YamlError: it is not valid YAML, or more than one document.
        YamlLimitError: it is too large, or nested too deep.
        ValueError: a byte array in it isn't base64.
    """
    if text and not re.search(_NEEDS_YAML, text):
        return parse_scalar(text)
    from tfloom.rosidl.user_yaml import compose

    node = compose(text)
    return nothing if node is None else _construct(node)


def _construct(node: Any) -> Any:
    import yaml

    if isinstance(node, yaml.MappingNode):
        content: dict[str, Any] = {}
        for key, value in node.value:
            _merge_value(content, str(key.value), _construct(value))
        return content
    if isinstance(node, yaml.SequenceNode):
        items = [_construct(item) for item in node.value]
        is_bytes = items and all(item.tag == _BINARY for item in node.value)
        return [byte for item in items for byte in item] if is_bytes else items
    if node.tag == _BINARY:
        return _bytes(node.value)
    if node.style is not None:
        return node.value
    return parse_scalar(node.value)


def _merge_value(content: dict[str, Any], key: str, value: Any) -> None:
    """Set `key` to `value`; merge them if both are mappings."""
    former_value = content.get(key)
    if isinstance(value, dict) and isinstance(former_value, dict):
        for inner_key, inner in value.items():
            _merge_value(former_value, inner_key, inner)
    else:
        content[key] = value


def _bytes(text: str) -> list[bytes]:
    """Return the bytes of a byte array, base64 in YAML."""
    import base64
    import binascii

    try:
        return [bytes([byte]) for byte in base64.b64decode("".join(text.split()), validate=True)]
    except binascii.Error as error:
        raise ValueError(f"it is no base64, which !!binary stands for: {error}") from None
