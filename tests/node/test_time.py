"""Times and durations."""

from __future__ import annotations

import operator

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tfloom.interfaces.builtin_interfaces import msg as builtin_msg
from tfloom.node.values.duration import Duration, Infinite
from tfloom.node.values.time import ClockType, Time

STAMPS = st.integers(0, 2**31 * 10**9 - 1)
SPANS = st.integers(-(2**31) * 10**9, 2**31 * 10**9 - 1)


@settings(deadline=None)
@given(STAMPS)
def test_time_survives_conversion_to_a_message(stamp_ns: int) -> None:
    time = Time(nanoseconds=stamp_ns, clock_type=ClockType.ROS_TIME)
    assert Time.from_msg(time.to_msg()) == time


@settings(deadline=None)
@given(SPANS)
def test_duration_survives_conversion_to_a_message(span_ns: int) -> None:
    duration = Duration(nanoseconds=span_ns)
    assert Duration.from_msg(duration.to_msg()) == duration
    assert 0 <= duration.to_msg().nanosec < 10**9


@settings(deadline=None)
@given(STAMPS, SPANS)
def test_subtraction_undoes_addition(stamp_ns: int, span_ns: int) -> None:
    time = Time(nanoseconds=stamp_ns + 2**31 * 10**9)
    later = time + Duration(nanoseconds=span_ns)
    assert later - time == Duration(nanoseconds=span_ns)
    assert later - Duration(nanoseconds=span_ns) == time


def test_seconds_and_nanoseconds_add_up() -> None:
    assert Time(seconds=1.5, nanoseconds=2).nanoseconds == 1_500_000_002
    assert Time(seconds=3, nanoseconds=7).seconds_nanoseconds() == (3, 7)
    assert Duration(seconds=-0.5).nanoseconds == -500_000_000


def test_values_beyond_64_bits_raise() -> None:
    with pytest.raises(OverflowError):
        Time(nanoseconds=2**63)
    with pytest.raises(OverflowError):
        Duration(nanoseconds=2**63)
    with pytest.raises(OverflowError):
        Time(nanoseconds=2**63 - 1) + Duration(nanoseconds=1)
    with pytest.raises(ValueError, match="negative time"):
        Time() - Duration(seconds=1)


def test_times_of_different_clocks_are_incompatible() -> None:
    system, steady = Time(), Time(clock_type=ClockType.STEADY_TIME)
    with pytest.raises(TypeError, match=r"^Can't subtract times with different clock types$"):
        system - steady
    for compare in (operator.eq, operator.ne, operator.lt, operator.ge):
        with pytest.raises(TypeError, match=r"^Can't compare times with different clock types$"):
            compare(system, steady)


@pytest.mark.parametrize(
    ("left", "right"),
    [(Time(), 0), (Time(), None), (Time(), Duration()), (Duration(), Time()), (Duration(), 0)],
)
def test_other_types_are_unequal_and_have_no_order(left: object, right: object) -> None:
    assert not left == right  # noqa: SIM201  # the operator itself
    assert left != right
    assert [left] != [right]
    for symbol, compare in (("<", operator.lt), ("<=", operator.le), (">", operator.gt), (">=", operator.ge)):
        names = f"'{type(left).__name__}' and '{type(right).__name__}'"
        with pytest.raises(TypeError, match=f"^'{symbol}' not supported between instances of {names}$"):
            compare(left, right)


def test_reprs_and_strings() -> None:
    assert repr(Time(nanoseconds=5)) == "Time(nanoseconds=5, clock_type=SYSTEM_TIME)"
    assert repr(Duration(nanoseconds=-1000000000)) == "Duration(nanoseconds=-1000000000)"
    assert str(Infinite) == "Infinite"
    assert str(Duration(nanoseconds=3)) == "3 nanoseconds"


def test_from_msg_accepts_messages_only() -> None:
    with pytest.raises(TypeError, match="Must pass a builtin_interfaces"):
        Time.from_msg(builtin_msg.Duration())  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="Must pass a builtin_interfaces"):
        Duration.from_msg(builtin_msg.Time())  # type: ignore[arg-type]
