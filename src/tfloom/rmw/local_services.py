"""What the ends of a service on the in-process wire know of each other."""

from __future__ import annotations

from tfloom.rmw.local_endpoints import LocalReader, LocalWriter


class LocalServers:
    """What a client knows of its servers; see `services.Servers`."""

    def __init__(self, requests: LocalWriter, responses: LocalReader) -> None:
        self._requests = requests
        self._responses = responses

    def is_ready(self) -> bool:
        """Tell whether a server is there."""
        return self._requests.matched_count() > 0 and self._responses.matched_count() > 0

    def obstacle(self) -> str:
        """Return an empty text: all ends are ours."""
        return ""


class LocalClients:
    """What a server knows of its clients; see `services.Clients`."""

    def obstacle(self) -> str:
        """Return an empty text: all ends are ours."""
        return ""

    def accepts(self, publisher_gid: bytes) -> bool:  # noqa: ARG002 - whoever it is
        """Return True: all ends are ours."""
        return True

    def hears(self, publisher_gid: bytes) -> bool | None:  # noqa: ARG002 - whoever it is
        """Return True: a client opens its reader first."""
        return True
