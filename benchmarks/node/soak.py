"""A soak test: guest processes join and leave repeatedly, and a permanent node must receive all their messages.

`python -m benchmarks.node.soak --seconds 300` is the permanent process. Each guest joins, publishes some hundred
numbered messages on a reliable topic, calls a service of the permanent node, subscribes to a topic of it, and leaves:
alternately by a normal shutdown, and by SIGKILL after all its messages are acknowledged. Every message must be received
once, in order. Two more processes are permanent: a broadcaster of transforms, and a listener that looks them up, and
calls the service.

The resident memory (RSS) of each permanent process is measured. In the steady state, the part of the time after WARM_UP
and WARM_UP_S, it must not grow by more than MAX_GROWTH: the report has its median over the first and the last tenth of
that part, and over each tenth of the whole time. The exit code is 1 if a message was lost, a permanent process ended,
or memory grew by more; in less than MIN_STEADY_S, memory is reported only, because it has not become steady. The last
lines, which are reported only, say what a latched publisher and its subscription leave (`soak_pairs`).
"""

from __future__ import annotations

import argparse
import os
import random
import subprocess
import sys
import threading
import time
from contextlib import suppress
from itertools import count
from typing import Any

import rclpy
from example_interfaces.srv import AddTwoInts
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.qos import HistoryPolicy, QoSProfile
from rclpy.time import Time
from std_msgs.msg import String
from tf2_ros import Buffer, TransformBroadcaster, TransformException, TransformListener

from benchmarks.domain import DOMAIN_ID
from benchmarks.node import soak_pairs
from benchmarks.node.memory import MIN_STEADY_S, Memory

GUESTS = 3
MESSAGES = (200, 1000)
"""The least and the greatest number of messages that a guest publishes."""
PERIOD_S = 0.002
CALL_EVERY = 50
PADDING = "x" * 200
PATIENCE_S = 60.0
FRAMES = 20
PAIRS = 200
RESIDENTS = ("broadcaster", "listener")

ALL = QoSProfile(history=HistoryPolicy.KEEP_ALL)


