"""Matching of servers and clients on DDS, and detection of incompatible vendors.

rmw_cyclonedds writes `serviceid=` into the USER_DATA of both endpoints of a server and `clientid=` into a client's, so
that a peer can check that both are matched. Other vendors write no header into the CDR and would misread this one; for
peers on Fast DDS, `native/rtps/service_forms` translates, where the system allows it.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable
from collections.abc import Set as AbstractSet
from functools import lru_cache
from typing import NamedTuple

from tfloom._native import dds_inline_client, dds_knows_address, intercept_dds_packets
from tfloom.common.terminal import shown_part
from tfloom.rmw.cyclone.endpoints import CycloneReader, CycloneWriter
from tfloom.rmw.cyclone.graph import FAST_DDS
from tfloom.rmw.topic_names import key_values

CYCLONE_VENDOR = b"\x01\x10"
"""The first bytes of Cyclone's GUIDs, its vendor id (RTPS 2.5, 8.3.3.1.3)."""


TRANSLATION_VARIABLE = "TFLOOM_FASTDDS_SERVICES"
"""Set to 0 in the environment, it refuses services with peers on Fast DDS."""

SERVER_KEY = "serviceid"
CLIENT_KEY = "clientid"

_GUID_PREFIX_SIZE = 12

_KEPT_BY_FAST_DDS = 10
"""Depth of a stock server: its reader replaces older requests that nobody has taken, without notice."""

HANDSHAKE_S = 0.1
"""The longest wait for the acknowledgement of a probe [s]."""

PROBE_AGAIN_S = 0.002
"""How long after a probe that was not acknowledged the next one is sent [s]; after each more twice as long."""

_ACKS_SLICE_NS = 1_000_000


def end_id(participant_gid: bytes, number: int) -> str:
    """Return the id of the `number`th service end of a participant, as rmw_cyclonedds writes it.

    Its 16 bytes in hex: the first padded with a space, dots between, no zeros in front.
    """
    id_bytes = participant_gid[:_GUID_PREFIX_SIZE] + number.to_bytes(4, "big")
    return f"{id_bytes[0]:2x}." + ".".join(f"{byte:x}" for byte in id_bytes[1:])


def end_user_data(key: str, identifier: str, type_hash: str) -> bytes:
    """Return the USER_DATA of an endpoint of a service."""
    text = f"{key}={identifier};"
    return (text + f"typehash={type_hash};" if type_hash else text).encode()


def _ids(peers: list[tuple[bytes, bytes]], key: str) -> set[str]:
    """Return the ids in these peers' USER_DATA; empty for a peer without one."""
    return {_id(user_data, key) for _, user_data in peers}


def _server_ids(peers: list[tuple[bytes, bytes]]) -> frozenset[str]:
    """Return the ids of these servers; without one in its USER_DATA, a server's participant stands for it."""
    return frozenset(_id(user_data, SERVER_KEY) or gid[:_GUID_PREFIX_SIZE].hex() for gid, user_data in peers)


@lru_cache(maxsize=256)
def _id(user_data: bytes, key: str) -> str:
    """Return the value of `key` in a peer's USER_DATA; cached, because the same peers are looked up repeatedly."""
    return key_values(user_data).get(key, "")


