"""The fuzzers of native code, with some ten thousand inputs each.

`fuzz_cdr` decodes plans of every kind of field; its corpus are bytes that a real ROS 2 wrote. `fuzz_tf` pushes bytes of
/tf into a buffer, `fuzz_bag` reads records of recordings into one, `fuzz_joints` converts the states of joints, and
`fuzz_frozen` maps frozen buffers; their corpora are in `corpus/`. `fuzz_rtps` reads and
rewrites datagrams of services, after some with known answers; it has its corpus itself.

By hand and for longer: `python -m tests.native.test_fuzz NAME AMOUNT [SEED]`; the amount is in seconds, or a number of
inputs with an `n`: `python -m tests.native.test_fuzz fuzz_cdr 1000000n`.
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
from tests.conftest import run_to_end
from tests.native.sanitizers import build_programs
from tests.shared_folders import shared_folder

from tfloom.rosidl.message import Message
from tfloom.rosidl.registry import get_message_class
from tfloom.rosidl.type_text import split_type

pytestmark = pytest.mark.slow
GOLDEN = Path(__file__).parents[1] / "golden" / "jazzy_types.jsonl"
CORPUS = Path(__file__).parent / "corpus"
MAX_DURATION_S = 7200.0
SANITIZE = "address,undefined"
SEEDS = {
    "fuzz_bag": (5, 5),
    "fuzz_cdr": (970, 970),
    "fuzz_frozen": (3, 4),
    "fuzz_joints": (4, 4),
    "fuzz_rtps": (3, 8),
    "fuzz_tf": (7, 7),
}
"""How many inputs of each corpus are accepted, of how many, with the one in the program."""
INPUTS = {
    "fuzz_bag": 50_000,
    "fuzz_cdr": 40_000,
    "fuzz_frozen": 20_000,
    "fuzz_joints": 100_000,
    "fuzz_rtps": 100_000,
    "fuzz_tf": 50_000,
}
"""How many inputs each program tries: some seconds' worth."""
SEED = "20261122"
"""The same in each run, so that a run says something of the change that it tests; by hand, take others."""
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

    def visit(message_class: type[Message]) -> None:
        for text in message_class._FIELDS.values():
            base = split_type(text)[0]
            if "/" in base:
                visit(get_message_class(base))
        if message_class not in order:
            order.append(message_class)

    visit(cls)
    return bytes([len(order) - 1]) + b"".join(
        bytes([len(message_class._FIELDS)]) + fields(message_class, order) for message_class in order
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


def corpus_of(name: str, folder: Path) -> Path:
    if name == "fuzz_rtps":
        (folder / "none").mkdir()
        return folder / "none"
    if name != "fuzz_cdr":
        return CORPUS / name.removeprefix("fuzz_")
    written = folder / "corpus"
    written.mkdir()
    write_corpus(written)
    return written


def run(program: Path, folder: Path, amount: str, *seed: str) -> subprocess.CompletedProcess[str]:
    return run_to_end(
        [program, amount, corpus_of(program.name, folder), *seed],
        env={**os.environ, "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1"},
        timeout_s=MAX_DURATION_S,
    )


@pytest.mark.skipif(sys.platform == "win32", reason="the sanitizers here are GCC's and Clang's")
def test_fuzzed_bytes_break_nothing(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    with shared_folder(tmp_path_factory, SANITIZE) as folder:
        programs = build_programs(folder, SANITIZE, list(SEEDS))
    for program in programs:
        name, expected = program.name, SEEDS[program.name]
        done = run(program, tmp_path, f"{INPUTS[name]}n", SEED)
        assert done.returncode == 0, done.stdout + done.stderr
        counts = re.search(r"(\d+) of (\d+) seeds read; (\d+) inputs, (\d+) read, (\d+) refused", done.stdout)
        assert counts is not None
        read, seeds, _, accepted, refused = map(int, counts.groups())
        assert (read, seeds) == expected, name
        assert min(accepted, refused) > 1000, name


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as home:
        (fuzzer,) = build_programs(Path(home) / "build", SANITIZE, [sys.argv[1]])
        outcome = run(fuzzer, Path(home), *sys.argv[2:4])
        print(outcome.stdout, outcome.stderr)
        sys.exit(outcome.returncode)
