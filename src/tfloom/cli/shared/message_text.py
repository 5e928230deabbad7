"""Conversion of messages to printed text, and to one line of YAML to start from."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable
from typing import Any

from tfloom.cli.shared.numbers import count
from tfloom.rosidl.message import Message

TRUNCATE_LENGTH = 128
"""Number of elements of arrays, bytes and strings that are printed by default."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags for the conversion of messages to text."""
    parser.add_argument("--full-length", "-f", action="store_true", help="print arrays and strings in full")
    parser.add_argument(
        "--truncate-length",
        "-l",
        type=count,
        default=TRUNCATE_LENGTH,
        help=f"number of elements of arrays, bytes and strings to print (default: {TRUNCATE_LENGTH})",
    )
    parser.add_argument("--no-arr", action="store_true", help="print the types of arrays, not their elements")
    parser.add_argument("--no-str", action="store_true", help="print the lengths of strings, not their text")
    parser.add_argument("--flow-style", action="store_true", help="print collections in one line")


def message_text(args: argparse.Namespace) -> Callable[[Any], str]:
    """Return the function that converts a message, a field of one, or several fields by their paths to text."""
    # The keywords of `yaml_text.message_to_yaml` for the flags.
    options: dict[str, Any] = {
        "truncate_length": None if args.full_length else args.truncate_length,
        "no_arr": args.no_arr,
        "no_str": args.no_str,
        "flow_style": args.flow_style,
    }
    of_csv = {name: options[name] for name in ("truncate_length", "no_arr", "no_str")}

    def csv(value: Any) -> str:
        from tfloom.rosidl import yaml_text

        if isinstance(value, dict):
            return ",".join(csv(item) for item in value.values())
        return yaml_text.message_to_csv(value, **of_csv) if isinstance(value, Message) else f"{value}"

    def text(value: Any) -> str:
        from tfloom.rosidl import yaml_text

        if args.json:
            from tfloom.cli.shared.listing import json_text

            return json_text(value)
        if args.csv:
            return csv(value)
        if isinstance(value, dict):
            return "\n".join(_titled(path, item, options) for path, item in value.items()) + "\n---"
        if isinstance(value, Message):
            return f"{yaml_text.message_to_yaml(value, **options)}---"
        return f"{value}\n---"

    return text


def _titled(path: str, value: Any, options: dict[str, Any]) -> str:
    """Return a field under its path."""
    from tfloom.rosidl.yaml_text import message_to_yaml

    if not isinstance(value, Message):
        return f"{path}: {value}"
    lines = message_to_yaml(value, **options).splitlines()
    return "\n  ".join([f"{path}:", *lines])


def prototype(value: Any) -> str:
    """Return a message's fields as YAML's flow style, as `{data: ""}`, or the value of one."""
    if isinstance(value, Message):
        return (
            f"{{{', '.join(f'{_key(name)}: {prototype(getattr(value, name))}' for name in value._FIELDS)}}}"
        )
    if isinstance(value, str):
        import json

        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, bytes):  # the one of a field of type `byte`
        return str(value[0])
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return (
            str(value) if math.isfinite(value) else str(value).replace("inf", ".inf").replace("nan", ".nan")
        )
    if hasattr(value, "tolist"):
        value = value.tolist()
    return f"[{', '.join(map(prototype, value))}]" if isinstance(value, list) else str(value)


def _key(name: str) -> str:
    """Return a field's name; in quotes where YAML reads it as a value, as `off`."""
    from tfloom.common.yaml import load

    return name if load(name) == name else f'"{name}"'
