"""A request of one service, in steps that never wait."""

from __future__ import annotations

import math
import time
from typing import Any

from tfloom._native import ReadyQueue
from tfloom.rmw.base import NodeName, Participant
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import service_of
from tfloom.rosidl import cdr

__all__ = ["RESPONSE_S", "SERVER_S", "Question", "QuestionError"]

SERVER_S = 3.0
"""The longest wait for a server, if nothing else is said [s]."""
RESPONSE_S = 10.0
"""The longest wait for a response, if nothing else is said [s]."""


class QuestionError(Exception):
    """A request has got no response that can be used; the text says why."""


class Question:
    """A request of one service. One thread may use it.

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
    ) -> None:
        self._name = name
        self._class = service_class
        self._requester = participant.create_requester(node, service_of(service_class, name), QoS())
        self._requester.notify(arrived, 1)
        self._requester.notify_ready(arrived, 1)
        self._request = b""
        self._number: int | None = None
        self._server_s = SERVER_S
        self._response_s = RESPONSE_S
        self._end_s = math.inf

    def ask(self, request: bytes, *, response_s: float = RESPONSE_S, server_s: float = SERVER_S) -> None:
        """Send a request as soon as there is a server.

        Args:
            request: Its bytes.
            response_s: The longest wait for its response [s].
            server_s: The longest wait for a server before [s].
        """
        self._request, self._number = request, None
        self._response_s, self._server_s = response_s, server_s
        self._end_s = time.monotonic() + server_s

    @property
    def is_sent(self) -> bool:
        """Whether the request was sent."""
        return self._number is not None

    def take(self) -> Any:
        """Return the response; None while there is none.

        Raises:
            QuestionError: there is no server, it has left, or did not respond in time, or its response is damaged.
        """
        if self._number is None:
            if self._requester.is_ready():
                self._number = self._requester.send(self._request)
                self._end_s = time.monotonic() + self._response_s
            elif incompatibility := self._requester.incompatibility():
                raise QuestionError(incompatibility)
            elif time.monotonic() > self._end_s:
                raise QuestionError(f"there is no server of {self._name}: waited {self._server_s:g} s for it")
            return None
        while (response := self._requester.take()) is not None:
            if response.id.sequence_number == self._number:
                try:
                    return cdr.decode(self._class.Response, response.data)
                except cdr.DecodeError as error:
                    raise QuestionError(f"the response of {self._name} can't be decoded: {error}") from None
        # A response that arrived before the server left was taken above.
        if not self._requester.is_ready():
            raise QuestionError(f"the server of {self._name} has left without a response")
        if time.monotonic() > self._end_s:
            raise QuestionError(f"no response from {self._name} within {self._response_s:g} s")
        return None

    def close(self) -> None:
        """Remove the client from the service; an answer that is still to come is dropped."""
        self._requester.close()
