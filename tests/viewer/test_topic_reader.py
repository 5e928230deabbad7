"""A topic of the viewer, whose publishers offer different qualities of service, or come later."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from tests.conftest import wait_until
from tests.viewer.messages import marker

from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.visualization_msgs.msg import Marker
from tfloom.rmw import backends
from tfloom.rmw.base import NodeName, Writer
from tfloom.rmw.errors import WireError
from tfloom.rmw.qos import DurabilityPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.topic_log import Cursor
from tfloom.viewer.topic_reader import KEPT_DEPTH, LATCHED_DEPTH
from tfloom.viewer.topics import LiveTopics

S = 1_000_000_000
NODE = NodeName("/", "viewer")
RELIABLE = QoS(ReliabilityPolicy.RELIABLE, depth=10)
LOOSE = QoS(ReliabilityPolicy.BEST_EFFORT, depth=10)
LATCHED = RELIABLE._replace(durability=DurabilityPolicy.TRANSIENT_LOCAL)
LOOSE_LATCHED = LATCHED._replace(reliability=ReliabilityPolicy.BEST_EFFORT)
WIRES = ["tfloom_local", pytest.param("rmw_cyclonedds_cpp", marks=pytest.mark.wire)]


class Graph:
    """Publishers of one topic, and what the viewer has of it."""

    def __init__(self, domain_id: int, message_class: type[Any]) -> None:
        self.message_class = message_class
        self.participants = [backends.open_participant(domain_id) for _ in range(2)]
        for participant in self.participants:
            participant.add_node(NODE)
        self.topics = LiveTopics(self.participants[0], NODE, 60 * S, lambda: 5 * S)
        self.cursor: Cursor | None = None

    def publish(self, qos: QoS, *texts: str) -> Writer:
        """Publish by a new publisher."""
        writer = self.participants[1].create_writer(NODE, topic_of(self.message_class, "/t"), qos)
        self.write(writer, *texts)
        return writer

    def write(self, writer: Writer, *texts: str) -> None:
        for text in texts:
            made = marker(Marker.CUBE, ns=text) if self.message_class is Marker else String(data=text)
            writer.write(cdr.encode(made))

    def open(self) -> None:
        wait_until(lambda: "/t" in self.topics.types(), what="the topic")
        self.cursor = self.topics.open("/t")

    def texts(self) -> list[str]:
        """Return what has come, in its order."""
        self.topics.poll()
        assert self.cursor is not None
        messages = [entry.message() for entry in Cursor(self.cursor.log).read()]
        return [getattr(message, "ns", None) or getattr(message, "data", "") for message in messages]

    def wait_for(self, *texts: str) -> None:
        wait_until(lambda: sorted(self.texts()) == sorted(texts), what=f"{texts}: {self.texts()}")

    def readers(self) -> list[QoS]:
        """Return what the viewer's readers of the topic request."""
        ends = self.participants[0].graph.endpoints()
        return [end.qos for end in ends if not end.is_writer and end.topic.name == "/t"]

    def sees(self, writer: Writer) -> bool:
        return any(end.gid == writer.gid for end in self.participants[0].graph.endpoints())


@pytest.fixture
def domain(request: pytest.FixtureRequest, domain_id: int, monkeypatch: pytest.MonkeyPatch) -> int:
    monkeypatch.setenv("RMW_IMPLEMENTATION", request.param)
    return domain_id


@pytest.fixture(params=[String, Marker])
def graph(request: pytest.FixtureRequest, domain: int) -> Iterator[Graph]:
    made = Graph(domain, request.param)
    yield made
    made.topics.close_all()
    for participant in made.participants:
        participant.close()


@pytest.mark.parametrize("domain", WIRES, indirect=True)
@pytest.mark.parametrize("first", [LATCHED, RELIABLE, LOOSE, LOOSE_LATCHED])
@pytest.mark.parametrize("second", [LATCHED, RELIABLE, LOOSE, LOOSE_LATCHED])
def test_publishers_that_come_later_are_read_whatever_they_offer(
    first: QoS, second: QoS, graph: Graph
) -> None:
    one = graph.publish(first)
    graph.open()
    two = graph.publish(second)
    wait_until(lambda: graph.sees(two), what="the second publisher")
    graph.texts()  # opens what it needs
    wait_until(lambda: one.matched_count() and two.matched_count(), what="matches")
    for number in range(3):
        graph.write(one, f"one {number}")
        graph.write(two, f"two {number}")
    graph.wait_for(*(f"{name} {number}" for name in ("one", "two") for number in range(3)))


