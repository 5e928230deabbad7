"""Displays to which all messages matter: none is lost, and one time has one picture, however it is reached."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator
from contextlib import closing
from functools import lru_cache
from itertools import count
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from tests.viewer.messages import header, marker

from tfloom.bag.opening import open_bag
from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.interfaces.builtin_interfaces.msg import Duration
from tfloom.interfaces.visualization_msgs.msg import Marker, MarkerArray
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.viewer import recorded, replay, topic_log
from tfloom.viewer.displays.kinds import kind_of
from tfloom.viewer.displays.markers import MarkerDisplay
from tfloom.viewer.displays.settings import MARKER_SETTINGS, usual_values
from tfloom.viewer.feed import Feed
from tfloom.viewer.recorded import RecordedLog, RecordedTopics
from tfloom.viewer.topic_log import Cursor, TopicLog

S = 1_000_000_000
TYPE = "visualization_msgs/msg/Marker"


def cube(number: int, action: int = Marker.ADD, lifetime_s: int = 0, x: float = 0.0) -> bytes:
    made = marker(Marker.CUBE, number, header=header("map"), action=action, lifetime=Duration(sec=lifetime_s))
    made.pose.position.x = x
    return cdr.encode(made)


@lru_cache
def decode(data: bytes) -> Any:
    return cdr.decode(Marker, data)


def log_of(length_s: int = 60, **options: Any) -> TopicLog:
    return TopicLog(length_s * S, options.pop("decode", decode), **options)


class Came(NamedTuple):
    """A message that was published."""

    stamp_ns: int
    data: bytes


class Shown:
    """What a feed of markers shows."""

    def __init__(self, cursor: Cursor) -> None:
        kind = kind_of("/m", TYPE)
        assert kind is not None
        self.feed = Feed("/m", kind, cursor)
        self.buffer = Buffer()
        self.buffer.set_log_callback(None)

    def at(self, held_ns: int | None, now_ns: int = 0) -> list[float]:
        """Return the x of each cube at a time."""
        placed = self.feed.draw(self.buffer, "map", held_ns, now_ns if held_ns is None else held_ns)
        return sorted(pose[0][0] for _, pose in placed if pose is not None)


def picture(entries: Iterable[Came], now_ns: int) -> list[float]:
    """Return the x of each cube after some messages."""
    display = MarkerDisplay(usual_values(MARKER_SETTINGS))
    for entry in entries:
        display.take(decode(entry.data), entry.stamp_ns)
    return sorted(placed.position[0] for placed in display.shapes(now_ns))


def random_cube(chance: random.Random, x: float) -> bytes:
    """Return a marker that is added, changed, deleted, or ends; or one that deletes all."""
    action = chance.choices((Marker.ADD, Marker.DELETE, Marker.DELETEALL), (20, 4, 1))[0]
    return cube(chance.randrange(12), action, chance.choice((0, 0, 0, 3)), x)


@pytest.fixture(params=[1, 3, 256])
def state_messages(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """Keep a state after so few messages that tests have many."""
    monkeypatch.setattr(replay, "STATE_MESSAGES", request.param)
    monkeypatch.setattr(replay, "MAX_STATES", 7)
    monkeypatch.setattr(replay, "READ_S", 1000.0)  # beside other work, too
    return request.param


# Live.


def test_markers_of_one_stamp_and_older_ones_are_shown() -> None:
    log = log_of()
    shown = Shown(log.open())
    for number, sec in enumerate((10, 10, 9, 11, 10, 1)):
        log.add(sec * S, cube(number, x=float(number)))
        assert shown.at(None) == [float(other) for other in range(number + 1)]
    assert shown.at(9 * S) == [2.0, 5.0]
    assert shown.at(10 * S) == [0.0, 1.0, 2.0, 4.0, 5.0]
    assert shown.at(None) == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]


def test_marker_beyond_the_history_stays_when_the_time_was_held() -> None:
    log = log_of()
    shown = Shown(log.open())
    log.add(1 * S, cube(0, x=0.0))
    assert shown.at(None) == [0.0]
    log.add(35 * S, cube(1, x=1.0))
    log.add(100 * S, cube(2, x=2.0))
    assert len(log) == 2
    assert shown.at(None) == [0.0, 1.0, 2.0]
    assert shown.at(90 * S) == [0.0, 1.0]
    assert shown.at(None) == [0.0, 1.0, 2.0]
    log.add(101 * S, cube(0, Marker.DELETE))
    assert shown.at(90 * S) == [0.0, 1.0]
    assert shown.at(None) == [1.0, 2.0]


def test_marker_that_is_far_older_than_the_history_is_added_and_takes_none_away() -> None:
    log = log_of()
    shown = Shown(log.open())
    for number in range(5):
        log.add((1000 + number) * S, cube(number, x=float(number)))
    log.add(1 * S, cube(5, x=5.0))  # as of a clock that went back
    assert shown.at(None) == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]
    log.add(1005 * S, cube(6, x=6.0))
    assert shown.at(None) == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]


@pytest.mark.parametrize("seed", range(3))
def test_live_picture_is_that_of_all_messages_by_their_arrival_whatever_was_held(
    seed: int, state_messages: int
) -> None:
    chance = random.Random(seed)
    log = log_of(10**6)
    shown = Shown(log.open())
    came: list[Came] = []
    for number in range(300):
        for _ in range(chance.randrange(3)):
            entry = Came((number + chance.randint(-5, 5) + 10) * S, random_cube(chance, float(number)))
            came.append(entry)
            log.add(*entry)
        held_ns = chance.choice((None, None, chance.randrange(320) * S))
        now_ns = (number + 10) * S
        until = [entry for entry in came if held_ns is None or entry.stamp_ns <= held_ns]
        assert shown.at(held_ns, now_ns) == picture(until, now_ns if held_ns is None else held_ns)


@pytest.mark.parametrize("seed", range(3))
def test_live_picture_is_whole_while_old_messages_are_dropped(
    seed: int, state_messages: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(topic_log, "MAX_ENTRIES", 40)
    chance = random.Random(seed)
    log = log_of(20)
    shown = Shown(log.open())
    came: list[Came] = []
    hold_ns: int | None = None
    for number in range(400):
        entry = Came(number * S // 3, random_cube(chance, float(number)))
        came.append(entry)
        log.add(*entry)
        oldest_ns, newest_ns = log._by_stamp[0].stamp_ns, entry.stamp_ns
        if chance.random() < 0.1:  # the user takes the slider, or lets it go
            hold_ns = chance.choice((None, chance.randint(oldest_ns, newest_ns)))
        held_ns = None if hold_ns is None else max(hold_ns, oldest_ns)
        if chance.random() < 0.7:
            until = [other for other in came if held_ns is None or other.stamp_ns <= held_ns]
            now_ns = newest_ns if held_ns is None else held_ns
            assert shown.at(held_ns, now_ns) == picture(until, now_ns)
    assert len(log._entries) <= 40 + 2 * state_messages + 3
    assert shown.at(None, 10**6 * S) == picture(came, 10**6 * S)


def test_first_message_of_a_latched_topic_counts_for_the_time_before_it() -> None:
    log = log_of(60, is_latched=True)
    shown = Shown(log.open())
    log.add(5 * S, cube(0, x=0.0))
    log.add(6 * S, cube(1, x=1.0))
    assert shown.at(1 * S) == [0.0]
    assert shown.at(6 * S) == [0.0, 1.0]


def test_wrong_message_is_a_sentence_until_the_next_one_and_hides_no_marker() -> None:
    log = log_of()
    shown = Shown(log.open())
    log.add(1 * S, cube(0, x=0.0))
    log.add(2 * S, b"\0\1\0\0")
    assert (shown.at(None), bool(shown.feed.status)) == ([0.0], True)
    assert (shown.at(1 * S), shown.feed.status) == ([0.0], "")
    assert (shown.at(2 * S), bool(shown.feed.status)) == ([0.0], True)
    log.add(3 * S, cube(1, x=1.0))
    assert (shown.at(None), shown.feed.status) == ([0.0, 1.0], "")


def test_unknown_action_is_a_sentence_and_changes_nothing() -> None:
    log = log_of()
    shown = Shown(log.open())
    log.add(1 * S, cube(0, x=0.0))
    log.add(2 * S, cube(0, action=7, x=1.0))
    assert shown.at(None) == [0.0]
    assert "its action is 7" in shown.feed.status


# A second life.


@pytest.mark.parametrize("held_ns", [None, 1 * S])
def test_markers_stay_when_pages_come_back_and_later_messages_change_them(held_ns: int | None) -> None:
    numbers = count()
    first, second = log_of(numbers=numbers), log_of(numbers=numbers)
    shown = Shown(first.open())
    for number in range(3):
        first.add((number + 1) * S, cube(number, x=float(number)))
    shown.at(held_ns)
    shown.feed.close()
    shown.feed.read(second.open())
    assert shown.at(None) == [0.0, 1.0, 2.0]
    first.add(9 * S, cube(8, x=8.0))  # nobody reads that any more
    second.add(10 * S, cube(0, Marker.DELETE))
    second.add(11 * S, cube(5, x=5.0))
    assert shown.at(None) == [1.0, 2.0, 5.0]
    assert shown.at(10 * S) == [1.0, 2.0]
    second.add(12 * S, cube(0, Marker.DELETEALL))
    assert shown.at(None) == []


def test_markers_that_were_forgotten_stay_away_and_later_ones_are_shown() -> None:
    first, second = log_of(), log_of()
    shown = Shown(first.open())
    first.add(1 * S, cube(0, x=0.0))
    assert shown.at(None) == [0.0]
    shown.feed.forget()
    first.add(2 * S, cube(1, x=1.0))
    assert (shown.at(None), shown.feed.status) == ([], "no message at this time")
    shown.feed.read(second.open())
    assert shown.at(None) == []
    second.add(3 * S, cube(2, x=2.0))
    assert (shown.at(None), shown.feed.status) == ([2.0], "")


def test_display_that_fails_misses_none_of_the_messages_that_the_log_drops(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(topic_log, "MAX_ENTRIES", 3)
    log = log_of(decode=decode)
    shown = Shown(log.open())
    log.add(1000 * S, cube(0, x=0.0))
    assert shown.at(None) == [0.0]
    shown.feed.fail(ZeroDivisionError("a fault"))
    for number in range(1, 20):
        log.add((1000 - number) * S, cube(number, x=float(number)))
        shown.at(None)
    log.add(1001 * S, cube(20, x=20.0))
    assert shown.at(None) == [float(number) for number in range(21)]


def test_display_that_is_shown_anew_has_what_another_reader_keeps() -> None:
    log = log_of()
    plot = log.open()
    for number in range(3):
        log.add((number + 1) * S, cube(number, x=float(number)))
    assert len(list(plot.read())) == 3
    shown = Shown(log.open())
    assert shown.at(None) == [0.0, 1.0, 2.0]
    assert shown.at(2 * S) == [0.0, 1.0]


# Recordings.


@pytest.fixture
def record(tmp_path: Path) -> Callable[[list[Came]], Path]:
    def write(entries: list[Came]) -> Path:
        folder = tmp_path / "bag"
        with closing(BagWriter(folder)) as writer:
            number = writer.add_topic(Topic("/m", TYPE))
            other = writer.add_topic(Topic("/other", TYPE))
            for entry in entries:
                writer.push(number, entry.data, entry.stamp_ns, entry.stamp_ns)
                writer.push(other, cube(99), entry.stamp_ns, entry.stamp_ns)
        return folder

    return write


@pytest.mark.parametrize("seed", range(2))
def test_picture_of_a_recording_at_one_time_does_not_depend_on_the_way_there(
    seed: int, state_messages: int, record: Callable[[list[Came]], Path]
) -> None:
    chance = random.Random(seed)
    # Some of one time, and a pause in which nothing comes.
    stamps = sorted(
        100 * S + chance.randrange(400) * S // 4 + (700 * S) * (part // 300) for part in range(700)
    )
    entries = [Came(stamp_ns, random_cube(chance, float(number))) for number, stamp_ns in enumerate(stamps)]
    ways = [
        range(99 * S, 1000 * S, 13 * S),
        range(1000 * S, 99 * S, -31 * S),
        [chance.randrange(90 * S, 1000 * S) for _ in range(30)],
        [chance.choice(stamps) + chance.randint(-1, 1) for _ in range(30)],
        [1000 * S, 99 * S, 500 * S, 1000 * S, stamps[0], stamps[-1]],
    ]
    with open_bag(record(entries)) as bag:
        for way in ways:
            shown = Shown(RecordedTopics(bag).open("/m"))
            for held_ns in way:
                until = [entry for entry in entries if entry.stamp_ns <= held_ns]
                assert shown.at(held_ns) == picture(until, held_ns), (held_ns, list(way)[:5])
            assert shown.at(None, 10**6 * S) == picture(entries, 10**6 * S)


def test_recording_that_pages_come_back_to_shows_its_time_and_nothing_of_before(
    record: Callable[[list[Came]], Path],
) -> None:
    entries = [Came((100 + number) * S, cube(number, x=float(number))) for number in range(5)]
    with open_bag(record(entries)) as bag:
        topics = RecordedTopics(bag)
        shown = Shown(topics.open("/m"))
        assert shown.at(104 * S) == [0.0, 1.0, 2.0, 3.0, 4.0]
        shown.feed.close()
        shown.feed.read(topics.open("/m"))
        assert shown.at(102 * S) == [0.0, 1.0, 2.0]
        assert shown.at(104 * S) == [0.0, 1.0, 2.0, 3.0, 4.0]


def test_many_messages_are_read_over_several_pictures_and_the_page_is_told(
    record: Callable[[list[Came]], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(replay, "READ_S", 0.0)
    entries = [Came((100 + number) * S, cube(number, x=float(number))) for number in range(40)]
    with open_bag(record(entries)) as bag:
        shown = Shown(RecordedTopics(bag).open("/m"))
        counts = []
        while not counts or "more follow" in shown.feed.status:
            counts.append(len(shown.at(139 * S)))
            assert len(counts) < 300
        assert counts == sorted(counts)
        assert len(counts) > 2
        assert counts[-1] == 40
        assert shown.feed.status == ""


def test_playing_a_recording_reads_each_part_once_and_keeps_few_states(
    record: Callable[[list[Came]], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(replay, "STATE_MESSAGES", 2)
    reads: list[int] = []
    read = RecordedLog._read
    monkeypatch.setattr(
        RecordedLog,
        "_read",
        lambda log, number, start, end: (reads.append(start), read(log, number, start, end))[1],
    )
    entries = [Came(100 * S + number * S // 10, cube(number % 7, x=float(number))) for number in range(1000)]
    with open_bag(record(entries)) as bag:
        shown = Shown(RecordedTopics(bag).open("/m"))
        for tick in range(3 * 1000):
            shown.at(100 * S + tick * S // 30)
        assert len(reads) == len(set(reads)) <= recorded.STEPS + 1
        assert len(shown.feed._replay._states) <= replay.MAX_STATES  # type: ignore[union-attr]
        before = len(reads)
        shown.at(150 * S)
        assert len(reads) - before < 20  # from a state near this time


def test_large_parts_of_a_recording_are_read_and_not_kept(
    record: Callable[[list[Came]], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    entries = [Came((100 + number) * S, cube(number, x=float(number))) for number in range(10)]
    with open_bag(record(entries)) as bag:
        for max_bytes, kept in ((1, 0), (1_000_000, 2)):
            monkeypatch.setattr(recorded, "MAX_KEPT_BYTES", max_bytes)
            log = RecordedLog(bag, "/m", lambda data: cdr.decode(Marker, data))
            assert len(list(Cursor(log).read())) == 10
            assert sum(len(part) > 0 for part in log._parts.values()) <= kept
            assert len(log._parts) == 2


def test_array_of_markers_is_taken_in_its_order() -> None:
    log = log_of(decode=lambda data: cdr.decode(MarkerArray, data))
    shown = Shown(log.open())
    markers = [
        decode(cube(0, x=0.0)),
        decode(cube(0, Marker.DELETEALL)),
        decode(cube(1, x=1.0)),
        decode(cube(2, x=2.0)),
    ]
    log.add(1 * S, cdr.encode(MarkerArray(markers=markers)))
    assert shown.at(None) == [1.0, 2.0]
