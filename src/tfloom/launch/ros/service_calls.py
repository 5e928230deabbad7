"""Calls of services by actions, on a thread beside that of the launch."""

from __future__ import annotations

import logging
import threading
from typing import TYPE_CHECKING, Any

from tfloom.launch.core.launch_context import LaunchContext

if TYPE_CHECKING:
    from tfloom.node.endpoints.client import Client

__all__ = ["call_service"]

_POLL_S = 0.2
"""The longest time until a wait notices the shutdown of the launch [s]."""


def call_service(client: Client, request: Any, context: LaunchContext, logger: logging.Logger) -> Any:
    """Wait for a service, call it, and return its response; None, with a log line, if there will be none.

    That is if the launch is shut down before, or the server leaves.

    Not on the launch's own thread: there, the wait would hold up all events, the shutdown among them.

    Args:
        client: The client, of the launch's node.
        request: The request.
        context: The launch.
        logger: Gets the line.
    """
    from tfloom.node.endpoints.client import NoResponseError
    from tfloom.node.values.exceptions import InvalidHandle

    # Both waits are polls, because nothing wakes them at the shutdown. The launch's thread destroys the node of the
    # client then, maybe in the middle of a call: hence InvalidHandle.
    try:
        while not client.wait_for_service(timeout_sec=_POLL_S):
            if context.is_shutdown:
                _warn_of_abandoned_wait(logger, f"'{client.srv_name}' service")
                return None
        future = client.call_async(request)
        if not _wait(future, context):
            _warn_of_abandoned_wait(logger, f"'{client.srv_name}' service response")
            return None
        return future.result()
    except InvalidHandle:  # the launch was shut down in between
        return None
    except NoResponseError as error:  # a process that dies while it is asked
        reason = str(error)
    logger.error("%s", reason)
    return None


def _warn_of_abandoned_wait(logger: logging.Logger, what: str) -> None:
    logger.warning("Abandoning wait for the %s, due to shutdown.", what)


def _wait(future: Any, context: LaunchContext) -> bool:
    """Wait for a response, and return whether it came before the shutdown of the launch."""
    done = threading.Event()
    future.add_done_callback(lambda _: done.set())
    while not done.wait(_POLL_S):
        if context.is_shutdown:
            return False
    return True