class Soak:
    """The permanent node, and its record of the messages received.

    `_lock` guards changes of `_next`, which the executor's thread and the guests' threads make.
    """

    def __init__(self, seconds: float, domain_id: int) -> None:
        self._end = time.monotonic() + seconds
        self._seconds = seconds
        self._domain_id = domain_id
        self._lock = threading.Lock()
        self._next: dict[str, int] = {}
        self.faults: list[str] = []
        self.messages = 0
        self.lives = 0
        self.killed = 0
        self.calls = 0
        self.memory = {"stayer": Memory(os.getpid(), seconds)}

    def run(self) -> None:
        """Run until the time is over and the last guests have left."""
        context = rclpy.Context()
        rclpy.init(context=context, domain_id=self._domain_id)
        node = rclpy.create_node("stayer", context=context)
        node.create_subscription(String, "soak", self._on_message, ALL)
        node.create_service(AddTwoInts, "soak_add", self._on_call)
        back = node.create_publisher(String, "soak_back", 10)
        node.create_timer(0.05, lambda: back.publish(String(data=PADDING)))
        node.create_timer(min(1.0, self._seconds / 30), self._note_memory)
        threads = [threading.Thread(target=self._host, args=(number,)) for number in range(GUESTS)]
        residents = {name: subprocess.Popen(self._command(name), stdin=subprocess.PIPE) for name in RESIDENTS}
        self.memory |= {name: Memory(process.pid, self._seconds) for name, process in residents.items()}
        with SingleThreadedExecutor(context=context) as executor:
            executor.add_node(node)
            for thread in threads:
                thread.start()
            # The hosts' threads start processes and wait for them; this one spins the node until the last guest has
            # left.
            while any(thread.is_alive() for thread in threads):
                executor.spin_once(timeout_sec=0.1)
        for name, process in residents.items():
            self._dismiss(name, process)
        node.destroy_node()
        rclpy.shutdown(context=context)

    def _dismiss(self, name: str, process: subprocess.Popen[bytes]) -> None:
        """End a permanent process."""
        if process.poll() is not None:
            self.faults.append(f"the {name} ended with {process.returncode} before the test")
        try:
            process.communicate(b"leave\n", timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        if process.returncode != 0:
            self.faults.append(f"the {name} ended with {process.returncode}")

    def _on_message(self, message: String) -> None:
        guest, number, _ = message.data.split()
        with self._lock:
            # Each guest has a name of its own and begins at 0, so a loss, a repetition and a wrong order all show here.
            expected = self._next.get(guest, 0)
            if int(number) != expected:
                self.faults.append(f"guest {guest} sent {number}, and {expected} was expected")
            self._next[guest] = int(number) + 1
            self.messages += 1

    def _on_call(self, request: Any, response: Any) -> Any:
        self.calls += 1
        response.sum = request.a + request.b
        return response

    def _note_memory(self) -> None:
        progress = 1.0 - (self._end - time.monotonic()) / self._seconds
        for memory in self.memory.values():
            memory.note(progress)

    def _host(self, number: int) -> None:
        """Start one guest after the other."""
        for life in count():
            if time.monotonic() >= self._end or self.faults:
                return
            guest = f"{number}.{life}"
            try:
                self._live(guest, is_killed=life % 2 == 1)
            except Exception as error:  # noqa: BLE001  # any exception is a fault
                self.faults.append(f"guest {guest}: {type(error).__name__}: {error}")

    def _command(self, role: str) -> list[str]:
        own = [sys.executable, "-m", "benchmarks.node.soak"]
        return [*own, "--role", role, "--domain", str(self._domain_id)]

    def _live(self, guest: str, *, is_killed: bool) -> None:
        with subprocess.Popen(
            self._command(guest), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        ) as process:
            # A guest that hangs would block `readline` for ever: the timer kills it, and `readline` returns an empty
            # line.
            watch = threading.Timer(PATIENCE_S, process.kill)
            watch.start()
            try:
                words = process.stdout.readline().split()
                if words[:1] != ["sent"]:
                    raise RuntimeError(f"it ended without having sent all, and said {words}")
                self._check(guest, int(words[1]))
            finally:
                watch.cancel()
                if is_killed or self.faults:
                    process.kill()
            process.communicate("leave\n", timeout=PATIENCE_S)
        self.lives += 1
        self.killed += is_killed
        if not is_killed and process.returncode != 0:
            self.faults.append(f"guest {guest} ended with {process.returncode}")

    def _check(self, guest: str, sent: int) -> None:
        """Wait until the callback has received all messages, which are acknowledged already."""
        end = time.monotonic() + PATIENCE_S
        while self._next.get(guest, 0) < sent:
            if time.monotonic() > end:
                self.faults.append(f"guest {guest} sent {sent}, and {self._next.get(guest, 0)} came")
                return
            time.sleep(0.01)
        with self._lock:
            del self._next[guest]

    def is_sound(self) -> bool:
        """Return whether no message was lost, and no memory grew."""
        is_flat = all(memory.is_flat() for memory in self.memory.values())
        return not self.faults and (is_flat or self._seconds < MIN_STEADY_S)

    def report(self) -> str:
        """Return what to print at the end."""
        lines = [
            (
                f"{self.messages} messages and {self.calls} calls; {self.lives} guests, {self.killed} of them killed; "
                f"{len(self.faults)} faults"
            ),
            *(f"{name}: {memory.report()}" for name, memory in self.memory.items()),
        ]
        return "\n".join(lines)


def be_broadcaster(domain_id: int) -> None:
    """Broadcast a chain of FRAMES frames at 50 Hz until a line on stdin."""
    rclpy.init(domain_id=domain_id)
    node = rclpy.create_node("broadcaster")
    broadcaster = TransformBroadcaster(node)
    transforms = [TransformStamped(child_frame_id=f"frame{number}") for number in range(FRAMES)]
    for number, transform in enumerate(transforms):
        transform.header.frame_id = f"frame{number - 1}" if number else "map"

    def broadcast() -> None:
        stamp = node.get_clock().now().to_msg()
        for transform in transforms:
            transform.header.stamp = stamp
        broadcaster.sendTransform(transforms)

    node.create_timer(0.02, broadcast)
    _spin_until_dismissed(node)


def be_listener(domain_id: int) -> None:
    """Look up the end of the chain and call the service, at 20 Hz, until a line on stdin."""
    rclpy.init(domain_id=domain_id)
    node = rclpy.create_node("listener")
    buffer = Buffer(node=node)
    listener = TransformListener(buffer, node)
    client = node.create_client(AddTwoInts, "soak_add")

    def work() -> None:
        with suppress(TransformException):  # before the first transforms
            buffer.lookup_transform("map", f"frame{FRAMES - 1}", Time())
        if client.service_is_ready():
            client.call_async(AddTwoInts.Request(a=1, b=2))

    node.create_timer(0.05, work)
    _spin_until_dismissed(node)
    del listener


def _spin_until_dismissed(node: Any) -> None:
    dismissed = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.readline(), dismissed.set()), daemon=True).start()
    with suppress(ExternalShutdownException, KeyboardInterrupt):
        while not dismissed.is_set():
            rclpy.spin_once(node, timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()


def be_guest(guest: str, domain_id: int) -> None:
    """Join, publish, call and subscribe; print the number of messages sent, and leave after a line on stdin."""
    rclpy.init(domain_id=domain_id)
    node = rclpy.create_node(f"guest_{guest.partition('.')[0]}")
    heard: list[String] = []
    node.create_subscription(String, "soak_back", heard.append, 10)
    publisher = node.create_publisher(String, "soak", ALL)
    client = node.create_client(AddTwoInts, "soak_add")
    if not client.wait_for_service(timeout_sec=PATIENCE_S / 2):
        raise TimeoutError("the service isn't there")
    while publisher.get_subscription_count() == 0:
        rclpy.spin_once(node, timeout_sec=0.01)
    how_many = random.randint(*MESSAGES)
    for number in range(how_many):
        publisher.publish(String(data=f"{guest} {number} {PADDING}"))
        if number % CALL_EVERY == 0:
            future = client.call_async(AddTwoInts.Request(a=number, b=1))
            rclpy.spin_until_future_complete(node, future, timeout_sec=PATIENCE_S / 2)
            if not future.done() or future.result().sum != number + 1:
                raise RuntimeError(f"call {number} was not answered rightly")
        time.sleep(PERIOD_S)
    if not publisher.wait_for_all_acked(Duration(seconds=PATIENCE_S / 2)):
        raise TimeoutError("not all is acknowledged")
    while not heard:
        rclpy.spin_once(node, timeout_sec=0.1)
    print("sent", how_many, flush=True)
    with suppress(ExternalShutdownException, KeyboardInterrupt):
        sys.stdin.readline()
    node.destroy_node()
    rclpy.shutdown()


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node.soak", description=__doc__)
    parser.add_argument("--seconds", type=float, default=300.0, help="how long guests are let in")
    parser.add_argument("--domain", type=int, default=DOMAIN_ID, help=argparse.SUPPRESS)
    parser.add_argument("--role", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.role in RESIDENTS:
        (be_broadcaster if arguments.role == "broadcaster" else be_listener)(arguments.domain)
        return 0
    if arguments.role is not None:
        be_guest(arguments.role, arguments.domain)
        return 0
    soak = Soak(arguments.seconds, arguments.domain)
    soak.run()
    print(
        "\n".join([*soak.faults[:10], soak.report(), *soak_pairs.reports(PAIRS, arguments.domain)]),
        flush=True,
    )
    return 0 if soak.is_sound() else 1


if __name__ == "__main__":
    sys.exit(main())
