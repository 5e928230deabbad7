"""The messages of one topic: what is kept, what is dropped, and what readers get."""

from __future__ import annotations

from itertools import count
from typing import Any

import pytest

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import PoseStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.rosidl import cdr
from tfloom.viewer import topic_log
from tfloom.viewer.topic_log import END, Cursor, TopicLog, header_stamp_ns

S = 1_000_000_000


def log_of(length_s: int = 100, **options: Any) -> TopicLog:
    return TopicLog(length_s * S, bytes.decode, **options)


def filled(number: int, length_s: int = 100, **options: Any) -> TopicLog:
    """Return a log of messages of 10 bytes, a second apart."""
    log = log_of(length_s, **options)
    for second in range(1, number + 1):
        log.add(second * S, b"%010d" % second)
    return log


def text_at(log: TopicLog, stamp_ns: int | None) -> str | None:
    entry = log.newest(stamp_ns)
    return None if entry is None else entry.message()


def numbers(cursor: Cursor, **options: Any) -> list[int]:
    return [entry.number for entry in cursor.read(**options)]


# The history, by stamps.


def test_message_of_a_time_is_the_last_one_before_it() -> None:
    log = filled(5)
    assert text_at(log, None) == "0000000005"
    assert text_at(log, 3 * S + 1) == "0000000003"
    assert text_at(log, 3 * S) == "0000000003"
    assert text_at(log, S - 1) is None
    assert len(log) == 5


def test_first_message_of_a_latched_topic_counts_for_the_time_before_it() -> None:
    log = log_of(is_latched=True)
    assert text_at(log, S) is None
    log.add(5 * S, b"map")
    log.add(6 * S, b"new map")
    assert (text_at(log, S), text_at(log, None)) == ("map", "new map")
    assert [entry.from_ns for entry in Cursor(log).read()] == [0, 6 * S]


def test_run_is_of_the_last_messages_by_their_stamps_and_none_of_long_ago() -> None:
    log = filled(20)
    log.add(18 * S + 1, b"late")

    def run(stamp_ns: int, number: int, *length_ns: int) -> list[str]:
        entry = log.newest(stamp_ns)
        assert entry is not None
        return [one.message()[-4:] for one in log.run(entry, number, *length_ns)]

    assert run(19 * S, 3) == ["0018", "late", "0019"]
    assert run(18 * S, 2) == ["0017", "0018"]
    assert run(2 * S, 9) == ["0001", "0002"]
    assert run(12 * S, 20, 5 * S) == ["0007", "0008", "0009", "0010", "0011", "0012"]
    assert len(run(12 * S, 20)) == 12
    log.add(80 * S, b"much later")
    assert run(80 * S, 20) == ["0020", "ater"]
    assert run(12 * S, 1) == ["0012"]


def test_message_that_comes_late_is_put_in_its_place_and_read_by_its_arrival() -> None:
    log = filled(3)
    cursor = log.open()
    log.add(2 * S + 5, b"late")
    log.add(2 * S, b"of the same stamp as an earlier one")
    assert text_at(log, None) == "0000000003"
    assert text_at(log, 3 * S - 1) == "late"
    assert text_at(log, 2 * S) == "of the same stamp as an earlier one"
    assert numbers(cursor) == [0, 1, 2, 3, 4]


def test_old_and_surplus_messages_are_dropped_and_the_newest_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    assert len(filled(20, length_s=5)) == 6
    log = filled(20, max_bytes=45)
    assert (len(log), log.size) == (4, 40)
    log.add(21 * S, bytes(1000))
    assert (len(log), log.size) == (1, 1000)
    monkeypatch.setattr(topic_log, "MAX_ENTRIES", 7)
    assert len(filled(20)) == 7


def test_message_that_counts_at_the_start_of_the_history_is_kept() -> None:
    log = log_of(10)
    for second in (1, 50, 55, 61):
        log.add(second * S, str(second).encode())
    assert text_at(log, 51 * S) == "50"
    log.add(65 * S, b"65")
    assert (text_at(log, 54 * S), text_at(log, 55 * S)) == (None, "55")


# A clock that goes back.


def test_history_begins_anew_with_a_clock_that_went_back_and_readers_get_all() -> None:
    log = filled(20, length_s=5, max_bytes=100)
    cursor = log.open()
    log.add(3 * S, b"again")
    assert (text_at(log, None), len(log), log.size, log.first) == ("again", 1, 5, 20)
    assert text_at(log, 2 * S) is None
    for second in range(4, 8):
        log.add(second * S, bytes(30))
    assert (len(log), log.size, log.first) == (3, 90, 22)  # of the new run alone
    entries = list(cursor.read())
    assert [entry.number for entry in entries] == [*range(14, 25)]
    assert [entry.number for entry in entries if entry.begins_anew] == [20]


