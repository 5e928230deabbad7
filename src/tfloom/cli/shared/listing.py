"""Lists as text and as JSON, and values as strict JSON."""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Collection, Mapping
from typing import Any

from tfloom.common import terminal as terminal_text
from tfloom.rosidl.message import Message


def json_text(value: Any, indent: int | None = None) -> str:
    """Return plain values, messages, arrays and bytes as JSON; NaN and infinities, which JSON lacks, as null."""
    import json

    return json.dumps(plain(value), indent=indent, ensure_ascii=False, allow_nan=False)


def plain(value: Any) -> Any:
    """Return a value converted to JSON's types: mappings with names, lists, numbers, texts, true, false and null."""
    if isinstance(value, Message):
        from tfloom.rosidl.yaml_text import message_to_ordereddict

        value = message_to_ordereddict(value)
    if value is None or isinstance(value, (str, int)):
        return value
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {str(name): plain(item) for name, item in value.items()}
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    return [plain(item) for item in value]


def print_names(names: Collection[str], *, as_json: bool = False, only_count: bool = False) -> None:
    """Print one name on each line, or all as a JSON list, or their number."""
    if as_json:
        print_json(list(names))
    elif only_count:
        print(len(names))
    else:
        is_terminal = terminal_text.is_terminal(sys.stdout)
        for name in names:
            print(terminal_text.shown_name(name) if is_terminal else name)


def print_types(types: Mapping[str, Collection[str]], args: argparse.Namespace, *, only_count: bool) -> None:
    """Print one name on each line, with its types if the flags say so, or all as a JSON list, or their number."""
    if args.json:
        print_json([{"name": name, "types": list(kinds)} for name, kinds in types.items()])
    elif only_count:
        print(len(types))
    else:
        for name, kinds in types.items():
            print(f"{name} [{', '.join(kinds)}]" if args.show_types else name)


def print_json(value: Any) -> None:
    """Print a value as JSON, indented."""
    print(json_text(value, indent=2))
