"""A node of the soak test of vendors; tfloom and the real rclpy run it: `soak_member.py NAME SLOT LIFE SLOTS`.

It publishes numbered messages and receives those of all members, serves sums and calls the servers of all other slots.
Of each sender and client it remembers the next number, so that its memory does not grow with messages. A line on stdin
is a command: `status` prints what has happened since the last one, as a line `= JSON`; `start` and `stop` begin and end
publishing and calling. It ends with its input.
"""

from __future__ import annotations

import json
import sys
import threading
import time
from contextlib import suppress
from typing import Any

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import String

TOPIC = "soak"
DEPTH = 1000
"""More messages than a sender publishes while its reader is not scheduled."""
PUBLISH_S, CALL_S = 0.05, 0.5
SMALL, LARGE = "x" * 100, "y" * 70_000
LARGE_EVERY = 100
"""One of as many messages is large: of several packets with either vendor."""
ANSWER_S = 30.0
"""The longest wait for an answer [s]: longer than the lease of a process that was killed, 20 s on Fast DDS."""
LATE_S = 10.0
"""The time after which an overtaken message is lost [s]."""
LIVES = 10**6
NUMBERS = 10**12


class Caller:
    """A client of a slot's server: one call after the other."""

    def __init__(self, node: Node, slot: int, key: int, failures: list[dict[str, Any]]) -> None:
        self._slot = slot
        self._key = key
        self._failures = failures
        self._client = node.create_client(AddTwoInts, f"soak_add_{slot}")
        self._number = 0
        self._future: Any = None
        self._start_s = 0.0
        self.answered = 0

    def work(self, may_call: bool) -> None:
        """Examine the call in flight; begin the next one if it has ended."""
        if self._future is not None:
            if self._future.done():
                self._end(self._future)
            elif time.time() - self._start_s > ANSWER_S:
                self._client.remove_pending_request(self._future)
                self._fail("no answer")
            else:
                return
            self._future = None
        if may_call and self._client.service_is_ready():
            self._number += 1
            self._start_s = time.time()
            self._future = self._client.call_async(AddTwoInts.Request(a=self._number, b=self._key))

    @property
    def is_calling(self) -> bool:
        return self._future is not None

    def _end(self, future: Any) -> None:
        if (error := future.exception()) is not None:
            self._fail(type(error).__name__)
        elif future.result().sum != self._slot * NUMBERS + self._number + self._key:
            self._fail(f"answer {future.result().sum}")
        else:
            self.answered += 1

    def _fail(self, how: str) -> None:
        times = {"start_s": self._start_s, "end_s": time.time()}
        self._failures.append({"slot": self._slot, "number": self._number, "how": how, **times})


