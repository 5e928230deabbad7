"""Hashes and bytes equal those of a real ROS 2 Jazzy (tests/golden/jazzy_types.jsonl)."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from tests.each import for_each

from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.registry import get_message_class

GOLDEN = Path(__file__).parents[1] / "golden" / "jazzy_types.jsonl"
TYPES = [json.loads(line) for line in GOLDEN.read_text(encoding="utf-8").splitlines()]
MESSAGES = [entry for entry in TYPES if entry["samples"]]


def build(cls: type[Message], values: dict[str, Any]) -> Message:
    """Build a message from a golden sample's value."""
    return cls(**{name: _field(parse_type(cls._FIELDS[name]), value) for name, value in values.items()})


def _field(type_: Any, value: Any) -> Any:
    if type_.shape:
        return [_field(type_.element, item) for item in value]
    if not type_.is_primitive:
        return build(get_message_class(type_.base), value)
    if type_.base == "byte":
        return bytes([value])
    return float(value) if type_.base.startswith("float") else value


@for_each(MESSAGES, name=lambda entry: entry["type"])
def test_golden_bytes_are_encoded_and_decoded(golden: dict[str, Any]) -> None:
    cls = get_message_class(golden["type"])
    for sample in golden["samples"]:
        data = bytes.fromhex(sample["cdr"])
        message = build(cls, sample["value"])
        assert cdr.encode(message).hex() == data.hex()
        decoded = cdr.decode(cls, data)
        assert decoded == message
        assert type(decoded) is cls
        assert cdr.encode(decoded) == data


def test_golden_file_has_all_samples() -> None:
    assert len(TYPES) == 375
    assert sum(len(entry["samples"]) for entry in TYPES) == 969


@for_each(MESSAGES, name=lambda entry: entry["type"])
def test_type_hash_matches_the_golden(golden: dict[str, Any]) -> None:
    assert golden["type_hash"] == get_message_class(golden["type"])._TYPE_HASH
