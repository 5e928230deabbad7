"""What command lines' words stand for, and answers of other nodes."""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Hashable, Mapping
from typing import Any, NamedTuple, TypeVar

from tfloom.cli.api.nodes import GraphNode, node_of
from tfloom.common.seconds import checked_timeout
from tfloom.node.client_library import spin_until_future_complete

__all__ = ["TIMEOUT_S", "Call", "argument_key", "call_services", "positive_float", "positive_int"]


def positive_int(string: str) -> int:
    """Return a whole number above 0.

    Raises:
        argparse.ArgumentTypeError: it is not such a number.
    """
    value: int = _positive(int, string, "value must be a positive integer")
    return value


def positive_float(inval: str) -> float:
    """Return a number above 0.

    Raises:
        argparse.ArgumentTypeError: it is not such a number.
    """
    value: float = _positive(float, inval, "value must be a positive float")
    return value


def _positive(kind: Callable[[str], Any], text: str, otherwise: str) -> Any:
    try:
        value = kind(text)
    except ValueError:
        value = 0
    if not value > 0:
        raise argparse.ArgumentTypeError(otherwise)
    return value


def argument_key(given: str | None, usual: str) -> str:
    """Return the name of the argument that a completer reads."""
    return usual if given is None else given


TIMEOUT_S = 5.0
"""Longest wait for the services, and after it for their responses [s]."""

_Key = TypeVar("_Key", bound=Hashable)


class Call(NamedTuple):
    """A request for a service."""

    service_class: type[Any]
    service_name: str
    request: Any


def call_services(
    node: GraphNode, calls: Mapping[_Key, Call], timeout_s: float | None = TIMEOUT_S
) -> dict[_Key, Any]:
    """Call services, all at a time, and spin the node until they have responded.

    Args:
        node: What the clients belong to.
        calls: The requests.
        timeout_s: Longest wait for the services and for their responses, each [s]; None: no limit for the responses.

    Returns:
        For each key the response, or a RuntimeError where the service isn't there or doesn't respond.
    """
    limit_s = checked_timeout("call_services", timeout_s)
    caller = node_of(node)
    clients: dict[_Key, Any] = {}
    try:
        # Each one is noted as soon as it is there: the name of a later one may be invalid.
        for key, call in calls.items():
            clients[key] = caller.create_client(call.service_class, call.service_name)
        futures, answers = {}, {}
        end_s = time.monotonic() + (TIMEOUT_S if limit_s is None else limit_s)
        for key, client in clients.items():
            if client.wait_for_service(timeout_sec=max(0.0, end_s - time.monotonic())):
                futures[key] = client.call_async(calls[key].request)
            else:
                answers[key] = RuntimeError(f"service {calls[key].service_name} is not there")
        end_s = float("inf") if limit_s is None else time.monotonic() + limit_s
        for key, future in futures.items():
            left_s = None if limit_s is None else max(0.0, end_s - time.monotonic())
            spin_until_future_complete(caller, future, timeout_sec=left_s)
            answers[key] = _answer(future, calls[key].service_name)
        return {key: answers[key] for key in calls}
    finally:
        for client in clients.values():
            caller.destroy_client(client)


def _answer(future: Any, service_name: str) -> Any:
    if not future.done():
        return RuntimeError(f"service {service_name} does not respond")
    error = future.exception()
    return future.result() if error is None else error
