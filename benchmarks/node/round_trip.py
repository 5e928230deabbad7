"""Measure the time of a message to another process and back, and that of a service call, with one of them in flight.

tfloom and the real rclpy run the same programs, `ros_trips.py`. The APIs run in turns, so that other load on the
machine affects all. cyclonedds waits in a waitset on both sides, without callbacks and an executor. It has no services,
so it exchanges two structs.

A percentile is the median of those of the turns: a shared machine may stall for milliseconds, and what happens in one
turn would otherwise be the p99 of all. In a turn of 500 trips, it is the fifth from the top.

Each message carries a number, the answering process counts the messages, and both are checked: what arrives is what was
asked for, and nothing is in flight when a turn begins.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from statistics import median
from typing import Any, NamedTuple

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.ros_spinning import IN_A_THREAD, WAYS, spinning
from benchmarks.node.ros_trips import (
    SIZES,
    TURN_S,
    WAYS_TO_CALL,
    Calls,
    Messages,
    answer_calls,
    answer_messages,
)

WARM_UP = 200
TURNS = 11
SERVICE = "service"
FIRST_CALL = "first call"
"""The first call of a new client, from its creation to the response."""
KINDS = ("String", *SIZES, SERVICE, FIRST_CALL)


def trips_of_a_turn(api: str, kind: str, way: str) -> int:
    """Return how many trips an API makes in a turn."""
    if api == "cyclonedds" and kind in SIZES:  # it copies large arrays element by element
        return {"64 kB": 5}.get(kind, 1)
    # In rclpy 7.1.6 each `spin_until_future_complete` takes longer than the one before.
    if api == "rclpy" and way == "call_async":
        return 30
    return {"64 kB": 200, "1 MB": 20, "8 MB": 20, FIRST_CALL: 100}.get(kind, 500)


MeasureUs = Callable[[int], list[float]]


class Trip(NamedTuple):
    p50_us: float
    p99_us: float
    cpu_us: float
    """CPU time of the answering process, all threads: it receives the message, calls back, and sends the answer."""


class Answered:
    """Counts the questions of an answering process, and reports the count and the CPU time for each line on stdin.

    The process ends when stdin is closed, even if the measuring process was killed.
    """

    def __init__(self) -> None:
        self._count = 0
        threading.Thread(target=self._report, daemon=True).start()

    def __call__(self) -> None:
        self._count += 1

    def _report(self) -> None:
        for _ in sys.stdin:
            print(json.dumps([self._count, time.process_time()]), flush=True)
        os._exit(0)


def ros_answers(api: str, kind: str, way: str) -> None:
    import rclpy

    rclpy.init()
    node = rclpy.create_node("answers", namespace=api)
    answered = Answered()
    if kind in (SERVICE, FIRST_CALL):
        answer_calls(node, answered)
    else:
        answer_messages(node, kind, answered)
    with spinning(way if way in IN_A_THREAD else "spin", node):
        threading.Event().wait()


def ros_asks(api: str, kind: str, way: str) -> None:
    import rclpy

    from benchmarks.node.processes import wait_for

    rclpy.init()
    node = rclpy.create_node("asks", namespace=api)
    if kind in (SERVICE, FIRST_CALL):
        calls = Calls(node, way)
        wait_for(calls.is_matched)
        calls.call_until_answered()
        with spinning("spin", node) if way == "call" else contextlib.nullcontext():
            serve(calls.measure if kind == SERVICE else calls.measure_first)
        return
    messages = Messages(node, kind)
    wait_for(messages.is_matched)
    with spinning("spin" if way == "spin" else "spin_once", node) as wait:
        serve(lambda count: messages.measure(count, wait))


def serve(measure: MeasureUs) -> None:
    """For each number on stdin, print the times of so many trips."""
    print("ready", flush=True)
    for line in sys.stdin:
        print(json.dumps(measure(int(line))), flush=True)


def cyclone_message(kind: str, number: int) -> Any:
    from benchmarks.node import cyclone_types

    if kind == SERVICE:
        return cyclone_types.Request(1, 2, number, 1)
    if kind == "String":
        return cyclone_types.String(data=f"Hello World: {number}")
    return cyclone_types.Bytes(number, list(range(256)) * (SIZES[kind] // 256))


def cyclone_answer(question: Any) -> Any:
    from benchmarks.node import cyclone_types

    if isinstance(question, cyclone_types.Request):
        return cyclone_types.Response(question.client, question.number, question.a + question.b)
    return question


def cyclonedds_ends(there: str, there_type: type, back: str, back_type: type) -> tuple[Any, Any]:
    from cyclonedds.domain import DomainParticipant

    from benchmarks.node.processes import cyclone_reader, cyclone_writer, wait_for

    participant = DomainParticipant(DOMAIN_ID)
    writer = cyclone_writer(participant, there, there_type)
    reader, receive = cyclone_reader(participant, back, back_type)
    wait_for(lambda: writer.get_matched_subscriptions() and reader.get_matched_publications())
    return writer, receive


def cyclonedds_answers(kind: str) -> None:
    example = cyclone_message(kind, 0)
    writer, receive = cyclonedds_ends("dds_back", type(cyclone_answer(example)), "dds_there", type(example))
    answered = Answered()
    while True:
        question = receive(1)[0]
        answered()
        writer.write(cyclone_answer(question))


def cyclonedds_asks(kind: str) -> None:
    example = cyclone_message(kind, 0)
    writer, receive = cyclonedds_ends("dds_there", type(example), "dds_back", type(cyclone_answer(example)))
    number = 0

    def measure(count: int) -> list[float]:
        nonlocal number
        times: list[float] = []
        end = time.monotonic() + TURN_S
        while len(times) < count and (not times or time.monotonic() < end):
            number += 1
            message = cyclone_message(kind, number)
            start = time.perf_counter_ns()
            writer.write(message)
            answers = receive(10)
            times.append((time.perf_counter_ns() - start) / 1e3)
            if answers != [cyclone_answer(message)]:
                raise ValueError(f"question {number} got another answer, or {len(answers)} answers")
        return times

    serve(measure)


class Pair:
    """An answering process and an asking process of an API."""

    def __init__(self, api: str, kind: str, way: str, stack: contextlib.ExitStack) -> None:
        from benchmarks.node.processes import background

        self.answering = stack.enter_context(background("round_trip", "answer", api, kind, way, api=api))
        self.asking = stack.enter_context(background("round_trip", "ask", api, kind, way, api=api))
        self.count = trips_of_a_turn(api, kind, way)
        self.turns_us: list[list[float]] = []
        """The times of the trips of each turn."""
        self.cpu_us: list[float] = []
        line(self.asking)  # it is ready

    def turn(self, count: int) -> tuple[list[float], float]:
        """Return the times of trips, and the CPU time of one in the answering process [us].

        They are `count` trips, or as many as began within TURN_S.

        Raises:
            RuntimeError: more or fewer messages were answered than asked.
        """
        count_before, cpu_before_s = self._status()
        times: list[float] = json.loads(line(self.asking, count))
        answered, cpu_s = self._status()
        if answered - count_before != len(times):
            raise RuntimeError(f"{answered - count_before} messages were answered for {len(times)} trips")
        return times, (cpu_s - cpu_before_s) / len(times) * 1e6

    def measure(self) -> None:
        times_us, cpu_us = self.turn(self.count)
        self.turns_us.append(times_us)
        self.cpu_us.append(cpu_us)

    def trip(self) -> Trip:
        """Return the figures of all turns."""
        percentiles = (median(percentile(turn, percent) for turn in self.turns_us) for percent in (50, 99))
        return Trip(*percentiles, min(self.cpu_us))

    def _status(self) -> tuple[int, float]:
        count, cpu_s = json.loads(line(self.answering, ""))
        return count, cpu_s


def line(process: subprocess.Popen[str], question: object = None) -> str:
    """Write a line to a process, if any, and return its next line."""
    assert process.stdin is not None
    assert process.stdout is not None
    if question is not None:
        process.stdin.write(f"{question}\n")
        process.stdin.flush()
    answer = process.stdout.readline()
    if not answer:
        raise RuntimeError(f"a process of the round trip ended with {process.wait()}")
    return answer


def measure(kind: str, way: str, apis: tuple[str, ...]) -> dict[str, Trip]:
    """Return the trips of each API.

    Args:
        kind: One of KINDS.
        way: One of WAYS; for a service call, one of WAYS_TO_CALL; for FIRST_CALL "call".
        apis: Of `processes.apis`.
    """
    with contextlib.ExitStack() as stack:
        pairs = {api: Pair(api, kind, way, stack) for api in apis}
        for pair in pairs.values():
            pair.turn(min(WARM_UP, pair.count))
        for _ in range(TURNS):
            for pair in pairs.values():
                pair.measure()
    return {api: pair.trip() for api, pair in pairs.items()}


def percentile(values: list[float], percent: int) -> float:
    return sorted(values)[len(values) * percent // 100]


def main() -> None:
    role, api, kind, way = sys.argv[1:]
    assert way in (WAYS_TO_CALL if kind in (SERVICE, FIRST_CALL) else WAYS)
    if api == "cyclonedds":
        {"answer": cyclonedds_answers, "ask": cyclonedds_asks}[role](kind)
    else:
        {"answer": ros_answers, "ask": ros_asks}[role](api, kind, way)


if __name__ == "__main__":
    main()
