"""The cases of each kind, answered by tfloom as by the real rclpy; and that a difference would be found."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from tools.ros_peer import JAZZY, RELEASES, RosPeer

from .compare import KINDS, compare, load_kind, unknown_rows

pytestmark = pytest.mark.ros

PURE_COUNT = 2000
WIRE_COUNT = 100
PLANTED = """
import os
import time

import rclpy

IS_PEER = not rclpy.__file__.endswith("ros_names/rclpy/__init__.py")
SECONDS = 5.0
CASES = ["equal", "ended", "equal", "stalled", "type", "nan", "class", "bytes", "row"]
KNOWN = {"tf2-static-replace": lambda case, theirs, ours: case == "row"}
remaining = iter(CASES)


def draw(random):
    return next(remaining)


def run(case):
    if case == "ended" and not IS_PEER:
        os._exit(7)
    if case == "stalled" and not IS_PEER:
        time.sleep(60)
    if case == "class":
        raise KeyError if IS_PEER else ValueError
    print("this is no answer")
    return {
        "equal": 1,
        "type": 1 if IS_PEER else 1.0,
        "nan": [float("nan"), (1, True)],
        "bytes": b"1" if IS_PEER else "1",
        "row": IS_PEER,
    }.get(case)
"""


def beside() -> Iterator[Any]:
    """Yield each kind and each release that it is compared with; those of many cases are slow."""
    for name in KINDS:
        kind = load_kind(name)
        for release in getattr(kind, "RELEASES", (JAZZY.name,)):
            marks = () if hasattr(kind, "RELEASES") else pytest.mark.slow
            yield pytest.param(kind, RELEASES[release], marks=marks, id=f"{name}-{release}")


@pytest.mark.parametrize(("kind", "peer"), list(beside()), indirect=["peer"])
def test_cases_are_answered_as_there(kind: ModuleType, peer: RosPeer, domain_id: int) -> None:
    assert unknown_rows(kind) == []
    count = WIRE_COUNT if hasattr(kind, "WIRE") else PURE_COUNT
    count = len(kind.EVERY) if hasattr(kind, "EVERY") else count
    differences = compare(kind, peer, count=count, seed=0, domain=domain_id)
    assert [difference for difference in differences if difference.row is None] == []


def planted_kind(folder: Path) -> ModuleType:
    path = folder / "planted.py"
    path.write_text(PLANTED, "utf-8")
    spec = importlib.util.spec_from_file_location("planted", path)
    assert spec is not None
    assert spec.loader is not None
    kind = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(kind)
    return kind


@pytest.mark.slow
def test_each_planted_difference_is_found(peer: RosPeer, domain_id: int, tmp_path: Path) -> None:
    kind = planted_kind(tmp_path)
    differences = compare(kind, peer, count=len(kind.CASES), seed=0, domain=domain_id)
    found = {difference.case: (difference.theirs, difference.ours) for difference in differences}
    assert found == {
        "ended": (None, {"ended": 7}),
        "stalled": (None, {"stalled": True}),
        "type": (1, 1.0),
        "class": ({"error": "KeyError"}, {"error": "ValueError"}),
        "bytes": ({"bytes": "31"}, "1"),
        "row": (True, False),
    }
    assert [difference.row for difference in differences] == [None] * 5 + ["tf2-static-replace"]


def test_a_row_that_is_not_on_the_page_is_named(tmp_path: Path) -> None:
    kind = planted_kind(tmp_path)
    kind.KNOWN = {"tf2-static-replace": None, "no-such-row": None}
    assert unknown_rows(kind) == ["no-such-row"]
