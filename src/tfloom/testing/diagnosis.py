"""Why a test waits in vain, as texts for its failure."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.rmw.typed_names import topic_of

if TYPE_CHECKING:
    from tfloom.node.endpoints.subscription import Subscription
    from tfloom.node.node import Node

__all__ = ["why_no_message", "why_not_spun"]

SHOWN = 10
"""Most names in a list."""


def why_not_spun(observer: Node) -> str:
    """Return a sentence on the nodes that nothing spins, with a semicolon before it; empty, if there are none."""
    from tfloom.node.executing.executor import executor_of

    executor = executor_of(observer)
    spun = set() if executor is None else {node.get_fully_qualified_name() for node in executor.get_nodes()}
    names = {
        f"{namespace.rstrip('/')}/{name}" for name, namespace in observer.get_node_names_and_namespaces()
    }
    if not (others := sorted(names - spun)):
        return ""
    return f"; this test does not spin {_listed(others)}: spin a node by ros_graph.add(node)"


def why_no_message(
    observer: Node, subscription: Subscription[Any], msg_type: type[Any], received: list[Any]
) -> str:
    """Return what is on a topic instead of the message that was waited for.

    Args:
        observer: The node that subscribed.
        subscription: The subscription.
        msg_type: The class that was asked for.
        received: The messages that were received, and not the right ones.
    """
    if received:
        return (
            f"{len(received)} others were received, of which `where` accepted none; the last: {received[-1]}"
        )
    topic = subscription.topic_name
    publishers = observer.get_publishers_info_by_topic(topic)
    wanted = topic_of(msg_type, topic).type_name
    wrong = [publisher for publisher in publishers if publisher.topic_type != wanted]
    if wrong and len(wrong) == len(publishers):
        return f"{wrong[0].node_name} publishes {wrong[0].topic_type} there, not {wanted}"
    if not publishers:
        topics = [name for name, _ in observer.get_topic_names_and_types() if name != topic]
        return f"nobody publishes there; topics of the graph: {_listed(topics)}{why_not_spun(observer)}"
    names = _listed(sorted({publisher.node_name for publisher in publishers}))
    return f"published by {names}, which sent nothing{why_not_spun(observer)}"


def _listed(names: list[str]) -> str:
    more = "" if len(names) <= SHOWN else f", and {len(names) - SHOWN} more"
    return (", ".join(names[:SHOWN]) or "none") + more
