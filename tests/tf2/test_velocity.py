"""lookupVelocity as recorded, and a twist that is one."""

from __future__ import annotations

import gzip
import json
import math
from typing import Any

import pytest
from tests.tf2.replay import GOLDEN

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import TransformException

SECOND = 1_000_000_000
with gzip.open(GOLDEN / "tf2_velocity.json.gz", "rt") as text:
    RUNS = json.load(text)


@pytest.mark.parametrize("run", RUNS, ids=range(len(RUNS)))
def test_lookup_velocity_is_the_recorded_one(run: dict[str, Any]) -> None:
    buffer = Buffer()
    for frame, child, stamp, xyz, xyzw, *is_static in run["sets"]:
        assert buffer.set(frame, child, stamp, xyz, xyzw, static=bool(is_static))
    assert run["queries"]
    for query in run["queries"]:
        asked = {key: value for key, value in query.items() if key not in ("ok", "raises", "text")}
        if "raises" in query:
            with pytest.raises(TransformException) as raised:
                buffer.lookup_velocity(**asked)
            assert query["raises"] in [kind.__name__ for kind in type(raised.value).__mro__]
            assert str(raised.value) == query["text"]
            continue
        for ours, theirs in zip(buffer.lookup_velocity(**asked), query["ok"], strict=True):
            assert ours == pytest.approx(theirs, rel=1e-7, abs=1e-7)


@pytest.fixture
def circling() -> Buffer:
    """A body on a circle of 2 m at 0.5 rad/s, looking ahead; a sensor 1 m before it."""
    buffer = Buffer(None)
    for step in range(1001):
        angle = 0.5 * step * 0.01
        stamp = 100 * SECOND + step * SECOND // 100
        position = 2 * math.cos(angle), 2 * math.sin(angle), 0.0
        heading = angle + math.pi / 2
        buffer.set("world", "body", stamp, position, (0, 0, math.sin(heading / 2), math.cos(heading / 2)))
    buffer.set("body", "sensor", 0, (1, 0, 0), (0, 0, 0, 1), static=True)
    return buffer


def test_a_twist_in_the_fixed_and_in_the_bodys_axes(circling: Buffer) -> None:
    stamp = 104 * SECOND
    linear, angular = circling.velocity("body", "world", stamp)
    assert linear == pytest.approx((-math.sin(2.0), math.cos(2.0), 0), abs=1e-3)
    assert angular == pytest.approx((0, 0, 0.5), abs=1e-9)
    linear, _ = circling.velocity("body", "world", stamp, axes_frame="body")
    assert linear == pytest.approx((1, 0, 0), abs=1e-3)
    linear, _ = circling.velocity("sensor", "world", stamp, axes_frame="sensor")
    assert linear == pytest.approx((1, 0.5, 0), abs=1e-3)


def test_at_the_latest_time_and_of_what_is_static(circling: Buffer) -> None:
    assert circling.velocity("body", "world").angular == pytest.approx((0, 0, 0.5), abs=1e-9)
    assert circling.velocity("sensor", "body") == ((0, 0, 0), (0, 0, 0))
    with pytest.raises(ValueError, match="interval_ns must be positive"):
        circling.velocity("body", "world", interval_ns=0)
