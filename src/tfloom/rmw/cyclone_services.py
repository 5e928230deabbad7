"""Matching of servers and clients on DDS, and detection of incompatible vendors.

rmw_cyclonedds writes `serviceid=` into the USER_DATA of both endpoints of a server and `clientid=` into a client's, so
that a peer can check that both are matched. Other vendors write no header into the CDR and would misread this one.
"""

from __future__ import annotations

from functools import lru_cache

from tfloom.rmw.cyclone_endpoints import CycloneReader, CycloneWriter
from tfloom.rmw.topic_names import key_values

CYCLONE_VENDOR = b"\x01\x10"
"""The first octets of Cyclone's GUIDs, its vendor id (RTPS 2.5, 8.3.3.1.3)."""

SERVER_KEY = "serviceid"
CLIENT_KEY = "clientid"

_GUID_PREFIX_SIZE = 12


def end_id(participant_gid: bytes, number: int) -> str:
    """Return the id of the `number`th service end of a participant, as rmw_cyclonedds writes it.

    Its 16 octets in hex: the first padded with a space, dots between, no zeros in front.
    """
    octets = participant_gid[:_GUID_PREFIX_SIZE] + number.to_bytes(4, "big")
    return f"{octets[0]:2x}." + ".".join(f"{octet:x}" for octet in octets[1:])


def end_user_data(key: str, identifier: str, type_hash: str) -> bytes:
    """Return the USER_DATA of an endpoint of a service."""
    text = f"{key}={identifier};"
    return (text + f"typehash={type_hash};" if type_hash else text).encode()


def _ids(peers: list[tuple[bytes, bytes]], key: str) -> set[str]:
    """Return the ids in these peers' USER_DATA; empty for a peer without one."""
    return {_id(user_data, key) for _, user_data in peers}


@lru_cache(maxsize=1024)
def _id(user_data: bytes, key: str) -> str:
    """Return the value of `key` in a peer's USER_DATA; cached, because the same peers are looked up repeatedly."""
    return key_values(user_data).get(key, "")


class _Peers:
    """The common part of clients and servers."""

    def __init__(self, requests: CycloneWriter | CycloneReader, name: str, others: str) -> None:
        self._requests_end = requests
        self._name = name
        self._others = others

    def accepts(self, publisher_gid: bytes) -> bool:
        """Return whether this peer runs on Cyclone."""
        return publisher_gid.startswith(CYCLONE_VENDOR)

    def obstacle(self) -> str:
        """Return the remedy for a peer of another vendor, or an empty text."""
        if all(self.accepts(gid) for gid, _ in self._requests_end.matched()):
            return ""
        return (
            f"{self._others} of {self._name} runs on another DDS vendor, whose form of services isn't ours "
            "(topics pass, services don't): start it with RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"
        )


class CycloneServers(_Peers):
    """The servers of a client; see `services.Servers`."""

    def __init__(self, requests: CycloneWriter, responses: CycloneReader, name: str) -> None:
        super().__init__(requests, name, "a server")
        self._requests = requests
        self._responses = responses

    def is_ready(self) -> bool:
        """Return whether both endpoints of a server are matched, and none is of another vendor."""
        receiving = _ids(self._requests.matched(), SERVER_KEY)
        return bool(receiving & _ids(self._responses.matched(), SERVER_KEY)) and not self.obstacle()


class CycloneClients(_Peers):
    """The clients of a server; see `services.Clients`."""

    def __init__(self, requests: CycloneReader, responses: CycloneWriter, name: str) -> None:
        super().__init__(requests, name, "a client")
        self._requests = requests
        self._responses = responses

    def is_matched(self, publisher_gid: bytes) -> bool | None:
        """Return whether the client of this writer is matched in both directions; None if it has left."""
        clients = dict(self._requests.matched())
        if publisher_gid not in clients:
            return None
        identifier = _id(clients[publisher_gid], CLIENT_KEY)
        return identifier in _ids(self._responses.matched(), CLIENT_KEY)
