"""Round trip of a small String between two processes: nodes with callbacks, and cyclonedds' own Python API.

The two take turns, so that whatever else the machine does hits both. cyclonedds waits in a waitset on both sides and
has no callbacks or executor to pay for.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from statistics import median

from tfloom.rmw.cyclone_config import configuration

DOMAIN_ID = 99
WARM_UP = 200
ROUND_TRIPS = 1000
TURNS = 5
TEXT = "Hello World: 0"

MeasureUs = Callable[[int], list[float]]


def wait_for(condition: Callable[[], object]) -> None:
    while not condition():
        time.sleep(0.005)


def node_answers() -> None:
    import rclpy
    from std_msgs.msg import String

    rclpy.init(domain_id=DOMAIN_ID)
    node = rclpy.create_node("answers")
    publisher = node.create_publisher(String, "node_back", 10)
    node.create_subscription(String, "node_there", publisher.publish, 10)
    rclpy.spin(node)


def node_asks() -> MeasureUs:
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from std_msgs.msg import String

    rclpy.init(domain_id=DOMAIN_ID, signal_handler_options=rclpy.SignalHandlerOptions.NO)
    node = rclpy.create_node("asks")
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    publisher = node.create_publisher(String, "node_there", 10)
    times: list[float] = []
    start = 0

    def ask() -> None:
        nonlocal start
        start = time.perf_counter_ns()
        publisher.publish(String(data=TEXT))

    def on_answer(_: String) -> None:
        times.append((time.perf_counter_ns() - start) / 1e3)
        ask()

    subscription = node.create_subscription(String, "node_back", on_answer, 10)
    wait_for(lambda: publisher.get_subscription_count() and subscription.get_publisher_count())

    def measure(count: int) -> list[float]:
        times.clear()
        ask()
        while len(times) < count:
            executor.spin_once()
        executor.spin_once(timeout_sec=1.0)  # one answer is still on its way
        return times[:count]

    return measure


def cyclonedds_ends(there: str, back: str) -> tuple[Callable[[str], None], Callable[[], str]]:
    from cyclonedds.core import ReadCondition, SampleState, WaitSet
    from cyclonedds.domain import DomainParticipant
    from cyclonedds.pub import DataWriter
    from cyclonedds.qos import Policy, Qos
    from cyclonedds.sub import DataReader
    from cyclonedds.topic import Topic

    from benchmarks.node.string_type import String

    qos = Qos(Policy.Reliability.Reliable(2**63 - 1), Policy.History.KeepLast(10))
    participant = DomainParticipant(DOMAIN_ID)
    writer = DataWriter(participant, Topic(participant, there, String), qos=qos)
    reader = DataReader(participant, Topic(participant, back, String), qos=qos)
    waitset = WaitSet(participant)
    waitset.attach(ReadCondition(reader, SampleState.NotRead))

    def receive() -> str:
        while not (samples := reader.take(1)):
            waitset.wait(1_000_000_000)
        return str(samples[0].data)

    wait_for(lambda: writer.get_matched_subscriptions() and reader.get_matched_publications())
    return lambda text: writer.write(String(data=text)), receive


def cyclonedds_answers() -> None:
    send, receive = cyclonedds_ends("dds_back", "dds_there")
    while True:
        send(receive())


def cyclonedds_asks() -> MeasureUs:
    send, receive = cyclonedds_ends("dds_there", "dds_back")

    def measure(count: int) -> list[float]:
        times = []
        for _ in range(count):
            start = time.perf_counter_ns()
            send(TEXT)
            receive()
            times.append((time.perf_counter_ns() - start) / 1e3)
        return times

    return measure


ANSWERS = {"node": node_answers, "cyclonedds": cyclonedds_answers}
ASKS = {"node": node_asks, "cyclonedds": cyclonedds_asks}


def main() -> None:
    os.environ["CYCLONEDDS_URI"] = configuration()
    command = [sys.executable, "-m", "benchmarks.node.round_trip"]
    partners = [subprocess.Popen([*command, name]) for name in ANSWERS]
    try:
        measure = {name: ask() for name, ask in ASKS.items()}
        for each in measure.values():
            each(WARM_UP)
        times: dict[str, list[float]] = {name: [] for name in measure}
        for _ in range(TURNS):
            for name, each in measure.items():
                times[name] += each(ROUND_TRIPS)
    finally:
        for partner in partners:
            partner.kill()
            partner.wait()
    print(f"round trip of a String, {len(times['node'])} trips each [us]")
    p50 = {name: median(values) for name, values in times.items()}
    p99 = {name: sorted(values)[len(values) * 99 // 100] for name, values in times.items()}
    for name in times:
        print(f"  {name:12} p50 {p50[name]:7.1f}   p99 {p99[name]:7.1f}")
    print(
        f"  cyclonedds / node: p50 {p50['cyclonedds'] / p50['node']:.1f}, p99 {p99['cyclonedds'] / p99['node']:.1f}"
    )


if __name__ == "__main__":
    if len(sys.argv) > 1:
        ANSWERS[sys.argv[1]]()
    else:
        main()
