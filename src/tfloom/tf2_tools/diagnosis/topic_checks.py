"""Checks of topics: quality of service, type and content of those of transforms, and who uses frames."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.base import EndpointInfo
from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.qos import DurabilityPolicy, QoSPolicyKind, ReliabilityPolicy
from tfloom.tf2_tools.diagnosis.catalogue import Limits
from tfloom.tf2_tools.diagnosis.finding import Evidence, Finding, Source
from tfloom.tf2_tools.diagnosis.subject import FrameUse, Subject, listed, source_of
from tfloom.tf2_tools.text import counted

TYPE = TFMessage._TYPE_NAME


def check_topics(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on topics; on their endpoints only if the graph is known."""
    yield from _unreadable_messages(subject)
    yield from _other_types(subject)
    ends = [end for end in subject.seen.endpoints if end.topic.type_name == TYPE]
    # An endpoint that connects with none of its peers is an error; its quality of service is not reported again as
    # unusual.
    mismatched: set[bytes] = set()
    for writer in (end for end in ends if end.is_writer):
        for finding in _mismatches(writer, [end for end in ends if not end.is_writer]):
            mismatched.update((writer.gid, *(bytes.fromhex(source.gid) for source in finding.sources)))
            yield finding
    yield from _unusual_qos([end for end in ends if end.gid not in mismatched], subject.static_topic)


def end_source(end: EndpointInfo) -> Source:
    """Return a publisher or a subscription of the graph as the source of a finding."""
    return Source("" if end.node is None else end.node.full, end.topic.name, end.gid.hex())


def _unreadable_messages(subject: Subject) -> Iterator[Finding]:
    for publisher in subject.seen.publishers:
        traffic = publisher.traffic
        if traffic is None or not traffic.unreadable:
            continue
        source = source_of(publisher)
        figures: dict[str, str | float | int | None] = {
            "unreadable": traffic.unreadable,
            "messages": traffic.messages,
        }
        text = f"{traffic.unreadable} of {traffic.messages} messages"
        yield Finding(
            "TF505",
            f"{source} sends messages that are not tf2_msgs/msg/TFMessage",
            [source],
            [],
            [Evidence(text, figures)],
        )


def _other_types(subject: Subject) -> Iterator[Finding]:
    for end in subject.seen.endpoints:
        if end.topic.type_name == TYPE:
            continue
        source = end_source(end)
        verb = "publishes" if end.is_writer else "subscribes to"
        yield Finding("TF506", f"{source} {verb} {end.topic.type_name} instead of {TYPE}", [source])


def _mismatches(writer: EndpointInfo, readers: list[EndpointInfo]) -> Iterator[Finding]:
    """Yield a finding for a publisher and all subscriptions of its topic that don't connect with it."""
    apart: dict[QoSPolicyKind, list[EndpointInfo]] = {}
    for reader in readers:
        if reader.topic.name == writer.topic.name:
            for policy in incompatible_policies(writer.qos, reader.qos):
                apart.setdefault(policy, []).append(reader)
    for policy, deprived in apart.items():
        sources = [end_source(end) for end in (writer, *deprived)]
        offered, requested = _policy_text(writer, policy), _policy_text(deprived[0], policy)
        names = listed(source.node or f"GID {source.gid}" for source in sources[1:])
        yield Finding(
            "TF503",
            f"{sources[0]} offers {offered}, but {names} requests {requested}: they do not connect",
            sources,
            [],
            [Evidence(f"{policy.name}: offered {offered}, requested {requested}", {"policy": policy.name})],
        )


def _policy_text(end: EndpointInfo, policy: QoSPolicyKind) -> str:
    value = getattr(end.qos, policy.name.lower(), None)
    return str(getattr(value, "name", None) or policy.name.lower())


def _unusual_qos(ends: list[EndpointInfo], static_topic: str) -> Iterator[Finding]:
    for end in ends:
        is_volatile = (
            end.topic.name == static_topic and end.qos.durability != DurabilityPolicy.TRANSIENT_LOCAL
        )
        is_lossy = end.is_writer and end.qos.reliability == ReliabilityPolicy.BEST_EFFORT
        verb = "offers" if end.is_writer else "requests"
        for policy in ["VOLATILE"] * is_volatile + ["BEST_EFFORT"] * is_lossy:
            source = end_source(end)
            yield Finding(
                "TF504",
                f"{source} {verb} {policy}",
                [source],
                [],
                [Evidence(f"offered or requested: {policy}", {"policy": policy})],
            )


def check_uses(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on frames that are named and that no transform holds."""
    yield from _unknown_frames(subject, "TF601", subject.headers, "is in the frame", "message")
    yield from _unknown_frames(subject, "TF602", subject.requests, "requests the frame", "request")


def _unknown_frames(
    subject: Subject, code: str, uses: Sequence[FrameUse], verb: str, what: str
) -> Iterator[Finding]:
    for use in uses:
        if use.frame and use.frame not in subject.frames:
            hint = subject.near(use.frame)
            evidence = Evidence(f"{counted(use.count, what)}{hint}", {"count": use.count, "frame": use.frame})
            summary = f"what {use.source} publishes" if code == "TF601" else str(use.source)
            yield Finding(
                code,
                f"{summary} {verb} {use.frame!r}, which no transform holds",
                [use.source],
                [use.frame],
                [evidence],
            )
