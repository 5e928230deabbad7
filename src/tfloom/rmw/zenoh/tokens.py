"""What the Zenoh wire has in rmw_zenoh's form: keys of data, liveliness tokens, which make up the graph, attachments.

`65/chatter/std_msgs::msg::dds_::String_/RIHS01_…` carries the samples of a topic, or the requests of a service.
`@ros2_lv/<domain>/<zid>/<node>/<entity>/<kind>/<enclave>/<namespace>/<name>` describes a node; four more chunks, the
name, type, hash and quality of service, describe an endpoint.
"""

from __future__ import annotations

import struct
import time
from enum import Enum
from typing import Any, NamedTuple

from tfloom.rmw.base import NodeName
from tfloom.rmw.errors import NoBackendError
from tfloom.rmw.qos import (
    INFINITE_NS,
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoS,
    ReliabilityPolicy,
)
from tfloom.rmw.topic_names import type_from_dds, type_to_dds

__all__ = [
    "DEFAULT_DEPTH",
    "PREFIX",
    "Attachment",
    "End",
    "Kind",
    "Token",
    "TokenError",
    "data_key",
    "gid_of",
    "pack_attachment",
    "parse_qos",
    "parse_token",
    "qos_text",
    "token_key",
    "token_pattern",
    "unpack_attachment",
    "wire_qos",
]

PREFIX = "@ros2_lv"
DEFAULT_DEPTH = 42
"""rmw_zenoh's depth where none is stated."""
UNKNOWN_HASH = "RIHS01_" + "0" * 64
"""What the token of an endpoint without a hash states, because a chunk can't be empty."""
MAX_DIGITS = 20
NODE_CHUNKS = 9
END_CHUNKS = 13
NS_PER_S = 1_000_000_000
_INFINITE = divmod(INFINITE_NS, NS_PER_S)


class TokenError(ValueError):
    """A key isn't a token of rmw_zenoh's form; the text has the chunk."""


class Kind(Enum):
    """The kind of entity that a token describes."""

    NODE = "NN"
    PUBLISHER = "MP"
    SUBSCRIPTION = "MS"
    SERVER = "SS"
    CLIENT = "SC"


class End(NamedTuple):
    """An endpoint on the graph."""

    name: str
    """Fully qualified name of its topic or service."""
    type_name: str
    """`std_msgs/msg/String`; another wire form as it is."""
    type_hash: str
    """Empty if unknown."""
    qos: QoS


class Token(NamedTuple):
    """A node or an endpoint, as its token tells."""

    domain_id: int
    zid: str
    """Id of its session: lower-case hexadecimal digits."""
    node_number: int
    entity_number: int
    """From one counter of the session, for nodes and endpoints alike; a node's is its `node_number`."""
    kind: Kind
    enclave: str
    node: NodeName
    end: End | None
    """None for a node."""


def data_key(domain_id: int, name: str, type_name: str, type_hash: str) -> str:
    """Return the key of a topic's samples or of a service's requests.

    Args:
        domain_id: The domain.
        name: Fully qualified name.
        type_name: `std_msgs/msg/String`; of a service, the name of the service's own type.
        type_hash: Hash of that type; empty: any, which a publisher can't have.
    """
    return f"{domain_id}/{name.strip('/')}/{type_to_dds(type_name)}/{type_hash or '*'}"


def token_pattern(domain_id: int) -> str:
    """Return the key expression of all tokens of a domain."""
    return f"{PREFIX}/{domain_id}/**"


def token_key(token: Token) -> str:
    """Return the key of a token."""
    chunks = [
        PREFIX,
        str(token.domain_id),
        token.zid,
        str(token.node_number),
        str(token.entity_number),
        token.kind.value,
        _mangled(token.enclave or "/"),
        _mangled(token.node.namespace or "/"),
        token.node.name,
    ]
    if token.end is not None:
        end = token.end
        chunks += [
            _mangled(end.name),
            type_to_dds(end.type_name),
            end.type_hash or UNKNOWN_HASH,
            qos_text(end.qos),
        ]
    return "/".join(chunks)


def parse_token(key: str) -> Token:
    """Return what a key tells. Chunks that follow are ignored, because newer releases have more.

    Raises:
        TokenError: it has another form.
    """
    chunks = key.split("/")
    if len(chunks) < NODE_CHUNKS or chunks[0] != PREFIX:
        raise TokenError(f"a token has {NODE_CHUNKS} chunks or more and begins with {PREFIX}")
    if not all(chunks[:END_CHUNKS]):
        raise TokenError("a chunk of a token is empty")
    domain_text, zid, node_number, entity_number, kind_text, enclave, namespace, name = chunks[1:NODE_CHUNKS]
    try:
        kind = Kind(kind_text)
    except ValueError:
        raise TokenError(f"{kind_text!r} is not a kind of entity") from None
    node = NodeName(_demangled(namespace), name)
    if not node.namespace.startswith("/") or "%" in name:
        raise TokenError(f"{namespace!r}, {name!r} is not a name of a node")
    end = None
    if kind is not Kind.NODE:
        if len(chunks) < END_CHUNKS:
            raise TokenError(f"a token of kind {kind_text} has {END_CHUNKS} chunks or more")
        topic, type_name, type_hash, qos = chunks[NODE_CHUNKS:END_CHUNKS]
        end = End(
            _demangled(topic),
            type_from_dds(type_name),
            "" if type_hash == UNKNOWN_HASH else type_hash,
            parse_qos(qos),
        )
    return Token(
        _number(domain_text),
        zid,
        _number(node_number),
        _number(entity_number),
        kind,
        _demangled(enclave),
        node,
        end,
    )


