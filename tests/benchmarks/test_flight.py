"""The round trip of the benchmarks has one message in flight, and a second one is noticed."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from typing import Any

import pytest
import rclpy
from benchmarks.node.flight import Flight, FlightError
from benchmarks.node.ros_spinning import WAYS, spinning
from benchmarks.node.ros_trips import WAYS_TO_CALL, Calls, Messages, answer_calls, answer_messages
from std_msgs.msg import String

TRIPS = 20


class Echo:
    """An answering node that spins in a thread, and counts the questions."""

    def __init__(self) -> None:
        self.node = rclpy.create_node("answers")
        self.answered = 0

    def count(self) -> None:
        self.answered += 1


@pytest.fixture
def echo(monkeypatch: pytest.MonkeyPatch) -> Iterator[Echo]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    with rclpy.init(domain_id=0):
        echo = Echo()
        with spinning("spin", echo.node):
            yield echo


@pytest.mark.parametrize("way", WAYS)
def test_each_question_is_answered_before_the_next(echo: Echo, way: str) -> None:
    answer_messages(echo.node, "String", echo.count)
    node = rclpy.create_node("asks")
    messages = Messages(node, "String")
    with spinning(way, node) as wait:
        assert len(messages.measure(TRIPS, wait)) == TRIPS
        assert echo.answered == TRIPS
        assert len(messages.measure(TRIPS, wait)) == TRIPS
    assert echo.answered == 2 * TRIPS


def test_a_turn_ends_on_a_machine_that_is_too_busy_for_all_its_trips(echo: Echo) -> None:
    turn_s = 0.2

    def answer_late(message: Any) -> None:
        time.sleep(turn_s / 4)
        publisher.publish(message)

    publisher = echo.node.create_publisher(String, "bench_back", 10)
    echo.node.create_subscription(String, "bench_there", answer_late, 10)
    node = rclpy.create_node("asks")
    messages = Messages(node, "String")
    with spinning("spin_once", node) as wait:
        assert 1 <= len(messages.measure(TRIPS, wait, turn_s)) <= 4
        assert len(messages.measure(TRIPS, wait, 0.0)) == 1


def test_a_question_is_counted_before_its_answer_arrives(echo: Echo) -> None:
    counts: list[int] = []

    def count_late() -> None:
        time.sleep(0.02)
        echo.count()

    answer_messages(echo.node, "String", count_late)
    node = rclpy.create_node("asks")
    messages = Messages(node, "String")
    with spinning("spin_once", node) as wait:
        for _ in range(3):
            messages.measure(1, wait)
            counts.append(echo.answered)
    assert counts == [1, 2, 3]


def test_a_second_answer_to_a_question_is_noticed(echo: Echo) -> None:
    answer_messages(echo.node, "String", echo.count)
    answer_messages(echo.node, "String", echo.count)
    node = rclpy.create_node("asks")
    messages = Messages(node, "String")
    with spinning("spin_once", node) as wait, pytest.raises(FlightError, match="message 1 arrived while"):
        messages.measure(TRIPS, wait)


def test_a_message_left_over_from_an_earlier_turn_is_noticed(echo: Echo) -> None:
    answer_messages(echo.node, "String", echo.count)
    node = rclpy.create_node("asks")
    messages = Messages(node, "String")
    with spinning("spin_once", node) as wait:
        messages.measure(TRIPS, wait)
        node.create_publisher(String, "bench_there", 10).publish(String(data=f"Hello World: {TRIPS + 1}"))
        with pytest.raises(FlightError, match=f"message {TRIPS + 1} arrived while none was in flight"):
            messages.measure(TRIPS, wait)


def test_an_answer_with_other_content_is_noticed(echo: Echo) -> None:
    def answer_wrongly(message: Any) -> None:
        message.data[-1] ^= 1
        publisher.publish(message)

    node = rclpy.create_node("asks")
    messages = Messages(node, "64 kB")
    message_type = messages._content.type
    publisher = echo.node.create_publisher(message_type, "bench_back", 10)
    echo.node.create_subscription(message_type, "bench_there", answer_wrongly, 10)
    with spinning("spin_once", node) as wait, pytest.raises(ValueError, match="other octets"):
        messages.measure(1, wait)


@pytest.mark.parametrize("way", WAYS_TO_CALL)
def test_each_call_has_its_own_answer(echo: Echo, way: str) -> None:
    answer_calls(echo.node, echo.count)
    node = rclpy.create_node("asks")
    calls = Calls(node, way)
    with spinning("spin", node) if way == "call" else spinning("spin_once"):
        assert len(calls.measure(TRIPS)) == TRIPS
    assert echo.answered == TRIPS


def test_a_wrong_answer_to_a_call_is_noticed(echo: Echo) -> None:
    from example_interfaces.srv import AddTwoInts

    def add_wrongly(request: Any, response: Any) -> Any:
        response.sum = request.a
        return response

    echo.node.create_service(AddTwoInts, "bench_add", add_wrongly)
    with pytest.raises(ValueError, match="1 \\+ 1 was answered with"):
        Calls(rclpy.create_node("asks"), "call_async").measure(1)


@pytest.mark.parametrize(
    ("arrivals", "fault"),
    [
        ([2], "message 2 arrived while 1 was in flight"),
        ([1, 1], "message 1 arrived while none was in flight"),
    ],
)
def test_a_flight_reports_an_arrival_out_of_turn(arrivals: list[int], fault: str) -> None:
    flight = Flight()
    flight.depart()
    for number in arrivals:
        flight.arrive(number, 0)
    with pytest.raises(FlightError, match=fault):
        flight.check()
    with pytest.raises(FlightError, match=fault):
        flight.depart()


def test_no_message_departs_while_one_is_in_flight() -> None:
    flight = Flight()
    flight.depart()
    with pytest.raises(FlightError, match="message 2 departs while 1 is in flight"):
        flight.depart()


@pytest.mark.parametrize("way", WAYS)
def test_a_wait_ends_without_its_event(echo: Echo, way: str) -> None:
    with spinning(way, rclpy.create_node("idle")) as wait:
        assert not wait(threading.Event(), 0.01)
