"""Names, rejected data, the kinds of cache, waits and requests; with exact texts."""

# ruff: noqa: E501, ISC004, texts are written here as printed
from __future__ import annotations

import math
import pickle
import signal
import threading
import time

import pytest

from tfloom.tf2 import errors
from tfloom.tf2.buffer import Buffer

SECOND = 1_000_000_000
HERE = (0.0, 0.0, 0.0)
UPRIGHT = (0.0, 0.0, 0.0, 1.0)
FIRST_HANDLE = 1


@pytest.fixture
def lines() -> list[tuple[int, str]]:
    return []


@pytest.fixture
def buffer(lines: list[tuple[int, str]]) -> Buffer:
    buffer = Buffer()
    buffer.set_log_callback(lambda severity, text: lines.append((severity, text)))
    return buffer


@pytest.mark.parametrize(
    ("target", "source", "kind", "text"),
    [
        ("", "a", errors.InvalidArgumentException, 'Invalid argument "" passed to lookupTransform argument target_frame - in tf2 frame_ids cannot be empty'),
        ("a", "/b", errors.InvalidArgumentException, 'Invalid argument "/b" passed to lookupTransform argument source_frame - in tf2 frame_ids cannot start with a \'/\''),
        ("x", "a", errors.LookupException, '"x" passed to lookupTransform argument target_frame does not exist. '),
        ("a", "NO_PARENT", errors.LookupException, '"NO_PARENT" passed to lookupTransform argument source_frame does not exist. '),
    ],
)  # fmt: skip
def test_invalid_or_unknown_names_raise(
    buffer: Buffer, target: str, source: str, kind: type[Exception], text: str
) -> None:
    buffer.set("a", "b", SECOND, HERE, UPRIGHT)
    with pytest.raises(kind) as raised:
        buffer.lookup(target, source)
    assert str(raised.value) == text
    assert not buffer.can(target, source)


def test_name_stored_with_two_slashes_is_listed_but_not_found(buffer: Buffer) -> None:
    assert buffer.set("/a", "//q", SECOND, HERE, UPRIGHT)
    assert buffer.frame_names() == ["/q", "a"]
    with pytest.raises(errors.InvalidArgumentException):
        buffer.lookup("a", "/q")
    with pytest.raises(errors.InvalidArgumentException):
        buffer.lookup_full("a", 0, "a", 0, "/q")


@pytest.mark.parametrize("name", ["", "/b", "never heard of"])
def test_lookup_of_a_frame_in_itself_needs_no_data(buffer: Buffer, name: str) -> None:
    assert buffer.can(name, name, 7)
    assert buffer.find_obstacle(name, name) is None
    answer = buffer.lookup(name, name, 7)
    assert (answer.stamp_ns, answer.translation, answer.rotation_xyzw) == (7, HERE, UPRIGHT)
    assert buffer.lookup(name, name).stamp_ns == 0


def test_names_that_are_not_text_raise(buffer: Buffer) -> None:
    with pytest.raises(ValueError, match="surrogates"):
        buffer.can("\ud800", "a")


@pytest.mark.parametrize("stamp", [2**63, -(2**63) - 1, 10**30])
def test_stamp_beyond_64_bits_raises(buffer: Buffer, stamp: int) -> None:
    with pytest.raises(ValueError, match="1677 to 2262"):
        buffer.lookup("a", "b", stamp)
    with pytest.raises(ValueError, match="1677 to 2262"):
        buffer.set("a", "b", stamp, HERE, UPRIGHT)


def test_interpolation_between_extreme_stamps() -> None:
    buffer = Buffer(None)
    buffer.set("a", "b", -(2**63), (0, 0, 0), UPRIGHT)
    buffer.set("a", "b", 2**63 - 1, (1, 0, 0), UPRIGHT)
    assert buffer.lookup("a", "b", 2**62).translation[0] == pytest.approx(0.75)


