"""The check of `doctor` on qualities of service: which publishers and subscriptions of a topic don't connect."""

from __future__ import annotations

from collections.abc import Iterator

from tfloom.cli.doctor.finding import Finding, Verdict
from tfloom.rmw.base import EndpointInfo
from tfloom.rmw.errors import WireError

QOS_TIMEOUT_S = 5.0
"""The longest wait for the endpoints of other participants [s]."""
MAX_PAIRS = 20
"""Pairs that are named, because a topic may have hundreds."""


def check_qos() -> Finding:
    """Check that the publishers of each topic offer what its subscriptions request."""
    from tfloom.cli.shared.graph import settled_graph

    try:
        with settled_graph(QOS_TIMEOUT_S) as graph:
            ends = list(graph.endpoints())
            passes_all = graph.delivers_incompatible()
    except WireError as error:
        return Finding(Verdict.FAILED, str(error))
    by_topic: dict[str, tuple[list[EndpointInfo], list[EndpointInfo]]] = {}
    for end in ends:
        by_topic.setdefault(end.topic.name, ([], []))[0 if end.is_writer else 1].append(end)
    apart = [
        pair
        for topic, (writers, readers) in sorted(by_topic.items())
        for pair in _apart(topic, writers, readers)
    ]
    if not apart:
        return Finding(
            Verdict.OK, "no publisher and subscription of a topic differ so that they don't connect"
        )
    details = {f"pair {number}": text for number, text in enumerate(apart[:MAX_PAIRS], 1)}
    more = f"; and {len(apart) - 1} more pair{'s' * (len(apart) > 2)}: see --report" if len(apart) > 1 else ""
    if passes_all:
        verdict, consequence = Verdict.WARNING, "their messages pass on this wire, but don't on others"
    else:
        verdict, consequence = Verdict.FAILED, "no message passes between them"
    advice = "give both the same quality of service, or the subscription the weaker one, as best effort"
    return Finding(verdict, f"{apart[0]}, so {consequence}{more}", advice, details)


def _apart(topic: str, writers: list[EndpointInfo], readers: list[EndpointInfo]) -> Iterator[str]:
    from tfloom.rmw.shared.qos_mismatch import differences

    for writer in writers:
        for reader in readers:
            if texts := differences(writer, reader):
                yield f"{topic}: {_node(writer)} {_node(reader, 'and ')}: {'; '.join(texts)}"


def _node(end: EndpointInfo, before: str = "") -> str:
    return before + ("an unknown node" if end.node is None else end.node.full)
