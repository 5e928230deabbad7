"""The layers of the graph of nodes, and what it leaves out."""

from __future__ import annotations

import itertools
import random

import pytest

from tfloom.rmw.base import EndpointInfo, NodeName, ServiceEndInfo, Topic
from tfloom.rmw.qos import QoS
from tfloom.viewer import node_graph as module
from tfloom.viewer.node_graph import Vertex, layers_of, node_graph


def end(node: str | None, topic: str, *, is_writer: bool) -> EndpointInfo:
    name = None if node is None else NodeName("/", node)
    return EndpointInfo(Topic(topic, "std_msgs/msg/String", ""), name, is_writer, bytes(16), QoS())


def service_end(node: str, name: str, *, is_server: bool) -> ServiceEndInfo:
    return ServiceEndInfo(name, "x/srv/X", NodeName("/", node), is_server, bytes(16), QoS())


def names(graph: dict[str, list[dict[str, object]]]) -> list[tuple[object, ...]]:
    return [(vertex["kind"], vertex["name"], vertex["layer"]) for vertex in graph["vertices"]]


def vertices(text: str) -> list[Vertex]:
    return [Vertex("node", letter) for letter in text]


def layers(*pairs: str) -> list[str]:
    """Return the layers of edges between single letters, as texts."""
    edges = [(Vertex("node", first), Vertex("node", second)) for first, second in pairs]
    return ["".join(vertex.name for vertex in layer) for layer in layers_of(edges)]


def test_data_flows_from_layer_to_layer() -> None:
    ends = [
        end("camera", "/image", is_writer=True),
        end("filter", "/image", is_writer=False),
        end("filter", "/edges", is_writer=True),
        end("viewer", "/edges", is_writer=False),
        end("viewer", "/image", is_writer=False),
        end("camera", "/rosout", is_writer=True),
        end("_hidden", "/image", is_writer=False),
        end(None, "/image", is_writer=False),
    ]
    graph = node_graph(ends)
    assert names(graph) == [
        ("node", "/camera", 0),
        ("topic", "/image", 1),
        ("node", "/filter", 2),
        ("topic", "/edges", 3),
        ("node", "/viewer", 4),
    ]
    assert sorted(graph["edges"]) == [[0, 1], [1, 2], [1, 4], [2, 3], [3, 4]]


def test_services_and_actions_are_there_where_they_are_asked_for() -> None:
    ends = [
        service_end("asker", "/spawn", is_server=False),
        service_end("sim", "/spawn", is_server=True),
        service_end("sim", "/sim/get_parameters", is_server=True),
        service_end("asker", "/turn/_action/send_goal", is_server=False),
        service_end("sim", "/turn/_action/send_goal", is_server=True),
        service_end("sim", "/turn/_action/cancel_goal", is_server=True),
    ]
    assert names(node_graph([], ends)) == []
    assert names(node_graph([], ends, with_services=True)) == [
        ("node", "/asker", 0),
        ("service", "/spawn", 1),
        ("node", "/sim", 2),
    ]
    both = node_graph([], ends, with_services=True, with_actions=True)
    assert names(both)[1:3] == [("action", "/turn", 1), ("service", "/spawn", 1)]
    assert sorted(both["edges"]) == [[0, 1], [0, 2], [1, 3], [2, 3]]


@pytest.mark.parametrize(
    ("pairs", "expected"),
    [
        ([], []),
        (["aa"], ["a"]),
        (["ab", "ba"], ["a", "b"]),
        (["ab", "bc", "ca"], ["a", "b", "c"]),
        (["xa", "ab", "ba"], ["x", "a", "b"]),  # a loop is entered where its source leads
        (["ab", "ac", "bd", "cd"], ["a", "bc", "d"]),
        (["ab", "bc", "ac"], ["a", "b", "c"]),  # behind all that lead to it
        (["ad", "be", "cf"], ["abc", "def"]),
        (["af", "be", "cd"], ["cba", "def"]),  # without a crossing
    ],
)
def test_layers(pairs: list[str], expected: list[str]) -> None:
    assert layers(*pairs) == expected


def test_edges_without_loops_lead_to_later_layers() -> None:
    rng = random.Random(4)
    for _ in range(200):
        count = rng.randint(2, 12)
        all_vertices = vertices("abcdefghijkl"[:count])
        shuffled = rng.sample(all_vertices, count)
        edges = [pair for pair in itertools.combinations(shuffled, 2) if rng.random() < 0.3]
        found = layers_of(edges)
        places = {vertex: number for number, layer in enumerate(found) for vertex in layer}
        assert sorted(places) == sorted({vertex for edge in edges for vertex in edge})
        for first, second in edges:
            assert places[first] < places[second]
        for vertex, number in places.items():  # no further back than it has to be
            assert number == max(
                (places[first] + 1 for first, second in edges if second == vertex), default=0
            )


def test_long_chains_and_large_graphs_are_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    chain = [Vertex("node", f"{number:06}") for number in range(3000)]
    assert layers_of(list(itertools.pairwise(chain))) == [[vertex] for vertex in chain]
    monkeypatch.setattr(module, "MAX_EDGES", 3)
    graph = node_graph([end("many", f"/topic{number}", is_writer=True) for number in range(10)])
    assert len(graph["edges"]) == 3
    assert len(graph["vertices"]) == 4