def test_invalid_transforms_are_rejected_with_the_reason(
    buffer: Buffer, lines: list[tuple[int, str]]
) -> None:
    assert not buffer.set("a", "/a", SECOND, HERE, UPRIGHT, "me")
    assert not buffer.set("a", "", SECOND, HERE, UPRIGHT, "me")
    assert not buffer.set("/", "b", SECOND, HERE, UPRIGHT, "me")
    assert not buffer.set("a", "b", SECOND, (1.0, math.nan, 0.0), UPRIGHT, "me")
    assert not buffer.set("a", "c", SECOND, HERE, (0.0, 0.0, 0.0, 0.0), "me")
    assert buffer.frame_names() == []
    assert [text.replace("-nan", "nan") for _, text in lines] == [
        'TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and  child_frame_id "a" because they are the same',
        'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "me" because child_frame_id not set ',
        'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "b"  from authority "me" because frame_id not set',
        'TF_NAN_INPUT: Ignoring transform for child_frame_id "b" from authority "me" because of a nan value in the transform '
        "(1.000000 nan 0.000000) (0.000000 0.000000 0.000000 1.000000)",
        'TF_NAN_INPUT: Ignoring transform for child_frame_id "c" from authority "me" because of a nan value in the transform '
        "(0.000000 0.000000 0.000000) (nan nan nan nan)",
        'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "c" from authority "me" because of an invalid '
        "quaternion in the transform (nan nan nan nan)",
    ]  # fmt: skip
    assert {severity for severity, _ in lines} == {40}


@pytest.mark.parametrize(
    ("given", "stored"),
    [
        ((0, 0, 0, 2), UPRIGHT),
        ((0, 0, 0.6, -0.8), (0, 0, -0.6, 0.8)),
        ((-1, 0, 0, 0), (1, 0, 0, 0)),
        ((0.5, -0.5, 0.5, -0.5), (0.5, -0.5, 0.5, -0.5)),
        ((-0.5, 0.5, -0.5, 0.5), (0.5, -0.5, 0.5, -0.5)),
        ((1e200, 0, 0, 1e200), UPRIGHT),  # its square overflows
    ],
)
def test_stored_quaternions_have_length_one_and_canonical_sign(
    buffer: Buffer, given: tuple, stored: tuple
) -> None:
    assert buffer.set("a", "b", SECOND, HERE, given)
    assert buffer.lookup("a", "b").rotation_xyzw == pytest.approx(stored, abs=1e-15)


def test_old_data_is_rejected_and_its_frames_become_known(
    buffer: Buffer, lines: list[tuple[int, str]]
) -> None:
    buffer.set("a", "b", 100 * SECOND, HERE, UPRIGHT)
    assert buffer.set("a", "b", 90 * SECOND, HERE, UPRIGHT)  # just within
    assert not buffer.set("new", "b", 90 * SECOND - 1, HERE, UPRIGHT, "me")
    assert buffer.has_frame("new")
    assert lines == [
        (
            30,
            "TF_OLD_DATA ignoring data from the past for frame b at time 90.000000 according to authority me\n"
            "Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained",
        )
    ]


def test_flood_of_old_data_logs_one_line(buffer: Buffer, lines: list[tuple[int, str]]) -> None:
    for child in ("b", "c"):
        buffer.set("a", child, 100 * SECOND, HERE, UPRIGHT)
    start = time.monotonic()
    for _ in range(1000):
        buffer.set("a", "b", SECOND, HERE, UPRIGHT)
        buffer.set("a", "c", SECOND, HERE, UPRIGHT)
    elapsed_s = time.monotonic() - start
    assert 2 <= len(lines) <= 2 * (1 + elapsed_s)


def test_pruning_lags_by_one_insert(buffer: Buffer) -> None:
    for stamp in (1, 2, 19):
        buffer.set("a", "b", stamp * SECOND, (float(stamp), 0, 0), UPRIGHT)
    assert buffer.lookup("a", "b", 10 * SECOND).translation[0] == pytest.approx(10)
    buffer.set("a", "b", 20 * SECOND, HERE, UPRIGHT)
    with pytest.raises(errors.BackwardExtrapolationException):
        buffer.lookup("a", "b", 10 * SECOND)


