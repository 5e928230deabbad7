"""Results of the array methods equal those of the scalar ones; wrong arrays raise."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from tests.oracles.transforms import matrix

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import ExtrapolationException, LookupException

SECOND = 1_000_000_000
START = 100 * SECOND


@pytest.fixture
def random() -> np.random.Generator:
    return np.random.default_rng(5)


@pytest.fixture
def buffer(random: np.random.Generator) -> Buffer:
    """map - odom - base - laser, and base - wheel; odom changes its parent over time, laser is static."""
    buffer = Buffer(None)
    for parent, child, count in (("map", "odom", 50), ("odom", "base", 2000), ("base", "wheel", 700)):
        stamps = START + np.arange(count) * (10 * SECOND // (count - 1))
        turns = random.normal(size=4) + 0.02 * np.cumsum(random.normal(size=(count, 4)), axis=0)
        assert buffer.set_many(parent, child, stamps, random.normal(size=(count, 3)), turns, "me") == count
    buffer.set("other", "odom", START + 5 * SECOND, (1, 2, 3), (0, 0, 0, 1))
    buffer.set("map", "other", 0, (4, 5, 6), (0, 0, 1, 1), static=True)
    buffer.set("base", "laser", 0, (0.1, 0.2, 0.3), (1, 0, 0, 1), static=True)
    return buffer


@pytest.mark.parametrize("order", ["ascending", "shuffled", "descending", "constant"])
@pytest.mark.parametrize(
    "pair",
    [
        ("map", "laser"),
        ("laser", "map"),
        ("wheel", "laser"),
        ("base", "odom"),
        ("map", "map"),
        ("laser", "base"),
    ],
)
def test_lookup_many_equals_single_lookups(
    buffer: Buffer, random: np.random.Generator, pair: tuple[str, str], order: str
) -> None:
    stamps = np.sort(random.integers(START - SECOND // 5, START + 10 * SECOND + SECOND // 5, 500))
    stamps = {
        "ascending": stamps, "descending": stamps[::-1], "constant": np.full(10, START + 3 * SECOND + 1),
        "shuffled": np.concatenate((random.permutation(stamps), [0, START, START + 10 * SECOND, 0])),
    }[order]  # fmt: skip
    poses = buffer.lookup_many(*pair, stamps, strict=False, workers=2)
    for index, stamp in enumerate(stamps):
        assert poses.known[index] == buffer.can(*pair, int(stamp))
        if poses.known[index]:
            transform = buffer.lookup(*pair, int(stamp))
            assert poses.positions[index] == pytest.approx(transform.translation, rel=1e-12, abs=1e-12)
            assert poses.rotations_xyzw[index] == pytest.approx(transform.rotation_xyzw, rel=1e-12, abs=1e-12)
        else:
            assert np.isnan(poses.positions[index]).all()
            assert np.isnan(poses.rotations_xyzw[index]).all()


def test_matrices_of_many_transforms(buffer: Buffer) -> None:
    poses = buffer.lookup_many("map", "laser", START + np.arange(5) * SECOND)
    for position, rotation, ours in zip(poses.positions, poses.rotations_xyzw, poses.matrices(), strict=True):
        assert np.allclose(ours, matrix(position, rotation), atol=1e-12)


def test_strict_raises_for_the_first_failing_stamp(buffer: Buffer) -> None:
    stamps = START + np.arange(3000) * SECOND // 100
    with pytest.raises(ExtrapolationException, match="extrapolation into the future") as raised:
        buffer.lookup_many("map", "laser", stamps)
    first = next(i for i, stamp in enumerate(stamps) if not buffer.can("map", "laser", int(stamp)))
    assert raised.value.index == first
    assert raised.value.requested_ns == stamps[first]
    with pytest.raises(LookupException, match="does not exist"):
        buffer.lookup_many("map", "nowhere", stamps)
    assert not buffer.lookup_many("map", "nowhere", stamps, strict=False).known.any()


def test_stamps_of_other_types_are_accepted(buffer: Buffer) -> None:
    as_dates = np.array([START, START + SECOND]).astype("datetime64[ns]")
    expected = buffer.lookup_many("map", "laser", [START, START + SECOND]).positions
    assert (buffer.lookup_many("map", "laser", as_dates).positions == expected).all()
    assert (buffer.lookup_many("map", "laser", as_dates.astype("datetime64[us]")).positions == expected).all()
    every_other = np.array([START, 0, START + SECOND, 0])[::2]
    assert (buffer.lookup_many("map", "laser", every_other).positions == expected).all()
    assert buffer.lookup_many("map", "laser", []).positions.shape == (0, 3)
    assert buffer.lookup_many("map", "laser", np.array([], "datetime64[D]")).positions.shape == (0, 3)
    edges = np.array(["1678-01-01", "2262-01-01"], "datetime64[D]")
    assert not buffer.lookup_many("map", "laser", edges, strict=False).known.any()


@pytest.mark.parametrize("count", [2, 300, 700, 20_000])
@pytest.mark.parametrize("workers", [1, 3])
def test_results_are_in_the_order_of_the_stamps(
    buffer: Buffer, random: np.random.Generator, count: int, workers: int
) -> None:
    ascending = np.sort(random.integers(START, START + 10 * SECOND, count))
    expected = buffer.lookup_many("map", "laser", ascending)
    order = random.permutation(count)
    poses = buffer.lookup_many("map", "laser", ascending[order], workers=workers)
    assert np.abs(poses.positions - expected.positions[order]).max() < 1e-12
    assert np.abs(poses.rotations_xyzw - expected.rotations_xyzw[order]).max() < 1e-12

    points = random.normal(size=(count, 3))
    moved = buffer.deskew(points, ascending, "map", "laser", "odom", START, workers=workers)
    again = buffer.deskew(points[order], ascending[order], "map", "laser", "odom", START, workers=workers)
    assert np.abs(again - moved[order]).max() < 1e-12


@pytest.mark.parametrize("workers", [1, 3])
def test_first_failure_is_the_first_in_the_given_order(
    buffer: Buffer, random: np.random.Generator, workers: int
) -> None:
    stamps = random.integers(START, START + 10 * SECOND, 5000)
    stamps[[40, 3000, 4999]] = START + 20 * SECOND, START - SECOND, START - 2 * SECOND
    with pytest.raises(ExtrapolationException) as raised:
        buffer.lookup_many("map", "laser", stamps, workers=workers)
    assert raised.value.index == 40
    assert raised.value.requested_ns == stamps[40]
    with pytest.raises(ExtrapolationException) as raised:
        buffer.deskew(np.zeros((5000, 3)), stamps, "map", "laser", "odom", START, workers=workers)
    assert raised.value.index == 40


@pytest.mark.parametrize(
    ("stamps", "kind", "text"),
    [
        ([1.5], TypeError, "must be integers"),
        (["a"], TypeError, "must be integers"),
        ([[1]], ValueError, r"shape \(N,\), not \(1, 1\)"),
        (5, ValueError, r"shape \(N,\)"),
        ([2**70], ValueError, "64 bits"),
        (np.array([2**63], np.uint64), ValueError, "64 bits"),
        (np.array(["3000-01-01"], "datetime64[D]"), ValueError, "1677 to 2262"),
        (np.array(["2263", "1500"], "datetime64[Y]"), ValueError, "1677 to 2262"),
        (np.array(["2000-01-01", "NaT"], "datetime64[ns]"), ValueError, "NaT"),
        ([True], TypeError, "must be integers"),
    ],
)
def test_invalid_stamps_raise(buffer: Buffer, stamps: object, kind: type[Exception], text: str) -> None:
    with pytest.raises(kind, match=text):
        buffer.lookup_many("map", "laser", stamps)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int32])
def test_points_are_transformed_at_one_time(buffer: Buffer, random: np.random.Generator, dtype: type) -> None:
    points = (10 * random.normal(size=(1000, 3))).astype(dtype)
    stamp = START + 3 * SECOND + 7
    transform = buffer.lookup("map", "laser", stamp)
    expected = (
        points @ matrix(transform.translation, transform.rotation_xyzw)[:3, :3].T + transform.translation
    )
    moved = buffer.transform_points(points, "map", "laser", stamp)
    assert moved.dtype == (np.float32 if dtype == np.float32 else np.float64)
    assert np.allclose(moved, expected, rtol=1e-5, atol=1e-4 if dtype == np.float32 else 1e-9)
    points.flags.writeable = False
    fortran = np.asfortranarray(points)
    assert (buffer.transform_points(fortran, "map", "laser", stamp) == moved).all()


def test_points_are_transformed_in_place(buffer: Buffer, random: np.random.Generator) -> None:
    points = random.normal(size=(100, 3))
    expected = buffer.transform_points(points, "map", "laser", START)
    assert buffer.transform_points(points, "map", "laser", START, out=points) is points
    assert (points == expected).all()


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_deskew_equals_a_full_lookup_for_each_point(
    buffer: Buffer, random: np.random.Generator, dtype: type
) -> None:
    points = random.normal(size=(2000, 3)).astype(dtype)
    stamps = np.sort(random.integers(START + SECOND, START + 2 * SECOND, 2000))
    target_stamp = START + 2 * SECOND
    moved = buffer.deskew(points, stamps, "laser", "laser", "odom", target_stamp)
    for index in range(0, 2000, 97):
        full = buffer.lookup_full("laser", target_stamp, "laser", int(stamps[index]), "odom")
        expected = matrix(full.translation, full.rotation_xyzw) @ [*points[index], 1]
        assert moved[index] == pytest.approx(
            expected[:3], rel=1e-5, abs=1e-5 if dtype == np.float32 else 1e-9
        )


@pytest.mark.parametrize(
    ("call", "kind", "text"),
    [
        (
            lambda b: b.transform_points(np.zeros((3, 4)), "map", "laser"),
            ValueError,
            r"\(N, 3\), not \(3, 4\)",
        ),
        (lambda b: b.transform_points(np.zeros(3), "map", "laser"), ValueError, r"\(N, 3\)"),
        (lambda b: b.transform_points(np.zeros((3, 3), complex), "map", "laser"), TypeError, "complex"),
        (
            lambda b: b.transform_points(np.zeros((3, 3)), "map", "laser", out=np.zeros((3, 3), np.float32)),
            ValueError,
            "out must be float64",
        ),
        (
            lambda b: b.transform_points(np.zeros((3, 3)), "map", "laser", out=np.zeros((3, 6))[:, ::2]),
            ValueError,
            "C-contiguous",
        ),
        (
            lambda b: b.deskew(np.zeros((3, 3)), [1, 2], "map", "laser", "odom"),
            ValueError,
            "3 points, 2 stamps",
        ),
        (lambda b: b.set_many("a", "b", [1, 2], np.zeros((2, 2)), np.ones((2, 4))), ValueError, "positions"),
        (
            lambda b: b.set_many("a", "b", [1, 2], np.zeros((2, 3)), np.ones((4, 2))),
            ValueError,
            "rotations_xyzw",
        ),
    ],
)
def test_arrays_of_wrong_shape_or_type_raise(
    buffer: Buffer, call: Callable[[Buffer], object], kind: type[Exception], text: str
) -> None:
    with pytest.raises(kind, match=text):
        call(buffer)


def series(random: np.random.Generator, count: int) -> tuple[Any, Any, Any]:
    """Return stamps, positions and rotations, most of them ascending and valid."""
    stamps = START + np.cumsum(random.integers(1, SECOND // 50, count))
    positions, rotations = random.normal(size=(count, 3)), random.normal(size=(count, 4))
    rotations[::3] /= np.linalg.norm(rotations[::3], axis=1)[:, None]
    for index in random.integers(1, count, count // 40):
        match random.integers(0, 7):
            case 0:
                positions[index, random.integers(3)] = np.nan
            case 1:
                rotations[index, random.integers(4)] = np.nan
            case 2:
                rotations[index] = 0
            case 3:
                positions[index, :2] = np.inf, -np.inf
            case 4:
                stamps[index] = stamps[index - 1]
            case 5:  # the same sample again
                stamps[index] = stamps[index - 1]
                positions[index], rotations[index] = positions[index - 1], rotations[index - 1]
            case 6:
                stamps[index] -= random.integers(0, 3 * SECOND)
    return stamps, positions, rotations


@pytest.mark.parametrize("cache_time_ns", [None, 10 * SECOND, SECOND])
@pytest.mark.parametrize("count", [1, 2, 255, 256, 257, 1023, 3000])
def test_set_many_equals_single_inserts(
    cache_time_ns: int | None, count: int, random: np.random.Generator
) -> None:
    logs: tuple[dict[str, str], dict[str, str]] = {}, {}  # the first text of each topic
    both = Buffer(cache_time_ns), Buffer(cache_time_ns)
    for buffer, log in zip(both, logs, strict=True):
        buffer.set_log_callback(lambda _, text, log=log: log.setdefault(text[:12], text))
    for part in range(3):  # the later parts partly precede what is stored
        columns = series(random, count)
        columns[0][:] += part * (columns[0][-1] - START) // 2
        who = f"node {part}"
        stored = sum(
            both[0].set("a", "b", int(stamp), tuple(position), tuple(rotation), who)
            for stamp, position, rotation in zip(*columns, strict=True)
        )
        assert both[1].set_many("a", "b", *columns, who) == stored
        single, many = (buffer.to_arrays("a", "b") for buffer in both)
        assert all((one == other).all() for one, other in zip(single, many, strict=True))
        edges = [
            (edge.authority, edge.oldest_ns, edge.newest_ns, edge.sample_count)
            for edge in (buffer.edges()[0] for buffer in both)
        ]
        assert edges[0] == edges[1]
    assert logs[0] == logs[1]
    assert bool(logs[0]) == (count > 100)


def test_set_many_after_a_static_transform_and_a_clear(random: np.random.Generator) -> None:
    buffer = Buffer(None)
    buffer.set("a", "b", 0, (1.0, 2.0, 3.0), (0.0, 0.0, 0.0, 1.0), static=True)
    stamps = START + np.arange(600)
    turns = random.normal(size=(600, 4))
    assert buffer.set_many("a", "b", stamps, random.normal(size=(600, 3)), turns) == 600
    buffer.clear()
    assert buffer.set_many("a", "b", stamps - SECOND, random.normal(size=(600, 3)), turns) == 600
    assert (buffer.to_arrays("a", "b").stamps_ns == stamps - SECOND).all()
    assert buffer.set_many("c", "b", stamps, random.normal(size=(600, 3)), turns) == 600
    assert len(buffer.to_arrays("c", "b").stamps_ns) == len(buffer.to_arrays("a", "b").stamps_ns) == 600


def test_set_many_and_to_arrays_are_inverse(random: np.random.Generator) -> None:
    buffer = Buffer(None)
    stamps = random.permutation(1000)
    positions = random.normal(size=(1000, 3))
    buffer.set_many("a", "b", stamps, positions, np.tile([0, 0, 0, 2.0], (1000, 1)))
    buffer.set("c", "b", 2000, (0, 0, 0), (0, 0, 0, 1))
    samples = buffer.to_arrays("a", "b")
    order = np.argsort(stamps)
    assert (samples.stamps_ns == stamps[order]).all()
    assert (samples.positions == positions[order]).all()
    assert (samples.rotations_xyzw == [0, 0, 0, 1]).all()
    assert buffer.to_arrays("b", "a").stamps_ns.size == 0


def test_a_stored_transform_takes_72_bytes_or_less(random: np.random.Generator) -> None:
    buffer = Buffer(None)
    buffer.set_many(
        "a", "b", np.arange(100_000), random.normal(size=(100_000, 3)), random.normal(size=(100_000, 4))
    )
    assert buffer.memory / 100_000 <= 72


@pytest.mark.parametrize("turn_rad", [0.0, 1e-9, 1e-3, 0.0089, 0.009, 0.0282, 0.0284, 0.3, 3.1])
def test_many_stamps_between_the_same_samples_equal_single_ones(
    random: np.random.Generator, turn_rad: float
) -> None:
    buffer = Buffer(None)
    stamps = np.sort(np.concatenate((random.integers(-100, 100, 12) * 1000, [-100_000, 100_000])))
    for index, stamp in enumerate(stamps.tolist()):  # some stamps occur twice, with different values
        half = index * turn_rad / 2
        turn = (0.6 * np.sin(half), 0.0, 0.8 * np.sin(half), np.cos(half))
        buffer.set("a", "b", stamp, random.normal(size=3).tolist(), turn)
        buffer.set("b", "c", stamp - 7, random.normal(size=3).tolist(), turn)
    asked = np.sort(np.concatenate((random.integers(-99_000, 99_000, 3000), stamps[2:-2], [0, -1, 1])))
    for target, source in (("a", "c"), ("c", "a"), ("a", "b")):
        poses = buffer.lookup_many(target, source, asked)
        for index, stamp in enumerate(asked.tolist()):
            transform = buffer.lookup(target, source, stamp)
            assert np.abs(poses.positions[index] - transform.translation).max() < 1e-12
            assert np.abs(poses.rotations_xyzw[index] - transform.rotation_xyzw).max() < 1e-12


@pytest.mark.parametrize("workers", [1, 2])
def test_deskew_of_more_points_than_one_part(
    buffer: Buffer, random: np.random.Generator, workers: int
) -> None:
    points = random.normal(size=(10_001, 3))
    stamps = np.linspace(START + SECOND, START + 2 * SECOND, len(points)).astype(np.int64)
    arguments = (stamps, "laser", "laser", "odom", START + 2 * SECOND)
    moved = buffer.deskew(points, *arguments, workers=workers)
    assert np.array_equal(moved[-1:], buffer.deskew(points[-1:], stamps[-1:], *arguments[1:]))
    assert np.array_equal(moved[5000:5050], buffer.deskew(points, *arguments, out=points.copy())[5000:5050])
    stamps[9000] = START + 20 * SECOND
    kept = points.copy()
    for out in (None, points):
        with pytest.raises(ExtrapolationException) as raised:
            buffer.deskew(points, *arguments, out=out, workers=workers)
        assert getattr(raised.value, "index") == 9000  # noqa: B009
    assert np.array_equal(points, kept)
