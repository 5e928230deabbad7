"""Run a kind's cases, JSON lines on stdin, and answer each with a JSON line: `compare_worker.py KIND_FILE < CASES`.

tfloom and the real rclpy run it unchanged. What a case prints goes to stderr.
"""

from __future__ import annotations

import importlib.util
import json
import os
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[3]


def told(value: Any) -> Any:
    """Return a value as JSON that tells its type: one of another class is an object with the class's name."""
    if value is None or type(value) in {bool, int, float, str}:
        return value
    if type(value) is list:
        return [told(item) for item in value]
    if type(value) is dict:
        return {str(key): told(item) for key, item in value.items()}
    name = type(value).__name__
    if isinstance(value, (bytes, bytearray)):
        return {name: value.hex()}
    if isinstance(value, (tuple, set, frozenset)):
        items = [told(item) for item in value]
        return {name: items if isinstance(value, tuple) else sorted(items, key=repr)}
    if hasattr(value, "tolist"):  # of numpy, or an array
        return {f"{name} {getattr(value, 'typecode', '') or value.dtype}": told(value.tolist())}
    return {name: str(value)}


def main() -> None:
    answers = os.fdopen(os.dup(1), "w", encoding="ascii")
    os.dup2(2, 1)
    sys.path.append(str(ROOT))  # for what kinds share
    spec = importlib.util.spec_from_file_location("kind", sys.argv[1])
    assert spec is not None
    assert spec.loader is not None
    kind = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(kind)
    for line in sys.stdin:
        try:
            answer = told(kind.run(json.loads(line)))
        except Exception as error:  # noqa: BLE001  # its class is the answer
            answer = {"error": type(error).__name__}
            print(f"{type(error).__name__}: {error}", file=sys.stderr)
        print(json.dumps(answer, sort_keys=True), file=answers, flush=True)
    # Without the ends of contexts and nodes, which are no subject here, and whose order is free.
    sys.stderr.flush()
    os._exit(0)


main()
