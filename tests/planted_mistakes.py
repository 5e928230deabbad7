"""Plant single mistakes, drawn from a seed, and print which ones no test finds.

`python -m tests.planted_mistakes --seed 1 viewer`: a mistake drops a statement or a call, negates a condition, or moves
a bound by one. It is written into the checkout, the tests of its room run until the first failure, and the file is
restored. What survives is either a missing test or a line that changes nothing.

Each room has the same number of mistakes, so that a small one is not lost beside a large one; within a room, files are
drawn by their number of places.
"""

from __future__ import annotations

import argparse
import ast
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
MAX_TESTS_S = 900
"""Time for the tests of one mistake [s]; tests that hang have found it."""


class Room(NamedTuple):
    """Code that mistakes are planted in, and what may find them."""

    files: tuple[str, ...]
    tests: tuple[str, ...]
    """Arguments of pytest: the quickest first."""


ROOMS = {
    "viewer": Room(
        ("src/tfloom/viewer/*.py", "src/tfloom/viewer/*/*.py"),
        ("tests/viewer",),
    ),
    "driving": Room(
        ("src/tfloom/viewer/driving/*.py",), ("tests/viewer/test_driver.py", "tests/viewer/test_driving.py")
    ),
    "foxglove_bridge": Room(("src/tfloom/foxglove/*.py",), ("tests/foxglove",)),
    "zenoh": Room(("src/tfloom/rmw/zenoh/*.py",), ("tests/rmw", "tests/node/wire")),
    "services": Room(
        (
            "src/tfloom/rmw/**/*services.py",
            "src/tfloom/node/endpoints/client.py",
            "src/tfloom/node/endpoints/service.py",
        ),
        (
            *(
                "tests/rmw/test_services.py",
                "tests/rmw/test_service_request.py",
                "tests/node/test_service.py",
            ),
            *("tests/node/wire", "tests/rmw"),
        ),
    ),
    "node": Room(
        ("src/tfloom/node/base/*.py", "src/tfloom/node/executing/*.py", "src/tfloom/node/*.py"),
        ("tests/node",),
    ),
    "native_dds": Room(
        ("native/dds/*.cpp", "native/bindings/dds.cpp"),
        ("tests/rmw", "tests/node/wire", "tests/ros_peer/test_services.py"),
    ),
    "ddsc": Room(
        ("packages/tfloom-ddsc/build_backend.py",),
        ("tests/tools/test_ddsc_package.py", "tests/rmw/test_cyclone_library.py"),
    ),
}


class Mistake(NamedTuple):
    """A change of one place of a file."""

    path: Path
    line: int
    kind: str
    start: int
    """Offset of the first character that is replaced."""
    end: int
    text: str

    def __str__(self) -> str:
        """Return the place, the kind, and the text before and after."""
        source = self.path.read_text(encoding="utf-8")
        before = " ".join(source[self.start : self.end].split())
        return f"{self.path.relative_to(ROOT)}:{self.line}: {self.kind}: {before[:70]} -> {self.text[:70]}"