class Member:
    """The node, and what it has received, served and called."""

    def __init__(self, node: Node, slot: int, life: int, slots: int) -> None:
        self._node = node
        self._key = slot * LIVES + life
        self._slot = slot
        self._is_started = False
        self._sent = 0
        self._received = 0
        self._served = 0
        self._first: dict[str, int] = {}
        self._next: dict[str, int] = {}
        self._next_served: dict[int, int] = {}
        self._faults: list[str] = []
        self._missing: dict[tuple[str, int], float] = {}
        """Messages that later ones have overtaken, each with the time of that [s since epoch]."""
        self._late = 0
        self._failures: list[dict[str, Any]] = []
        profile = QoSProfile(depth=DEPTH)
        self._publisher = node.create_publisher(String, TOPIC, profile)
        node.create_subscription(String, TOPIC, self._on_message, profile)
        node.create_service(AddTwoInts, f"soak_add_{slot}", self._on_call)
        others = [other for other in range(slots) if other != slot]
        self._callers = [Caller(node, other, self._key, self._failures) for other in others]
        node.create_timer(PUBLISH_S, self._publish)
        node.create_timer(CALL_S, self._call)

    def _publish(self) -> None:
        if self._is_started:
            padding = LARGE if self._sent % LARGE_EVERY == LARGE_EVERY // 2 else SMALL
            self._publisher.publish(String(data=f"{self._key} {self._sent} {padding}"))
            self._sent += 1

    def _on_message(self, message: String) -> None:
        sender, text, padding = message.data.split()
        number = int(text)
        self._first.setdefault(sender, number)
        expected = self._next.get(sender, number)
        now_s = time.time()
        # The first message of a sender may have any number, because it may have been sending before this member joined.
        # A gap counts as lost only after LATE_S: what comes in the meantime has been overtaken.
        if number >= expected:
            self._missing |= {(sender, missing): now_s for missing in range(expected, number)}
            self._next[sender] = number + 1
        elif self._missing.pop((sender, number), None) is not None:
            self._late += 1
        else:
            self._faults.append(f"message {number} of {sender} arrived twice")
        if padding != (LARGE if number % LARGE_EVERY == LARGE_EVERY // 2 else SMALL):
            self._faults.append(f"message {number} of {sender} has a changed text")
        self._received += 1

    def _on_call(self, request: Any, response: Any) -> Any:
        if request.a < self._next_served.get(request.b, 0):
            self._faults.append(f"request {request.a} of {request.b} was served twice")
        self._next_served[request.b] = request.a + 1
        self._served += 1
        response.sum = self._slot * NUMBERS + request.a + request.b
        return response

    def _call(self) -> None:
        for caller in self._callers:
            caller.work(self._is_started)

    def start(self) -> None:
        self._is_started = True

    def stop(self) -> None:
        self._is_started = False

    def status(self) -> dict[str, Any]:
        """Return counts, and the faults, lost messages and failed calls since the last status."""
        events = {
            name: _drained(events)
            for name, events in (
                ("faults", self._faults),
                ("failures", self._failures),
            )
        }
        return {
            "sent": self._sent,
            "received": self._received,
            "first": _of_newest(self._first),
            "next": _of_newest(self._next),
            "served": self._served,
            "answered": sum(caller.answered for caller in self._callers),
            "calling": sum(caller.is_calling for caller in self._callers),
            "matched": self._publisher.get_subscription_count(),
            "publishers": self._node.count_publishers(TOPIC),
            "nodes": sorted(self._node.get_node_names()),
            "late": self._late,
            "lost": self._lost(),
            "missing": len(self._missing),
            **events,
        }

    def _lost(self) -> list[dict[str, Any]]:
        """Return the messages that are missing for LATE_S, and forget them."""
        before_s = time.time() - LATE_S
        missing = [(key, at_s) for key, at_s in list(self._missing.items()) if at_s < before_s]
        for key, _ in missing:
            del self._missing[key]
        return [{"sender": key[0], "number": key[1], "at_s": at_s} for key, at_s in missing]


def _of_newest(numbers: dict[str, int]) -> dict[str, int]:
    """Return the numbers of each slot's newest senders, and forget the others, so that memory does not grow."""
    newest: dict[int, int] = {}
    for key in list(numbers):
        slot, life = divmod(int(key), LIVES)
        newest[slot] = max(newest.get(slot, 0), life)
    for key in list(numbers):
        slot, life = divmod(int(key), LIVES)
        # Keep the newest life and the one before it, whose last messages may still arrive.
        if life < newest[slot] - 1:
            del numbers[key]
    return dict(numbers)


def _drained(events: list[Any]) -> list[Any]:
    """Return the events, and remove them, while another thread appends others."""
    drained = events[:]
    del events[: len(drained)]
    return drained


def main() -> None:
    name, slot, life, slots = sys.argv[1], *map(int, sys.argv[2:5])
    rclpy.init(args=[])
    node = Node(name, start_parameter_services=False)
    member = Member(node, slot, life, slots)

    def obey() -> None:
        for line in sys.stdin:
            print("=", json.dumps(getattr(member, line.strip())()), flush=True)
        rclpy.try_shutdown()

    threading.Thread(target=obey, daemon=True).start()
    print("= null", flush=True)
    with suppress(ExternalShutdownException, KeyboardInterrupt):
        rclpy.spin(node)
    node.destroy_node()
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
