"""A message as one line of YAML to start from: each field with its default."""

from __future__ import annotations

import json
import math
from typing import Any

from tfloom.rosidl.message import Message


def prototype(value: Any) -> str:
    """Return a message's fields as YAML's flow style, as `{data: ""}`, or the value of one."""
    if isinstance(value, Message):
        return (
            f"{{{', '.join(f'{_key(name)}: {prototype(getattr(value, name))}' for name in value._FIELDS)}}}"
        )
    if isinstance(value, str):
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
