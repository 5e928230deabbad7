"""Measure the time of a message to another process and back, with callbacks on both sides, and that of a service call.

The two APIs run in turns, so that other load on the machine affects both. cyclonedds waits in a waitset on both sides,
without callbacks and an executor. It has no services, so it exchanges two structs.
"""

from __future__ import annotations

import contextlib
import json
import sys
import time
from collections.abc import Callable
from typing import Any

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.messages import SIZES, TEXT, octets
from benchmarks.node.processes import (
    APIS,
    background,
    cyclone_reader,
    cyclone_writer,
    wait_for,
)

WARM_UP = 200
TURNS = 5
TRIPS = {"String": (1000, 1000), "64 kB": (300, 5), "1 MB": (40, 1), "service": (500, 500)}
"""Trips of a turn: tfloom's, and cyclonedds', which copies large arrays element by element."""

MeasureUs = Callable[[int], list[float]]


def tfloom_node(name: str) -> Any:
    import rclpy

    rclpy.init()
    return rclpy.create_node(name)


def tfloom_answers(kind: str) -> None:
    import rclpy

    node = tfloom_node("answers")
    if kind == "service":
        from example_interfaces.srv import AddTwoInts

        def add(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
            response.sum = request.a + request.b
            return response

        node.create_service(AddTwoInts, "bench_add", add)
    else:
        message_type = type(tfloom_message(kind))
        publisher = node.create_publisher(message_type, "bench_back", 10)
        node.create_subscription(message_type, "bench_there", publisher.publish, 10)
    rclpy.spin(node)


def tfloom_message(kind: str) -> Any:
    from std_msgs.msg import String

    return String(data=TEXT) if kind == "String" else octets(SIZES[kind])


def tfloom_asks(kind: str) -> MeasureUs:
    node = tfloom_node("asks")
    return tfloom_calls(node) if kind == "service" else tfloom_sends(node, tfloom_message(kind))


def tfloom_sends(node: Any, message: Any) -> MeasureUs:
    from rclpy.executors import SingleThreadedExecutor

    executor = SingleThreadedExecutor()
    executor.add_node(node)
    publisher = node.create_publisher(type(message), "bench_there", 10)
    times: list[float] = []
    start = 0

    def ask() -> None:
        nonlocal start
        start = time.perf_counter_ns()
        publisher.publish(message)

    def on_answer(_: Any) -> None:
        times.append((time.perf_counter_ns() - start) / 1e3)
        ask()

    subscription = node.create_subscription(type(message), "bench_back", on_answer, 10)
    wait_for(lambda: publisher.get_subscription_count() and subscription.get_publisher_count())

    def measure(count: int) -> list[float]:
        times.clear()
        ask()
        while len(times) < count:
            executor.spin_once()
        executor.spin_once(timeout_sec=1.0)  # the reply to the last message sent
        return times[:count]

    return measure


def tfloom_calls(node: Any) -> MeasureUs:
    import rclpy
    from example_interfaces.srv import AddTwoInts

    client = node.create_client(AddTwoInts, "bench_add")
    if not client.wait_for_service(60.0):
        raise TimeoutError("the service was not discovered")

    def measure(count: int) -> list[float]:
        times = []
        for number in range(count):
            start = time.perf_counter_ns()
            future = client.call_async(AddTwoInts.Request(a=number, b=1))
            rclpy.spin_until_future_complete(node, future)
            times.append((time.perf_counter_ns() - start) / 1e3)
        return times

    return measure


def cyclone_message(kind: str) -> Any:
    from benchmarks.node import cyclone_types

    if kind == "service":
        return cyclone_types.Request(1, 2, 3, 4)
    if kind == "String":
        return cyclone_types.String(data=TEXT)
    return cyclone_types.Bytes(data=bytes(SIZES[kind]))


def cyclonedds_ends(there: str, there_type: type, back: str, back_type: type) -> tuple[Any, Any]:
    from cyclonedds.domain import DomainParticipant

    participant = DomainParticipant(DOMAIN_ID)
    writer = cyclone_writer(participant, there, there_type)
    reader, receive = cyclone_reader(participant, back, back_type)
    wait_for(lambda: writer.get_matched_subscriptions() and reader.get_matched_publications())
    return writer, receive


def cyclonedds_answers(kind: str) -> None:
    from benchmarks.node import cyclone_types

    asked = type(cyclone_message(kind))
    answer = cyclone_types.Response if kind == "service" else asked
    writer, receive = cyclonedds_ends("dds_back", answer, "dds_there", asked)
    while True:
        question = receive(1)[0]
        if kind == "service":
            question = cyclone_types.Response(question.client, question.number, question.a + question.b)
        writer.write(question)


def cyclonedds_asks(kind: str) -> MeasureUs:
    from benchmarks.node import cyclone_types

    message = cyclone_message(kind)
    answer = cyclone_types.Response if kind == "service" else type(message)
    writer, receive = cyclonedds_ends("dds_there", type(message), "dds_back", answer)

    def measure(count: int) -> list[float]:
        times = []
        for _ in range(count):
            start = time.perf_counter_ns()
            writer.write(message)
            receive(1)
            times.append((time.perf_counter_ns() - start) / 1e3)
        return times

    return measure


ANSWERS = {"tfloom": tfloom_answers, "cyclonedds": cyclonedds_answers}
ASKS = {"tfloom": tfloom_asks, "cyclonedds": cyclonedds_asks}


def measure(kind: str) -> dict[str, tuple[float, float]]:
    """Return the median and the 99th percentile of the trips for each API [us]."""
    times: dict[str, list[float]] = {api: [] for api in APIS}
    with contextlib.ExitStack() as stack:
        asking = {}
        for api in APIS:
            stack.enter_context(background("round_trip", "answer", api, kind))
            asking[api] = stack.enter_context(background("round_trip", "ask", api, kind))

        def ask(api: str, count: int) -> list[float]:
            asks, answers = asking[api].stdin, asking[api].stdout
            assert asks is not None
            assert answers is not None
            asks.write(f"{count}\n")
            asks.flush()
            return json.loads(answers.readline())

        counts = dict(zip(APIS, TRIPS[kind], strict=True))
        for api, count in counts.items():
            ask(api, min(WARM_UP, count))
        for _ in range(TURNS):
            for api, count in counts.items():
                times[api] += ask(api, count)
    return {api: (percentile(values, 50), percentile(values, 99)) for api, values in times.items()}


def percentile(values: list[float], percent: int) -> float:
    return sorted(values)[len(values) * percent // 100]


def main() -> None:
    role, api, kind = sys.argv[1:]
    if role == "answer":
        ANSWERS[api](kind)
        return
    trips = ASKS[api](kind)
    for line in sys.stdin:
        print(json.dumps(trips(int(line))), flush=True)


if __name__ == "__main__":
    main()
