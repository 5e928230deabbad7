"""The graph of nodes and topics, for the page's picture."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from tfloom.viewer.displays.display import shown_text

if TYPE_CHECKING:
    from tfloom.rmw.base import EndpointInfo

__all__ = ["node_graph"]

HIDDEN_TOPICS = ("/rosout", "/parameter_events")
"""Topics of every node, which would hide the others."""
MAX_LINES = 2000
"""Number of lines between nodes and topics."""


def node_graph(endpoints: Iterable[EndpointInfo]) -> dict[str, list[str] | list[list[str]]]:
    """Return who publishes and subscribes to what: names, and pairs of names, in order.

    Nodes and topics whose names begin with an underscore are left out, and topics of every node.
    """
    published: set[tuple[str, str]] = set()
    subscribed: set[tuple[str, str]] = set()
    for end in endpoints:
        topic = end.topic.name
        if topic in HIDDEN_TOPICS or end.node is None or end.node.name.startswith("_"):
            continue
        node, topic = shown_text(end.node.full), shown_text(topic)
        if end.is_writer:
            published.add((node, topic))
        else:
            subscribed.add((topic, node))
    writes, reads = sorted(published)[:MAX_LINES], sorted(subscribed)[:MAX_LINES]
    topics = {topic for _, topic in writes} | {topic for topic, _ in reads}
    return {
        "publishers": sorted({node for node, _ in writes}),
        "topics": sorted(topics),
        "subscribers": sorted({node for _, node in reads}),
        "published": [list(pair) for pair in writes],
        "subscribed": [list(pair) for pair in reads],
    }
