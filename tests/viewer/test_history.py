"""The last messages of a topic, in bounded memory."""

from __future__ import annotations

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import PoseStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.rosidl import cdr
from tfloom.viewer.history import Entry, History, header_stamp_ns

S = 1_000_000_000


def filled(count: int, **options: int) -> History:
    history = History(options.pop("length_ns", 100 * S), **options)
    for second in range(1, count + 1):
        history.add(Entry(second * S, bytes(10)))
    return history


def test_message_of_a_time_is_the_last_one_before_it() -> None:
    history = filled(5)
    assert history.newest(None) == Entry(5 * S, bytes(10))
    assert history.newest(3 * S + 1) == Entry(3 * S, bytes(10))
    assert history.newest(3 * S) == Entry(3 * S, bytes(10))
    assert history.newest(S - 1) is None
    assert [entry.stamp_ns for entry in history.until(2 * S)] == [S, 2 * S]
    assert len(history.until(None)) == 5


def test_first_message_of_a_latched_topic_counts_for_the_time_before_it() -> None:
    history = History(100 * S, is_latched=True)
    assert history.newest(S) is None
    history.add(Entry(5 * S, b"map"))
    history.add(Entry(6 * S, b"new map"))
    assert history.newest(S) == Entry(5 * S, b"map")
    assert history.newest(None) == Entry(6 * S, b"new map")


def test_message_that_comes_late_is_put_in_its_place() -> None:
    history = filled(3)
    history.add(Entry(2 * S + 5, b"late"))
    assert history.newest(None).stamp_ns == 3 * S
    assert history.newest(3 * S - 1) == Entry(2 * S + 5, b"late")


def test_old_and_surplus_messages_are_dropped_and_the_newest_stays() -> None:
    assert len(filled(20, length_ns=5 * S)) == 6
    history = filled(20, max_bytes=45)
    assert (len(history), history.size) == (4, 40)
    history.add(Entry(21 * S, bytes(1000)))
    assert (len(history), history.size) == (1, 1000)


def test_clock_that_went_back_begins_anew() -> None:
    history = filled(20, length_ns=5 * S)
    history.add(Entry(3 * S, b"again"))
    assert history.newest(None) == Entry(3 * S, b"again")
    assert len(history) == 1


def test_stamp_of_a_header_in_bytes() -> None:
    message = PoseStamped(header=Header(stamp=Time(sec=7, nanosec=8), frame_id="map"))
    data = cdr.encode(message)
    assert header_stamp_ns(data) == 7 * S + 8
    assert header_stamp_ns(data[:8]) == 0
    assert header_stamp_ns(b"\0\7" + data[2:]) == 0  # an encapsulation that is none
