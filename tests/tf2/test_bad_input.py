"""Invalid input has a defined result: an error with the reason, a rejection, or unchanged numbers.

Names, NaN and zero quaternions, and chains that are too long are in test_buffer.py; arrays of the wrong shape or type
in test_arrays.py.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.tf2 import errors
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.transform import Transform

HERE, UPRIGHT = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)
EXTREMES = [-(2**63), -SECOND, -1, 1, 2**63 - 1]


@pytest.fixture
def buffer() -> Buffer:
    buffer = Buffer(None)
    buffer.set_log_callback(None)
    stamps = SECOND + np.arange(100) * 1000
    buffer.set_many("a", "b", stamps, np.arange(300.0).reshape(100, 3), np.tile(UPRIGHT, (100, 1)))
    return buffer


@pytest.mark.parametrize("quaternion", [(math.inf, 0, 0, 1), (0, 0, -math.inf, 0), (math.inf,) * 4])
def test_infinite_quaternions_are_rejected(buffer: Buffer, quaternion: tuple[float, ...]) -> None:
    assert not buffer.set("a", "c", SECOND, HERE, quaternion)
    assert not buffer.has_frame("c")
    with pytest.raises(ValueError, match="rotation_xyzw has no direction"):
        Transform(HERE, quaternion)


@pytest.mark.parametrize("tiny", [5e-324, 1e-310, 1e-160])
def test_denormal_quaternions_are_rejected(buffer: Buffer, tiny: float) -> None:
    assert not buffer.set("a", "c", SECOND, HERE, (0, tiny, 0, tiny))
    assert buffer.set("a", "c", SECOND, HERE, (0, tiny, 0, 1))
    assert buffer.lookup("a", "c").rotation_xyzw == pytest.approx(UPRIGHT)


def test_infinite_position_gives_nan_without_error(buffer: Buffer) -> None:
    assert buffer.set("b", "c", SECOND, (math.inf, 0, 0), UPRIGHT)
    assert not np.isfinite(buffer.lookup("a", "c").translation).all()
    assert not np.isfinite(buffer.lookup("c", "a").translation).all()
    assert not np.isfinite(buffer.lookup_many("a", "c", [SECOND]).positions).all()
    assert buffer.lookup("a", "b").translation == (297, 298, 299)


def test_set_many_stores_the_valid_rows(buffer: Buffer) -> None:
    positions, rotations = np.ones((6, 3)), np.tile(UPRIGHT, (6, 1))
    positions[1, 2], positions[2, 0] = math.nan, math.inf
    rotations[3], rotations[4, 1], rotations[5] = 0, math.nan, (0, 0, 0, 1e-200)
    stamps = 2 * SECOND + np.arange(6)
    assert buffer.set_many("a", "new", stamps, positions, rotations) == 2
    assert buffer.to_arrays("a", "new").stamps_ns.tolist() == [stamps[0], stamps[2]]


@pytest.mark.parametrize("name", ["", "/", "//"])
def test_invalid_names_are_rejected(buffer: Buffer, name: str) -> None:
    if name != "//":  # stored as "/", which can't be requested
        assert not buffer.set("a", name, SECOND, HERE, UPRIGHT)
        assert not buffer.set(name, "a", SECOND, HERE, UPRIGHT)
        assert buffer.set_many(name, "a", [SECOND], [HERE], [UPRIGHT]) == 0
        message = TFMessage(transforms=[transform_stamped("a", name, SECOND)])
        assert buffer.insert_cdr(cdr.encode(message)) == 0
    assert not buffer.can("a", name)
    for ask in (
        lambda: buffer.lookup("a", name),
        lambda: buffer.lookup_many("a", name, [SECOND]),
        lambda: buffer.transform_points(np.zeros((1, 3)), name, "a"),
        lambda: buffer.deskew(np.zeros((1, 3)), [SECOND], "a", name, "a"),
        lambda: buffer.latest_common_time(name, "a"),
    ):
        with pytest.raises(errors.InvalidArgumentException, match="frame_ids cannot"):
            ask()


@pytest.mark.parametrize("stamp", EXTREMES)
def test_any_stamp_of_64_bits_is_stored_and_found(stamp: int) -> None:
    buffer = Buffer(None)
    assert buffer.set("a", "one", stamp, (1, 2, 3), UPRIGHT)
    assert buffer.lookup("a", "one", stamp).stamp_ns == stamp
    assert buffer.set_many("a", "b", [stamp], [(1, 2, 3)], [UPRIGHT]) == 1
    assert buffer.lookup_many("a", "b", [stamp]).positions.tolist() == [[1, 2, 3]]
    assert buffer.to_arrays("a", "b").stamps_ns.tolist() == [stamp]
    others = [other for other in EXTREMES if other != stamp]
    assert not buffer.lookup_many("a", "b", others * 500, strict=False).known.any()


def test_stamps_over_all_of_time_in_any_order() -> None:
    buffer = Buffer(None)
    buffer.set_many("a", "b", EXTREMES, np.arange(15.0).reshape(5, 3), np.tile(UPRIGHT, (5, 1)))
    random = np.random.default_rng(7)
    asked = random.integers(-(2**63), 2**63 - 1, 2000, endpoint=True)
    poses = buffer.lookup_many("a", "b", asked)
    for index, stamp in enumerate(asked.tolist()):
        assert poses.positions[index] == pytest.approx(buffer.lookup("a", "b", stamp).translation)


def test_listings_of_extreme_stamps() -> None:
    buffer = Buffer(None)
    for stamp in (EXTREMES[0], EXTREMES[-1]):
        buffer.set("a", "b", stamp, HERE, UPRIGHT)
    listing = buffer.all_frames_as_yaml()
    assert "oldest_transform: -9223372036.854776" in listing
    assert "buffer_length: 18446744073.710" in listing
    assert "rate: 0.000" in listing
    assert "Buffer length: 18446744073.710 sec" in buffer.all_frames_as_dot()


def test_read_only_or_strided_arrays_are_accepted(buffer: Buffer) -> None:
    stamps = np.repeat(SECOND + np.arange(100) * 1000, 2)[::2]
    positions, rotations = np.asfortranarray(np.ones((100, 3))), np.ones((100, 8))[:, ::2]
    points = np.ones((200, 3), np.float32)[::2]
    for array in (stamps, positions, rotations, points):
        array.flags.writeable = False
    assert buffer.set_many("a", "c", stamps, positions, rotations) == 100
    assert buffer.lookup_many("a", "b", stamps[::-1]).positions[0].tolist() == [297, 298, 299]
    assert (buffer.deskew(points, stamps, "a", "b", "a")[:, 0] == 1 + 3 * np.arange(100)).all()
    kept = np.zeros((100, 3), np.float32)
    kept.flags.writeable = False
    with pytest.raises(ValueError, match="writeable"):
        buffer.deskew(points, stamps, "a", "b", "a", out=kept)
    with pytest.raises(ValueError, match="writeable"):
        buffer.transform_points(points, "a", "b", out=kept)


def test_empty_stamps_and_points(buffer: Buffer) -> None:
    assert buffer.lookup_many("a", "b", []).positions.shape == (0, 3)
    assert buffer.lookup_many("a", "b", [], workers=8).known.shape == (0,)
    assert buffer.set_many("a", "b", [], np.empty((0, 3)), np.empty((0, 4))) == 0
    assert buffer.transform_points(np.empty((0, 3)), "a", "b").shape == (0, 3)
    assert buffer.deskew(np.empty((0, 3)), [], "a", "b", "a").shape == (0, 3)


@pytest.mark.parametrize("workers", [-1, 0, 1, 3, 10**6])
def test_any_number_of_workers_is_accepted(buffer: Buffer, workers: int) -> None:
    stamps = np.random.default_rng(3).integers(SECOND, SECOND + 99_000, 5000)
    assert (buffer.lookup_many("a", "b", stamps, workers=workers).positions[:, 0] >= 0).all()


def test_nan_points_stay_nan(buffer: Buffer) -> None:
    points = np.array([[math.nan, 0, 0], [0, math.inf, 0], [1, 2, 3]], np.float32)
    for moved in (
        buffer.transform_points(points, "a", "b"),
        buffer.deskew(points, [SECOND + 99_000] * 3, "a", "b", "a"),
    ):
        assert np.isfinite(moved).all(axis=1).tolist() == [False, False, True]
        assert moved[2].tolist() == [298, 300, 302]


def test_failed_deskew_leaves_out_unchanged(buffer: Buffer) -> None:
    points = np.ones((2000, 3))
    stamps = np.full(2000, SECOND)
    stamps[[1700, 300]] = 5
    with pytest.raises(errors.ExtrapolationException) as raised:
        buffer.deskew(points, stamps, "a", "b", "a", out=points)
    assert raised.value.index == 300
    assert (points == 1).all()


def test_chain_of_a_hundred_thousand_frames_raises() -> None:
    buffer = Buffer()
    for index in range(100_000):
        buffer.set(f"f{index}", f"f{index + 1}", SECOND, (1, 0, 0), UPRIGHT)
    assert buffer.lookup("f500", "f900").translation == (400, 0, 0)
    for pair in (("f0", "f100000"), ("f100000", "f0")):
        with pytest.raises(errors.LookupException, match="loop"):
            buffer.lookup(*pair)
        assert not buffer.lookup_many(*pair, [0, SECOND], strict=False).known.any()


def test_common_time_needs_no_path_to_the_root() -> None:
    buffer = Buffer()
    for index in range(1200):
        buffer.set(f"trunk{index}", f"trunk{index + 1}", 2 * SECOND, (1, 0, 0), UPRIGHT)
    for side in ("left", "right"):
        buffer.set("trunk900", side, 2 * SECOND, HERE, UPRIGHT)
        for index in range(400):
            below = side if index == 0 else f"{side}{index}"
            buffer.set(below, f"{side}{index + 1}", 2 * SECOND, HERE, UPRIGHT)
    assert buffer.latest_common_time("left99", "right9") == 2 * SECOND
    assert buffer.latest_common_time("left400", "right9") == 2 * SECOND
    assert buffer.latest_common_time("left400", "trunk900") == 2 * SECOND
    with pytest.raises(errors.LookupException, match="loop"):
        buffer.lookup("left400", "right9")


def test_cycle_raises(buffer: Buffer) -> None:
    for parent, child in (("a", "b"), ("b", "c"), ("c", "a")):
        buffer.set(parent, child, 9 * SECOND, HERE, UPRIGHT)
    buffer.set("x", "y", 9 * SECOND, HERE, UPRIGHT)
    assert buffer.can("a", "b")  # the loop is not on this path
    for ask in (
        lambda: buffer.lookup("x", "a"),
        lambda: buffer.lookup_many("x", "a", [9 * SECOND]),
        lambda: buffer.lookup_many("x", "a", [0]),
        lambda: buffer.transform_points(np.zeros((1, 3)), "x", "a"),
        lambda: buffer.latest_common_time("x", "a"),
    ):
        with pytest.raises(errors.LookupException, match="loop"):
            ask()


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda b: b.lookup("a", "b", 1.5), "a stamp must be an int of nanoseconds"),
        (lambda b: b.lookup("a", "b", None), "a Time's nanoseconds, not None of class NoneType"),
        (lambda b: b.lookup("a", "b", np.float64(1)), "of class numpy.float64"),
        (lambda b: b.set("a", "b", 1.5, HERE, UPRIGHT), "a stamp must be an int of nanoseconds"),
        (lambda b: b.can(1, "b"), "the name of a frame or a publisher must be a str, not 1 of class int"),
        (lambda b: b.can("a", None), "must be a str, not None of class NoneType"),
        (lambda b: b.lookup_full("a", "now", "b", 1, "a"), "not 'now' of class str"),
        (lambda b: b.has_frame(b"a"), "must be a str, not b'a' of class bytes"),
        (lambda b: b.wait("a", 2, timeout_s=1.0), "must be a str, not 2 of class int"),
        (
            lambda b: b.set("a", "b", 1, (0, 0), UPRIGHT),
            "a translation must be three numbers, x, y, z, not (0, 0)",
        ),
        (
            lambda b: b.set("a", "b", 1, (1, 2, "x"), UPRIGHT),
            "a translation must be three numbers, x, y, z, not (1, 2, 'x')",
        ),
        (
            lambda b: b.set("a", "b", 1, HERE, HERE),
            "a rotation must be four numbers, x, y, z, w, not (0.0, 0.0, 0.0)",
        ),
        (
            lambda b: b.set("a", "b", 1, None, UPRIGHT),
            "a translation must be three numbers, x, y, z, not None",
        ),
        (lambda b: b.set("a", "b", 1, HERE, UPRIGHT, authority=None), "not None of class NoneType"),
        (lambda b: b.lookup("ä" * 99, object), "not <class 'object'> of class type"),
        (lambda b: b.lookup("a", ["ä" * 99]), "... of class list"),
        (lambda b: b.insert_cdr(b"", authority=1), "not 1 of class int"),
        (lambda _: Buffer("x"), "a cache's time must be an int of nanoseconds"),  # type: ignore[arg-type]
    ],
)
def test_wrong_arguments_say_what_was_given(buffer: Buffer, call: Callable[[Any], object], text: str) -> None:
    with pytest.raises(TypeError) as raised:
        call(buffer)
    assert text in str(raised.value)
    assert "incompatible" not in str(raised.value)


def test_numbers_of_other_classes_are_accepted(buffer: Buffer) -> None:
    assert buffer.set("a", "n", np.int64(SECOND), [1, 2, 3], np.array(UPRIGHT))  # type: ignore[arg-type]
    assert buffer.lookup("a", "n", np.int32(SECOND)).translation == (1, 2, 3)  # type: ignore[arg-type]
