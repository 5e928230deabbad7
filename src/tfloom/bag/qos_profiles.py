"""QoS profiles of recordings: as YAML, as a recorder requests them, and as a player offers them.

A recorder subscribes with one by which it receives from every publisher of a topic.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from tfloom.bag.errors import BagError
from tfloom.bag.values import Topic
from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.qos import (
    INFINITE_NS,
    POLICIES,
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoS,
    QoSPolicyEnum,
    QoSPolicyKind,
    ReliabilityPolicy,
)

__all__ = [
    "MAX_KEPT_MESSAGES",
    "adapted",
    "offered",
    "offers_differ",
    "parse_profiles",
    "profiles_text",
    "read_overrides",
    "unmet_policies",
    "warnings_of",
]

_S_TO_NS = 1_000_000_000
_UNREADABLE = (KeyError, ValueError, TypeError, OverflowError, AttributeError)
_DEPTH_END = 1 << 31
_DURATIONS = {
    "deadline": "deadline_ns",
    "lifespan": "lifespan_ns",
    "liveliness_lease_duration": "liveliness_lease_ns",
}
_DEFAULTS: dict[str, QoSPolicyEnum] = {
    "history": HistoryPolicy.KEEP_LAST,
    "reliability": ReliabilityPolicy.RELIABLE,
    "durability": DurabilityPolicy.VOLATILE,
    "liveliness": LivelinessPolicy.AUTOMATIC,
}
MAX_KEPT_MESSAGES = 1000
"""How many static transforms' messages are kept for late subscriptions, at most."""
DEPTH_MAX = (1 << 31) - 1
"""The greatest depth that a wire takes."""
_STATIC_TF = "tf_static"


def profiles_text(profiles: Iterable[QoS]) -> str:
    """Return profiles as YAML, as rosbag2 writes them; there is no line break at the end."""
    return "\n".join(_text(profile) for profile in profiles) or "[]"


def _text(qos: QoS) -> str:
    return "\n".join(
        (
            f"- history: {qos.history.short_key}",
            f"  depth: {qos.depth}",
            f"  reliability: {qos.reliability.short_key}",
            f"  durability: {qos.durability.short_key}",
            *_duration_lines("deadline", qos.deadline_ns),
            *_duration_lines("lifespan", qos.lifespan_ns),
            f"  liveliness: {qos.liveliness.short_key}",
            *_duration_lines("liveliness_lease_duration", qos.liveliness_lease_ns),
            "  avoid_ros_namespace_conventions: false",
        )
    )


def _duration_lines(name: str, duration_ns: int) -> tuple[str, str, str]:
    seconds, rest = divmod(duration_ns, _S_TO_NS)
    return f"  {name}:", f"    sec: {seconds}", f"    nsec: {rest}"


def parse_profiles(text: str) -> list[QoS]:
    """Return the profiles in a bag's YAML, of any version: policies are names or numbers.

    What can't be read is left out, because a bag is readable without its profiles.
    """
    from tfloom.common import yaml as user_yaml

    try:
        values = user_yaml.load(text) if text else []
    except user_yaml.YamlError:
        return []
    profiles = [_profile_if_readable(value) for value in (values if isinstance(values, list) else [])]
    return [profile for profile in profiles if profile is not None]


def _profile_if_readable(values: Any) -> QoS | None:
    try:
        return _profile(values)
    except _UNREADABLE:
        return None


def read_overrides(path: str | Path) -> dict[str, QoS]:
    """Return the profiles in a file of overrides, by topic.

    Raises:
        BagError: it can't be read, or isn't a map from topics to profiles.
    """
    from tfloom.common import yaml as user_yaml

    try:
        values = user_yaml.load(Path(path).read_text("utf-8"))
    except OSError as error:
        raise BagError(path, f"it can't be read: {error.strerror}") from None
    except (user_yaml.YamlError, UnicodeDecodeError) as error:
        raise BagError(path, f"it isn't YAML: {error}") from None
    if not isinstance(values, dict):
        raise BagError(
            path, "it must be a map from topics to profiles, as `/scan: {reliability: best_effort}`"
        )
    topic: Any = None
    try:
        return {str(topic := name): _profile(values[name]) for name in values}
    except _UNREADABLE as error:
        if isinstance(error, KeyError) and error.args[0] in {"sec", "nsec"}:
            raise BagError(path, f"a duration in the profile of {topic} needs both sec and nsec") from None
        raise BagError(path, f"the profile of {topic} has an unknown value: {error}") from None


