"""Wide vectors, narrow ones and plain numbers give the same: transforms at many stamps, and clouds."""

from __future__ import annotations

import os
import platform
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.oracles.transforms import OracleBuffer, matrix

from tfloom._native import move_cloud_float32, move_cloud_float64, use_wide_vectors
from tfloom.tf2.buffer import Buffer

IS_SANITIZED = "TFLOOM_SANITIZED_NATIVE" in os.environ
"""Built for a sanitizer, with less optimisation, both widths round alike."""
SECOND = 1_000_000_000
START = 100 * SECOND
LENGTH = 4 * SECOND
HALF_ANGLES_RAD = {"very near": 0.002, "near": 0.02, "apart": 0.05, "far": 0.5, "opposite": 1.5}
"""Between two samples, for each way to interpolate: a short series, a long one, trigonometry."""


@pytest.fixture(autouse=True)
def wide_again() -> Iterator[None]:
    yield
    use_wide_vectors(True)


def flags_of_processor() -> set[str]:
    lines = Path("/proc/cpuinfo").read_text("utf-8").splitlines()
    return next(set(line.split(":")[1].split()) for line in lines if line.startswith("flags"))


@pytest.mark.skipif(
    platform.system() != "Linux" or platform.machine() != "x86_64", reason="reads /proc/cpuinfo of an x86-64"
)
def test_wide_vectors_are_used_where_the_processor_has_them() -> None:
    assert use_wide_vectors(True) == ({"avx2", "fma"} <= flags_of_processor())
    assert not use_wide_vectors(False)


