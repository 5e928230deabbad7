"""The graph of nodes, topics, services and actions, in layers, for the page's picture."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.rmw.typed_names import SEND_GOAL
from tfloom.viewer.displays.display import shown_text

if TYPE_CHECKING:
    from tfloom.rmw.base import EndpointInfo, NodeName, ServiceEndInfo

__all__ = ["Vertex", "layers_of", "node_graph"]

HIDDEN_TOPICS = ("/rosout", "/parameter_events")
"""Topics of every node, which would hide the others."""
HIDDEN_SERVICES = (
    *("describe_parameters", "get_parameter_types", "get_parameters", "list_parameters", "set_parameters"),
    *("set_parameters_atomically", "get_type_description", "get_logger_levels", "set_logger_levels"),
)
"""Last words of services of every node."""
ACTION_PART = "/_action/"
MAX_EDGES = 2000
"""Number of edges of the picture."""
SWEEPS = 8
"""How often all layers are put in the order of their neighbours."""


class Vertex(NamedTuple):
    """What the picture has a box for."""

    kind: str
    """`node`, `topic`, `service` or `action`."""
    name: str


Edge = tuple[Vertex, Vertex]


def node_graph(
    endpoints: Iterable[EndpointInfo],
    service_ends: Iterable[ServiceEndInfo] = (),
    *,
    with_services: bool = False,
    with_actions: bool = False,
) -> dict[str, Any]:
    """Return who publishes and subscribes to what, and who calls whom, as values for JSON.

    `vertices` have a kind, a name, the number of their layer and of their place in it; `edges` are pairs of their
    numbers, each in the direction of the data, or from a client to a server. Nodes and topics whose names begin with an
    underscore are left out, and topics and services of every node.
    """
    edges = [*_topic_edges(endpoints), *_service_edges(service_ends, with_services, with_actions)]
    edges = sorted(set(edges))[:MAX_EDGES]
    layers = layers_of(edges)
    numbers = {vertex: number for number, vertex in enumerate(vertex for layer in layers for vertex in layer)}
    return {
        "vertices": [
            {"kind": vertex.kind, "name": vertex.name, "layer": number, "place": place}
            for number, layer in enumerate(layers)
            for place, vertex in enumerate(layer)
        ],
        "edges": [[numbers[first], numbers[second]] for first, second in edges],
    }


def _topic_edges(endpoints: Iterable[EndpointInfo]) -> Iterable[Edge]:
    for end in endpoints:
        if end.topic.name in HIDDEN_TOPICS or _is_hidden(end.node):
            continue
        node, topic = _of_node(end.node), Vertex("topic", shown_text(end.topic.name))
        yield (node, topic) if end.is_writer else (topic, node)


def _service_edges(ends: Iterable[ServiceEndInfo], with_services: bool, with_actions: bool) -> Iterable[Edge]:
    for end in ends:
        is_action = ACTION_PART in end.name
        if _is_hidden(end.node) or not (with_actions if is_action else with_services):
            continue
        if is_action and not end.name.endswith(SEND_GOAL):
            continue
        if not is_action and end.name.rpartition("/")[2] in HIDDEN_SERVICES:
            continue
        kind, name = ("action", end.name.removesuffix(SEND_GOAL)) if is_action else ("service", end.name)
        node, what = _of_node(end.node), Vertex(kind, shown_text(name))
        yield (what, node) if end.is_server else (node, what)


def _is_hidden(node: NodeName | None) -> bool:
    return node is None or node.name.startswith("_")


def _of_node(node: NodeName | None) -> Vertex:
    return Vertex("node", "" if node is None else shown_text(node.full))


def layers_of(edges: Sequence[Edge]) -> list[list[Vertex]]:
    """Return the vertices of edges in layers, each in an order in which few edges cross.

    An edge leads to a later layer, unless a search in depth finds that it leads back, as one that closes a loop. A
    vertex is in the first layer that is behind all that lead to it; layers are then put in the order of their
    neighbours' means, back and forth (the method of Sugiyama, Tagawa and Toda, 1981).
    """
    following: dict[Vertex, list[Vertex]] = {}
    for first, second in edges:
        following.setdefault(first, []).append(second)
        following.setdefault(second, [])
    numbers: dict[Vertex, int] = dict.fromkeys(following, 0)
    order, forward = _without_loops(following)
    for vertex in order:
        for later in forward[vertex]:
            numbers[later] = max(numbers[later], numbers[vertex] + 1)
    layers: list[list[Vertex]] = [[] for _ in range(max(numbers.values(), default=-1) + 1)]
    for vertex in sorted(following):
        layers[numbers[vertex]].append(vertex)
    neighbours: dict[Vertex, list[Vertex]] = {vertex: [] for vertex in following}
    for first, second in edges:
        neighbours[first].append(second)
        neighbours[second].append(first)
    for sweep in range(SWEEPS):
        _sort_layers(layers if sweep % 2 == 0 else layers[::-1], neighbours)
    return layers


def _without_loops(
    following: dict[Vertex, list[Vertex]],
) -> tuple[list[Vertex], dict[Vertex, list[Vertex]]]:
    """Return the vertices, each before those that follow it, and what follows each but for edges that lead back."""
    forward: dict[Vertex, list[Vertex]] = {vertex: [] for vertex in following}
    done: list[Vertex] = []
    is_open: dict[Vertex, bool] = {}
    """Whether the search is below a vertex that it has met."""
    has_source = {later for follows in following.values() for later in follows}
    for start in sorted(following, key=lambda vertex: (vertex in has_source, vertex)):
        if start in is_open:
            continue
        is_open[start] = True
        stack = [(start, iter(following[start]))]
        while stack:
            vertex, left = stack[-1]
            for later in left:
                if not is_open.get(later, False):
                    forward[vertex].append(later)
                if later not in is_open:
                    is_open[later] = True
                    stack.append((later, iter(following[later])))
                    break
            else:
                is_open[vertex] = False
                done.append(vertex)
                stack.pop()
    return done[::-1], forward


def _sort_layers(layers: Sequence[list[Vertex]], neighbours: dict[Vertex, list[Vertex]]) -> None:
    """Put each layer in the order of the mean of its neighbours' places, as shares of their layers' lengths."""
    places = {vertex: (place + 0.5) / len(layer) for layer in layers for place, vertex in enumerate(layer)}
    for layer in layers:
        means = {
            vertex: sum(places[one] for one in neighbours[vertex]) / max(1, len(neighbours[vertex]))
            for vertex in layer
        }
        layer.sort(key=lambda vertex: (means[vertex], vertex))
        places |= {vertex: (place + 0.5) / len(layer) for place, vertex in enumerate(layer)}