def test_clock_that_goes_back_by_the_length_of_the_history_is_only_late() -> None:
    log = filled(20, length_s=5)
    log.add(15 * S, b"late")
    assert (len(log), text_at(log, None), text_at(log, 15 * S)) == (7, "0000000020", "late")
    log.add(15 * S - 1, b"again")
    assert (len(log), text_at(log, None)) == (1, "again")


def test_first_message_of_a_latched_topic_of_another_run_counts_for_the_time_before_it() -> None:
    log = log_of(5, is_latched=True)
    log.add(100 * S, b"old")
    log.add(50 * S, b"new")
    assert (text_at(log, 1 * S), text_at(log, 100 * S)) == ("new", "new")
    assert [entry.from_ns for entry in log.open().read()] == [50 * S]


# Readers.


def test_each_reader_gets_each_message_once_by_its_arrival() -> None:
    log = filled(3)
    first = log.open()
    assert numbers(first) == [0, 1, 2]
    assert numbers(first) == []
    log.add(4 * S, b"a")
    second = log.open()
    assert (numbers(first), numbers(second)) == ([3], [0, 1, 2, 3])
    log.add(5 * S, b"b")
    assert (numbers(second), numbers(first)) == ([4], [4])


def test_reader_that_ends_in_the_middle_goes_on_there() -> None:
    log = filled(5)
    cursor = log.open()
    for entry in cursor.read():
        if entry.number == 2:
            break
    assert numbers(cursor) == [3, 4]
    again = log.open()
    assert (numbers(again, limit_s=-1.0), again.is_behind) == ([0], True)
    assert (numbers(again), again.is_behind) == ([1, 2, 3, 4], False)


def test_messages_are_kept_until_each_reader_has_passed_them() -> None:
    log = filled(3, length_s=2)
    slow, quick = log.open(), log.open()
    for second in range(4, 20):
        log.add(second * S, bytes(10))
        assert numbers(quick)[-1] == second - 1
    assert len(log) == 3
    assert numbers(slow) == list(range(19))
    log.add(20 * S, bytes(10))
    assert numbers(Cursor(log)) == [17, 18, 19]


def test_reader_of_the_history_alone_keeps_nothing() -> None:
    log = filled(3, length_s=2)
    log.open().number = END
    for second in range(4, 20):
        log.add(second * S, bytes(10))
    assert numbers(Cursor(log)) == [16, 17, 18]


@pytest.mark.parametrize("by_bytes", [True, False])
def test_reader_that_never_reads_costs_twice_the_limit_and_no_more(
    by_bytes: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not by_bytes:
        monkeypatch.setattr(topic_log, "MAX_ENTRIES", 10)
    log = log_of(5, max_bytes=100 if by_bytes else 10**9)
    cursor = log.open()
    for second in range(1000):
        log.add(second * S, bytes(10))
        assert len(log._entries) <= 20
    assert numbers(cursor) == list(range(980, 1000))


# Second lives.


def test_log_is_left_once_by_its_last_reader_and_read_again() -> None:
    left: list[int] = []
    log = filled(3, length_s=2, on_left=lambda: left.append(1))
    first, second = log.open(), log.open()
    for _ in range(2):  # closed twice is closed
        first.close()
    assert left == []
    second.close()
    second.close()
    assert left == [1]
    for number in range(4, 9):
        log.add(number * S, bytes(10))
    again = log.open()
    assert numbers(again) == [5, 6, 7]  # what nobody waited for was dropped
    again.close()
    assert left == [1, 1]


def test_reader_that_was_closed_reads_what_is_left_and_keeps_nothing() -> None:
    log = filled(3, length_s=2)
    cursor = log.open()
    cursor.close()
    for second in range(4, 9):
        log.add(second * S, bytes(10))
    assert numbers(cursor) == [5, 6, 7]


def test_numbers_of_a_later_log_go_on() -> None:
    numbered = count()
    first = filled(3, numbers=numbered)
    place = Cursor(first)
    assert numbers(place) == [0, 1, 2]
    second = filled(2, numbers=numbered)
    assert numbers(Cursor(second, place.number)) == [3, 4]
    assert second.first == 3


# Stamps in bytes.


def test_stamp_of_a_header_in_bytes() -> None:
    message = PoseStamped(header=Header(stamp=Time(sec=7, nanosec=8), frame_id="map"))
    data = cdr.encode(message)
    assert header_stamp_ns(data) == 7 * S + 8
    assert header_stamp_ns(data[:8]) == 0
    assert header_stamp_ns(b"\0\7" + data[2:]) == 0  # an encapsulation that is none
