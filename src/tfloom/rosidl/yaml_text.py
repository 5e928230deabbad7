"""Conversion of messages to the text of `ros2 topic echo` (YAML and CSV), and from the values of `ros2 topic pub`."""

from __future__ import annotations

import sys
from collections import OrderedDict
from collections.abc import Iterator
from typing import Any

from tfloom.rosidl.fill import set_message_fields
from tfloom.rosidl.message import Message
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.spec import Type, idl_name

__all__ = ["message_to_csv", "message_to_ordereddict", "message_to_yaml", "set_message_fields"]


def message_to_yaml(
    msg: Message,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
    flow_style: bool = False,
) -> str:
    """Return a message as YAML that ends with a line break.

    Args:
        msg: The message.
        truncate_length: Truncate arrays and strings to this length, followed by `...`; None: no limit.
        no_arr: Show the type and length of arrays instead of their elements.
        no_str: Show the length of strings instead of their characters.
        flow_style: Write arrays on one line, in brackets.
    """
    import yaml

    class Dumper(yaml.SafeDumper):
        """Writes mappings in block style, except inside flow sequences, where YAML has none."""

    def represent_mapping(dumper: Dumper, mapping: OrderedDict[str, Any]) -> Any:
        return dumper.represent_mapping("tag:yaml.org,2002:map", list(mapping.items()), flow_style=False)

    def represent_text(dumper: Dumper, text: str) -> Any:
        # YAML takes these for line breaks, which only escapes keep in quotes.
        is_changed = any(character in text for character in "\x85\u2028\u2029")
        return dumper.represent_scalar("tag:yaml.org,2002:str", text, style='"' if is_changed else None)

    Dumper.add_representer(OrderedDict, represent_mapping)
    Dumper.add_representer(str, represent_text)
    values = message_to_ordereddict(msg, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    text = yaml.dump(
        values, Dumper=Dumper, allow_unicode=True, width=sys.maxsize, default_flow_style=flow_style
    )
    return str(text)


def message_to_csv(
    msg: Message, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> str:
    """Return all values of a message, nested messages and arrays included, separated by commas.

    The arguments are those of `message_to_yaml`.
    """
    options = _Options(truncate_length, no_arr=no_arr, no_str=no_str, is_csv=True)
    return ",".join(str(value) for value in _flatten(options.message(msg)))


def message_to_ordereddict(
    msg: Message, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> OrderedDict[str, Any]:
    """Return a message as plain values, field by field: numbers, strings, lists and mappings.

    The arguments are those of `message_to_yaml`.
    """
    options = _Options(truncate_length, no_arr=no_arr, no_str=no_str)
    return options.message(msg)


def _flatten(value: Any) -> Iterator[Any]:
    if isinstance(value, OrderedDict):
        value = list(value.values())
    if isinstance(value, list):
        for item in value:
            yield from _flatten(item)
    else:
        yield value


class _Options:
    def __init__(
        self, truncate_length: int | None, *, no_arr: bool, no_str: bool, is_csv: bool = False
    ) -> None:
        self.truncate_length = truncate_length
        self.no_arr = no_arr
        self.no_str = no_str
        self.is_csv = is_csv

    def message(self, msg: Message) -> OrderedDict[str, Any]:
        return OrderedDict(
            (name, self.value(getattr(msg, name), parse_type(text))) for name, text in msg._FIELDS.items()
        )

    def value(self, value: Any, type_: Type) -> Any:
        if isinstance(value, bytes):
            # CSV has bytes as Python writes them, because some would be a comma or a line break there.
            value = str(value) if self.is_csv else value.decode("latin-1")
        if isinstance(value, str):
            return self.string(value)
        if type_.shape:
            return _describe_array(type_, len(value)) if self.no_arr else self.array(value, type_.element)
        if isinstance(value, Message):
            return self.message(value)
        return value.item() if hasattr(value, "item") else value  # a numpy number

    def string(self, value: str) -> str:
        if self.no_str:
            return f"<string length: <{len(value)}>>"
        cut = self.truncate_length
        return value if cut is None or len(value) <= cut else f"{value[:cut]}..."

    def array(self, value: Any, element: Type) -> list[Any]:
        cut = self.truncate_length
        kept = value if cut is None or len(value) <= cut else value[:cut]
        plain = kept.tolist() if hasattr(kept, "tolist") else [self.value(item, element) for item in kept]
        return [*plain, "..."] if len(kept) < len(value) else plain


def _describe_array(type_: Type, length: int) -> str:
    name = type_.base if not type_.is_primitive else idl_name(Type(type_.base))
    if type_.shape == "array":
        return f"<array type: {name}[{type_.length}]>"
    bound = f"[{type_.length}]" if type_.shape == "bounded" else ""
    return f"<sequence type: {name}{bound}, length: {length}>"
