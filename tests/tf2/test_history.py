"""One frame's history: order, duplicates, ends, changes of parent, and interpolation."""

from __future__ import annotations

import math
import random

import pytest

from tfloom.tf2 import errors
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.transform import Transform

SECOND = 1_000_000_000
HERE = (0.0, 0.0, 0.0)
UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def put(buffer: Buffer, *rows: tuple[int, int]) -> None:
    """Store samples of (stamp, x)."""
    for stamp, x in rows:
        assert buffer.set("a", "b", stamp, (x, 0, 0), UPRIGHT)


def held(buffer: Buffer) -> list[tuple[int, int]]:
    """Return the stored samples, newest first."""
    samples = buffer.to_arrays("a", "b")
    return list(
        zip(samples.stamps_ns[::-1].tolist(), samples.positions[::-1, 0].astype(int).tolist(), strict=True)
    )


FIRST = [(0, 0), (10, 1), (5, 2), (3, 3), (8, 4), (8, 5), (8, 6)]


def test_samples_are_ordered_by_stamp_then_arrival() -> None:
    buffer = Buffer(10)
    put(buffer, *FIRST)
    assert held(buffer) == [(10, 1), (8, 6), (8, 5), (8, 4), (5, 2), (3, 3), (0, 0)]
    put(buffer, *reversed(FIRST))  # all samples again
    assert held(buffer) == [(10, 1), (8, 6), (8, 5), (8, 4), (5, 2), (3, 3), (0, 0)]
    put(buffer, (15, 7))
    assert not buffer.set("a", "b", 0, (8, 0, 0), UPRIGHT)  # more than 10 older than the newest
    put(buffer, (5, 9))  # just 10
    assert held(buffer) == [(15, 7), (10, 1), (8, 6), (8, 5), (8, 4), (5, 9), (5, 2)]


@pytest.mark.parametrize("stamps", [range(1, 101), range(100, 0, -1)])
def test_each_sample_is_found_at_its_stamp(stamps: range) -> None:
    buffer = Buffer()
    put(buffer, *((stamp, stamp) for stamp in stamps))
    assert [buffer.lookup("a", "b", stamp).translation[0] for stamp in range(1, 101)] == list(range(1, 101))
    assert buffer.lookup("a", "b").stamp_ns == 100


def test_repeated_sample_is_stored_once() -> None:
    buffer = Buffer()
    put(buffer, *[(7, 1)] * 99)
    assert held(buffer) == [(7, 1)]


def test_interpolation_uses_the_outermost_of_equal_stamps() -> None:
    buffer = Buffer()
    put(buffer, (1, 0), (1, 1), (5, 2), (5, 3), (3, 4), (3, 5))
    assert [buffer.lookup("a", "b", stamp).translation[0] for stamp in (1, 2, 3, 4, 5)] == [0, 2.5, 5, 3.5, 3]


def test_positions_are_interpolated_linearly() -> None:
    source = random.Random(2)
    buffer = Buffer()
    ends = [[source.uniform(-10, 10) for _ in range(3)] for _ in range(2)]
    for stamp, end in zip((100, 200), ends, strict=True):
        buffer.set("a", "b", stamp, end, UPRIGHT)
    for step in range(101):
        expected = [start + (end - start) * step / 100 for start, end in zip(*ends, strict=True)]
        assert buffer.lookup("a", "b", 100 + step).translation == pytest.approx(expected, abs=1e-12)


def test_rotations_are_interpolated_on_the_arc() -> None:
    source = random.Random(3)
    for _ in range(20):
        turns = [Transform.from_rpy(*(source.uniform(-1.5, 1.5) for _ in range(3))) for _ in range(2)]
        buffer = Buffer()
        for stamp, turn in zip((100, 200), turns, strict=True):
            buffer.set("a", "b", stamp, HERE, turn.rotation_xyzw)
        axis, angle = (turns[0].inverse() @ turns[1]).axis_angle
        for step in range(0, 101, 10):
            transform = buffer.lookup("a", "b", 100 + step).transform
            expected = turns[0] @ Transform.from_axis_angle(axis, angle * step / 100)
            assert (transform.inverse() @ expected).axis_angle[1] < 1e-7


