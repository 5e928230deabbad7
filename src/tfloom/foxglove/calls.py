"""Calls of services on threads of the SDK, while the node's thread runs the responses."""

from __future__ import annotations

import threading
import time
from collections.abc import Container, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.node.values.exceptions import InvalidHandle
from tfloom.rmw.errors import WireError

if TYPE_CHECKING:
    from tfloom.node.endpoints.client import Client
    from tfloom.node.node import Node

__all__ = ["Call", "CallError", "Calls"]

SLEEP_S = 0.002


class CallError(Exception):
    """A service did not respond; the text says why."""


class Call(NamedTuple):
    """A call of a service."""

    service_class: type[Any]
    name: str
    request: Any


class Calls:
    """Calls services, on any thread but the node's. Clients are kept for further calls."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._lock = threading.Lock()
        self._clients: dict[tuple[str, str], Client[Any, Any]] = {}
        """By name and type; guarded by `_lock`."""

    def call(self, call: Call, timeout_s: float) -> Any:
        """Return the response.

        Raises:
            CallError: there is no server, or it did not respond in time.
        """
        (response,) = self.call_all([call], timeout_s)
        if response is None:
            raise CallError(f"no response from {call.name} within {timeout_s:g} s")
        return response

    def call_all(self, calls: Sequence[Call], timeout_s: float) -> list[Any]:
        """Make calls at the same time; return their responses in this order, None for one that has none in time."""
        end_s = time.monotonic() + timeout_s
        clients = [self._client(call) for call in calls]
        futures: list[Any] = [None] * len(calls)
        done = threading.Event()
        waiting = dict(enumerate(clients))
        while waiting and time.monotonic() < end_s and self._node.context.ok():
            for index, client in list(waiting.items()):
                with suppress(InvalidHandle, WireError):  # the server has just left: this one has no response
                    if not client.service_is_ready():
                        continue
                    futures[index] = client.call_async(calls[index].request)
                    futures[index].add_done_callback(lambda _: done.set())
                del waiting[index]
            if waiting:
                time.sleep(SLEEP_S)
        # The requests to a server that leaves are cancelled with their client.
        while not all(future is None or future.done() or future.cancelled() for future in futures):
            left_s = end_s - time.monotonic()
            if left_s <= 0.0 or not done.wait(left_s):
                break
            done.clear()
        return [self._result(client, future) for client, future in zip(clients, futures, strict=True)]

    @staticmethod
    def _result(client: Client[Any, Any], future: Any) -> Any:
        if future is None:
            return None
        if not future.done():
            client.remove_pending_request(future)
            return None
        return None if future.exception() is not None else future.result()

    def _client(self, call: Call) -> Client[Any, Any]:
        key = call.name, call.service_class._TYPE_NAME
        with self._lock:
            if (client := self._clients.get(key)) is None:
                client = self._clients[key] = self._node.create_client(call.service_class, call.name)
            return client

    def forget(self, services: Container[str]) -> None:
        """Destroy the clients of services that are not among these, which have servers; on the node's thread."""
        with self._lock:
            gone = [key for key in self._clients if key[0] not in services]
            clients = [self._clients.pop(key) for key in gone]
        for client in clients:
            self._node.destroy_client(client)
