"""The measurements of receivers, listeners and timers notice what did not arrive, or arrived otherwise."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest
from benchmarks.node.listener import Counted, compile_bare_reader
from benchmarks.node.messages import NUMBER_AT, numbered, tf_message
from benchmarks.node.receiving import COUNTS, Heard
from benchmarks.node.sender import number_at, stamp_ns, x_of
from benchmarks.node.timers import Kept, best
from builtin_interfaces.msg import Time
from rclpy.serialization import deserialize_message, serialize_message
from tf2_msgs.msg import TFMessage


@pytest.mark.parametrize("kind", COUNTS)
def test_the_number_of_a_message_is_where_the_sender_writes_it(kind: str) -> None:
    numbers = numbered(kind)
    data = bytearray(serialize_message(numbers.message(0)))
    struct.pack_into("<i", data, NUMBER_AT, 70_000)
    message = deserialize_message(bytes(data), numbers.type)
    assert numbers.number(message) == 70_000
    assert message == numbers.message(70_000)


def test_all_messages_are_counted_and_some_are_kept() -> None:
    heard = Heard(10)
    assert [heard(f"message {number}", number) for number in range(1, 11)] == [False] * 9 + [True]
    assert heard.kept == [f"message {number}" for number in (2, 4, 6, 8, 10)]
    assert heard.received is not None


@pytest.mark.parametrize("numbers", [[2], [1, 1], [1, 3]])
def test_a_message_that_is_missing_or_doubled_is_noticed(numbers: list[int]) -> None:
    heard = Heard(10)
    for number in numbers[:-1]:
        heard(None, number)
    with pytest.raises(ValueError, match=f"message {numbers[-1]} arrived as the"):
        heard(None, numbers[-1])


@pytest.mark.parametrize("rate_hz", [7, 100, 1000, 3333])
def test_a_stamp_gives_the_number_of_its_message(rate_hz: int) -> None:
    for number in (0, 1, 2, 999, 123_457):
        assert number_at(stamp_ns(number, rate_hz), rate_hz) == number


def paced_message(number: int, rate_hz: int) -> TFMessage:
    message = tf_message(3)
    seconds, nanoseconds = divmod(stamp_ns(number, rate_hz), 1_000_000_000)
    for transform in message.transforms:
        transform.header.stamp = Time(sec=seconds, nanosec=nanoseconds)
        transform.transform.translation.x = x_of(number)
    return message


def test_a_message_of_the_listener_with_other_content_is_noticed() -> None:
    counted = Counted(3, 100)
    message = paced_message(41, 100)
    counted(message)
    assert (counted.count, counted.number()) == (1, 41)
    message.transforms[2].transform.translation.x = x_of(42)
    with pytest.raises(ValueError, match="other content"):
        counted.number()


def test_the_turn_of_timers_that_counts_is_complete_if_there_is_one() -> None:
    skipped, costly, complete = (
        Kept(5.0, 0.1, 1.0, 0.5),
        Kept(20.0, 0.1, 1.0, 1.0),
        Kept(10.0, 0.1, 1.0, 0.99),
    )
    assert best([skipped, costly, complete]) == complete
    assert best([skipped, skipped._replace(share=0.7)]).share == 0.7


@pytest.mark.slow
def test_the_reader_in_cpp_compiles(tmp_path: Path) -> None:
    program = compile_bare_reader(str(tmp_path), "-O0")
    if program is None:
        pytest.skip("there is no compiler")
    assert Path(program).stat().st_size
