"""Service calls on `rmw`, without a node."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, TypeVar

from tfloom._native import ReadyQueue
from tfloom.cli.errors import CommandError
from tfloom.cli.names import did_you_mean
from tfloom.rmw.action_names import SEND_GOAL
from tfloom.rmw.base import NodeName, Participant
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import service_of
from tfloom.rmw.waiting import wait_until_ready
from tfloom.rosidl import cdr

T = TypeVar("T")

HINT_S = 2.0
"""Wait for a server before the nearest names are printed [s]: longer than discovery on a busy machine."""
PROGRESS_S = 1.0
"""Wait for a response before the user gets a message about it [s]."""
CHECK_S = 0.005
"""Period at which the match with a server is checked [s]; short, because discovery takes most of a command's time."""
LOOK_AGAIN_S = 0.05
"""Period at which a waiting client checks that its server is still matched [s]."""


class Client:
    """One client of one service."""

    def __init__(self, participant: Participant, node: NodeName, name: str, service_class: type[Any]) -> None:
        self.name = name
        self._class = service_class
        self._graph = participant.graph
        self._requester = participant.create_requester(node, service_of(service_class, name), QoS())
        self._queue = ReadyQueue()
        self._requester.notify(self._queue)

    def wait_for_server(
        self, timeout_s: float = math.inf, while_waiting: Callable[[], None] | None = None
    ) -> None:
        """Wait until a server is ready; `while_waiting` is called once if none is ready at the start.

        After `HINT_S`, a line on stderr names the service, with those of similar names.

        Raises:
            CommandError: no server is ready within `timeout_s`, or it is incompatible; the text has the reason.
        """
        hint_s = time.monotonic() + HINT_S

        def is_ready() -> bool:
            nonlocal hint_s, while_waiting
            if self._requester.is_ready():
                return True
            # An incompatible server stays so: end the wait with the reason, instead of at the timeout without one.
            if incompatibility := self._requester.incompatibility():
                raise CommandError(incompatibility)
            if while_waiting is not None:
                while_waiting()
                while_waiting = None
            # The hint comes after discovery: earlier, the graph would lack the names that are near.
            if time.monotonic() > hint_s:
                hint_s = math.inf
                print(f"no server of {self._name_with_nearest()}", file=sys.stderr)
            return False

        end_s = time.monotonic() + timeout_s
        if not wait_until_ready(self._requester, is_ready, end_s, look_again_s=CHECK_S):
            raise CommandError(f"no server of {self.name}: waited {timeout_s:g} s for it")

    def _name_with_nearest(self) -> str:
        """Return the name of the service or its action, and a line with the nearest existing names."""
        is_action = self.name.endswith(SEND_GOAL)
        served = {end.name for end in self._graph.service_ends() if end.is_server}
        names = {name.removesuffix(SEND_GOAL) for name in served if name.endswith(SEND_GOAL) == is_action}
        name = self.name.removesuffix(SEND_GOAL)
        return f"{name} yet{did_you_mean(name, sorted(names))}"

    def send(self, request: Any) -> int:
        """Send a request and return its number, for `receive`."""
        return self._requester.send(cdr.encode(request))

    def receive(
        self, number: int, timeout_s: float = math.inf, meanwhile: Callable[[], None] = lambda: None
    ) -> Any:
        """Wait for the response to a request; `meanwhile` is called repeatedly until it arrives.

        Raises:
            CommandError: no response arrived within `timeout_s`, the server has left, or its response is damaged.
        """
        end_s = time.monotonic() + timeout_s
        while True:
            # Take all responses: one of another number answers a request whose wait has ended at its timeout.
            while response := self._requester.take():
                if response.id.sequence_number == number:
                    return self._decode_response(response.data)
            meanwhile()
            if time.monotonic() > end_s:
                raise CommandError(f"no response from {self.name} within {timeout_s:g} s")
            # Look for the server only after the reader: a response that arrived before the server left still counts.
            if not self._requester.is_ready():
                raise CommandError(f"the server of {self.name} has left without a response")
            # A response posts a token and ends the sleep at once; a server that leaves posts none, so sleep briefly.
            self._queue.wait(int(LOOK_AGAIN_S * 1e9))

    def call(self, request: Any, timeout_s: float = math.inf) -> Any:
        """Send a request and wait for its response; see `receive`.

        After `PROGRESS_S`, a user at a terminal gets a message about the wait.
        """
        report_s = time.monotonic() + PROGRESS_S if sys.stderr.isatty() else math.inf

        def report_once() -> None:
            nonlocal report_s
            if time.monotonic() > report_s:
                report_s = math.inf
                print(f"waiting for a response from {self.name}", file=sys.stderr)

        return self.receive(self.send(request), timeout_s, report_once)

    def _decode_response(self, data: bytes) -> Any:
        try:
            return cdr.decode(self._class.Response, data)
        except cdr.DecodeError as error:
            raise CommandError(f"the response of {self.name} can't be decoded: {error}") from None

    def close(self) -> None:
        """Close the requester, so that servers no longer see this client."""
        self._requester.close()


@contextmanager
def service_client(
    participant: Participant, node: NodeName, name: str, service_class: type[Any]
) -> Iterator[Client]:
    """Open a client of a service for the block."""
    client = Client(participant, node, name, service_class)
    try:
        yield client
    finally:
        client.close()


class NodeServices:
    """The services of one node, each with a client for one call.

    Args:
        participant: Where the clients are created.
        own: The command's own node, which they belong to.
        node: The full name of the other node.
        timeout_s: Longest wait for a server, and for its response [s].
    """

    def __init__(self, participant: Participant, own: NodeName, node: str, timeout_s: float) -> None:
        self.node = node
        self._participant = participant
        self._own = own
        self._timeout_s = timeout_s

    def call(
        self, service: str, service_class: type[Any], request: Any, response_timeout_s: float | None = None
    ) -> Any:
        """Return the response of a service, whose name is below the node's.

        Raises:
            CommandError: there is no server, or no response.
        """
        with service_client(self._participant, self._own, f"{self.node}/{service}", service_class) as client:
            client.wait_for_server(self._timeout_s)
            return client.call(request, self._timeout_s if response_timeout_s is None else response_timeout_s)


def call_each(asked: Mapping[str, Callable[[], T]]) -> dict[str, T]:
    """Return the results of several calls, by name; if only some fail, their errors are printed on stderr.

    Raises:
        CommandError: all calls failed.
    """
    answers = {name: _result_or_error(ask) for name, ask in asked.items()}
    errors = [answer for answer in answers.values() if isinstance(answer, CommandError)]
    text = "\n".join(map(str, errors))
    if errors and len(errors) == len(answers):
        raise CommandError(text)
    if errors:
        print(text, file=sys.stderr)
    return {name: answer for name, answer in answers.items() if not isinstance(answer, CommandError)}


def _result_or_error(ask: Callable[[], T]) -> T | CommandError:
    try:
        return ask()
    except CommandError as error:
        return error


def printer(text: str) -> Callable[[], None]:
    """Return a function that prints a line."""
    return lambda: print(text)
