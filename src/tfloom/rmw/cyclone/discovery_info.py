"""The messages on `ros_discovery_info`, in which each participant lists its nodes with their readers and writers.

The type is rmw_dds_common/msg/ParticipantEntitiesInfo: the participant's gid and a sequence of nodes, each with its
namespace, its name, and the gids of its readers and of its writers.
"""

from __future__ import annotations

import struct
from typing import NamedTuple

from tfloom.rmw.base import NodeName

TOPIC_NAME = "ros_discovery_info"
TYPE_NAME = "rmw_dds_common/msg/ParticipantEntitiesInfo"
TYPE_HASH = "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e"

GID_SIZE = 16
_HEADER = b"\x00\x01\x00\x00"
_LENGTH = struct.Struct("<I")


class NodeEnds(NamedTuple):
    """A node and its open endpoints."""

    name: NodeName
    reader_gids: list[bytes]
    writer_gids: list[bytes]


class NodeListError(ValueError):
    """The bytes aren't a node list; the text has the offset."""


def encode(participant_gid: bytes, nodes: list[NodeEnds]) -> bytes:
    """Return the message of a participant, with its encapsulation header."""
    data = bytearray(participant_gid)
    data += _LENGTH.pack(len(nodes))
    for node in nodes:
        _append_string(data, node.name.namespace)
        _append_string(data, node.name.name)
        for gids in (node.reader_gids, node.writer_gids):
            _align(data)
            data += _LENGTH.pack(len(gids)) + b"".join(gids)
    return _HEADER + bytes(data)


def decode(data: bytes) -> tuple[bytes, list[NodeEnds]]:
    """Return a participant's gid and its nodes.

    Raises:
        NodeListError: the bytes end too early, or hold a text that isn't UTF-8.
    """
    if data[:2] != _HEADER[:2]:
        raise NodeListError(
            f"a list of nodes is little-endian CDR, and these bytes start with {data[:2].hex()!r}"
        )
    cursor = _Cursor(data[len(_HEADER) :])
    participant_gid = cursor.take(GID_SIZE)
    nodes = []
    for _ in range(cursor.length(smallest_item=4)):
        name = NodeName(cursor.string(), cursor.string())
        nodes.append(NodeEnds(name, cursor.gids(), cursor.gids()))
    return participant_gid, nodes


def _align(data: bytearray) -> None:
    data += bytes(-len(data) % 4)


def _append_string(data: bytearray, text: str) -> None:
    _align(data)
    text_bytes = text.encode() + b"\0"
    data += _LENGTH.pack(len(text_bytes)) + text_bytes


class _Cursor:
    """Reads values in order, and checks each read against the end."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    def take(self, count: int) -> bytes:
        item = self._data[self._at : self._at + count]
        if len(item) < count:
            raise NodeListError(f"{count} bytes are announced at byte {self._at} of {len(self._data)}")
        self._at += count
        return item

    def length(self, smallest_item: int) -> int:
        """Read how many items follow; raise if the remaining bytes can't hold so many."""
        self._at += -self._at % 4
        (count,) = _LENGTH.unpack(self.take(4))
        if count * smallest_item > len(self._data) - self._at:
            raise NodeListError(f"{count} items are announced at byte {self._at} of {len(self._data)}")
        return int(count)

    def string(self) -> str:
        text_bytes = self.take(self.length(smallest_item=1))
        try:
            return text_bytes.removesuffix(b"\0").decode()
        except UnicodeDecodeError:
            raise NodeListError(f"the text before byte {self._at} isn't UTF-8") from None

    def gids(self) -> list[bytes]:
        return [self.take(GID_SIZE) for _ in range(self.length(smallest_item=GID_SIZE))]
