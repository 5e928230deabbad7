"""Listening on a graph: transforms, headers of topics, and the frames in requests to buffer servers."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from tfloom._native import HeaderSink
from tfloom.rmw.backends import WITHOUT_DDS, implementation_identifier
from tfloom.rmw.base import NodeName, Participant, Reader, Sample, Service, Writer
from tfloom.rmw.cyclone.graph import FAST_DDS
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.topic_names import request_topic, response_topic
from tfloom.rmw.typed_names import SEND_GOAL, SEND_GOAL_TYPE
from tfloom.rosidl import cdr
from tfloom.tf2_tools.diagnosis.finding import Source
from tfloom.tf2_tools.diagnosis.subject import FrameUse, Subject, begins_with_header
from tfloom.tf2_tools.diagnosis.topic_checks import TYPE
from tfloom.tf2_tools.watch.live import LiveWatch
from tfloom.tf2_tools.watch.model import TOPICS

LOOK_S = 0.1
"""Period at which the graph is looked at for new topics, and what came on slow ones is taken [s]."""
CLOCK_TOPIC = "/clock"
LOOKUP_TYPE = "tf2_msgs/action/LookupTransform"

_ANY = QoS(ReliabilityPolicy.BEST_EFFORT, DurabilityPolicy.VOLATILE, depth=1000)
"""Matches every publisher."""
_ALL_REQUESTS = QoS(ReliabilityPolicy.RELIABLE, DurabilityPolicy.VOLATILE, HistoryPolicy.KEEP_ALL)
_ENCAPSULATION_SIZE = 4
_HEADER_SIZE = 16
"""Of a request in the form of rmw_cyclonedds: the client's key and a sequence number, 8 bytes each."""


def listen(
    participant: Participant,
    duration_s: float,
    *,
    with_topics: bool = False,
    topics: tuple[str, str] = TOPICS,
) -> Subject:
    """Listen for a time, or until Ctrl-C, and return what was seen.

    Where /clock is published, stamps are compared with its time.

    Args:
        participant: The participant that reads; its discovery is complete.
        duration_s: How long [s].
        with_topics: Whether to subscribe to all topics with headers as well.
        topics: The topics of moving and of static transforms.
    """
    with _open_readers(participant, topics) as readers:
        end_s = time.monotonic() + duration_s
        with suppress(KeyboardInterrupt):
            while (now_s := time.monotonic()) < end_s:
                readers.refresh(with_topics=with_topics)
                time.sleep(min(LOOK_S, max(0.0, end_s - now_s)))
        return readers.subject()


@contextmanager
def _open_readers(participant: Participant, topics: tuple[str, str]) -> Iterator[_Readers]:
    node = NodeName("/", f"_tfloom_tf_doctor_{os.getpid()}")
    participant.add_node(node)
    try:
        readers = _Readers(participant, node, topics)
        try:
            yield readers
        finally:
            readers.close()
    finally:
        participant.remove_node(node)


