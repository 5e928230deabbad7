"""The drawing of a round trip's budget."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest
from benchmarks.node.budget import (
    BAR_PX,
    COLOURS,
    DIGIT_PX,
    LEFT_PX,
    PARTS,
    THICK_PX,
    WIDTH_PX,
    Budget,
    drawing,
)

SVG = "{http://www.w3.org/2000/svg}"
ASKING = {"kernel": 40.0, "libddsc": 10.0, "tfloom's C++": 20.0, "Python": 30.0}


def drawn(trip_us: float) -> ET.Element:
    """Return a drawing of two processes, of which the second needs 5 µs for each part."""
    return ET.fromstring(drawing({"a trip": Budget(trip_us, ASKING, dict.fromkeys(PARTS, 5.0))}))


def bars(svg: ET.Element) -> list[ET.Element]:
    return [box for box in svg.iter(f"{SVG}rect") if box.get("height") == str(THICK_PX)]


def test_bars_are_as_long_as_their_times() -> None:
    found = bars(drawn(50.0))
    assert [float(bar.get("width", 0)) for bar in found[:4]] == [
        BAR_PX * part / 100 for part in (40, 10, 20, 30)
    ]
    assert [bar.get("fill") for bar in found[:4]] == list(COLOURS.values())
    assert sum(float(bar.get("width", 0)) for bar in found[4:]) == BAR_PX * 20 / 100
    assert set(COLOURS) == set(PARTS)


@pytest.mark.parametrize("trip_us", [12.0, 20.0, 45.0, 60.0, 85.0, 100.0, 130.0])
def test_no_digits_are_on_the_line_of_the_clock_or_outside_of_their_part(trip_us: float) -> None:
    svg = drawn(trip_us)
    clock = LEFT_PX + BAR_PX * trip_us / max(trip_us, 100.0)
    assert f"{trip_us:.0f} µs" in [element.text for element in svg.iter(f"{SVG}text")]
    parts = bars(svg)
    found = 0
    for label in svg.iter(f"{SVG}text"):
        digits, middle = label.text or "", float(label.get("x", 0))
        half = DIGIT_PX * len(digits) / 2
        for part in parts:
            below = float(label.get("y", 0)) - float(part.get("y", 0))
            begin = float(part.get("x", 0))
            if 0 < below < THICK_PX and begin <= middle <= begin + float(part.get("width", 0)):
                found += 1
                assert abs(middle - clock) > half
                assert begin <= middle - half
                assert middle + half <= begin + float(part.get("width", 0))
    assert found >= 6  # the four of the asking process, and of the other one what has room


def test_all_is_inside_of_the_picture() -> None:
    svg = drawn(130.0)
    for element in svg.iter():
        assert all(0 <= float(element.get(name, 0)) <= WIDTH_PX for name in ("x", "x1", "x2"))
