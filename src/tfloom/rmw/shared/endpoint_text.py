"""The text that describes a writer or a reader on the graph, in the reference's format."""

from __future__ import annotations

from tfloom.rmw.base import NodeName
from tfloom.rmw.qos import INFINITE_NS, HistoryPolicy, QoS

UNKNOWN_NODE = NodeName("_NODE_NAMESPACE_UNKNOWN_", "_NODE_NAME_UNKNOWN_")
"""Shown for an endpoint without a node: its participant's node list has not arrived, or it is not a ROS program."""


def endpoint_text(
    node: NodeName, type_name: str, type_hash: str, kind: str, gid: bytes | list[int], qos: QoS
) -> str:
    """Return the lines that describe an endpoint.

    Args:
        node: The node of the endpoint.
        type_name: Name of the topic's type.
        type_hash: The type's hash as text.
        kind: PUBLISHER, SUBSCRIPTION or INVALID.
        gid: 16 bytes.
        qos: The offered or requested quality of service.
    """
    return "\n".join(
        [
            f"Node name: {node.name}",
            f"Node namespace: {node.namespace}",
            f"Topic type: {type_name}",
            f"Topic type hash: {type_hash}",
            f"Endpoint type: {kind}",
            f"GID: {'.'.join(f'{byte:02x}' for byte in gid)}",
            "QoS profile:",
            *(f"  {title}: {text}" for title, text in policy_texts(qos).items()),
        ]
    )


def policy_texts(qos: QoS) -> dict[str, str]:
    """Return each policy of a quality of service as text, by its title."""
    depth = f" ({qos.depth})" if qos.history == HistoryPolicy.KEEP_LAST else ""
    return {
        "Reliability": qos.reliability.name,
        "History (Depth)": f"{qos.history.name}{depth}",
        "Durability": qos.durability.name,
        "Lifespan": _duration(qos.lifespan_ns),
        "Deadline": _duration(qos.deadline_ns),
        "Liveliness": qos.liveliness.name,
        "Liveliness lease duration": _duration(qos.liveliness_lease_ns),
    }


def _duration(duration_ns: int) -> str:
    return "Infinite" if duration_ns >= INFINITE_NS else f"{duration_ns} nanoseconds"