def test_half_turns_and_tiny_angles_are_interpolated() -> None:
    buffer = Buffer()
    buffer.set("a", "b", 100, HERE, UPRIGHT)
    buffer.set("a", "b", 200, HERE, (0, 0, 1, 0))
    assert abs(buffer.lookup("a", "b", 150).transform.axis_angle[1]) == pytest.approx(math.pi / 2)
    fine = Buffer()
    fine.set("a", "b", 100, HERE, UPRIGHT)
    fine.set("a", "b", 200, HERE, (0, 0, 1e-9, 1))
    assert fine.lookup("a", "b", 150).transform.axis_angle[1] == pytest.approx(1e-9)


def test_old_parent_is_valid_until_the_new_one_starts() -> None:
    buffer = Buffer()
    buffer.set("root", "p", 0, (100, 0, 0), UPRIGHT, static=True)
    buffer.set("root", "q", 0, (200, 0, 0), UPRIGHT, static=True)
    buffer.set("p", "b", 100, (1, 0, 0), UPRIGHT)
    buffer.set("q", "b", 200, (2, 0, 0), UPRIGHT)
    places = [buffer.lookup("root", "b", stamp).translation[0] for stamp in (100, 101, 150, 199, 200)]
    assert places == [101, 101, 101, 101, 202]


def test_static_transform_is_the_last_inserted_at_any_time() -> None:
    buffer = Buffer()
    for x in (1, 2, 3):
        buffer.set("a", "b", x * SECOND, (x, 0, 0), UPRIGHT, static=True)
    for stamp in (0, -5, 1, 77 * SECOND):
        transform = buffer.lookup("a", "b", stamp)
        assert (transform.translation[0], transform.stamp_ns) == (3, stamp)
    assert buffer.latest_common_time("a", "b") == 0


def test_histories_of_one_and_two_samples() -> None:
    buffer = Buffer()
    put(buffer, (2 * SECOND, 1))
    assert buffer.can("a", "b", 2 * SECOND)
    text = r"only time 2\.000000 is in the buffer"
    with pytest.raises(errors.NoDataForExtrapolationException, match=text) as raised:
        buffer.lookup("a", "b", 4 * SECOND)
    assert (raised.value.oldest_ns, raised.value.newest_ns, raised.value.gap_ns) == (
        2 * SECOND,
        2 * SECOND,
        2 * SECOND,
    )
    put(buffer, (3 * SECOND, 2))
    for stamp, kind in (
        (SECOND, errors.BackwardExtrapolationException),
        (4 * SECOND, errors.ForwardExtrapolationException),
    ):
        with pytest.raises(kind):
            buffer.lookup("a", "b", stamp)


def test_emptied_history_has_no_data() -> None:
    buffer = Buffer()
    put(buffer, (SECOND, 1), (2 * SECOND, 2))
    buffer.clear()
    with pytest.raises(errors.NoDataForExtrapolationException) as raised:
        buffer.lookup("a", "b", SECOND)
    error = raised.value
    assert (
        str(error) == ", when looking up transform from frame [b] to frame [a]"
    )  # Jazzy's text has no reason
    assert (error.frame_id, error.oldest_ns, error.newest_ns, error.gap_ns) == ("b", None, None, None)
    with pytest.raises(errors.ConnectivityException):
        buffer.lookup("a", "b")
    assert buffer.frame_names() == ["b", "a"]
    assert (buffer.all_frames_as_string(), buffer.all_frames_as_yaml()) == (
        "Frame b exists with parent NO_PARENT.\n",
        "",
    )


def test_extrapolation_is_reported_before_missing_connection() -> None:
    buffer = Buffer()
    for stamp in (SECOND, 2 * SECOND):
        buffer.set("a", "b", stamp, HERE, UPRIGHT)
        buffer.set("x", "y", stamp, HERE, UPRIGHT)
    for pair in (("a", "y"), ("b", "y"), ("y", "a")):
        with pytest.raises(errors.ForwardExtrapolationException):
            buffer.lookup(*pair, 9 * SECOND)
        with pytest.raises(errors.ConnectivityException):
            buffer.lookup(*pair, SECOND)


