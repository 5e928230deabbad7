"""Numeric arguments: their bounds, and the errors beyond."""

from __future__ import annotations

import argparse
from collections.abc import Callable

import pytest

from tfloom.cli.shared import numbers


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        (numbers.positive, "1e-3", 0.001),
        (numbers.size, "0", 0),
        (numbers.size, str(2**63 - 1), 2**63 - 1),
        (numbers.count, str(2**31 - 1), 2**31 - 1),
        (numbers.seconds, "1e300", numbers.FOREVER_S),
    ],
)
def test_number_within_its_bounds(kind: Callable[[str], float], text: str, value: float) -> None:
    assert kind(text) == value


@pytest.mark.parametrize(
    ("kind", "texts"),
    [
        (numbers.positive, ["0", "-1", "nan", "inf", "x"]),
        (numbers.size, ["-1", str(2**63), "1.5", "x"]),
        (numbers.count, ["-1", str(2**31), "x"]),
        (numbers.seconds, ["-1", "nan", "x"]),
    ],
)
def test_number_beyond_its_bounds_is_named(kind: Callable[[str], float], texts: list[str]) -> None:
    for text in texts:
        with pytest.raises(argparse.ArgumentTypeError, match=rf"^must be a .*, not '{text}'$"):
            kind(text)