def test_last_insert_determines_whether_a_frame_is_static(buffer: Buffer) -> None:
    buffer.set("a", "b", SECOND, (1, 0, 0), UPRIGHT)
    buffer.set("a", "b", 0, (2, 0, 0), UPRIGHT, static=True)
    assert buffer.lookup("a", "b", 77 * SECOND).translation == (2, 0, 0)
    buffer.clear()
    assert buffer.can("a", "b")
    buffer.set("a", "b", 5 * SECOND, (3, 0, 0), UPRIGHT)
    assert not buffer.can("a", "b", SECOND)
    assert buffer.lookup("a", "b").stamp_ns == 5 * SECOND


@pytest.mark.parametrize(
    ("stamp", "kind", "gap"),
    [
        (SECOND, errors.BackwardExtrapolationException, SECOND),
        (6 * SECOND, errors.ForwardExtrapolationException, 3 * SECOND),
    ],
)
def test_extrapolation_error_has_the_missing_time(buffer: Buffer, stamp: int, kind: type, gap: int) -> None:
    buffer.set("map", "odom", 0, HERE, UPRIGHT, static=True)
    for stored in (2 * SECOND, 3 * SECOND):
        buffer.set("odom", "base", stored, HERE, UPRIGHT)
    with pytest.raises(kind) as raised:
        buffer.lookup("map", "base", stamp)
    error = raised.value
    assert error.frame_id == "base"
    assert (error.requested_ns, error.oldest_ns, error.newest_ns) == (stamp, 2 * SECOND, 3 * SECOND)
    assert error.gap_ns == gap
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), str(again), again.gap_ns) == (kind, str(error), gap)


def chain(buffer: Buffer, links: int) -> None:
    for index in range(links):
        buffer.set(f"f{index}", f"f{index + 1}", SECOND, (1, 0, 0), UPRIGHT)


@pytest.mark.parametrize("stamp", [0, SECOND])
def test_chain_of_a_thousand_links_is_allowed(stamp: int) -> None:
    buffer = Buffer()
    chain(buffer, 1001)
    assert buffer.lookup("f0", "f1000", stamp).translation[0] == pytest.approx(1000)
    assert buffer.lookup("f1000", "f0", stamp).translation[0] == pytest.approx(-1000)
    for pair in (("f0", "f1001"), ("f1001", "f0")):
        with pytest.raises(errors.LookupException, match="The tf tree is invalid because it contains a loop"):
            buffer.lookup(*pair, stamp)


def test_many_frames() -> None:
    buffer = Buffer()
    for index in range(100_000):
        buffer.set("hub", f"spoke{index}", SECOND, (index, 0, 0), UPRIGHT)
    assert len(buffer.frame_names()) == 100_001
    assert buffer.lookup("spoke1", "spoke99999").translation == (99998, 0, 0)


def test_wait_ends_with_the_missing_transform() -> None:
    woken_at: list[float] = []

    def wait() -> None:
        assert buffer.wait("map", "base", timeout_s=30)
        woken_at.append(time.perf_counter())

    delays = []
    for attempt in range(5):
        buffer = Buffer()
        thread = threading.Thread(target=wait)
        thread.start()
        time.sleep(0.02)  # let it begin to wait; the result is the same if it has not
        buffer.set("map", "elsewhere", SECOND, HERE, UPRIGHT)
        sent_at = time.perf_counter()
        buffer.set("map", "base", SECOND, HERE, UPRIGHT)
        thread.join(30)
        delays.append(woken_at[attempt] - sent_at)
    assert min(delays) < 0.005  # polling would find it after 10 ms on average


