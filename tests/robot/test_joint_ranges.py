"""The ranges of joints, and what depends on what."""

from __future__ import annotations

import math

import pytest
from tests.robot.test_urdf import joint, robot

from tfloom.robot.joint_ranges import JointRange, range_of
from tfloom.robot.mimicry import Dependence, LoopError, resolve
from tfloom.robot.urdf import parse_urdf


def limits(lower: float, upper: float) -> str:
    return f'<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>'


def found(kind: str, inside: str = "", *, zero: float | None = None, soft: bool = True) -> JointRange | None:
    parsed = parse_urdf(robot(joint("j", "a", "b", kind, inside))).joints["j"]
    return range_of(parsed, {} if zero is None else {"j": zero}, use_soft_limits=soft)


def test_ranges() -> None:
    soft = '<safety_controller k_velocity="1" soft_lower_limit="-0.5" soft_upper_limit="9"/>'
    assert found("continuous") == (-math.pi, math.pi, 0.0)
    assert found("continuous", limits(0, 0)) == (-math.pi, math.pi, 0.0)
    assert found("revolute", limits(-1, 2)) == (-1.0, 2.0, 0.0)
    assert found("revolute", limits(-1, 2) + soft) == (-0.5, 2.0, 0.0)
    assert found("revolute", limits(-1, 2) + soft, soft=False) == (-1.0, 2.0, 0.0)
    assert found("prismatic", limits(1, 2)) == (1.0, 2.0, 1.5), "0 is out of range"
    assert found("prismatic", limits(-2, -1)) == (-2.0, -1.0, -1.5)
    assert found("prismatic", limits(1, 2), zero=1.25) == (1.0, 2.0, 1.25)
    assert [found(kind) for kind in ("fixed", "planar", "floating")] == [None] * 3


def test_dependences_by_way_of_others() -> None:
    given = {"a": Dependence("b", 2.0, 1.0), "b": Dependence("c", 3.0, 0.5), "d": Dependence("a")}
    assert resolve(given) == {
        "a": Dependence("c", 6.0, 2.0),
        "b": Dependence("c", 3.0, 0.5),
        "d": Dependence("c", 6.0, 2.0),
    }


def test_loops_are_named() -> None:
    with pytest.raises(LoopError, match=r"Found an infinite recursive mimic chain: \['b', 'c', 'b'\]"):
        resolve({"a": Dependence("b"), "b": Dependence("c"), "c": Dependence("b")})


def test_a_long_chain_takes_time_in_proportion() -> None:
    count = 20_000
    resolved = resolve({str(i): Dependence(str(i + 1), 1.0, 1.0) for i in range(count)})
    assert resolved["0"] == Dependence(str(count), 1.0, float(count))
