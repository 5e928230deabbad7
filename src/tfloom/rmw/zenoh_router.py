"""A router of the Zenoh wire: the point at which sessions meet, in a process of its own or inside the first session's.

`zenoh.open` with the mode `router` is a whole router; it has threads of its own, none of Python.
"""

from __future__ import annotations

from typing import Any

from tfloom.rmw.errors import WireError
from tfloom.rmw.zenoh_config import endpoints_of, reason_of
from tfloom.rmw.zenoh_library import open_library
from tfloom.rmw.zenoh_port import find_port_owner

__all__ = ["RouterError", "is_port_taken", "open_router"]

_IN_USE = ("Address already in use", "os error 98", "os error 48", "os error 10048")
"""What Zenoh's error has where the port is taken: Linux's number of the error, macOS's, Windows's."""


class RouterError(WireError):
    """A router can't be opened; the text names its endpoint and the reason.

    Args:
        text: The text.
        is_port_taken: Whether the reason is that another process listens there.
    """

    def __init__(self, text: str, *, is_port_taken: bool = False) -> None:
        super().__init__(text)
        self.is_port_taken = is_port_taken


def is_port_taken(error: Exception) -> bool:
    """Return whether an error of Zenoh says that another process listens on an endpoint."""
    return any(part in str(error) for part in _IN_USE)


def open_router(config: Any) -> Any:
    """Open a router, and return its `zenoh.Session`, which must be closed.

    Args:
        config: A `zenoh.Config` with the mode `router`.

    Raises:
        RouterError: it can't listen, as where the port is taken.
        NoBackendError: eclipse-zenoh isn't installed.
    """
    zenoh = open_library()
    try:
        return zenoh.open(config)
    except zenoh.ZError as error:
        endpoints = endpoints_of(config, "listen/endpoints")
        where = ", ".join(endpoints) or "no endpoint"
        if not is_port_taken(error):
            raise RouterError(f"the router can't listen on {where}: {reason_of(error)}") from None
        ports = [endpoint.rpartition(":")[2] for endpoint in endpoints]
        owners = [owner for port in ports if port.isdigit() and (owner := find_port_owner(int(port)))]
        holder = str(owners[0]) if owners else "another process"
        raise RouterError(
            f"the router can't listen on {where}: the port is held by {holder}. If that is a router, programs meet "
            "there already; otherwise end it, or name another port in TFLOOM_ZENOH_PORT, for all programs",
            is_port_taken=True,
        ) from None
