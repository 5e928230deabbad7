"""What the nodes that record and play have in common: how their services answer, and until when they spin."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from typing import Any

from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.ros_imports import ros_distro

__all__ = ["Answer", "refusal_of_time", "serve", "spin_until"]

Answer = Callable[[Any], object]
"""Returns the fields of the response to a request, as a dict; whatever else it returns, they keep their defaults."""
_POLL_S = 0.1


def serve(
    create_service: Callable[[Any, str, Callable[[Any, Any], Any]], object],
    answers: Mapping[str, tuple[Any, Answer]],
) -> None:
    """Create the private services of a node, by their names: each with its type, and what answers requests."""
    for name, (srv_type, answer) in answers.items():

        def on_request(request: Any, response: Any, answer: Answer = answer) -> Any:
            fields = answer(request)
            for field, value in fields.items() if isinstance(fields, dict) else ():
                setattr(response, field, value)
            return response

        create_service(srv_type, f"~/{name}", on_request)


def refusal_of_time(request: Any, word: str, response: Any) -> dict[str, object]:
    """Return the fields of a response that refuses to resume or split at a time; empty where it is to be done now.

    Before Lyrical, requests have no time.

    Args:
        request: The request.
        word: `resume` or `split`, by which its fields are named.
        response: The class of the response, which has the codes.
    """
    if not ros_distro.HAS_LATER_DEFINITIONS:
        return {}
    mode, stamp = getattr(request, f"{word}_mode"), getattr(request, f"{word}_time")
    if mode not in range(3):
        code, text = f"INVALID_{word.upper()}_MODE", f"{mode} is not a {word}_mode: it is 0, 1 or 2"
    elif stamp.sec or stamp.nanosec:
        code, text = f"{word.upper()}_FAILED", f"only {word}_time 0, which is now, can be asked for here"
    else:
        return {}
    return {"return_code": getattr(response, f"RETURN_CODE_{code}"), "error_string": text}


def spin_until(node: Node, has_ended: Callable[[], bool], stop: threading.Event | None) -> None:
    """Spin a node until it has ended, `stop` is set, or its context is shut down."""
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    try:
        while node.context.ok() and not has_ended() and not (stop and stop.is_set()):
            executor.spin_once(timeout_sec=_POLL_S)
    finally:
        executor.shutdown(timeout_sec=1.0)
