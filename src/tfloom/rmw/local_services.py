"""The peers of servers and clients on the in-process wire."""

from __future__ import annotations

from tfloom.rmw.local_endpoints import LocalReader, LocalWriter


class LocalServers:
    """The servers of a client; see `services.Servers`."""

    def __init__(self, requests: LocalWriter, responses: LocalReader) -> None:
        self._requests = requests
        self._responses = responses

    def is_ready(self) -> bool:
        """Return whether there is a server."""
        return self._requests.matched_count() > 0 and self._responses.matched_count() > 0

    def obstacle(self) -> str:
        """Return an empty text, because all peers use the same format."""
        return ""


class LocalClients:
    """The clients of a server; see `services.Clients`."""

    def obstacle(self) -> str:
        """Return an empty text, because all peers use the same format."""
        return ""

    def accepts(self, publisher_gid: bytes) -> bool:  # noqa: ARG002 - the same for all clients
        """Return True, because all peers use the same format."""
        return True

    def is_matched(self, publisher_gid: bytes) -> bool | None:  # noqa: ARG002 - the same for all clients
        """Return True, because a client opens its reader first."""
        return True