def test_wait_ends_at_its_timeout_or_at_once_if_hopeless(buffer: Buffer) -> None:
    start = time.monotonic()
    assert not buffer.wait("a", "b", timeout_s=0.05)
    assert time.monotonic() - start >= 0.05
    assert not buffer.wait("a", "/b", timeout_s=30)
    buffer.set("a", "b", 100 * SECOND, HERE, UPRIGHT)
    assert not buffer.wait("a", "b", SECOND, timeout_s=30)
    assert not buffer.wait("b", "a", 50 * SECOND, timeout_s=-1)
    assert time.monotonic() - start < 10


def test_a_signal_ends_a_wait(buffer: Buffer) -> None:
    class StopError(Exception):
        pass

    def stop(*_: object) -> None:
        raise StopError

    before = signal.signal(signal.SIGALRM, stop)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.02)
        with pytest.raises(StopError):
            buffer.wait("a", "b", timeout_s=30)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize("stamps", [list(range(1, 11)), list(range(10, 0, -1))])
def test_request_is_completed_by_the_missing_insert(buffer: Buffer, stamps: list[int]) -> None:
    calls: list[tuple[int, bool]] = []
    wanted = stamps[-1]
    handle = buffer.add_request("a", "b", wanted * SECOND, lambda *call: calls.append(call))
    assert handle == FIRST_HANDLE
    for stamp in stamps:
        assert calls == []
        buffer.set("a", "b", stamp * SECOND, HERE, UPRIGHT)
    assert calls == [(handle, True)]
    assert not buffer.cancel_request(handle)


def test_available_transform_completes_a_request_at_once(buffer: Buffer) -> None:
    def unexpected(*call: object) -> None:
        pytest.fail(f"called with {call}")

    buffer.set("a", "b", 100 * SECOND, HERE, UPRIGHT)
    assert buffer.add_request("a", "a", 5, unexpected) == 0
    assert buffer.add_request("a", "b", 100 * SECOND, unexpected) == 0
    assert buffer.add_request("a", "b", 80 * SECOND, unexpected) is None
    assert buffer.add_request_full("a", 0, "b", 0, "a", unexpected) == 0


def test_request_fails_when_its_time_is_too_old(buffer: Buffer) -> None:
    calls: list[tuple[int, bool]] = []
    handle = buffer.add_request("a", "b", SECOND, lambda *call: calls.append(call))
    buffer.set("a", "b", 100 * SECOND, HERE, UPRIGHT)
    assert calls == [(handle, False)]


def test_request_callback_can_use_the_buffer(buffer: Buffer) -> None:
    calls: list[int] = []

    def again(handle: int, is_available: bool) -> None:
        calls.append(handle)
        if len(calls) < 5:
            buffer.add_request("a", "b", (len(calls) + 1) * SECOND, again)
            buffer.set("a", "b", (len(calls) + 1) * SECOND, HERE, UPRIGHT)

    cancelled = buffer.add_request("a", "b", 2 * SECOND, lambda *_: calls.append(-1))
    buffer.add_request("a", "b", SECOND, again)
    assert buffer.cancel_request(cancelled)
    buffer.set("a", "b", SECOND, HERE, UPRIGHT)
    assert calls == [2, 3, 4, 5, 6]


def test_negative_cache_time_raises() -> None:
    with pytest.raises(ValueError, match="cache_time_ns must not be negative"):
        Buffer(-1)


@pytest.mark.parametrize("beyond", [2**63, -(2**64)])
def test_cache_time_beyond_64_bits_raises(beyond: int) -> None:
    with pytest.raises(ValueError, match="must fit into 64 bits of nanoseconds"):
        Buffer(beyond)


def test_unlimited_and_zero_cache_times() -> None:
    assert Buffer(None).cache_time_ns is None
    keeps_two = Buffer(0)
    for stamp in range(1, 10):
        keeps_two.set("a", "b", stamp, (stamp, 0, 0), UPRIGHT)
    assert [keeps_two.can("a", "b", stamp) for stamp in (7, 8, 9)] == [False, True, True]