def test_sample_at_zero_is_ignored_for_the_latest_common_time() -> None:
    buffer = Buffer()
    put(buffer, (0, 1))
    buffer.set("b", "c", 5 * SECOND, HERE, UPRIGHT)
    assert buffer.latest_common_time("a", "c") == 5 * SECOND
    with pytest.raises(errors.NoDataForExtrapolationException, match=r"only time 0\.000000 is in the buffer"):
        buffer.lookup("a", "c")
    assert buffer.lookup("a", "b").translation[0] == 1


def test_common_time_can_precede_the_start_of_a_branch() -> None:
    buffer = Buffer()
    for child, stamps in (("a", (5, 6)), ("b", (1, 2))):
        for stamp in stamps:
            buffer.set("root", child, stamp * SECOND, HERE, UPRIGHT)
    assert buffer.latest_common_time("a", "b") == 2 * SECOND
    with pytest.raises(errors.BackwardExtrapolationException):
        buffer.lookup("a", "b")


def test_a_full_lookup_checks_all_names_and_has_the_targets_stamp() -> None:
    buffer = Buffer()
    for stamp in (1, 2, 3):
        buffer.set("r", "a", stamp * SECOND, (stamp, 0, 0), UPRIGHT)
    with pytest.raises(errors.LookupException, match='"x" passed to lookupTransform argument target_frame'):
        buffer.lookup_full("x", 0, "x", 0, "x")
    with pytest.raises(
        errors.InvalidArgumentException, match="argument source_frame - in tf2 frame_ids cannot be empty"
    ):
        buffer.lookup_full("a", 0, "", 0, "/f")
    with pytest.raises(
        errors.InvalidArgumentException, match=r"argument fixed_frame - .* cannot start with a '/'"
    ):
        buffer.lookup_full("a", 0, "a", 0, "/f")
    stamps = [
        buffer.lookup_full(*query).stamp_ns
        for query in (
            ("r", 0, "a", 2 * SECOND, "r"),
            ("a", 0, "r", 2 * SECOND, "a"),
            ("a", 0, "a", SECOND, "r"),
        )
    ]
    assert stamps == [0, 3 * SECOND, 3 * SECOND]
    assert buffer.lookup_full("a", 3 * SECOND, "a", SECOND, "r").translation[0] == -2


def test_full_lookup_reports_the_source_first_and_can_transform_the_target() -> None:
    buffer = Buffer()
    for stamp in (1, 2):
        buffer.set("r", "a", stamp * SECOND, HERE, UPRIGHT)
    query = "a", 9 * SECOND, "a", 8 * SECOND, "r"
    with pytest.raises(errors.ForwardExtrapolationException, match=r"Requested time 8\.000000"):
        buffer.lookup_full(*query)
    assert "Requested time 9.000000" in buffer.find_obstacle_full(*query)


def test_every_reason_for_rejection_is_logged() -> None:
    buffer, lines = Buffer(), []
    buffer.set_log_callback(lambda _, text: lines.append(text.partition(":")[0]))
    assert not buffer.set("a", "a", SECOND, (math.nan, 0, 0), (0, 0, 0, 0))
    assert lines == ["TF_SELF_TRANSFORM", "TF_NAN_INPUT", "TF_DENORMALIZED_QUATERNION"]
    assert buffer.all_frames_as_yaml() == "[]"
    assert buffer.all_frames_as_dot() == 'digraph G {\n"no tf data recieved"}'


def test_times_print_with_six_digits() -> None:
    buffer = Buffer()
    buffer.set("a", "b", -1, HERE, UPRIGHT)
    for stamp, text in ((1000, "0.000001"), (SECOND, "1.000000"), (-SECOND, "-1.000000"), (-2, "-0.000000")):
        obstacle = buffer.find_obstacle("a", "b", stamp)
        assert f"at time {text}, but only time -0.000000 is in the buffer" in obstacle