@cache
def filled(half_angle_rad: float) -> tuple[Buffer, OracleBuffer]:
    """Return a - b - c - d, sampled at three rates; c - d is static. Tests don't change them."""
    random = np.random.default_rng(6)
    buffer, oracle = Buffer(None), OracleBuffer(100 * SECOND)
    for parent, child, count in (("a", "b", 700), ("b", "c", 40), ("e", "a", 300)):
        rotation = random.normal(size=4)
        for stamp in START + np.arange(count) * (LENGTH // (count - 1)):
            axis = random.normal(size=4)
            rotation /= np.linalg.norm(rotation)
            axis -= (axis @ rotation) * rotation
            step = half_angle_rad * random.uniform(0.8, 1.0)
            rotation = np.cos(step) * rotation + np.sin(step) * axis / np.linalg.norm(axis)
            call = parent, child, int(stamp), tuple(random.normal(size=3)), tuple(rotation)
            assert buffer.set(*call)
            # The oracle gets the stored digits, because it does not normalise.
            stored = buffer.lookup(parent, child, int(stamp))
            assert oracle.set(*call[:3], stored.translation, stored.rotation_xyzw)
    for one in (buffer, oracle):
        one.set("c", "d", 0, (1.0, 2.0, 3.0), (0.0, 0.6, 0.0, 0.8), static=True)
    return buffer, oracle


def stamps(count: int) -> NDArray[np.int64]:
    """Return ascending stamps, some of which are those of samples."""
    within = np.random.default_rng(7).integers(START, START + LENGTH - 1000, count)
    within[::10] = START + np.arange(len(within[::10])) * (LENGTH // 699)
    return np.sort(within)


@pytest.mark.parametrize("count", [50, 3000], ids=["sparse", "dense"])
@pytest.mark.parametrize("half_angle_rad", HALF_ANGLES_RAD.values(), ids=HALF_ANGLES_RAD)
@pytest.mark.parametrize("are_wide", [True, False], ids=["wide", "narrow"])
def test_transforms_equal_those_of_the_oracle(*, are_wide: bool, half_angle_rad: float, count: int) -> None:
    use_wide_vectors(are_wide)
    buffer, oracle = filled(half_angle_rad)
    asked = stamps(count)
    for target, source in (("e", "d"), ("d", "e"), ("b", "d")):
        poses = buffer.lookup_many(target, source, asked)
        for index in range(0, count, max(count // 50, 1)):
            _, expected = oracle.lookup(target, source, int(asked[index]))
            ours = matrix(poses.positions[index], poses.rotations_xyzw[index])
            assert np.abs(ours - expected).max() < 1e-12


@pytest.mark.parametrize("half_angle_rad", HALF_ANGLES_RAD.values(), ids=HALF_ANGLES_RAD)
def test_wide_and_narrow_vectors_and_single_lookups_agree(half_angle_rad: float) -> None:
    buffer, _ = filled(half_angle_rad)
    asked = stamps(3000)
    results = []
    for are_wide in (True, False):
        differs = use_wide_vectors(are_wide)
        poses = buffer.lookup_many("e", "d", asked)
        results.append(np.concatenate((poses.positions, poses.rotations_xyzw), axis=1))
        single = [buffer.lookup("e", "d", int(stamp)) for stamp in asked]
        rows = np.array([[*one.translation, *one.rotation_xyzw] for one in single])
        assert np.abs(results[-1] - rows).max() < 1e-12
        results.append(rows)
        if are_wide:
            wide_exists = differs
    wide, single_beside_wide, narrow, single_beside_narrow = results
    assert np.abs(wide - narrow).max() < 1e-12
    if not IS_SANITIZED:
        assert (wide != narrow).any() == wide_exists  # so it was really computed in two ways
    assert (single_beside_wide == single_beside_narrow).all()


@pytest.mark.parametrize("are_wide", [True, False], ids=["wide", "narrow"])
@pytest.mark.parametrize("count", [*range(1, 20), 127, 128, 129, 511, 512, 513])
def test_any_number_of_stamps(*, are_wide: bool, count: int) -> None:
    """Rows beyond the last whole vector, and at the ends of chunks, are right too."""
    use_wide_vectors(are_wide)
    buffer, _ = filled(HALF_ANGLES_RAD["near"])
    asked = stamps(count)
    poses = buffer.lookup_many("e", "d", asked)
    for index in {0, count // 2, count - 2, count - 1} & set(range(count)):
        single = buffer.lookup("e", "d", int(asked[index]))
        assert poses.positions[index] == pytest.approx(single.translation, abs=1e-12)
        assert poses.rotations_xyzw[index] == pytest.approx(single.rotation_xyzw, abs=1e-12)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("point_octets", [0, 1, 4, 8, 20, 52], ids="{} more octets".format)
@pytest.mark.parametrize("offset", [0, 3, 16])
@pytest.mark.parametrize("are_wide", [True, False], ids=["wide", "narrow"])
def test_clouds_move_and_other_octets_stay(
    *, are_wide: bool, offset: int, point_octets: int, dtype: type[np.floating]
) -> None:
    """What is around the coordinates is any octets, among them those of signalling NaNs; the last point has none."""
    use_wide_vectors(are_wide)
    random = np.random.default_rng(9)
    size = np.dtype(dtype).itemsize
    height, width, step = 3, 7, offset + 3 * size + point_octets
    row_step = width * step + 5
    octets = random.integers(
        0, 256, (height - 1) * row_step + (width - 1) * step + offset + 3 * size, np.uint8
    )
    points = random.normal(size=(height, width, 3)).astype(dtype)
    signalling = np.array([0xA0, 0x01, 0x80, 0x7F], np.uint8)  # as float32
    places = [
        (slice(at, at + 3 * size), point)
        for row in range(height)
        for point, at in zip(points[row], row * row_step + offset + step * np.arange(width), strict=True)
    ]
    for place, point in places:
        octets[place] = point.view(np.uint8)
        after = octets[place.stop : place.stop + min(point_octets, 4)]
        after[:] = signalling[: len(after)]
    before = octets.copy()
    quaternion = np.array([0.1, -0.2, 0.3, 0.9])
    quaternion /= np.linalg.norm(quaternion)
    moved_by = matrix(np.array([1.0, 2.0, 3.0]), quaternion)

    move_cloud = move_cloud_float32 if dtype == np.float32 else move_cloud_float64
    move_cloud(
        np.array([1.0, 2.0, 3.0, *quaternion]),
        octets,
        (height, width),
        (row_step, step),
        [offset, offset + size, offset + 2 * size],
    )
    is_other = np.ones(len(octets), bool)
    for place, point in places:
        is_other[place] = False
        expected = moved_by[:3, :3] @ point.astype(float) + moved_by[:3, 3]
        assert np.abs(octets[place].copy().view(dtype) - expected).max() < 20 * np.finfo(dtype).eps
    assert (octets[is_other] == before[is_other]).all()
