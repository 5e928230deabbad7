"""The buffer against the reference buffer, on random trees; and the laws of any buffer of transforms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.oracles.transforms import NoAnswerError, OracleBuffer, matrix
from tests.tf2.replay import outcome

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import ConnectivityException, ExtrapolationException, LookupException

SECOND = 1_000_000_000
FRAMES = [f"f{i}" for i in range(5)]

# Values of a table, because drawing seven numbers for each sample takes longer than all else; equal samples are common.
# None is half a turn from another, because slerp between such has two ways to go.
RANDOM = np.random.default_rng(3)
translations = st.sampled_from(
    [(0.0, 0.0, 0.0), (100.0, -100.0, 1e-9), *map(tuple, RANDOM.uniform(-100, 100, (30, 3)).tolist())]
)
rotations = st.sampled_from(
    [
        *((0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0, -1.0), (0.5, 0.5, -0.5, 0.5)),
        *map(tuple, RANDOM.normal(size=(30, 4)).tolist()),
    ]
)
# A coarse grid makes equal stamps and exact hits common; the odd offset is between grid points.
stamps = st.builds(
    lambda tenth, odd: 100 * SECOND + tenth * SECOND // 10 + odd, st.integers(0, 120), st.integers(0, 2)
)
queries = st.one_of(st.just(0), stamps)
# A child's parent has a lower number, so that there are no cycles; it may change over time.
edges = st.integers(1, len(FRAMES) - 1).flatmap(
    lambda child: st.tuples(st.integers(0, child - 1), st.just(child))
)
inserts = st.tuples(edges, stamps, translations, rotations, st.sampled_from([False] * 5 + [True]))


def build(
    operations: list[tuple[tuple[int, int], int, tuple[float, ...], tuple[float, ...], bool]],
) -> tuple[Buffer, OracleBuffer]:
    buffer, oracle = Buffer(), OracleBuffer()
    buffer.set_log_callback(None)
    for (parent, child), stamp, translation, rotation, static in operations:
        call = FRAMES[parent], FRAMES[child], stamp, translation, rotation
        assert buffer.set(*call, static=static) == oracle.set(*call, static=static)
    return buffer, oracle


def as_matrix(answer: object) -> np.ndarray:
    return matrix(np.array(answer.translation), np.array(answer.rotation_xyzw))


@settings(max_examples=150, deadline=None)
@given(st.lists(inserts, min_size=1, max_size=60), st.sampled_from(FRAMES), st.sampled_from(FRAMES), queries)
def test_results_equal_those_of_the_oracle(operations: list, target: str, source: str, stamp: int) -> None:
    assume(target != source)
    buffer, oracle = build(operations)
    try:
        stamp_used, expected = oracle.lookup(target, source, stamp)
    except NoAnswerError as reason:
        assert not buffer.can(target, source, stamp)
        kinds = {
            "unknown": (LookupException,),
            "unconnected": (ConnectivityException, ExtrapolationException),
            "extrapolation": (ExtrapolationException,),
        }
        with pytest.raises(kinds[reason.kind]):
            buffer.lookup(target, source, stamp)
        return
    assert buffer.can(target, source, stamp)
    answer = buffer.lookup(target, source, stamp)
    assert answer.stamp_ns == stamp_used
    assert np.allclose(as_matrix(answer), expected, rtol=1e-9, atol=1e-9 * 700)
    assert np.linalg.norm(answer.rotation_xyzw) == pytest.approx(1, abs=1e-12)


@settings(max_examples=25, deadline=None)
@given(
    st.lists(inserts, min_size=1, max_size=60),
    st.lists(st.tuples(st.sampled_from(FRAMES), st.sampled_from(FRAMES), queries), max_size=20),
)
def test_frozen_equals_live(operations: list, questions: list[tuple[str, str, int]]) -> None:
    live, _ = build(operations)
    mapped = Buffer()
    mapped.set_log_callback(None)
    mapped.map_frozen(live.frozen())
    for question in questions:
        assert outcome(mapped, *question) == outcome(live, *question)
    for (parent, child), stamp, translation, rotation, static in operations[::3]:  # and after further inserts
        call = FRAMES[parent], FRAMES[child], stamp + 1, translation, rotation
        assert mapped.set(*call, static=static) == live.set(*call, static=static)
    for question in questions:
        assert outcome(mapped, *question) == outcome(live, *question)
    assert mapped.all_frames_as_yaml() == live.all_frames_as_yaml()


@settings(max_examples=25, deadline=None)
@given(
    st.lists(inserts, min_size=1, max_size=60),
    st.sampled_from(FRAMES),
    st.sampled_from(FRAMES),
    st.lists(queries, max_size=30),
)
def test_batch_equals_single(operations: list, target: str, source: str, asked: list[int]) -> None:
    buffer, _ = build(operations)
    poses = buffer.lookup_many(target, source, asked, strict=False)
    first_error = None
    for index, stamp in enumerate(asked):
        single = outcome(buffer, target, source, stamp)
        assert poses.known[index] == (not isinstance(single[0], type))
        if poses.known[index]:
            assert poses.positions[index] == pytest.approx(single[1].translation, rel=1e-9, abs=1e-9)
            assert poses.rotations_xyzw[index] == pytest.approx(single[1].rotation_xyzw, abs=1e-9)
        elif first_error is None:
            first_error = index, *single
    if first_error is not None:
        with pytest.raises(first_error[1]) as raised:
            buffer.lookup_many(target, source, asked)
        assert (raised.value.index, str(raised.value)) == (first_error[0], first_error[2])


@st.composite
def trees(draw: st.DrawFn) -> Buffer:
    """A connected tree in which every edge is known from 100 s to 110 s."""
    buffer = Buffer()
    for child in range(1, len(FRAMES)):
        parent = FRAMES[draw(st.integers(0, child - 1))]
        for stamp in (100 * SECOND, 110 * SECOND):
            assert buffer.set(parent, FRAMES[child], stamp, draw(translations), draw(rotations))
    return buffer


within = st.integers(100 * SECOND, 110 * SECOND)


@settings(max_examples=30, deadline=None)
@given(trees(), st.permutations(FRAMES), within)
def test_lookups_compose(buffer: Buffer, order: list[str], stamp: int) -> None:
    a, b, c = order[:3]
    a_from_b, b_from_c, a_from_c, b_from_a = (
        as_matrix(buffer.lookup(*pair, stamp)) for pair in [(a, b), (b, c), (a, c), (b, a)]
    )
    assert np.allclose(a_from_b @ b_from_c, a_from_c, rtol=1e-9, atol=1e-9 * 700)
    assert np.allclose(a_from_b @ b_from_a, np.eye(4), rtol=1e-9, atol=1e-9 * 700)


@settings(max_examples=30, deadline=None)
@given(trees(), st.permutations(FRAMES), within, within)
def test_full_lookup_uses_the_fixed_frame(
    buffer: Buffer, order: list[str], target_stamp: int, source_stamp: int
) -> None:
    target, source, fixed = order[:3]
    full = buffer.lookup_full(target, target_stamp, source, source_stamp, fixed)
    target_from_fixed = as_matrix(buffer.lookup(target, fixed, target_stamp))
    fixed_from_source = as_matrix(buffer.lookup(fixed, source, source_stamp))
    assert full.stamp_ns == target_stamp
    assert np.allclose(as_matrix(full), target_from_fixed @ fixed_from_source, rtol=1e-9, atol=1e-9 * 700)


@pytest.mark.parametrize("seed", range(2))
def test_a_long_history_in_any_order(seed: int) -> None:
    """Thousands of samples, shuffled: blocks split, fill up and are pruned."""
    random = np.random.default_rng(seed)
    buffer, oracle = Buffer(30 * SECOND), OracleBuffer(30 * SECOND)
    buffer.set_log_callback(None)
    grid = 100 * SECOND + np.arange(1200) * SECOND // 20  # 60 s: the first half is pruned on the way
    order = np.concatenate(
        [random.permutation(600), 600 + random.permutation(600), random.integers(0, 1200, 300)]
    )
    for index in order:
        call = "map", "base", int(grid[index]), tuple(random.normal(size=3)), tuple(random.normal(size=4))
        assert buffer.set(*call) == oracle.set(*call)
    ends = grid[590:610]  # around the oldest one that is kept
    for stamp in [*ends, *random.integers(100 * SECOND, 160 * SECOND, 200)]:
        try:
            _, expected = oracle.lookup("map", "base", int(stamp))
        except NoAnswerError:
            assert not buffer.can("map", "base", int(stamp))
            continue
        assert np.allclose(as_matrix(buffer.lookup("map", "base", int(stamp))), expected, atol=1e-9)


def test_stored_rotations_have_length_one_and_the_sign_of_their_matrix() -> None:
    random = np.random.default_rng(8)
    for _ in range(1000):
        q = random.normal(size=4)
        q /= np.linalg.norm(q)
        length = 1 + random.choice([0.0, 1e-12, 4.9e-9, -4.9e-9, 5.1e-9, 1e-6, 1e-3]) * random.random()
        buffer = Buffer()
        buffer.set("a", "b", 1, (0, 0, 0), (length * q).tolist())
        stored = np.array(buffer.lookup("a", "b").rotation_xyzw)
        sign = np.sign(q[3]) if 4 * q[3] ** 2 > 1 else np.sign(q[:3][np.argmax(np.abs(q[:3]))])
        assert np.abs(stored - sign * q).max() < 1e-15
