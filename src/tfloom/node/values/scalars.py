"""The one reader of parameter values: from YAML text, by the rules of rcl, which are not those of YAML 1.1.

`value_text` writes what these rules read.
"""

from __future__ import annotations

import re
from typing import Any

from tfloom.common.text import shortened
from tfloom.ros_imports import ros_distro

__all__ = ["is_markup", "parse_documents", "parse_scalar", "parse_value"]

_TRUE = {"y", "Y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"}
_FALSE = {"n", "N", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"}
_LETTERS = {"y", "Y", "n", "N"}
# Patterns are compiled and cached by `re` at their first use, because most programs never need them.
# They accept what strtol (base 0) and strtod accept, white space before it included.
_INTEGER = r"(?a)\s*([-+]?)(0[xX])?([0-9a-fA-F]+)\Z"
_DOUBLE = r"(?a)\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\Z"
_HEX_DOUBLE = r"(?a)\s*[-+]?0[xX]([0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)([pP][-+]?[0-9]+)?\Z"
_NOT_FINITE = r"(?ai)\s*([-+]?)(inf|nan)(?:(?<=f)inity|(?<=n)\([a-z0-9_]*\))?\Z"
_DOTTED_NOT_FINITE = r"([-+]?)\.(inf|Inf|INF)\Z|()\.(nan|NaN|NAN)\Z"
_DIGITS = {8: r"[0-7]*\Z", 10: r"[0-9]+\Z", 16: ""}
_MAX_DIGITS = 25
"""More digits than an integer of 64 bits has, after its leading zeros, to any base."""
_MIN_NORMAL = 2.0**-1022
"""The smallest float that has all of its 53 bits."""
_BINARY = "tag:yaml.org,2002:binary"
_FLOAT = "tag:yaml.org,2002:float"
_MERGE = "tag:yaml.org,2002:merge"
_KNOWN_TAGS = {_BINARY, _FLOAT, *(f"tag:yaml.org,2002:{kind}" for kind in ("bool", "int", "str"))}
"""What may stand before a scalar in Lyrical; distributions before ignore what they don't know."""
_QUOTES = ("'", '"')
_WORDS = r"(?!\.\.\.)-?[A-Za-z0-9_+./][A-Za-z0-9_+./-]*( [A-Za-z0-9_+./][A-Za-z0-9_+./-]*)*\Z"
"""Text that YAML has no other meaning for, so that yaml, which takes 15 ms to load, isn't needed."""
_MARKUP = r"\ufeff?\s*<"
"""The beginning of a robot's description: as YAML, one with a colon before a blank would be refused, others folded."""


def parse_scalar(text: str, *, letters: bool = True) -> bool | int | float | str:
    """Return the value of an unquoted scalar: a bool, an integer, a float, else the text itself.

    An integer beyond 64 bits is a float; a number beyond a float's range is text.

    Args:
        text: The scalar.
        letters: Whether `y` and `n` are bools, too.
    """
    if text in _LETTERS and not letters:
        return text
    if text in _TRUE:
        return True
    if text in _FALSE:
        return False
    integer = _integer(text)
    if integer is not None:
        return integer
    double = _double(text)
    return text if double is None else double


def _integer(text: str) -> int | None:
    """Return the integer that strtol reads to base 0; None if it is none, or doesn't fit 64 bits."""
    match = re.match(_INTEGER, text)
    if not match:
        return None
    sign, prefix, digits = match.groups()
    base = 16 if prefix else 8 if digits[0] == "0" else 10
    significant = digits.lstrip("0") or "0"
    if not re.match(_DIGITS[base], digits) or len(significant) > _MAX_DIGITS:
        return None
    value = int(f"{sign}{significant}", base)
    return value if -(2**63) <= value < 2**63 else None


def _double(text: str) -> float | None:
    """Return the float that strtod reads; None if it is none, or out of range."""
    if re.match(_DOUBLE, text):
        value = float(text)
        is_exact = abs(value) >= _MIN_NORMAL or _is_exact(text, value)
        return value if is_exact and abs(value) != float("inf") else None
    if re.match(_HEX_DOUBLE, text):
        try:
            value = float.fromhex(text)
        except OverflowError:
            return None
        return value if abs(value) >= _MIN_NORMAL or _is_exact_hex(text, value) else None
    special = re.match(_NOT_FINITE, text) or re.match(_DOTTED_NOT_FINITE, text)
    return float("".join(filter(None, special.groups()))) if special else None


def _is_exact(text: str, value: float) -> bool:
    """Return whether a decimal text stands for this small float. Another number is out of range for strtod."""
    mantissa = re.split("[eE]", text)[0]
    if not value:
        return not re.search("[1-9]", mantissa)
    from decimal import Decimal

    return Decimal(text) == Decimal(value)


def _is_exact_hex(text: str, value: float) -> bool:
    mantissa, _, exponent = text.lower().partition("p")
    digits = mantissa.partition("0x")[2]
    whole, _, fraction = digits.partition(".")
    number = int(f"{whole}{fraction}", 16)
    if not number or not value:
        return not number
    from fractions import Fraction

    return number * Fraction(2) ** (int(exponent or 0) - 4 * len(fraction)) == abs(Fraction(value))


def parse_value(text: str, *, nothing: Any = "", letters: bool = True) -> Any:
    """Return the value of a piece of YAML: a scalar, a list, or a mapping with text for keys.

    Of several documents, the last counts. A text that begins with `<` is XML, as of a robot's description, and is the
    value as it is, with its line breaks.

    Args:
        text: The YAML.
        nothing: Returned for text without a value: blanks, or a comment.
        letters: Whether `y` and `n` are bools, too.

    Raises:
        ValueError: it is not valid YAML, or a part of it has no value; a YamlLimitError if it is too large or nested
            too deep.
    """
    if re.match(_WORDS, text):
        return parse_scalar(text, letters=letters)
    if is_markup(text):
        return text
    documents = parse_documents(text, letters=letters)
    return documents[-1] if documents else nothing


def is_markup(text: str) -> bool:
    """Return whether a text is XML, whose first character that isn't blank is `<`."""
    return re.match(_MARKUP, text) is not None


def parse_documents(text: str, *, letters: bool = True) -> list[Any]:
    """Return the values of the documents of a YAML text; see `parse_value`.

    Mappings of one key, given twice, are merged; of other values the last counts. What `<<` merges into a mapping gives
    way to the keys that stand in it.
    """
    from tfloom.common.yaml import compose_all

    return [_construct(node, letters) for node in compose_all(text)]


def _construct(node: Any, letters: bool) -> Any:
    import yaml

    if isinstance(node, yaml.MappingNode):
        return _construct_mapping(node, letters)
    if isinstance(node, yaml.SequenceNode):
        items = [_construct(item, letters) for item in node.value]
        is_bytes = items and all(item.tag == _BINARY for item in node.value)
        return [byte for item in items for byte in item] if is_bytes else items
    if node.has_tag and node.tag not in _KNOWN_TAGS and ros_distro.READS_FLOAT_TAG:
        raise _error(
            f'Unsupport tag "{node.tag}"', node, "the tags are !!bool, !!int, !!float, !!str and !!binary"
        )
    if node.style in _QUOTES and node.tag != _BINARY:
        return node.value
    if node.value == "":
        raise _error("there is no value", node, "write '' for an empty text")
    if node.tag == _BINARY:
        return _bytes(node.value)
    if node.has_tag and node.tag == _FLOAT and ros_distro.READS_FLOAT_TAG:
        return _tagged_double(node)
    return parse_scalar(node.value, letters=letters)


def _tagged_double(node: Any) -> float:
    if (value := _double(node.value)) is None:
        raise _error(
            f"'{shortened(node.value)}' is not a number", node, "!!float stands before one, as 10 or 1.5"
        )
    return value


def _construct_mapping(node: Any, letters: bool) -> dict[str, Any]:
    import yaml

    content: dict[str, Any] = {}
    merged: dict[str, Any] = {}
    for key, value in node.value:
        if not isinstance(key, yaml.ScalarNode):
            raise _error("a key is a list or a mapping", key, "a key is a name")
        if key.tag != _MERGE:
            _merge_value(content, key.value, _construct(value, letters))
            continue
        sources = value.value if isinstance(value, yaml.SequenceNode) else [value]
        for source in sources:
            if not isinstance(source, yaml.MappingNode):
                raise _error("'<<' is there without a mapping", key, "write <<: *anchor")
            merged = _construct_mapping(source, letters) | merged
    return merged | content


def _error(what: str, node: Any, hint: str) -> ValueError:
    mark = node.start_mark
    return ValueError(f"{what} at line {mark.line + 1}, column {mark.column + 1}: {hint}")


def _merge_value(content: dict[str, Any], key: str, value: Any) -> None:
    """Set `key` to `value`; merge them if both are mappings."""
    former_value = content.get(key)
    if isinstance(value, dict) and isinstance(former_value, dict):
        for inner_key, inner in value.items():
            _merge_value(former_value, inner_key, inner)
    elif isinstance(former_value, list) and any(isinstance(item, dict) for item in former_value):
        raise ValueError(f"'{key}' is a list of mappings, and is there twice")
    else:
        content[key] = value


def _bytes(text: str) -> list[bytes]:
    """Return the bytes of a byte array, base64 in YAML."""
    import base64
    import binascii

    try:
        return [bytes([byte]) for byte in base64.b64decode("".join(text.split()), validate=True)]
    except binascii.Error as error:
        raise ValueError(f"it is not base64, which !!binary stands for: {error}") from None