def gid_of(key: str) -> bytes:
    """Return the gid of an entity, 16 bytes: every peer can compute it from the key of its token.

    Raises:
        NoBackendError: xxhash isn't installed.
    """
    try:
        import xxhash
    except ImportError as error:
        raise NoBackendError(
            f"the gids of Zenoh's endpoints need xxhash: {error}; install it with: pip install 'tfloom[zenoh]'"
        ) from None

    return xxhash.xxh3_128_digest(key.encode())[::-1]


def wire_qos(qos: QoS) -> QoS:
    """Return a quality of service with all defaults replaced as on this wire, where a depth of 0 means 42."""
    return qos.resolved(DEFAULT_DEPTH)


def qos_text(qos: QoS) -> str:
    """Return the text of a quality of service, in which defaults are left out: `::,10:,:,:,,`."""
    reliability = _unless(qos.reliability, ReliabilityPolicy.RELIABLE)
    durability = _unless(qos.durability, DurabilityPolicy.VOLATILE)
    history = _unless(qos.history, HistoryPolicy.KEEP_LAST)
    depth = _unless(qos.depth or DEFAULT_DEPTH, DEFAULT_DEPTH)
    liveliness = _unless(qos.liveliness, LivelinessPolicy.AUTOMATIC)
    deadline, lifespan, lease = map(
        _duration_text, (qos.deadline_ns, qos.lifespan_ns, qos.liveliness_lease_ns)
    )
    return f"{reliability}:{durability}:{history},{depth}:{deadline}:{lifespan}:{liveliness},{lease}"


def parse_qos(text: str) -> QoS:
    """Return the quality of service of a text; groups that follow are ignored.

    Raises:
        TokenError: it has another form, or a number that stands for nothing.
    """
    groups = [group.split(",") for group in text.split(":")[:6]]
    if len(groups) < 6 or any(
        len(group) < size for group, size in zip(groups, (1, 1, 2, 2, 2, 3), strict=True)
    ):
        raise TokenError(f"{text!r} is not a quality of service")
    reliability, durability, history, deadline, lifespan, liveliness = groups
    try:
        return QoS(
            ReliabilityPolicy(_number(reliability[0], ReliabilityPolicy.RELIABLE)),
            DurabilityPolicy(_number(durability[0], DurabilityPolicy.VOLATILE)),
            HistoryPolicy(_number(history[0], HistoryPolicy.KEEP_LAST)),
            _number(history[1], DEFAULT_DEPTH) or DEFAULT_DEPTH,
            _duration_ns(*deadline[:2]),
            _duration_ns(*lifespan[:2]),
            LivelinessPolicy(_number(liveliness[0], LivelinessPolicy.AUTOMATIC)),
            _duration_ns(*liveliness[1:3]),
        )
    except ValueError as error:
        raise TokenError(f"{text!r} is not a quality of service: {error}") from None


def _unless(number: int, default: int) -> str:
    return "" if number == default else str(int(number))


def _duration_text(duration_ns: int) -> str:
    parts = divmod(duration_ns if 0 < duration_ns < INFINITE_NS else INFINITE_NS, NS_PER_S)
    return ",".join(_unless(part, default) for part, default in zip(parts, _INFINITE, strict=True))


def _duration_ns(seconds: str, nanoseconds: str) -> int:
    total_ns = _number(seconds, _INFINITE[0]) * NS_PER_S + _number(nanoseconds, _INFINITE[1])
    return total_ns if 0 < total_ns < INFINITE_NS else INFINITE_NS


def _number(text: str, default: int | None = None) -> int:
    if not text and default is not None:
        return int(default)
    if not (text.isascii() and text.isdigit() and len(text) <= MAX_DIGITS):
        raise TokenError(f"{text[:MAX_DIGITS]!r} is not a number")
    return int(text)


def _mangled(name: str) -> str:
    return name.replace("/", "%")


def _demangled(chunk: str) -> str:
    return chunk.replace("%", "/")


GID_SIZE = 16
_ATTACHMENT = struct.Struct(f"<qqB{GID_SIZE}s")


class Attachment(NamedTuple):
    """The number and time of a sample and its writer; of a response, the number and client of its request."""

    sequence_number: int
    """From 1."""
    source_stamp_ns: int
    """By the writer's clock [ns since epoch]."""
    gid: bytes
    """16 bytes."""


def pack_attachment(sequence_number: int, gid: bytes) -> bytes:
    """Return the bytes of an attachment, with the time of now."""
    return _ATTACHMENT.pack(sequence_number, time.time_ns(), GID_SIZE, gid)


def unpack_attachment(attachment: Any) -> Attachment | None:
    """Return what a `zenoh.ZBytes` from the wire holds, or None. Bytes that follow are ignored."""
    if attachment is None:
        return None
    data = attachment.to_bytes()
    if len(data) < _ATTACHMENT.size:
        return None
    sequence_number, stamp_ns, size, gid = _ATTACHMENT.unpack_from(data)
    return Attachment(sequence_number, stamp_ns, gid) if size == GID_SIZE else None
