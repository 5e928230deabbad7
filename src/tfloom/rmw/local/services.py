"""The peers of servers and clients on the in-process wire."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

from tfloom.rmw.local.endpoints import LocalReader, LocalWriter


class LocalServers:
    """The servers of a client; see `services.Servers`."""

    def __init__(self, requests: LocalWriter, responses: LocalReader) -> None:
        self._requests = requests
        self._responses = responses

    def is_ready(self) -> bool:
        """Return whether there is a server."""
        return self._requests.matched_count() > 0 and self._responses.matched_count() > 0

    def is_synchronising(self) -> bool:
        """Return False, because a match is complete at once."""
        return False

    def synchronise(self) -> None:
        """Do nothing, because a match is complete at once."""

    def receiving(self) -> frozenset[str]:
        """Return ids of the servers that receive a request sent now."""
        return frozenset(gid.hex() for gid in self._requests.matched_gids())

    def most_in_flight(self) -> int | None:
        """Return None, because a server keeps all requests."""
        return None

    def connected(self) -> frozenset[str]:
        """Return the same as `receiving`, because a response arrives before its writer closes."""
        return self.receiving()

    def incompatibility(self) -> str:
        """Return an empty text, because all peers use the same format."""
        return ""


class LocalClients:
    """The clients of a server; see `services.Clients`."""

    def __init__(self, requests: LocalReader) -> None:
        self._requests = requests

    def connected(self) -> AbstractSet[bytes]:
        """Return the gids of the writers that send requests."""
        return self._requests.matched_gids()

    def incompatibility(self) -> str:
        """Return an empty text, because all peers use the same format."""
        return ""

    def accepts(self, publisher_gid: bytes) -> bool:
        """Return True, because all peers use the same format."""
        return True

    def synchronise(self) -> None:
        """Do nothing, because a match is complete at once."""

    def may_be_late(self, publisher_gid: bytes) -> bool:
        """Return False, because a client opens its reader first."""
        return False

    def is_matched(self, key: bytes, publisher_gid: bytes) -> bool | None:
        """Return True, because a client opens its reader first."""
        return True
