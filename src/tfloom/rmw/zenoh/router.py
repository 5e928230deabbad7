"""A router of the Zenoh wire: the point at which sessions meet, in a separate process or inside the first session's.

`zenoh.open` with the mode `router` is a whole router; it has its own threads, none of Python.
"""

from __future__ import annotations

from typing import Any

from tfloom.rmw.errors import WireError
from tfloom.rmw.zenoh.config import endpoints_of, reason_of
from tfloom.rmw.zenoh.library import open_library
from tfloom.rmw.zenoh.port_holder import find_port_owner

__all__ = ["RouterError", "open_router", "open_where_free"]

_IN_USE = ("Address already in use", "os error 98", "os error 48", "os error 10048")
"""What Zenoh's error has where the port is taken: Linux's number of the error, macOS's, Windows's."""


class RouterError(WireError):
    """A router can't be opened; the text names its endpoint and the reason."""


def open_router(config: Any) -> Any:
    """Open a router, and return its `zenoh.Session`, which must be closed.

    Args:
        config: A `zenoh.Config` with the mode `router`.

    Raises:
        RouterError: it can't listen, as where the port is taken.
        NoBackendError: eclipse-zenoh isn't installed.
    """
    router = open_where_free(config)
    if router is None:
        ports = [endpoint.rpartition(":")[2] for endpoint in _listens_on(config)]
        owners = [owner for port in ports if port.isdigit() and (owner := find_port_owner(int(port)))]
        holder = str(owners[0]) if owners else "another process"
        raise RouterError(
            f"{_cannot_listen(config)}: the port is held by {holder}. If that is a router, programs meet "
            "there already; otherwise end it, or name another port in TFLOOM_ZENOH_PORT, for all programs"
        )
    return router


def open_where_free(config: Any) -> Any:
    """Open a router as `open_router` does; return None where another process listens at its port.

    Who that is isn't sought, because that reads the open files of all processes, and most sessions find a router there.

    Raises:
        RouterError: it can't listen, for another reason.
        NoBackendError: eclipse-zenoh isn't installed.
    """
    zenoh = open_library()
    try:
        return zenoh.open(config)
    except zenoh.ZError as error:
        if any(part in str(error) for part in _IN_USE):
            return None
        raise RouterError(f"{_cannot_listen(config)}: {reason_of(error)}") from None


def _listens_on(config: Any) -> list[str]:
    return endpoints_of(config, "listen/endpoints")


def _cannot_listen(config: Any) -> str:
    return f"the router can't listen on {', '.join(_listens_on(config)) or 'no endpoint'}"
