"""A request of one service, in steps that never wait: for all that ask a service without a node."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Any

from tfloom._native import ReadyQueue
from tfloom.rmw.base import NodeName, Participant
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import service_of
from tfloom.rosidl import cdr

__all__ = ["RESPONSE_S", "SERVER_S", "ServiceRequest", "ServiceRequestError"]

SERVER_S = 3.0
"""The longest wait for a server, if nothing else is said [s]."""
RESPONSE_S = 10.0
"""The longest wait for a response, if nothing else is said [s]."""
LOOK_AGAIN_S = 0.05
"""Period at which a wait looks for the response and the server again [s]; what arrives ends the sleep."""


class ServiceRequestError(Exception):
    """A request has got no response that can be used; the text says why."""


class ServiceRequest:
    """A client of one service, which sends one request at a time. One thread may use it.

    Args:
        participant: The participant that asks.
        node: The node whose end it has, which was added to the participant.
        name: The full name of the service.
        service_class: Its class.
        arrived: Gets a token when something may have arrived.
    """

    def __init__(
        self,
        participant: Participant,
        node: NodeName,
        name: str,
        service_class: type[Any],
        arrived: ReadyQueue,
        qos: QoS | None = None,
    ) -> None:
        self._name = name
        self._class = service_class
        self._arrived = arrived
        self._requester = participant.create_requester(
            node, service_of(service_class, name), QoS() if qos is None else qos
        )
        self._requester.notify(arrived, 1)
        self._requester.watch_servers(arrived, 1)
        self._request = b""
        self._number: int | None = None
        self._servers: frozenset[str] = frozenset()
        """The servers that have received the request."""
        self._server_s = SERVER_S
        self._response_s = RESPONSE_S
        self._end_s = math.inf

    def ask(self, request: bytes, *, response_s: float = RESPONSE_S, server_s: float = SERVER_S) -> None:
        """Send a request as soon as there is a server. The response to the one before, if any, is dropped.

        Args:
            request: Its bytes.
            response_s: The longest wait for its response [s].
            server_s: The longest wait for a server before [s].
        """
        self._give_up()
        self._request = request
        self._response_s, self._server_s = response_s, server_s
        self._end_s = time.monotonic() + server_s

    @property
    def is_sent(self) -> bool:
        """Whether the request was sent."""
        return self._number is not None

    @property
    def servers(self) -> frozenset[str]:
        """The servers that are connected, by names that stand for them here."""
        return self._requester.connected_servers()

    def is_ready(self) -> bool:
        """Return whether there is a server.

        Raises:
            ServiceRequestError: there is one with which nothing passes.
        """
        if self._requester.is_ready():
            return True
        if incompatibility := self._requester.incompatibility():
            raise ServiceRequestError(incompatibility)
        return False

    def take(self) -> Any:
        """Return the response; None while there is none.

        Raises:
            ServiceRequestError: there is no server, it has left, or did not respond in time, or its response is
                damaged.
        """
        if self._number is None:
            self._send_if_ready()
            return None
        # A server that leaves is unmatched in one direction before its response has arrived, so that `is_ready` tells
        # nothing of a request under way. And a response precedes the departure of its server: those of all that have
        # left by this look are taken after it.
        connected = self._requester.connected_servers()
        while (response := self._requester.take()) is not None:
            if response.id.sequence_number == self._number:
                try:
                    return cdr.decode(self._class.Response, response.data)
                except cdr.DecodeError as error:
                    text = f"the response of {self._name} can't be decoded: {error}"
                    raise ServiceRequestError(text) from None
        if self._servers.isdisjoint(connected):
            self._give_up(is_lost=True)
            raise ServiceRequestError(f"the server of {self._name} has left without a response")
        if time.monotonic() > self._end_s:
            self._give_up()
            raise ServiceRequestError(f"no response from {self._name} within {self._response_s:g} s")
        return None

    def _send_if_ready(self) -> None:
        if self.is_ready() and (servers := self._requester.receiving_servers()):
            self._servers = servers
            self._number = self._requester.send(self._request)
            self._end_s = time.monotonic() + self._response_s
        elif time.monotonic() > self._end_s:
            raise ServiceRequestError(
                f"there is no server of {self._name}: waited {self._server_s:g} s for it"
            )

    def _give_up(self, *, is_lost: bool = False) -> None:
        if self._number is not None:
            self._requester.give_up([self._number], is_lost=is_lost)
            self._number = None

    def wait(self, meanwhile: Callable[[], None] = lambda: None) -> Any:
        """Wait for the response, and return it; `meanwhile` is called repeatedly until it has arrived.

        Raises:
            ServiceRequestError: as of `take`.
        """
        while (response := self.take()) is None:
            meanwhile()
            self._arrived.wait(int(LOOK_AGAIN_S * 1e9))
        return response

    def close(self) -> None:
        """Remove the client from the service; a response that is still to come is dropped."""
        self._requester.close()
