"""Run cases with one form of the extension: `worker.py EXTENSION`.

A line on stdin is `answer CASE`, `time CASE` or `drop CASE`; its result is a line of JSON on stdout.
"""

from __future__ import annotations

import importlib.util
import json
import sys
from time import process_time_ns
from typing import Any


def load(path: str) -> None:
    """Import the extension from `path`, before another module imports the installed one."""
    spec = importlib.util.spec_from_file_location("tfloom._native", path)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)


def seconds(case: Any) -> float:
    """Return the CPU time of one operation [s]."""
    begin_ns = process_time_ns()
    result = case.call()
    took = result if isinstance(result, float) else (process_time_ns() - begin_ns) / 1e9
    return float(took / case.count)


def main() -> None:
    load(sys.argv[1])
    from benchmarks.native.cases import CASES

    cases: dict[str, Any] = {}
    for line in sys.stdin:
        what, name = line.rstrip("\n").split(" ", 1)
        if what == "drop":
            del cases[name]
            print("null", flush=True)
            continue
        case = cases.get(name) or cases.setdefault(name, CASES[name]())
        print(json.dumps(case.answer() if what == "answer" else seconds(case)), flush=True)


if __name__ == "__main__":
    main()
