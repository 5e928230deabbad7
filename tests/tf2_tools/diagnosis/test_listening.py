"""Listening on the wire inside the process: publishers that leave, headers, and who subscribes."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator

import pytest
from tests.conftest import wait_until
from tests.tf2_tools.diagnosis.faulty_nodes import Node, S, edge

from tfloom._native import HeaderSink
from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.sensor_msgs.msg import Image
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.tf2_msgs.action import LookupTransform
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import Participant, Sample, Service
from tfloom.rmw.qos import QoS
from tfloom.rmw.topic_names import request_topic, response_topic
from tfloom.rmw.typed_names import SEND_GOAL_TYPE
from tfloom.rosidl import cdr
from tfloom.tf2_tools.diagnosis.live import LOOKUP_TYPE, listen, requested_frames
from tfloom.tf2_tools.diagnosis.report import diagnose
from tfloom.tf2_tools.diagnosis.subject import Subject, begins_with_header


@pytest.fixture
def participant(monkeypatch: pytest.MonkeyPatch) -> Iterator[Participant]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    opened = open_participant(0)
    yield opened
    opened.close()


def read_topics(participant: Participant) -> set[str]:
    return {end.topic.name for end in participant.graph.endpoints() if not end.is_writer}


def listen_while(
    participant: Participant, act: Callable[[], None], *, with_topics: bool = False, seconds: float = 0.3
) -> Subject:
    """Listen for a short time, and act once both topics are read."""
    heard: list[Subject] = []
    thread = threading.Thread(
        target=lambda: heard.append(listen(participant, seconds, with_topics=with_topics)), daemon=True
    )
    thread.start()
    wait_until(lambda: "/tf_static" in read_topics(participant))
    act()
    thread.join()
    return heard[0]


def test_a_publisher_that_restarts(participant: Participant) -> None:
    former = Node(participant, "mounting")
    former.send(edge("base", "camera", x=1.0), topic="/tf_static")

    def restart() -> None:
        former.writer("/tf_static").close()
        Node(participant, "mounting").send(edge("base", "camera", x=1.0), topic="/tf_static")

    subject = listen_while(participant, restart)
    assert [edge.publisher.has_left for edge in subject.seen.edges] == [True, False]
    assert diagnose(subject) == []


def test_a_simulation_that_restarts(participant: Participant) -> None:
    former, later = Node(participant, "simulator"), Node(participant, "simulator")

    def restart() -> None:
        for number in range(10):
            former.send(edge("map", "base", stamp_ns=100 * S + number * S // 50, x=number * 0.01))
        former.writer("/tf").close()
        for number in range(10):
            later.send(edge("map", "base", stamp_ns=S + number * S // 50, x=number * 0.01))

    findings = {finding.code: finding for finding in diagnose(listen_while(participant, restart))}
    assert "TF407" not in findings
    text = findings["TF408"].evidence[0].text
    assert text == "map -> base: by 99.180 s at most, 10 of 10 transforms are rejected as old"


def test_headers_are_read_on_request(participant: Participant) -> None:
    node = Node(participant, "camera")
    node.send(edge("base", "camera", x=1.0), topic="/tf_static")
    image, point = Image(data=[0] * 1000), PointStamped()
    image.header.frame_id = "camera"
    point.header.frame_id = "hand"
    image_writer = node.writer("/image", Image)
    point_writer = node.writer("/point", PointStamped)
    node.writer("/text", String)

    def publish() -> None:
        wait_until(lambda: {"/image", "/point"} <= read_topics(participant))
        for writer, message in ((image_writer, image), (point_writer, point)):
            writer.write(cdr.encode(message))

    subject = listen_while(participant, publish, with_topics=True)
    assert sorted((use.frame, str(use.source), use.count) for use in subject.headers) == [
        ("camera", "/faults/camera on /image", 1),
        ("hand", "/faults/camera on /point", 1),
    ]
    assert [finding.code for finding in diagnose(subject)] == ["TF601"]
    assert listen(participant, 0.0).headers == []


def test_it_stands_beside_a_server_for_as_long_as_that_is_there(participant: Participant) -> None:
    node = Node(participant, "buffer")
    service = Service("/lookup/_action/send_goal", LOOKUP_TYPE + SEND_GOAL_TYPE)
    server = participant.create_responder(node.name, service, QoS())

    def ends() -> list[str]:
        names = {request_topic(service).name, response_topic(service).name}
        return [end.topic.name for end in participant.graph.raw_endpoints() if end.topic.name in names]

    alone = ends()

    def leave() -> None:
        wait_until(lambda: len(ends()) == len(alone) + 2)
        server.close()
        wait_until(lambda: ends() == [])
        assert "/tf_static" in read_topics(participant), "the listening has ended"

    listen_while(participant, leave, seconds=2.0)


def test_nothing_of_the_doctor_stays(participant: Participant) -> None:
    listen(participant, 0.0, with_topics=True)
    assert participant.graph.nodes() == []
    assert participant.graph.endpoints() == []


def test_types_with_headers() -> None:
    for type_name, expected in (
        ("sensor_msgs/msg/Image", True),
        ("std_msgs/msg/Header", False),
        ("std_msgs/msg/String", False),
        ("tf2_msgs/msg/TFMessage", False),
        ("visualization_msgs/msg/MarkerArray", False),
        ("nobody_msgs/msg/Nothing", False),
        ("no type", False),
    ):
        assert begins_with_header(type_name) is expected, type_name


HEADER = bytes((0, 1, 0, 0)) + bytes(8)
HOSTILE = [
    b"",
    bytes(3),
    HEADER,
    HEADER + b"\xff\xff\xff\xff",
    HEADER + b"\x05\x00\x00\x00abc",
    HEADER + b"\x04\x00\x00\x00abcd",
    HEADER + b"\x04\x00\x00\x00\xff\xfe\xfd\x00",
    HEADER + (2000).to_bytes(4, "little") + b"a" * 1999 + b"\0",
    bytes((0, 7, 0, 0)) + bytes(8) + b"\x02\x00\x00\x00a\0",
]


def test_hostile_headers_are_counted() -> None:
    sink = HeaderSink()
    for data in HOSTILE:
        sink.push(data, 0, 0, bytes(16))
    assert (sink.uses(), sink.unreadable_count) == ([], len(HOSTILE))
    sink.push(HEADER + b"\x02\x00\x00\x00a\0" + b"rest", 0, 0, bytes(16))
    sink.push(bytes(12) + b"\x00\x00\x00\x02a\0", 0, 0, bytes(16))
    assert sink.uses() == [(bytes(16), "a", 2)], "of both byte orders"


def test_the_memory_for_headers_is_bounded() -> None:
    sink = HeaderSink()
    for number in range(5000):
        name = f"{number:06}\0".encode()
        sink.push(HEADER + len(name).to_bytes(4, "little") + name, 0, 0, bytes(16))
    assert len(sink.uses()) == 4096


def test_requests_in_both_forms_of_services() -> None:
    goal = LookupTransform.Goal(target_frame="map", source_frame="laser", fixed_frame="odom")
    request = cdr.encode(LookupTransform.Impl.SendGoalService.Request(goal=goal))
    with_header = request[:4] + bytes(16) + request[4:]
    cyclone, fast_dds = b"\x01\x10" + bytes(14), b"\x01\x0f" + bytes(14)
    assert requested_frames(Sample(with_header, 0, 0, cyclone)) == ["map", "laser"]
    assert requested_frames(Sample(request, 0, 0, fast_dds)) == ["map", "laser"]
    for gid in (cyclone, fast_dds):
        for size in (0, 3, 4, 19, 20, 25, 60):
            assert requested_frames(Sample(with_header[:size], 0, 0, gid)) == [], size
        assert requested_frames(Sample(b"\0\1\0\0" + b"\xff" * 100, 0, 0, gid)) == []