@pytest.mark.parametrize("domain", WIRES, indirect=True)
def test_kept_messages_of_a_publisher_that_comes_later_are_read(graph: Graph) -> None:
    graph.publish(LOOSE)
    graph.open()
    graph.publish(LATCHED, "a", "b")
    graph.wait_for("a", "b")


@pytest.mark.parametrize("domain", WIRES, indirect=True)
def test_what_a_publisher_wrote_that_has_left_is_read(graph: Graph) -> None:
    one = graph.publish(LATCHED)
    graph.open()
    two = graph.publish(LOOSE)
    wait_until(lambda: graph.sees(two), what="the second publisher")
    graph.texts()
    wait_until(lambda: one.matched_count() and two.matched_count(), what="matches")
    graph.write(two, "last")
    two.close()
    wait_until(lambda: not graph.sees(two), what="the second publisher's end")
    graph.wait_for("last")


@pytest.mark.parametrize("domain", ["tfloom_local"], indirect=True)
def test_refused_reader_is_told_and_the_others_go_on(graph: Graph, monkeypatch: pytest.MonkeyPatch) -> None:
    one = graph.publish(LOOSE)
    graph.open()
    made = graph.participants[0].create_reader

    def refuse(*_: Any) -> Any:
        raise WireError("no more readers")

    monkeypatch.setattr(graph.participants[0], "create_reader", refuse)
    graph.publish(LATCHED, "kept")
    graph.write(one, "one")
    with pytest.raises(DisplayError, match="no more readers"):
        graph.texts()
    monkeypatch.setattr(graph.participants[0], "create_reader", made)
    graph.publish(LATCHED)
    graph.wait_for("one", "kept")


@pytest.mark.parametrize("domain", ["tfloom_local"], indirect=True)
def test_topic_that_is_closed_leaves_none_of_its_readers(graph: Graph) -> None:
    graph.publish(LOOSE)
    graph.publish(LATCHED)
    graph.open()
    assert len(graph.readers()) == 2
    assert graph.cursor is not None
    graph.cursor.close()
    assert graph.readers() == []


@pytest.mark.parametrize("domain", WIRES, indirect=True)
def test_queue_has_the_greatest_depth_that_is_asked_for(
    graph: Graph, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A display that comes, changes its depth or goes changes the reader, and no message is lost or comes twice."""
    usual = KEPT_DEPTH if graph.message_class is Marker else LATCHED_DEPTH
    asked: list[int] = []
    create = graph.participants[0].create_reader

    def note(node: NodeName, topic: Any, qos: QoS) -> Any:
        asked.append(qos.depth)
        return create(node, topic, qos)

    monkeypatch.setattr(graph.participants[0], "create_reader", note)
    writer = graph.publish(LATCHED, "kept")
    wait_until(lambda: "/t" in graph.topics.types(), what="the topic")
    graph.cursor = first = graph.topics.open("/t", 3)
    graph.wait_for("kept")
    assert asked == [3]
    second = graph.topics.open("/t", 7)
    graph.texts()
    second.close()
    graph.texts()
    first.depth = 0
    graph.texts()
    first.depth = 5
    graph.texts()
    assert asked == [3, 7, 3, usual, 5]
    assert len(graph.readers()) == 1
    wait_until(lambda: writer.matched_count() == 1, what="the match of the last reader")
    graph.write(writer, "new")
    graph.wait_for("kept", "new")
    first.close()
    assert graph.readers() == []
    graph.cursor = graph.topics.open("/t")
    assert asked[-1] == usual


@pytest.mark.parametrize("domain", ["tfloom_local"], indirect=True)
def test_queue_keeps_as_many_messages_as_it_is_deep(graph: Graph) -> None:
    writer = graph.publish(LOOSE)
    wait_until(lambda: "/t" in graph.topics.types(), what="the topic")
    for depth in (3, 5):
        graph.cursor = graph.topics.open("/t", depth)
        texts = [f"{depth} {number}" for number in range(10)]
        graph.write(writer, *texts)
        graph.wait_for(*texts[-depth:])
        graph.cursor.close()


@pytest.mark.parametrize("domain", ["tfloom_local"], indirect=True)
def test_queue_that_is_refused_is_told_and_the_reader_stays(
    graph: Graph, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer = graph.publish(LOOSE)
    graph.open()
    assert graph.cursor is not None

    def refuse(*_: Any) -> Any:
        raise WireError("no more readers")

    with monkeypatch.context() as patch:
        patch.setattr(graph.participants[0], "create_reader", refuse)
        graph.cursor.depth = 7
        with pytest.raises(DisplayError, match="no more readers"):
            graph.texts()
        graph.write(writer, "one")
        with pytest.raises(DisplayError, match="no more readers"):
            graph.texts()
    graph.wait_for("one")
    graph.write(writer, "two")
    graph.wait_for("one", "two")
