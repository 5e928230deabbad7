"""Values as strict JSON."""

from __future__ import annotations

import math
from typing import Any

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
