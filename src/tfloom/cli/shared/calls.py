"""Service calls on `rmw`, without a node."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, TypeVar

from tfloom._native import ReadyQueue
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.names import did_you_mean
from tfloom.common.terminal import report
from tfloom.rmw.base import NodeName, Participant
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared.service_request import ServiceRequest, ServiceRequestError
from tfloom.rmw.typed_names import SEND_GOAL, other_type_text
from tfloom.rosidl import cdr

T = TypeVar("T")

HINT_S = 2.0
"""Wait for a server before the nearest names are printed [s]: longer than discovery on a busy machine."""
PROGRESS_S = 1.0
"""Wait for a response before the user gets a message about it [s]."""
CHECK_S = 0.005
"""Period at which the match with a server is checked [s]; short, because discovery takes most of a command's time."""


class Client:
    """One client of one service."""

    def __init__(
        self,
        participant: Participant,
        node: NodeName,
        name: str,
        service_class: type[Any],
        qos: QoS | None = None,
    ) -> None:
        self.name = name
        self._type_name = service_class._TYPE_NAME
        self._graph = participant.graph
        self._arrived = ReadyQueue()
        self._request = ServiceRequest(participant, node, name, service_class, self._arrived, qos)

    def wait_for_server(
        self, timeout_s: float = math.inf, while_waiting: Callable[[], None] | None = None
    ) -> None:
        """Wait until a server is ready; `while_waiting` is called once if none is ready at the start.

        After `HINT_S`, a line on stderr names the service, with those of similar names.

        Raises:
            CommandError: no server is ready within `timeout_s`, or it is incompatible; the text has the reason.
        """
        start_s = time.monotonic()
        hint_s = start_s + HINT_S
        while not self._is_ready():
            if while_waiting is not None:
                while_waiting()
                while_waiting = None
            now_s = time.monotonic()
            if now_s >= start_s + timeout_s:
                reason = self._other_type()
                text = f"no server of {self.name}: waited {timeout_s:g} s for it"
                raise CommandError(f"{text}; {reason}" if reason else text)
            # The hint comes after discovery: earlier, the graph would lack the names that are near.
            if now_s > hint_s:
                hint_s = math.inf
                report(self._other_type() or f"no server of {self._name_with_nearest()}")
            self._arrived.wait(int(CHECK_S * 1e9))

    def _is_ready(self) -> bool:
        try:
            return self._request.is_ready()
        except ServiceRequestError as error:  # an incompatible server stays so
            raise CommandError(str(error)) from None

    def _other_type(self) -> str:
        return other_type_text(self._graph, self.name, self._type_name)

    def _name_with_nearest(self) -> str:
        """Return the name of the service or its action, and a line with the nearest existing names."""
        is_action = self.name.endswith(SEND_GOAL)
        served = {end.name for end in self._graph.service_ends() if end.is_server}
        names = {name.removesuffix(SEND_GOAL) for name in served if name.endswith(SEND_GOAL) == is_action}
        name = self.name.removesuffix(SEND_GOAL)
        return f"{name} yet{did_you_mean(name, sorted(names))}"

    def send(self, request: Any, timeout_s: float = math.inf) -> None:
        """Send a request, for whose response `receive` waits, up to `timeout_s`."""
        self._request.ask(cdr.encode(request), response_s=timeout_s)

    def receive(self, meanwhile: Callable[[], None] = lambda: None) -> Any:
        """Wait for the response to a request; `meanwhile` is called repeatedly until it arrives.

        Raises:
            CommandError: no response arrived in time, the server has left, or its response is damaged.
        """
        try:
            return self._request.wait(meanwhile)
        except ServiceRequestError as error:
            raise CommandError(str(error)) from None

    def call(self, request: Any, timeout_s: float = math.inf) -> Any:
        """Send a request and wait for its response; see `receive`.

        After `PROGRESS_S`, a user at a terminal gets a message about the wait.
        """
        report_s = time.monotonic() + PROGRESS_S if sys.stderr.isatty() else math.inf

        def report_once() -> None:
            nonlocal report_s
            if time.monotonic() > report_s:
                report_s = math.inf
                report(f"waiting for a response from {self.name}")

        self.send(request, timeout_s)
        return self.receive(report_once)

    def close(self) -> None:
        """Close the client, so that servers no longer see it."""
        self._request.close()


@contextmanager
def service_client(
    participant: Participant, node: NodeName, name: str, service_class: type[Any], qos: QoS | None = None
) -> Iterator[Client]:
    """Open a client of a service for the block, with the quality of service that services have, unless one is given."""
    client = Client(participant, node, name, service_class, qos)
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
        report(text)
    return {name: answer for name, answer in answers.items() if not isinstance(answer, CommandError)}


def _result_or_error(ask: Callable[[], T]) -> T | CommandError:
    try:
        return ask()
    except CommandError as error:
        return error


def printer(text: str) -> Callable[[], None]:
    """Return a function that prints a line."""
    return lambda: print(text)
