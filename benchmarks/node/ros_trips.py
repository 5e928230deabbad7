"""Trips of a message or a service call there and back, with ROS's names alone: tfloom and rclpy run the same code.

Each message carries a number. The answers are compared with what was sent, outside of the measured time.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

from benchmarks.node.flight import Flight
from benchmarks.node.ros_spinning import MAX_DURATION_S, Wait

SIZES = {"64 kB": 64_000, "1 MB": 1_000_000, "8 MB": 8_000_000}
QUIET_S = 0.02
"""Time in which a surplus message would arrive before a turn."""

TURN_S = 3.0
"""Longest time of a turn, because on a busy machine a trip by rclpy's MultiThreadedExecutor may take 0.1 s."""

WAYS_TO_CALL = ("call_async", "call")
"""`call_async` with `spin_until_future_complete`, or the blocking call."""

Answered = Callable[[], None]


class Content:
    """The message of a kind: its type, and its number."""

    def __init__(self, kind: str) -> None:
        from std_msgs.msg import String, UInt8MultiArray

        self._size = SIZES.get(kind)
        self.type: type = String if self._size is None else UInt8MultiArray
        self._octets = bytes(range(256)) * ((self._size or 0) // 256)
        self._array = UInt8MultiArray(data=self._octets)

    def message(self, number: int) -> Any:
        """Return the message with a number."""
        if self._size is None:
            return self.type(data=f"Hello World: {number}")
        self._array.layout.data_offset = number
        return self._array

    def number(self, message: Any) -> int:
        """Return the number in a message; -1 if it has none."""
        if self._size is None:
            head, _, number = message.data.rpartition(" ")
            return int(number) if head == "Hello World:" and number.isdigit() else -1
        return int(message.layout.data_offset)

    def check(self, message: Any) -> None:
        """Raise ValueError if a message has not the bytes that were sent."""
        if self._size is not None and bytes(message.data) != self._octets:
            raise ValueError("a message returned with other octets than were sent")


def answer_messages(node: Any, kind: str, answered: Answered) -> None:
    """Send each message on `bench_there` back on `bench_back`."""
    message_type = Content(kind).type
    publisher = node.create_publisher(message_type, "bench_back", 10)

    def on_question(message: Any) -> None:
        answered()  # before the answer, because the asking process compares the count after it
        publisher.publish(message)

    node.create_subscription(message_type, "bench_there", on_question, 10)


def answer_calls(node: Any, answered: Answered) -> None:
    """Offer the service `bench_add`."""
    from example_interfaces.srv import AddTwoInts

    def on_request(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        answered()
        return response

    node.create_service(AddTwoInts, "bench_add", on_request)


class Messages:
    """Sends messages to `answer_messages`, one at a time."""

    def __init__(self, node: Any, kind: str) -> None:
        self._content = Content(kind)
        self._flight = Flight()
        self._arrived: Any = None
        message_type = self._content.type
        self._publisher = node.create_publisher(message_type, "bench_there", 10)
        self._subscription = node.create_subscription(message_type, "bench_back", self._on_answer, 10)

    def is_matched(self) -> bool:
        """Return whether the other end is there, in both directions."""
        return bool(self._publisher.get_subscription_count() and self._subscription.get_publisher_count())

    def measure(self, count: int, wait: Wait, turn_s: float = TURN_S) -> list[float]:
        """Return the times of trips [us], from before the publishing to the begin of the callback.

        They are `count` trips, or as many as began within `turn_s` seconds, at least one.

        Raises:
            FlightError: another message arrived than the one in flight.
            TimeoutError: a message did not return.
            ValueError: a message returned with other content.
        """
        flight = self._flight
        wait(threading.Event(), QUIET_S)  # a message that is still on its way would arrive now
        flight.times_us.clear()
        end = time.monotonic() + turn_s
        while len(flight.times_us) < count and (not flight.times_us or time.monotonic() < end):
            number = flight.next_number
            message = self._content.message(number)
            flight.depart()
            self._publisher.publish(message)
            if not wait(flight.landed):
                raise TimeoutError(f"message {number} did not return")
            flight.check()
            self._content.check(self._arrived)
        return flight.times_us[:]

    def _on_answer(self, message: Any) -> None:
        at_ns = time.perf_counter_ns()
        self._arrived = message
        self._flight.arrive(self._content.number(message), at_ns)


class Calls:
    """Calls the service of `answer_calls`, one call at a time.

    Args:
        node: The client's node; for "call" it spins in another thread.
        way: One of WAYS_TO_CALL.
    """

    def __init__(self, node: Any, way: str) -> None:
        from example_interfaces.srv import AddTwoInts

        self._node = node
        self._service, self._request = AddTwoInts, AddTwoInts.Request
        self._last: Any = None
        """The new client of the last first call."""
        self._client = node.create_client(AddTwoInts, "bench_add")
        self._call = self._call_and_wait if way == "call" else self._call_and_spin
        self._number = 0

    def is_matched(self) -> bool:
        """Return whether the service is there."""
        return bool(self._client.service_is_ready())

    def measure(self, count: int) -> list[float]:
        """Return the times of calls [us]: of `count`, or of as many as began within TURN_S, at least one.

        Raises:
                ValueError: a wrong answer, or none.
        """
        return self._times_us(count, self._call)

    def call_until_answered(self) -> None:
        """Call until the first answer, because Fast DDS may lose the calls before both ends have matched."""
        for _ in range(int(MAX_DURATION_S)):
            if self._call_and_spin(self._request(), timeout_s=1.0) is not None:
                return
        raise TimeoutError("no call was answered")

    def measure_first(self, count: int) -> list[float]:
        """Return the times of the first calls of `count` new clients [us], each from its creation to the response.

        They are fewer where TURN_S is over.

        Raises:
                ValueError: a wrong answer, or none.
        """
        return self._times_us(count, self._call_anew, self._destroy_last)

    def _times_us(
        self, count: int, call: Callable[[Any], Any], clean_up: Callable[[], object] = lambda: None
    ) -> list[float]:
        """Return the times of calls, without those of what cleans up behind each."""
        times_us: list[float] = []
        end = time.monotonic() + TURN_S
        while len(times_us) < count and (not times_us or time.monotonic() < end):
            self._number += 1
            request = self._request(a=self._number, b=1)
            start_ns = time.perf_counter_ns()
            response = call(request)
            times_us.append((time.perf_counter_ns() - start_ns) / 1e3)
            clean_up()
            if response is None or response.sum != self._number + 1:
                raise ValueError(f"{self._number} + 1 was answered with {response}")
        return times_us

    def _call_anew(self, request: Any) -> Any:
        self._last = self._node.create_client(self._service, "bench_add")
        self._last.wait_for_service()
        return self._last.call(request, timeout_sec=MAX_DURATION_S)

    def _destroy_last(self) -> None:
        self._node.destroy_client(self._last)

    def _call_and_wait(self, request: Any) -> Any:
        return self._client.call(request, timeout_sec=MAX_DURATION_S)

    def _call_and_spin(self, request: Any, timeout_s: float = MAX_DURATION_S) -> Any:
        import rclpy

        future = self._client.call_async(request)
        rclpy.spin_until_future_complete(self._node, future, timeout_sec=timeout_s)
        return future.result()
