"""The one writer of parameter values: as YAML from which rcl's rules, those of `scalars`, read the same value.

Import this module where it is used, because yaml takes 15 ms to load.
"""

from __future__ import annotations

import base64
import sys
from collections.abc import Mapping
from typing import Any

import yaml

from tfloom.node.values.scalars import parse_scalar

__all__ = ["tree_text", "value_text"]

_STRING = "tag:yaml.org,2002:str"


class _Dumper(yaml.SafeDumper):
    """Writes texts in quotes that rcl would read as another value, or that YAML would change."""

    def ignore_aliases(self, data: Any) -> bool:
        """Return True, because rcl reads no aliases."""
        return True


def _represent_text(dumper: _Dumper, text: str) -> Any:
    style = None if parse_scalar(text) == text else "'"
    is_changed = not text.replace("\n", "").isprintable() or ("\n" in text and dumper.default_flow_style)
    return dumper.represent_scalar(_STRING, text, style='"' if is_changed else style)


def _represent_float(dumper: _Dumper, value: float) -> Any:
    if parse_scalar(repr(value)) == repr(value):
        # strtod has no such small number in decimal, but its exact value. For PyYAML, this is a text.
        return dumper.represent_scalar(_STRING, value.hex())
    return dumper.represent_float(value)


def _represent_list(dumper: _Dumper, values: list[Any]) -> Any:
    if values and all(isinstance(value, bytes) for value in values):
        return _represent_bytes(dumper, b"".join(values))
    return dumper.represent_list(values)


def _represent_bytes(dumper: _Dumper, data: bytes) -> Any:
    return dumper.represent_scalar("tag:yaml.org,2002:binary", base64.b64encode(data).decode("ascii"))


_Dumper.add_representer(str, _represent_text)
_Dumper.add_representer(float, _represent_float)
_Dumper.add_representer(list, _represent_list)
_Dumper.add_representer(bytes, _represent_bytes)


def value_text(value: Any) -> str:
    """Return a parameter's value as YAML on one line; "" for None."""
    if value is None:
        return ""
    text = yaml.dump(
        _plain(value), Dumper=_Dumper, default_flow_style=True, allow_unicode=True, width=sys.maxsize
    )
    return str(text).removesuffix("\n").removesuffix("\n...")


def tree_text(tree: Mapping[str, Any]) -> str:
    """Return a mapping, as that of a parameter file, as YAML in lines of the length that `ros2 param dump` has."""
    return str(yaml.dump(_plain(tree), Dumper=_Dumper, default_flow_style=False, allow_unicode=True))


def _plain(value: Any) -> Any:
    """Return a value with its sequences as lists."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if hasattr(value, "tolist"):  # an array
        return value.tolist()
    return list(value) if isinstance(value, tuple) else value
