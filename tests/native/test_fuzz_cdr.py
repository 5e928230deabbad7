"""The fuzzer of the codec, for a short time; its corpus are bytes that a real ROS 2 wrote.

By hand and for longer: `python -m tests.native.test_fuzz_cdr SECONDS`.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from tests.native.test_sanitizers import build

from tfloom.rosidl.message import Message
from tfloom.rosidl.registry import get_message_class
from tfloom.rosidl.type_text import split_type

pytestmark = pytest.mark.slow
GOLDEN = Path(__file__).parents[1] / "golden" / "jazzy_types.jsonl"
KINDS = [
    "bool",
    "byte",
    "int8",
    "uint8",
    "int16",
    "uint16",
    "int32",
    "uint32",
    "int64",
    "uint64",
    "float32",
    "float64",
    "string",
    "wstring",
    "message",
]
SHAPES = ["", "array", "bounded", "unbounded"]


def plan_bytes(cls: type[Message]) -> bytes:
    """Return a class's plan in the format of fuzz_cdr.cpp, nested messages first."""
    order: list[type[Message]] = []

    def visit(each: type[Message]) -> None:
        for text in each._FIELDS.values():
            base = split_type(text)[0]
            if "/" in base:
                visit(get_message_class(base))
        if each not in order:
            order.append(each)

    visit(cls)
    return bytes([len(order) - 1]) + b"".join(
        bytes([len(each._FIELDS)]) + fields(each, order) for each in order
    )


def fields(cls: type[Message], order: list[type[Message]]) -> bytes:
    result = b""
    for text in cls._FIELDS.values():
        base, bound, shape, length = split_type(text)
        kind = KINDS.index("message" if "/" in base else "uint8" if base == "char" else base)
        result += bytes([kind, SHAPES.index(shape), length, min(bound, 255)])
        if "/" in base:
            result += bytes([order.index(get_message_class(base))])
    return result


def write_corpus(folder: Path) -> int:
    """Write a file for each golden sample, and return how many."""
    count = 0
    for golden in map(json.loads, GOLDEN.read_text("utf-8").splitlines()):
        for sample in golden["samples"]:
            plan = plan_bytes(get_message_class(golden["type"]))
            (folder / f"{count:04}.bin").write_bytes(plan + bytes.fromhex(sample["cdr"]))
            count += 1
    return count


def fuzz(folder: Path, seconds: float) -> subprocess.CompletedProcess[str]:
    build(folder / "build", "address,undefined", ["fuzz_cdr"])
    (folder / "corpus").mkdir()
    write_corpus(folder / "corpus")
    program = next(path for path in (folder / "build").rglob("fuzz_cdr") if path.is_file())
    return subprocess.run(
        [program, str(seconds), folder / "corpus"],
        capture_output=True,
        text=True,
        timeout=seconds + 120,
        check=False,
        env={**os.environ, "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1"},
    )


@pytest.mark.skipif(sys.platform == "win32", reason="the sanitizers here are GCC's and Clang's")
def test_fuzzed_bytes_never_break_the_codec(tmp_path: Path) -> None:
    done = fuzz(tmp_path, 3.0)
    assert done.returncode == 0, done.stdout + done.stderr
    counts = re.search(r"(\d+) of (\d+) seeds read; (\d+) inputs, (\d+) read, (\d+) refused", done.stdout)
    assert counts is not None
    read, seeds, _, accepted, refused = map(int, counts.groups())
    assert read == seeds == 970
    assert min(accepted, refused) > 1000


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as home:
        outcome = fuzz(Path(home), float(sys.argv[1]))
        print(outcome.stdout, outcome.stderr)
        sys.exit(outcome.returncode)