def _profile(values: Mapping[str, Any]) -> QoS:
    if unknown := values.keys() - {*_DEFAULTS, *_DURATIONS, "depth", "avoid_ros_namespace_conventions"}:
        raise ValueError(", ".join(sorted(unknown)))
    depth = int(values.get("depth", QoS().depth))
    if not 0 <= depth < _DEPTH_END:
        raise ValueError(f"depth {depth}")
    changes: dict[str, Any] = {"depth": depth}
    for name, default in _DEFAULTS.items():
        changes[name] = _policy(POLICIES[name], values[name]) if name in values else default
    for name, field in _DURATIONS.items():
        if name in values:
            changes[field] = _duration_ns(values[name])
    return QoS(**changes)


def _policy(kind: type[QoSPolicyEnum], value: Any) -> QoSPolicyEnum:
    return kind(value) if isinstance(value, int) else kind.get_from_short_key(str(value))


def _duration_ns(value: Mapping[str, Any]) -> int:
    """Return a duration [ns]; one without limit is `INFINITE_NS`, and so is 0."""
    duration = int(value["sec"]) * _S_TO_NS + int(value["nsec"])
    return duration if 0 < duration < INFINITE_NS else INFINITE_NS


def adapted(offers: Sequence[QoS]) -> QoS:
    """Return the strongest profile that is compatible with all offers; the default without any.

    All samples are kept until they are taken, so that none is replaced by a later one.
    """
    reliable = all(offer.reliability == ReliabilityPolicy.RELIABLE for offer in offers)
    kept = offers and all(offer.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers)
    return QoS(
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if kept else DurabilityPolicy.VOLATILE,
        history=HistoryPolicy.KEEP_ALL,
    )


def warnings_of(topic: str, offers: Sequence[QoS]) -> list[str]:
    """Return what the user should know about a profile that is adapted to different offers."""
    texts = []
    if 0 < sum(offer.reliability == ReliabilityPolicy.RELIABLE for offer in offers) < len(offers):
        texts.append(
            f"Some, but not all, publishers on topic '{topic}' are reliable. It is recorded as best effort, which "
            "receives from all of them: messages from reliable publishers may be lost."
        )
    if 0 < sum(offer.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers) < len(offers):
        texts.append(
            f"Some, but not all, publishers on topic '{topic}' are transient local. It is recorded as volatile, which "
            "receives from all of them: messages that were published before are not recorded."
        )
    return texts


def unmet_policies(offer: QoS, requested: QoS) -> list[QoSPolicyKind]:
    """Return the policies for which nothing is received from a publisher."""
    return incompatible_policies(offer.resolved(), requested.resolved())


def offers_differ(topic: Topic) -> bool:
    """Return whether the recorded publishers offered different qualities."""
    return (
        len({(profile.reliability, profile.durability) for profile in parse_profiles(topic.offered_qos)}) > 1
    )


def offered(topic: Topic) -> QoS:
    """Return the strongest of the recorded publishers' qualities; the default where the bag has none.

    One publisher takes the place of all recorded ones, so it keeps as many messages as all of them did. That of
    /tf_static keeps all, because each one may be of another frame.
    """
    profiles = parse_profiles(topic.offered_qos)
    is_static = topic.name.rpartition("/")[2] == _STATIC_TF
    if not profiles:
        profiles = [QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL)] if is_static else [QoS()]
    depth = min(sum(max(profile.depth, 1) for profile in profiles), DEPTH_MAX)
    if is_static:
        depth = max(depth, min(topic.message_count, MAX_KEPT_MESSAGES))
    is_reliable = any(profile.reliability == ReliabilityPolicy.RELIABLE for profile in profiles)
    is_kept = any(profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for profile in profiles)
    return QoS(
        reliability=ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if is_kept else DurabilityPolicy.VOLATILE,
        history=HistoryPolicy.KEEP_LAST,
        depth=depth,
        # Deadlines are not offered, because a pause would miss them.
        lifespan_ns=max(profile.lifespan_ns for profile in profiles),
        liveliness=LivelinessPolicy.AUTOMATIC,
    ).resolved()
