"""A node with services, actions and parameters that JSON lines on stdin control, as `end.py`; a thread spins it.

tfloom and the real rclpy run it unchanged: `service_end.py NAME --ros-args …`.
"""

from __future__ import annotations

import json
import sys
import threading
import time
import traceback
from collections import Counter
from contextlib import suppress
from typing import Any

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts, Trigger
from rclpy.action import ActionClient, ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient

WAIT_S = 20.0
STEP_S = 0.02
"""Time between two steps of a goal."""


class ServiceEnd:
    """The node, its clients and servers by their names."""

    def __init__(self, node: Node) -> None:
        self.node = node
        self._clients: dict[str, Any] = {}
        self._servers: dict[str, Any] = {}
        self._requests: Counter[tuple[int, int]] = Counter()
        self._ended: list[Any] = []
        self._group = ReentrantCallbackGroup()
        self._free = threading.Event()
        self._pending: Any = None

    def add_server(self, name: str, offset: int = 0) -> None:
        """Serve sums, plus an offset that tells who answers."""

        def answer(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
            self._requests[request.a, request.b] += 1
            response.sum = request.a + request.b + offset
            return response

        self._servers[name] = self.node.create_service(AddTwoInts, name, answer)

    def text_server(self, name: str, size: int) -> None:
        """Serve texts of `size` octets."""

        def answer(_: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
            response.success = True
            response.message = "m" * size
            return response

        self._servers[name] = self.node.create_service(Trigger, name, answer)

    def close(self, name: str) -> None:
        self.node.destroy_service(self._servers.pop(name))

    def requests(self, least: int = 0) -> list[int]:
        """Return how many different requests from a number on were served, and how many of these more than once."""
        counts = [count for (number, _), count in self._requests.items() if number >= least]
        return [len(counts), sum(count > 1 for count in counts)]

    def clients(self, name: str, count: int, kind: str = "add") -> float:
        """Create clients, and wait for their servers; return how long that took [s]."""
        start = time.monotonic()
        kinds = {"add": AddTwoInts, "text": Trigger}
        self._clients[name] = [self.node.create_client(kinds[kind], name) for _ in range(count)]
        for client in self._clients[name]:
            assert client.wait_for_service(WAIT_S), f"no server of {name}"
        return time.monotonic() - start

    def call(self, name: str, count: int, at_once: int = 1, base: int = 0) -> dict[str, Any]:
        """Call with each client `count` times, `at_once` in flight; return how many answers had which offset."""
        offsets: Counter[int] = Counter()
        lost: list[int] = []
        slowest_s = 0.0
        clients = self._clients[name]
        numbers = iter(range(base, base + count * len(clients)))
        pending: list[tuple[int, float, Any]] = []
        while True:
            while len(pending) < at_once and (number := next(numbers, None)) is not None:
                request = AddTwoInts.Request(a=number, b=3 * number)
                future = clients[number % len(clients)].call_async(request)
                pending.append((number, time.monotonic(), future))
            if not pending:
                break
            number, start, future = pending.pop(0)
            if not wait(future):
                lost.append(number)
                continue
            slowest_s = max(slowest_s, time.monotonic() - start)
            offsets[future.result().sum - 4 * number] += 1
        return {"offsets": sorted(offsets.items()), "lost": lost, "slowest_s": slowest_s}

    def call_text(self, name: str, count: int) -> list[int]:
        """Call for texts, one after the other; return their sizes."""
        sizes = []
        for _ in range(count):
            future = self._clients[name][0].call_async(Trigger.Request())
            assert wait(future), "no answer"
            assert set(future.result().message) <= {"m"}
            sizes.append(len(future.result().message))
        return sizes

    def call_or_error(self, name: str, timeout_s: float) -> str:
        """Call once; return what became of it: answered, no answer, or the name of an error."""
        future = self._clients[name][0].call_async(AddTwoInts.Request(a=1, b=2))
        if not wait(future, timeout_s):
            return "no answer"
        error = future.exception()
        return type(error).__name__ if error is not None else "answered"

    def occupy(self) -> None:
        """Occupy the group of the clients, so that nothing takes their responses, until `free`."""
        occupied = threading.Event()
        self._free.clear()

        def hold() -> None:
            timer.cancel()
            occupied.set()
            self._free.wait(WAIT_S)

        timer = self.node.create_timer(0.001, hold)
        assert occupied.wait(WAIT_S), "the timer did not expire"

    def call_occupied(self, name: str) -> None:
        """Send a request whose response is taken after `free`."""
        self._pending = self._clients[name][0].call_async(AddTwoInts.Request(a=1, b=2))

    def free(self, timeout_s: float) -> bool:
        """End `occupy`; return whether the response of `call_occupied` arrives in time."""
        self._free.set()
        return wait(self._pending, timeout_s)

    def is_ready(self, name: str) -> bool:
        return self._clients[name][0].service_is_ready()

    def action_server(self, name: str) -> None:
        """Serve Fibonacci's numbers, one after each `STEP_S`, as feedback too."""

        def execute(goal: Any) -> Fibonacci.Result:
            sequence = [0, 1]
            while len(sequence) < goal.request.order:
                if goal.is_cancel_requested:
                    goal.canceled()
                    self._ended.append([goal.request.order, "canceled"])
                    return Fibonacci.Result(sequence=sequence)
                sequence.append(sequence[-1] + sequence[-2])
                goal.publish_feedback(Fibonacci.Feedback(sequence=sequence))
                time.sleep(STEP_S)
            goal.succeed()
            self._ended.append([goal.request.order, "succeeded"])
            return Fibonacci.Result(sequence=sequence)

        self._servers[name] = ActionServer(
            self.node,
            Fibonacci,
            name,
            execute,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=self._group,
        )

    def introspect(self, name: str) -> None:
        """Publish the events of an action server, with contents."""
        from rclpy.qos import qos_profile_system_default
        from rclpy.service_introspection import ServiceIntrospectionState

        self._servers[name].configure_introspection(
            self.node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS
        )

    def ended(self) -> list[Any]:
        """Return the goals that have ended, in order, each with its order and how it ended."""
        return self._ended

    def action_client(self, name: str) -> None:
        client = ActionClient(self.node, Fibonacci, name, callback_group=self._group)
        self._clients[name] = [client]
        assert client.wait_for_server(WAIT_S), f"no server of {name}"

    def send_goal(self, name: str, order: int, cancel: bool = False) -> dict[str, Any]:
        """Send a goal, and cancel it after its first feedback if asked; return what became of it."""
        feedback: list[int] = []
        first = threading.Event()

        def on_feedback(message: Any) -> None:
            feedback.append(len(message.feedback.sequence))
            first.set()

        sent = self._clients[name][0].send_goal_async(Fibonacci.Goal(order=order), on_feedback)
        assert wait(sent), "no answer to the goal"
        goal = sent.result()
        assert goal.accepted
        result = goal.get_result_async()
        canceling = None
        if cancel:
            assert first.wait(WAIT_S), "no feedback"
            canceled = goal.cancel_goal_async()
            assert wait(canceled), "no answer to the cancel request"
            canceling = len(canceled.result().goals_canceling)
        assert wait(result), "no result"
        return {
            "status": result.result().status,
            "sequence": list(result.result().result.sequence),
            "feedback": feedback,
            "canceling": canceling,
        }

    def declare(self, name: str, value: Any) -> None:
        self.node.declare_parameter(name, value)

    def parameter(self, name: str) -> Any:
        return self.node.get_parameter(name).value

    def set_and_get(self, node: str, name: str, value: Any) -> list[Any]:
        """Set a parameter of another node, and get it; return what the node said, and the value."""
        client = AsyncParameterClient(self.node, node)
        assert client.wait_for_services(WAIT_S), f"{node} has no services for parameters"
        result = client.set_parameters([Parameter(name, value=value)])
        assert wait(result), "no answer to set_parameters"
        got = client.get_parameters([name])
        assert wait(got), "no answer to get_parameters"
        return [result.result().results[0].successful, got.result().values[0].integer_value]


def wait(future: Any, timeout_s: float = WAIT_S) -> bool:
    """Wait for a future that the spinning thread ends; return False if it has not ended in time."""
    ended = threading.Event()
    future.add_done_callback(lambda _: ended.set())
    return ended.wait(timeout_s)


def main() -> None:
    rclpy.init(args=sys.argv)
    node = Node(sys.argv[1])
    executor = MultiThreadedExecutor(4)
    executor.add_node(node)
    end = ServiceEnd(node)

    def spin() -> None:
        with suppress(ExternalShutdownException):
            executor.spin()

    thread = threading.Thread(target=spin)
    thread.start()
    print("= null", flush=True)
    for line in sys.stdin:
        verb, *arguments = json.loads(line)
        try:
            result = getattr(end, verb)(*arguments)
        except Exception:  # noqa: BLE001 - the other side shows it
            result = {"error": traceback.format_exc()}
        print(f"= {json.dumps(result)}", flush=True)
    executor.shutdown(timeout_sec=5.0)
    rclpy.try_shutdown()
    thread.join()
    node.destroy_node()


if __name__ == "__main__":
    main()