class Handshake:
    """The start of a writer's session with each of its readers.

    A reader drops all messages that precede the first heartbeat it receives from a writer, though both are matched
    before. The first of many requests that are sent at once would be lost without notice. So new readers are probed:
    one that has acknowledged the probe receives all that is written later.

    A reader acknowledges nothing if the probe comes at the moment in which it is being matched. The library's next
    heartbeat follows after its period, so the probe is repeated before.
    """

    def __init__(self, writer: CycloneWriter) -> None:
        self._writer = writer
        self._lock = threading.Lock()
        self._probed: list[tuple[bytes, bytes]] = []
        """The readers at the last probe, or fewer."""
        self._end_s: float | None = None
        """End of the wait for acknowledgements, on the monotonic clock [s]; None: all are there."""
        self._again_s, self._pause_s = 0.0, 0.0
        """When to probe again, and the time between that and the next probe [s]."""

    def is_complete(self, readers: list[tuple[bytes, bytes]]) -> bool:
        """Return whether these readers receive all that is written now; probe those that are new.

        After `HANDSHAKE_S` this is assumed, because the reader of a process that was killed never acknowledges.
        """
        # The usual case, and the cost of every request: the same readers as before, and all have acknowledged.
        if readers == self._probed and self._end_s is None:
            return True
        with self._lock:
            # Only a new reader makes a probe necessary. If some have merely left, the others have been probed.
            if not set(readers) <= set(self._probed):
                self._end_s = time.monotonic() + HANDSHAKE_S
                self._pause_s = PROBE_AGAIN_S
                self._probe()
            self._probed = readers
            if self._end_s is None:
                return True
            # If all that was written is acknowledged, so is the probe.
            if self._writer.wait_for_acks(0) or time.monotonic() >= self._end_s:
                self._end_s = None
            elif time.monotonic() >= self._again_s:
                self._probe()
            return self._end_s is None

    def _probe(self) -> None:
        self._writer.probe()
        self._again_s = time.monotonic() + self._pause_s
        self._pause_s *= 2

    def wait(self, readers: list[tuple[bytes, bytes]]) -> None:
        """Wait until `is_complete`."""
        while not self.is_complete(readers):
            self._writer.wait_for_acks(_ACKS_SLICE_NS)


@lru_cache(maxsize=8)
def start_translation(library: str) -> str:
    """Start the translation of services for peers on Fast DDS in a library; return why it is off, or an empty text."""
    if os.environ.get(TRANSLATION_VARIABLE) == "0":
        return f"{TRANSLATION_VARIABLE} is 0"
    return intercept_dds_packets(library)


def _is_on_fast_dds(gid: bytes) -> bool:
    return gid.startswith(FAST_DDS)


def _on_cyclone(peers: list[tuple[bytes, bytes]]) -> list[tuple[bytes, bytes]]:
    return [peer for peer in peers if peer[0].startswith(CYCLONE_VENDOR)]


def _participant(gid: bytes) -> bytes:
    return gid[:_GUID_PREFIX_SIZE]


class Vendors(NamedTuple):
    """What ends of services need to know of peers on other vendors."""

    untranslated: str = ""
    """Why services don't pass with peers on Fast DDS; empty if they do."""
    find_node: Callable[[bytes], str] = lambda _: ""
    """Returns the name of the node with an endpoint, by its gid; empty if it is unknown."""


class _Peers:
    """The common part of clients and servers."""

    def __init__(
        self, requests: CycloneWriter | CycloneReader, name: str, others: str, vendors: Vendors
    ) -> None:
        self._requests_end = requests
        self._name = name
        self._others = others
        self._vendors = vendors

    def accepts(self, publisher_gid: bytes) -> bool:
        """Return whether requests and responses pass between this peer and this process."""
        if _is_on_fast_dds(publisher_gid):
            return not self._vendors.untranslated
        return publisher_gid.startswith(CYCLONE_VENDOR)

    def incompatibility(self) -> str:
        """Return the remedy for a peer of another vendor, or an empty text."""
        refused_gids = [gid for gid, _ in self._requests_end.matched() if not self.accepts(gid)]
        if not refused_gids:
            return ""
        node = shown_part(next(filter(None, map(self._vendors.find_node, refused_gids)), ""))
        # What the reason is for peers on Fast DDS says nothing of other vendors.
        reason = f", because {self._vendors.untranslated}" if any(map(_is_on_fast_dds, refused_gids)) else ""
        return (
            f"{self._others} of {self._name}{node and f', {node},'} runs on another DDS vendor, whose form of services "
            f"isn't ours (topics pass, services don't{reason}): start it with RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"
        )