class _Readers:
    """The watch of transforms, and the readers of headers and requests. One thread may use it."""

    def __init__(self, participant: Participant, node: NodeName, topics: tuple[str, str]) -> None:
        self._participant = participant
        self._node = node
        self._started_ns = time.time_ns()
        self._topics = topics
        self._skipped = set(topics)
        self._headers: dict[str, tuple[Reader, HeaderSink]] = {}
        self._may_meet_fast_dds = implementation_identifier() != WITHOUT_DDS
        self._services: dict[str, tuple[Reader, Writer | None]] = {}
        """The readers of requests to the servers that are there, by name; `_open_services` explains the writers."""
        self._asked: dict[tuple[bytes, str, str], int] = {}
        """Numbers of requests by the client's gid, the name of the server, and the frame."""
        self._is_simulated = any(
            end.is_writer and end.topic.name == CLOCK_TOPIC for end in participant.graph.endpoints()
        )
        self._watch = LiveWatch(participant, node, topics=topics, simulated=self._is_simulated)
        self._changes = -1
        self._nodes: dict[bytes, str] = {}

    def refresh(self, *, with_topics: bool) -> None:
        """Read the graph if it has changed, and take what came in requests."""
        self._watch.look()
        graph = self._participant.graph
        if (changes := graph.changes()) != self._changes:
            self._changes = changes
            for end in graph.raw_endpoints():
                # Names are kept: the graph forgets a node that leaves, and the report still names it. DDS's own
                # endpoints, because the gid of a request is that of a client's writer, which is on no ROS topic.
                if end.node is not None:
                    self._nodes[end.gid] = end.node.full
            self._open_services()
            if with_topics:
                self._open_headers()
        for name in self._services:
            self._take_requests(name)

    def _open_headers(self) -> None:
        for end in self._participant.graph.endpoints():
            name, type_name = end.topic.name, end.topic.type_name
            if not end.is_writer or name in self._skipped:
                continue
            # Judge each topic once, by the first publisher that is seen.
            self._skipped.add(name)
            if begins_with_header(type_name):
                sink = HeaderSink()
                reader = self._participant.create_reader(self._node, end.topic, _ANY)
                reader.feed(sink)
                self._headers[name] = reader, sink

    def _open_services(self) -> None:
        """Read the requests to each server, for as long as the server is there.

        Fast DDS takes a service for absent while the numbers of its readers of requests and its writers of responses
        differ. So each reader has a writer beside it, which is opened and closed with it, also where no client of
        Fast DDS is known yet. A moment remains in which a client knows of one of the two only. On Zenoh there is no
        Fast DDS, and no writer without the hash of its type.
        """
        own = {reader.gid for reader, _ in self._services.values()}
        servers = {
            end.name: Service(end.name, end.type_name)
            for end in self._participant.graph.service_ends()
            if end.is_server and end.type_name == LOOKUP_TYPE + SEND_GOAL_TYPE and end.gid not in own
        }
        for name in self._services.keys() - servers:
            self._take_requests(name)
            self._close_service(name)
        for name in servers.keys() - self._services:
            requests = request_topic(servers[name])._replace(is_native=True)
            responses = response_topic(servers[name])._replace(is_native=True)
            reader = self._participant.create_reader(self._node, requests, _ALL_REQUESTS)
            writer = (
                self._participant.create_writer(self._node, responses, QoS())
                if self._may_meet_fast_dds
                else None
            )
            self._services[name] = reader, writer

    def _close_service(self, name: str) -> None:
        reader, writer = self._services.pop(name)
        reader.close()
        if writer is not None:
            writer.close()

    def _take_requests(self, name: str) -> None:
        for sample in _take_all(self._services[name][0]):
            for frame in requested_frames(sample):
                key = sample.publisher_gid, name.removesuffix(SEND_GOAL), frame
                self._asked[key] = self._asked.get(key, 0) + 1

    def subject(self) -> Subject:
        """Return what was seen."""
        # Take what came since the last look. New topics would bring nothing any more, so no headers are opened.
        self.refresh(with_topics=False)
        until_ns = time.time_ns()
        return Subject(
            self._watch.observation(),
            (self._started_ns, until_ns),
            self._header_uses(),
            self._request_uses(),
            static_topic=self._topics[True],
            other_topics=self._other_topics(),
            is_simulated=self._is_simulated,
        )

    def _other_topics(self) -> list[str]:
        ends = [end for end in self._participant.graph.endpoints() if end.is_writer]
        return sorted({end.topic.name for end in ends if end.topic.type_name == TYPE} - set(self._topics))

    def _source(self, gid: bytes, topic: str) -> Source:
        return Source(self._nodes.get(gid, ""), topic, gid.hex())

    def _header_uses(self) -> list[FrameUse]:
        return [
            FrameUse(frame, self._source(gid, name), count)
            for name, (_, sink) in self._headers.items()
            for gid, frame, count in sink.uses()
        ]

    def _request_uses(self) -> list[FrameUse]:
        return [
            FrameUse(frame, self._source(gid, server), count)
            for (gid, server, frame), count in self._asked.items()
        ]

    def close(self) -> None:
        """Close the watch, all readers, and the writers of responses."""
        self._watch.close()
        for name in list(self._services):
            self._close_service(name)
        for reader, _ in self._headers.values():
            reader.close()


def _take_all(reader: Reader) -> Iterator[Sample]:
    while (sample := reader.take()) is not None:
        yield sample


def requested_frames(sample: Sample) -> list[str]:
    """Return the frames that a request of `tf2_msgs/action/LookupTransform` names; none if it can't be decoded."""
    from tfloom.interfaces.tf2_msgs.action import LookupTransform_SendGoal_Request

    data = sample.data
    if not sample.publisher_gid.startswith(FAST_DDS):
        data = data[:_ENCAPSULATION_SIZE] + data[_ENCAPSULATION_SIZE + _HEADER_SIZE :]
    try:
        goal = cdr.decode(LookupTransform_SendGoal_Request, data).goal
    except cdr.DecodeError:
        return []
    frames = [goal.target_frame, goal.source_frame, *([goal.fixed_frame] if goal.advanced else [])]
    return list(dict.fromkeys(frames))
