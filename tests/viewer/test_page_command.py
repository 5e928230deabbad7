"""What a page asks for is checked."""

from __future__ import annotations

from typing import Any

import pytest

from tfloom.viewer.page_command import MAX_TEXT, MAX_TEXTS, PageError, flag, number, stamp, text, texts


def test_values_that_are_right() -> None:
    assert text({"a": "<b>"}, "a") == "<b>"
    assert number({"a": 3}, "a") == 3.0
    assert flag({"a": False}, "a") is False
    assert stamp({"a": "1700000000000000001"}, "a") == 1_700_000_000_000_000_001
    assert stamp({"a": None}, "a") is None
    assert texts({"a": ["b", ""]}, "a") == ["b", ""]


@pytest.mark.parametrize(
    ("read", "value"),
    [
        (text, None),
        (text, 3),
        (text, "x" * (MAX_TEXT + 1)),
        (text, ["a"]),
        (number, "3"),
        (number, True),
        (number, float("nan")),
        (number, float("inf")),
        (number, None),
        (number, 10**400),
        (number, -(10**400)),
        (text, "\ud800"),
        (text, "a\udfff"),
        (texts, ["a", "\ud800"]),
        (flag, 1),
        (flag, "true"),
        (stamp, 5),
        (stamp, "-5"),
        (stamp, "²"),
        (stamp, "9" * 20),
        (texts, "ab"),
        (texts, ["a", 1]),
        (texts, ["a"] * (MAX_TEXTS + 1)),
        (stamp, ""),
    ],
)
def test_values_that_are_wrong(read: Any, value: object) -> None:
    with pytest.raises(PageError, match="has to be"):
        read({"a": value}, "a")
