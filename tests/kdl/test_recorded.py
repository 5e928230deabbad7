"""PyKDL's answers, recorded by `tests/oracles/record_pykdl.py` beside Orocos' PyKDL 1.5.1, and ours."""

from __future__ import annotations

import gzip
import json
import math
from pathlib import Path

import pytest
from tests.oracles.record_pykdl import answer_to

GOLDEN = Path(__file__).parents[1] / "golden" / "pykdl.jsonl.gz"
LINES = [json.loads(line) for line in gzip.decompress(GOLDEN.read_bytes()).splitlines()]
TOLERANCE = 1e-12


def differs(line: dict[str, object]) -> str:
    """Return what differs in the answer to a line's expression; empty, if nothing does."""
    wanted, found = {**line}, answer_to(str(line["expression"]))
    del wanted["expression"]
    numbers, ours = wanted.pop("numbers", []), found.pop("numbers", [])
    near = len(numbers) == len(ours) and all(
        math.isclose(a, b, rel_tol=TOLERANCE, abs_tol=TOLERANCE) or (math.isnan(a) and math.isnan(b))
        for a, b in zip(numbers, ours, strict=True)
    )
    return (
        "" if near and wanted == found else f"{line['expression']}: {wanted} {numbers}, ours {found} {ours}"
    )


def test_answers_equal_the_recorded_ones() -> None:
    assert len(LINES) > 1500
    differences = [difference for line in LINES if (difference := differs(line))]
    assert not differences, "\n".join(differences)


@pytest.mark.parametrize(
    "wrong",
    [
        {"expression": "Vector(1,2,3)", "kind": "Vector", "numbers": [1, 2, 3 + 4e-12]},
        {"expression": "Vector(1,2,3)", "kind": "Twist", "numbers": [1, 2, 3]},
        {"expression": "Vector()[3]", "error": "IndexError", "says": "Twist index out of range"},
    ],
    ids=["number", "kind", "error"],
)
def test_a_wrong_answer_is_detected(wrong: dict[str, object]) -> None:
    """Check the instrument itself."""
    assert differs(wrong)