class CycloneServers(_Peers):
    """The servers of a client; see `services.Servers`."""

    def __init__(
        self, requests: CycloneWriter, responses: CycloneReader, name: str, vendors: Vendors
    ) -> None:
        super().__init__(requests, name, "a server", vendors)
        self._requests = requests
        self._responses = responses
        self._handshake = Handshake(requests)

    def is_ready(self) -> bool:
        """Return whether both endpoints of a server are matched, and none is of another vendor.

        The server may not take data yet, for which `synchronise` waits before a request is written. The answer doesn't
        depend on that, because the handshake begins when it is asked for: the first question would always get False.
        """
        if not self._is_matched():
            return False
        # Begin it, so that the first request waits less.
        self._handshake.is_complete(self._requests.matched())
        return True

    def is_synchronising(self) -> bool:
        """Return whether a server is matched in both directions, and may not take data yet."""
        return self._is_matched() and not self._handshake.is_complete(self._requests.matched())

    def synchronise(self) -> None:
        """Wait until all servers that are matched take data, or `HANDSHAKE_S` is over."""
        self._handshake.wait(self._requests.matched())

    def _is_matched(self) -> bool:
        receiving, responding = self._requests.matched(), self._responses.matched()
        if self.incompatibility():
            return False
        # A server on Cyclone writes one id into the USER_DATA of both of its endpoints. An id on both sides is a server
        # that is matched in both directions; two halves of different servers don't count.
        if _ids(_on_cyclone(receiving), SERVER_KEY) & _ids(_on_cyclone(responding), SERVER_KEY):
            return True
        # Fast DDS writes no ids, so its participant stands for the server. Samples for it are translated on their way
        # to its addresses: as long as none is known, a request would leave in a form that it can't read.
        receivers = {
            _participant(gid) for gid, _ in receiving if _is_on_fast_dds(gid) and dds_knows_address(gid)
        }
        return any(_participant(gid) in receivers for gid, _ in responding)

    def receiving(self) -> frozenset[str]:
        """Return ids of the servers that receive a request sent now."""
        return _server_ids(self._requests.matched())

    def most_in_flight(self) -> int | None:
        """Return how many requests servers on Fast DDS keep: ROS's default depth; None if there are none."""
        return _KEPT_BY_FAST_DDS if any(_is_on_fast_dds(gid) for gid, _ in self._requests.matched()) else None

    def connected(self) -> frozenset[str]:
        """Return ids of the servers that are matched in one direction at least.

        A server that leaves stays matched by its responses until they are acknowledged.
        """
        return _server_ids(self._requests.matched()) | _server_ids(self._responses.matched())


class CycloneClients(_Peers):
    """The clients of a server; see `services.Clients`."""

    def __init__(
        self, requests: CycloneReader, responses: CycloneWriter, name: str, vendors: Vendors
    ) -> None:
        super().__init__(requests, name, "a client", vendors)
        self._requests = requests
        self._responses = responses
        self._handshake = Handshake(responses)

    def connected(self) -> AbstractSet[bytes]:
        """Return the gids of the writers that send requests."""
        return {gid for gid, _ in self._requests.matched()}

    def synchronise(self) -> None:
        """Wait until all clients that are matched take data, or `HANDSHAKE_S` is over."""
        self._handshake.wait(self._responses.matched())

    def may_be_late(self, publisher_gid: bytes) -> bool:
        """Return whether a client is on Fast DDS, which may announce its reader again after a second only."""
        return _is_on_fast_dds(publisher_gid)

    def is_matched(self, key: bytes, publisher_gid: bytes) -> bool | None:
        """Return whether the client of this writer is matched in both directions; None if it has left."""
        clients = dict(self._requests.matched())
        if publisher_gid not in clients:
            return None
        # A client on Fast DDS: what awaits its responses was noted when its request was translated. Where that is the
        # writer of its requests, there is no reader to look for.
        if (awaiting := dds_inline_client(key)) is not None:
            readers = {gid for gid, _ in self._responses.matched()}
            return awaiting in readers or awaiting == publisher_gid
        identifier = _id(clients[publisher_gid], CLIENT_KEY)
        return identifier in _ids(self._responses.matched(), CLIENT_KEY)