def main() -> int:
    """Plant the mistakes; return 1 if one survives."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rooms", nargs="*", choices=[[], *ROOMS], help="rooms to plant in; without: all")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, default=9, help="mistakes for each room")
    parser.add_argument("--list", action="store_true", help="only print what would be planted")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # the file is restored
    survivors = 0
    for room in options.rooms or ROOMS:
        for mistake in draw(room, options.seed, options.count):
            if options.list:
                print(f"{room}: {mistake}", flush=True)
                continue
            described = str(mistake)
            started = time.monotonic()
            answer = answer_of_tests(mistake, ROOMS[room].tests)
            survivors += answer == "survived"
            print(f"{answer} ({time.monotonic() - started:.0f} s): {room}: {described}", flush=True)
    return bool(survivors)


def draw(room: str, seed: int, count: int) -> list[Mistake]:
    """Return mistakes of a room: first the kind is drawn, then the place, because some kinds have few places."""
    paths = sorted({path for pattern in ROOMS[room].files for path in ROOT.glob(pattern)})
    by_kind: dict[str, list[Mistake]] = {}
    for path in paths:
        for mistake in python_mistakes(path) if path.suffix == ".py" else native_mistakes(path):
            by_kind.setdefault(mistake.kind, []).append(mistake)
    numbers = random.Random(f"{seed} {room}")
    drawn: dict[Mistake, None] = {}
    while len(drawn) < count:
        drawn[numbers.choice(by_kind[numbers.choice(sorted(by_kind))])] = None
    return list(drawn)


def python_mistakes(path: Path) -> Iterator[Mistake]:
    """Yield each mistake that the functions of a Python file can have."""
    source = path.read_text(encoding="utf-8")
    starts = [0]
    for line in source.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    for function in ast.walk(ast.parse(source)):
        if not isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        for statement in function.body:
            for node in ast.walk(statement):
                for part, kind, text in changes(node, source):
                    end_line, end_column = part.end_lineno or 0, part.end_col_offset or 0
                    start = starts[part.lineno - 1] + characters(source, starts, part.lineno, part.col_offset)
                    end = starts[end_line - 1] + characters(source, starts, end_line, end_column)
                    yield Mistake(path, part.lineno, kind, start, end, text)


def changes(node: ast.AST, source: str) -> Iterator[tuple[ast.expr | ast.stmt, str, str]]:
    """Yield the parts of a node that can be wrong, with the kind of the mistake and its text."""
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        yield node, "drop a call", "pass"
    elif isinstance(node, ast.Assign | ast.AugAssign):
        target = node.targets[0] if isinstance(node, ast.Assign) else node.target
        # A name that is not assigned is an error by itself, which any test would find.
        if isinstance(target, ast.Attribute | ast.Subscript):
            yield node, "drop a statement", "pass"
    elif isinstance(node, ast.If | ast.While | ast.IfExp) and not isinstance(node.test, ast.Constant):
        yield node.test, "negate a condition", f"not ({ast.get_source_segment(source, node.test)})"
    elif isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in TURNED:
        left = ast.get_source_segment(source, node.left)
        right = ast.get_source_segment(source, node.comparators[0])
        yield node, "off by one", f"({left} {TURNED[type(node.ops[0])]} {right})"
    elif isinstance(node, ast.Constant) and type(node.value) is int:
        yield node, "off by one", str(node.value + 1)


TURNED: dict[type[ast.cmpop], str] = {ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">"}


def characters(source: str, starts: list[int], line: int, octets: int) -> int:
    """Return the number of characters in the first `octets` bytes of a line (ast counts bytes of UTF-8)."""
    return len(source[starts[line - 1] : starts[line]].encode()[:octets].decode())


STATEMENT = re.compile(
    r"^[ \t]+(?!return\b|throw\b|using\b|const\b|auto\b|static\b|case\b|break\b|continue\b|goto\b)"
    r"([\w:>.\-\[\]*]+(?:\(.*\)| [-+|&]?= .*));$",
    re.MULTILINE,
)
CONDITION = re.compile(r"\b(?:if|while) \(((?:[^(){};=]|\([^(){};]*\))+)\) ")
BOUND = re.compile(r"(?<=\w) (<|>|<=|>=) (?=\w)")


def native_mistakes(path: Path) -> Iterator[Mistake]:
    """Yield mistakes that a C++ file can have, where one line shows them."""
    source = path.read_text(encoding="utf-8")
    body = source.index("namespace")

    def line_of(offset: int) -> int:
        return source.count("\n", 0, offset) + 1

    for found in STATEMENT.finditer(source, body):
        kind = "drop a statement" if "= " in found[1] else "drop a call"
        yield Mistake(path, line_of(found.start(1)), kind, found.start(1), found.end(1), "")
    for found in CONDITION.finditer(source, body):
        yield Mistake(
            path, line_of(found.start()), "negate a condition", found.start(1), found.end(1), f"!({found[1]})"
        )
    for found in BOUND.finditer(source, body):
        turned = found[1][0] if found[1].endswith("=") else found[1] + "="
        yield Mistake(path, line_of(found.start()), "off by one", found.start(1), found.end(1), turned)


def answer_of_tests(mistake: Mistake, tests: tuple[str, ...]) -> str:
    """Return which test found a mistake, if one did; the mistake stands in its file only while they run."""
    source = mistake.path.read_text(encoding="utf-8")
    try:
        mistake.path.write_text(
            source[: mistake.start] + mistake.text + source[mistake.end :], encoding="utf-8"
        )
        if mistake.path.suffix == ".cpp" and compiled() != 0:
            return "not compiled"
        options = ("-x", "-q", "-n", "3", "--dist", "loadfile", "-p", "no:cacheprovider")
        command = [sys.executable, "-m", "pytest", *options, "-m", "not slow", *tests]
        with (
            tempfile.TemporaryFile("w+") as output,
            subprocess.Popen(
                command, cwd=ROOT, stdout=output, stderr=subprocess.DEVNULL, start_new_session=True
            ) as process,
        ):
            try:
                if process.wait(MAX_TESTS_S) == 0:
                    return "survived"
            except subprocess.TimeoutExpired:
                return "found: tests hang"
            finally:
                if process.poll() is None:
                    os.killpg(process.pid, signal.SIGKILL)
            output.seek(0)
            finders = re.findall(r"^(?:FAILED|ERROR) (\S+)", output.read(), re.MULTILINE)
            return f"found by {finders[0]}" if finders else "found"
    finally:
        mistake.path.write_text(source, encoding="utf-8")
        if mistake.path.suffix == ".cpp":
            compiled()


def compiled() -> int:
    """Compile the core of the checkout; return the exit code."""
    return subprocess.run(["make", "setup"], cwd=ROOT, capture_output=True, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
