"""The Zenoh wire beside plain Zenoh, by which tests write and read rmw_zenoh's bytes: data, graph, failures."""

from __future__ import annotations

import argparse
import math
import os
import re
import signal
import socket
import struct
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.rmw.conftest import Peer, outputs_by_end
from tests.zenoh_ports import use_port_of

from tfloom._native import ReadyQueue, SampleQueue
from tfloom.common import signals as signals_module
from tfloom.common.signals import signals_deferred
from tfloom.rmw.base import NodeName, Participant, Reader, Requester, Sample, Service, Topic
from tfloom.rmw.endpoint_events import READER_EVENTS, EndpointEvents
from tfloom.rmw.errors import ClosedError, ForeignPeerError, NoBackendError, WireError
from tfloom.rmw.events import Event, LivelinessChanged, Matched
from tfloom.rmw.qos import (
    BEST_AVAILABLE_NS,
    INFINITE_NS,
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoS,
    ReliabilityPolicy,
)
from tfloom.rmw.zenoh import announced as zenoh_announced
from tfloom.rmw.zenoh import config as zenoh_config
from tfloom.rmw.zenoh import graph as zenoh_graph
from tfloom.rmw.zenoh import services as zenoh_services
from tfloom.rmw.zenoh.endpoints import MAX_REPORTS, ZenohReader, _Lease
from tfloom.rmw.zenoh.events import MIN_PERIOD_S, Timers
from tfloom.rmw.zenoh.graph import ZenohGraph
from tfloom.rmw.zenoh.services import ServiceEndpoint, ZenohRequester, ZenohResponder
from tfloom.rmw.zenoh.session import open_session
from tfloom.rmw.zenoh.tokens import PREFIX, End, Kind, Token, data_key, gid_of, pack_attachment, token_key

zenoh = pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")

HASH, OTHER_HASH = "RIHS01_" + "1" * 64, "RIHS01_" + "2" * 64
TOPIC = Topic("/robot/chatter", "std_msgs/msg/String", HASH)
KILL = Service("/kill", "turtlesim/srv/Kill", HASH, HASH, HASH)
KILL_END = End(KILL.name, KILL.type_name, HASH, QoS())
NODE = NodeName("/tests", "here")
LATCHED = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=5)
HEADER = b"\0\1\0\0"
GID = bytes(range(16))
NOT_FED = "cannot feed /robot/chatter, which takes a thread: can't start"


@pytest.fixture(autouse=True)
def zenoh_environment(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    with use_port_of(domain_id):
        yield


@pytest.fixture
def participant(zenoh_environment: None, domain_id: int) -> Iterator[Participant]:
    from tfloom.rmw.zenoh.wire import open_participant

    participant = open_participant(domain_id)
    participant.add_node(NODE)
    yield participant
    participant.close()


@pytest.fixture
def plain(participant: Participant) -> Iterator[Any]:
    """Yield a plain session of Zenoh that is linked to the participant's router, as a client."""

    from tests.oracles.compare_rmw_zenoh import client_session

    with client_session(int(os.environ["TFLOOM_ZENOH_PORT"])) as session:
        yield session


def refuse(_thread: threading.Thread) -> None:
    """Take the place of `threading.Thread.start` where the system has no more threads."""
    raise RuntimeError("can't start new thread")


@contextmanager
def no_more_threads() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(threading.Thread, "start", refuse)
        yield


def callback(function: Callable[[Any], object]) -> Any:
    return zenoh.handlers.Callback(function, indirect=False)


def ready_querier(session: Any, key: str) -> Any:
    querier = session.declare_querier(key, target=zenoh.QueryTarget.ALL_COMPLETE)
    wait_until(lambda: querier.matching_status.matching)
    return querier


def key_of(topic: Topic, domain_id: int) -> str:
    return data_key(domain_id, topic.name, topic.type_name, topic.type_hash)


def kill_key(domain_id: int) -> str:
    return data_key(domain_id, KILL.name, KILL.type_name, HASH)


def take_one(end: Any) -> Any:
    """Wait for a sample, a request or a response, and return it."""
    taken: list[Any] = []
    wait_until(lambda: taken.append(end.take()) or taken[-1])
    return taken[-1]


def take_all(reader: Reader, how_many: int) -> list[Sample]:
    taken: list[Sample] = []
    wait_until(
        lambda: taken.extend(iter(reader.take, None)) or len(taken) >= how_many, what=f"{how_many} samples"
    )
    return taken


def pushed(sink: SampleQueue, how_many: int) -> list[bytes]:
    """Return the data of samples that were pushed into a sink, when they have come."""
    taken: list[Any] = []
    wait_until(lambda: taken.extend(sink.take()) or len(taken) >= how_many, what=f"{how_many} samples")
    return [sample[0] for sample in taken]


def plain_key(session: Any, domain_id: int, kind: Kind, end: End | None, number: int = 5) -> str:
    plain = NodeName("/", "plain")
    return token_key(Token(domain_id, str(session.zid()), 0, number, kind, "/", plain, end))


def declare_token(session: Any, domain_id: int, kind: Kind, end: End | None, number: int = 5) -> Any:
    return session.liveliness().declare_token(plain_key(session, domain_id, kind, end, number))


def test_a_sample_bears_number_time_and_gid_of_the_writers_token(
    participant: Participant, plain: Any, domain_id: int
) -> None:
    heard: list[Any] = []
    subscriber = plain.declare_subscriber(f"{domain_id}/**", callback(heard.append))
    writer = participant.create_writer(NODE, TOPIC, QoS())
    before_ns = time.time_ns()
    wait_until(lambda: writer.write(HEADER + b"one") or heard)
    subscriber.undeclare()
    first = heard[0]
    assert str(first.key_expr) == f"{domain_id}/robot/chatter/std_msgs::msg::dds_::String_/{HASH}"
    assert first.payload.to_bytes() == HEADER + b"one"
    number, stamp_ns, size, gid = struct.unpack("<qqB16s", first.attachment.to_bytes())
    assert number >= 1
    assert before_ns <= stamp_ns <= time.time_ns()
    assert size == 16
    assert gid == writer.gid
    tokens = [str(reply.ok.key_expr) for reply in plain.liveliness().get(f"@ros2_lv/{domain_id}/**")]
    assert writer.gid in {gid_of(token) for token in tokens}


def test_the_tokens_of_a_node_and_its_endpoints(participant: Participant, plain: Any, domain_id: int) -> None:
    participant.create_writer(NODE, TOPIC, LATCHED)
    participant.create_reader(NODE, TOPIC, QoS(reliability=ReliabilityPolicy.BEST_EFFORT, depth=5))
    participant.create_requester(NODE, KILL, QoS())
    participant.create_responder(NODE, KILL, QoS())

    def tails() -> list[str]:
        replies = plain.liveliness().get(f"@ros2_lv/{domain_id}/**")
        return sorted(str(reply.ok.key_expr).split("/", 4)[4] for reply in replies)

    wait_until(lambda: len(tails()) == 5)
    topic = f"%robot%chatter/std_msgs::msg::dds_::String_/{HASH}"
    service = f"%kill/turtlesim::srv::dds_::Kill_/{HASH}"
    assert tails() == [
        "0/NN/%/%tests/here",
        f"1/MP/%/%tests/here/{topic}/:1:,5:,:,:,,",
        f"2/MS/%/%tests/here/{topic}/2::,5:,:,:,,",
        f"3/SC/%/%tests/here/{service}/::,10:,:,:,,",
        f"4/SS/%/%tests/here/{service}/::,10:,:,:,,",
    ]


def test_the_graph_has_what_others_announce_and_loses_it(
    participant: Participant, plain: Any, domain_id: int
) -> None:
    queue = ReadyQueue()
    participant.graph.notify(queue, 3)
    before = participant.graph.changes()
    tokens = [
        declare_token(plain, domain_id, Kind.NODE, None, 0),
        declare_token(plain, domain_id, Kind.PUBLISHER, End(*TOPIC[:3], QoS())),
        declare_token(plain, domain_id, Kind.SERVER, KILL_END, 6),
    ]
    other = NodeName("/", "plain")
    wait_until(participant.graph.service_ends)
    assert participant.graph.nodes() == [other, NODE]
    [end] = participant.graph.endpoints()
    assert (end.topic, end.node, end.is_writer, end.qos) == (TOPIC, other, True, QoS())
    [server] = participant.graph.service_ends()
    assert (server.name, server.is_server, server.node) == ("/kill", True, other)
    assert participant.graph.changes() >= before + 3
    assert 3 in queue.wait(10_000_000_000)
    assert {info.is_own for info in participant.graph.participants()} == {True, False}
    for token in tokens:
        token.undeclare()
    wait_until(lambda: participant.graph.nodes() == [NODE])
    wait_until(lambda: participant.graph.endpoints() == participant.graph.service_ends() == [])


def test_a_repeated_token_changes_nothing_and_a_wrong_one_harms_no_other(
    participant: Participant, plain: Any, domain_id: int
) -> None:
    bad = [
        f"@ros2_lv/{domain_id}/x",
        f"@ros2_lv/{domain_id}/zid/0/0/XX/%/%/node",
        f"@ros2_lv/{domain_id}/zid/{'9' * 300}/0/NN/%/%/node",
        f"@ros2_lv/{domain_id}/zid/0/0/NN/%/%/{'n' * 10_000}",
        f"@ros2_lv/{domain_id}/zid/0/1/MP/%/%/node/%t/type/hash/text",
    ]
    kept = [plain.liveliness().declare_token(key) for key in bad]
    kept.append(declare_token(plain, domain_id, Kind.NODE, None, 0))
    wait_until(lambda: len(participant.graph.nodes()) == 2)
    changes = participant.graph.changes()
    key = next(key for key in participant.graph._entities if "/plain" in key)
    participant.graph._add(key)
    assert participant.graph.changes() == changes
    assert participant.graph.endpoints() == []
    assert len(kept) == len(bad) + 1


def test_tokens_beyond_the_limit_are_ignored_with_one_line(
    participant: Participant,
    plain: Any,
    domain_id: int,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(zenoh_graph, "MAX_TOKENS", 2)
    first = declare_token(plain, domain_id, Kind.NODE, None, 0)
    wait_until(lambda: len(participant.graph.nodes()) == 2)
    changes = participant.graph.changes()
    graph: Any = participant.graph
    ignored = [declare_token(plain, domain_id, Kind.NODE, None, number) for number in (1, 2)]
    wait_until(lambda: graph._is_overflow_told)
    first.undeclare()
    wait_until(lambda: participant.graph.nodes() == [NODE])
    assert participant.graph.changes() == changes + 1
    assert capsys.readouterr().err == (
        "tfloom: this domain has more than 2 nodes, publishers, subscriptions, servers and clients: further ones are "
        "neither listed nor matched in this program; use more domains (ROS_DOMAIN_ID), and start it again\n"
    )
    last = declare_token(plain, domain_id, Kind.NODE, None, 3)
    wait_until(lambda: len(participant.graph.nodes()) == 2)
    assert len([*ignored, last]) == 3  # held until here


def test_samples_of_others_are_taken_with_their_stamps(
    participant: Participant, plain: Any, domain_id: int
) -> None:
    reader = participant.create_reader(NODE, TOPIC, QoS())
    queue = ReadyQueue()
    reader.notify(queue, 9)
    publisher = plain.declare_publisher(key_of(TOPIC, domain_id))
    attachment = struct.pack("<qqB16s", 1, 123456789, 16, GID)
    received: list[Sample] = []

    def has_come() -> bool:
        publisher.put(HEADER + b"abc", attachment=attachment)
        received.extend(iter(reader.take, None))
        return bool(received)

    wait_until(has_come)
    assert received[0].data == HEADER + b"abc"
    assert received[0].source_stamp_ns == 123456789
    assert received[0].publisher_gid == GID
    assert 0 <= time.time_ns() - received[0].received_stamp_ns < 30_000_000_000
    assert queue.wait(10_000_000_000) == [9]


HOSTILE = [
    (None, HEADER + b"x"),
    (b"", HEADER + b"x"),
    (b"\xff" * 32, HEADER + b"x"),
    (b"\xff" * 33, HEADER + b"x"),
    (b"\x00" * 1_000_000, HEADER + b"x"),
    (struct.pack("<qqB16s", 1, 0, 255, GID), HEADER + b"x"),
    (struct.pack("<qqB16s", 1, 0, 16, GID), b""),
    (struct.pack("<qqB16s", 1, 0, 16, GID), b"\0\1\0"),
]


def test_hostile_samples_are_dropped_and_the_stream_goes_on(
    participant: Participant, plain: Any, domain_id: int, capfd: pytest.CaptureFixture[str]
) -> None:
    reader = participant.create_reader(NODE, TOPIC, QoS(depth=100))
    key = key_of(TOPIC, domain_id)
    good = struct.pack("<qqB16s", 2**63 - 1, -(2**63), 16, GID)
    # Or a sample would be dropped while the link is busy with the large one.
    publisher = plain.declare_publisher(key, congestion_control=zenoh.CongestionControl.BLOCK)
    wait_until(lambda: publisher.put(HEADER + b"start", attachment=good) or reader.take())
    for attachment, payload in HOSTILE:
        publisher.put(payload, attachment=attachment)
    publisher.delete(attachment=good)
    publisher.put(HEADER + b"end", attachment=good)
    datas: list[bytes] = []
    wait_until(lambda: datas.extend(s.data for s in iter(reader.take, None)) or HEADER + b"end" in datas)
    assert set(datas) <= {HEADER + b"start", HEADER + b"end"}
    assert "Traceback" not in capfd.readouterr().err


def test_hostile_requests_are_dropped_and_the_server_goes_on(
    participant: Participant, plain: Any, domain_id: int, capfd: pytest.CaptureFixture[str]
) -> None:
    server = participant.create_responder(NODE, KILL, QoS())
    key = kill_key(domain_id)
    querier = ready_querier(plain, key)
    for attachment, payload in HOSTILE:
        # The stream ends, because the query is dropped: a client isn't kept waiting.
        assert list(querier.get(payload=payload, attachment=attachment)) == []
    assert list(querier.get()) == []
    assert server.take() is None
    assert "no attachment of rmw_zenoh's form" in server.last_drop_reason()
    replies: list[Any] = []
    attachment = pack_attachment(4, GID)
    querier.get(callback(replies.append), payload=HEADER + b"good", attachment=attachment)
    request = take_one(server)
    assert request.data == HEADER + b"good"
    assert request.id == (GID, 4)
    server.send(request.id, HEADER + b"reply")
    wait_until(lambda: replies)
    sample = replies[0].ok
    assert str(sample.key_expr) == key
    assert sample.payload.to_bytes() == HEADER + b"reply"
    assert struct.unpack("<qqB16s", sample.attachment.to_bytes())[::3] == (4, GID)
    server.send(request.id, HEADER + b"again")  # nobody waits for it any more
    assert "Traceback" not in capfd.readouterr().err


def test_replies_of_others_are_dropped(participant: Participant, plain: Any, domain_id: int) -> None:
    client = participant.create_requester(NODE, KILL, QoS())
    key = kill_key(domain_id)
    asked: list[bytes] = []

    def answer(query: Any) -> None:
        header = query.attachment.to_bytes()
        asked.append(header)
        stranger = struct.pack("<qqB16s", 1, 5, 16, GID)
        future = struct.pack("<qqB16s", 10**6, 5, 16, header[17:])
        for attachment, payload in [
            *HOSTILE,
            (stranger, HEADER + b"stranger's"),
            (future, HEADER + b"never asked"),
            (header, HEADER + b"right"),
        ]:
            query.reply(key, payload, attachment=attachment)
        query.reply_err(b"error")
        query.drop()

    queryable = plain.declare_queryable(key, callback(answer), complete=True)
    token = declare_token(plain, domain_id, Kind.SERVER, KILL_END)
    wait_until(client.is_ready)
    queue = ReadyQueue()
    client.notify(queue, 8)
    assert client.send(HEADER + b"ask") == 1
    response = take_one(client)
    assert response.data == HEADER + b"right"
    assert response.id == (client.client_gid, 1)
    assert client.take() is None
    assert struct.unpack("<qqB16s", asked[0])[::3] == (1, client.gid)
    assert queue.wait(10_000_000_000) == [8]
    token.undeclare()
    wait_until(lambda: not client.is_ready())
    queryable.undeclare()


def test_a_request_without_a_server_stays_without_response(participant: Participant) -> None:
    client = participant.create_requester(NODE, KILL, QoS())
    assert client.send(HEADER + b"ask") == 1
    assert client.take() is None
    server = participant.create_responder(NODE, KILL, QoS())
    wait_until(client.is_ready)
    assert client.send(HEADER + b"ask") == 2
    assert take_one(server).id.sequence_number == 2


def test_more_requests_than_the_depth_push_out_the_oldest(participant: Participant) -> None:
    server = participant.create_responder(NODE, KILL, QoS(depth=2))
    client = participant.create_requester(NODE, KILL, QoS())
    wait_until(client.is_ready)
    for _ in range(5):
        client.send(HEADER + b"ask")
    taken: list[Any] = []
    wait_until(lambda: taken.extend(iter(server.take, None)) or taken)
    assert [request.id.sequence_number for request in taken] == [4, 5]
    assert "more than 2 requests" in server.last_drop_reason()
    assert len(server._queries) == 2


def declare_answering_server(plain: Any, domain_id: int) -> Any:
    """Let a session of Zenoh answer each request of the service `KILL`, without a token."""
    key = kill_key(domain_id)

    def answer(query: Any) -> None:
        query.reply(key, HEADER + b"right", attachment=query.attachment.to_bytes())
        query.drop()

    return plain.declare_queryable(key, callback(answer), complete=True)


def test_server_without_a_route_is_not_ready_and_the_route_wakes_its_waiters(
    participant: Participant, domain_id: int, plain: Any
) -> None:
    """Tokens and routes come in any order. A request sent before the route would end at once, without a response."""
    client = participant.create_requester(NODE, KILL, QoS())
    token = declare_token(plain, domain_id, Kind.SERVER, KILL_END)
    wait_until(client.receiving_servers)
    assert client.is_synchronising()
    assert not client.is_ready()
    queue = ReadyQueue()
    client.notify_ready(queue, 8)
    assert queue.wait(30 * 10**9) == [8]  # at the start
    queryable = declare_answering_server(plain, domain_id)
    assert queue.wait(30 * 10**9) == [8]
    wait_until(client.is_ready)
    assert not client.is_synchronising()
    client.send(HEADER + b"ask")
    wait_until(lambda: client.take() is not None)
    queryable.undeclare()
    wait_until(client.is_synchronising)
    token.undeclare()


def test_route_wakes_waiters_where_no_thread_can_be_started(
    participant: Participant, domain_id: int, plain: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> int:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(Timers, "add", refuse)
    client = participant.create_requester(NODE, KILL, QoS())
    queue = ReadyQueue()
    client.notify_ready(queue, 8)
    assert queue.wait(30 * 10**9) == [8]  # at the start
    token = declare_token(plain, domain_id, Kind.SERVER, KILL_END)
    assert queue.wait(30 * 10**9) == [8]  # a server
    queryable = declare_answering_server(plain, domain_id)
    assert queue.wait(30 * 10**9) == [8]
    wait_until(client.is_ready)
    queryable.undeclare()
    token.undeclare()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.usefixtures("zenoh_environment")
def test_signal_within_a_callback_of_zenoh_reaches_the_program(
    domain_id: int, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str], number: int
) -> None:
    """Zenoh reports an own token on the thread that declares it; it would print the handler's exception and go on."""
    from tfloom.rmw.zenoh.wire import open_participant

    told: list[str] = []

    def on_token(_graph: ZenohGraph, sample: Any) -> None:
        if not told and threading.current_thread() is threading.main_thread():
            signal.raise_signal(number)
            told.append(str(sample.key_expr))

    def handle(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(ZenohGraph, "_on_token", on_token)
    participant = open_participant(domain_id)
    before = signal.signal(number, handle)
    try:
        with pytest.raises(KeyboardInterrupt):
            participant.add_node(NODE)
        assert signal.getsignal(number) is handle
    finally:
        signal.signal(number, before)
        participant.close()
    assert len(told) == 1
    assert "callback error" not in capfd.readouterr().err


def test_ctrl_c_while_the_main_thread_writes_to_an_own_reader_loses_nothing(
    participant: Participant, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    receive = ZenohReader._on_sample
    interrupted: list[bool] = []

    def on_sample(reader: ZenohReader, sample: Any) -> None:
        if not interrupted:
            interrupted.append(threading.current_thread() is threading.main_thread())
            signal.raise_signal(signal.SIGINT)
        receive(reader, sample)

    monkeypatch.setattr(ZenohReader, "_on_sample", on_sample)
    reader = participant.create_reader(NODE, TOPIC, QoS())
    writer = participant.create_writer(NODE, TOPIC, QoS())
    with pytest.raises(KeyboardInterrupt):
        writer.write(HEADER + b"one")
    writer.write(HEADER + b"two")
    taken: list[Sample] = []
    wait_until(lambda: taken.extend(iter(reader.take, None)) or len(taken) == 2)
    assert interrupted == [True]
    assert "callback error" not in capfd.readouterr().err


@pytest.mark.parametrize("called", ["_on_query", "_on_reply"])
def test_ctrl_c_while_the_main_thread_serves_an_own_client_is_raised(
    called: str, participant: Participant, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    end = ZenohResponder if called == "_on_query" else ZenohRequester
    run = getattr(end, called)
    interrupted: list[bool] = []

    def run_interrupted(self: Any, *arguments: Any) -> None:
        if not interrupted:
            interrupted.append(threading.current_thread() is threading.main_thread())
            signal.raise_signal(signal.SIGINT)
        run(self, *arguments)

    monkeypatch.setattr(end, called, run_interrupted)
    server = participant.create_responder(NODE, KILL, QoS())
    client = participant.create_requester(NODE, KILL, QoS())
    wait_until(client.is_ready)
    with pytest.raises(KeyboardInterrupt):  # noqa: PT012 - one of both calls back
        client.send(HEADER + b"ask")
        wait_until(lambda: server._requests)
        server.send(server.take().id, HEADER + b"told")
    if called == "_on_query":
        server.send(server.take().id, HEADER + b"told")
    wait_until(lambda: client.take() is not None)
    assert interrupted == [True]
    assert "callback error" not in capfd.readouterr().err


class Signals:
    """The handlers of two signals, which note what they get; that of SIGINT raises."""

    def __init__(self) -> None:
        self.handled: list[int] = []

    def handle(self, number: int, _frame: object) -> None:
        self.handled.append(number)
        if number == signal.SIGINT:
            raise KeyboardInterrupt


@pytest.fixture
def signals() -> Iterator[Signals]:
    noting = Signals()
    numbers = signal.SIGINT, signal.SIGTERM
    before = [signal.signal(number, noting.handle) for number in numbers]
    yield noting
    after = [signal.signal(number, handler) for number, handler in zip(numbers, before, strict=True)]
    assert after == [noting.handle, noting.handle]


@pytest.mark.parametrize(
    "came", [[signal.SIGINT, signal.SIGTERM], [signal.SIGTERM, signal.SIGINT], 2 * [signal.SIGINT]]
)
def test_each_signal_of_one_deferred_call_is_handled_although_one_before_raises(
    came: list[int], signals: Signals
) -> None:
    with pytest.raises(KeyboardInterrupt), signals_deferred():  # noqa: PT012
        for number in came:
            signal.raise_signal(number)
        assert not signals.handled
    assert signals.handled == came


def test_signals_of_a_nested_deferred_call_come_after_the_outer_one(signals: Signals) -> None:
    with pytest.raises(KeyboardInterrupt) as told, signals_deferred():  # noqa: PT012
        with signals_deferred():
            signal.raise_signal(signal.SIGTERM)
            signal.raise_signal(signal.SIGINT)
        assert not signals.handled
        raise ValueError("of the block")
    assert signals.handled == [signal.SIGTERM, signal.SIGINT]
    assert isinstance(told.value.__context__, ValueError)


def test_signal_that_comes_while_handlers_are_set_again_is_not_the_last_that_is_heard(
    signals: Signals, monkeypatch: pytest.MonkeyPatch
) -> None:
    set_handler = signals_module._signal.signal

    def set_and_send(number: int, handler: Any) -> None:
        set_handler(number, handler)
        if number == signal.SIGINT:
            monkeypatch.undo()
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt), signals_deferred():  # noqa: PT012
        signal.raise_signal(signal.SIGTERM)
        monkeypatch.setattr(signals_module._signal, "signal", set_and_send)
    assert sorted(signals.handled) == [signal.SIGINT, signal.SIGTERM]
    signal.raise_signal(signal.SIGTERM)  # its handler wasn't set again, but is called
    assert signals.handled[2:] == [signal.SIGTERM]
    set_handler(signal.SIGTERM, signals.handle)


@pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="Windows has no alarm")
def test_alarm_of_a_program_is_deferred_too() -> None:
    def handle(*_: object) -> None:
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, handle)
    try:
        with pytest.raises(TimeoutError), signals_deferred():  # noqa: PT012
            signal.raise_signal(signal.SIGALRM)
            reached = True
        assert reached
    finally:
        signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize(("name", "is_endless"), [("/count/_action/get_result", True), ("/kill", False)])
def test_results_of_actions_alone_are_awaited_without_an_end(
    participant: Any, name: str, *, is_endless: bool
) -> None:
    options: dict[str, Any] = {}
    session: Any = SimpleNamespace(declare_querier=lambda _key, **given: options.update(given) or "querier")
    endpoint = ServiceEndpoint(GID, NODE, KILL._replace(name=name), QoS(), participant._timers)
    client = ZenohRequester(endpoint, participant.graph, print)
    assert client.declare(session, "key") == "querier"
    assert options.get("timeout") == (zenoh_services.ENDLESS_S if is_endless else None)
    assert options["target"] == zenoh.QueryTarget.ALL_COMPLETE
    assert options["consolidation"] == zenoh.ConsolidationMode.NONE


def test_request_waits_for_the_route(participant: Participant, domain_id: int, plain: Any) -> None:
    client = participant.create_requester(NODE, KILL, QoS())
    token = declare_token(plain, domain_id, Kind.SERVER, KILL_END)
    wait_until(client.receiving_servers)
    opened: list[Any] = []
    late = threading.Timer(0.05, lambda: opened.append(declare_answering_server(plain, domain_id)))
    late.start()
    client.send(HEADER + b"ask")
    wait_until(lambda: client.take() is not None)
    late.join()
    opened[0].undeclare()
    token.undeclare()


@pytest.fixture
def asked(participant: Participant, domain_id: int, plain: Any) -> Iterator[tuple[Requester, Any, Any, Any]]:
    """Yield a client, its request's query in a plain session that keeps it, that server's token and its queryable."""
    client = participant.create_requester(NODE, KILL, QoS())
    queries: list[Any] = []
    key = kill_key(domain_id)
    queryable = plain.declare_queryable(key, callback(queries.append), complete=True)
    token = declare_token(plain, domain_id, Kind.SERVER, KILL_END)
    wait_until(client.is_ready)
    client.send(HEADER + b"ask")
    wait_until(lambda: queries)
    yield client, queries.pop(), token, queryable
    queryable.undeclare()


def test_a_response_that_comes_after_the_end_of_its_servers_token_is_awaited(
    asked: tuple[Requester, Any, Any, Any],
) -> None:
    """Zenoh sends the end of a token ahead of a response that was sent before."""
    client, query, token, _ = asked
    servers = client.receiving_servers()
    assert client.connected_servers() == servers
    token.undeclare()
    wait_until(lambda: not client.receiving_servers())
    queue = ReadyQueue()
    client.watch_servers(queue, 8)
    assert queue.wait(30 * 10**9) == [8]  # at the start
    assert client.connected_servers() == servers
    query.reply(query.key_expr, HEADER + b"right", attachment=query.attachment.to_bytes())
    wait_until(lambda: client.take() is not None)
    assert client.connected_servers() == servers
    query.drop()
    assert queue.wait(30 * 10**9) == [8]
    assert not client.connected_servers()


def test_a_request_that_is_given_up_makes_no_server_awaited(asked: tuple[Requester, Any, Any, Any]) -> None:
    client, _, token, _ = asked
    client.give_up([1])
    token.undeclare()
    wait_until(lambda: not client.receiving_servers())
    assert not client.connected_servers()


@pytest.mark.parametrize("is_thread_refused", [False, True], ids=["", "no thread"])
def test_a_server_that_leaves_and_keeps_its_request_is_awaited_for_a_limited_time(
    asked: tuple[Requester, Any, Any, Any], monkeypatch: pytest.MonkeyPatch, *, is_thread_refused: bool
) -> None:
    client, query, token, _ = asked
    monkeypatch.setattr(zenoh_services, "MAX_WAIT_FOR_END_S", 0.2)
    if is_thread_refused:
        monkeypatch.setattr(threading.Thread, "start", refuse)
    queue = ReadyQueue()
    client.watch_servers(queue, 8)
    token.undeclare()
    wait_until(lambda: queue.wait(10**9) and not client.connected_servers())
    query.reply(query.key_expr, HEADER + b"late", attachment=query.attachment.to_bytes())
    wait_until(lambda: client.take() is not None)
    query.drop()


def test_a_server_that_returns_is_awaited_for_an_unlimited_time(
    asked: tuple[Requester, Any, Any, Any], domain_id: int, plain: Any
) -> None:
    """As behind a router that ends and begins anew, and then once more."""
    client, _, token, _ = asked
    servers = client.receiving_servers()
    for _ in range(2):
        token.undeclare()
        wait_until(lambda: client._end_timers)
        limits = {client._timers._checks[number] for number in client._end_timers.values()}
        token = declare_token(plain, domain_id, Kind.SERVER, KILL_END)
        wait_until(lambda: client.receiving_servers() == servers)
        for limit in limits:
            limit(0.0)  # the timers' thread may have come as far before the server returned
        assert limits.isdisjoint(client._timers._checks.values())
    client._limit_wait_for(*servers)  # its news may have been handled after that of the return
    assert not client._end_timers
    token.undeclare()
    wait_until(lambda: not client.receiving_servers())
    assert client.connected_servers() == servers


def test_a_client_that_closes_ends_its_wait_for_a_server(asked: tuple[Requester, Any, Any, Any]) -> None:
    client, _, token, _ = asked
    token.undeclare()
    wait_until(lambda: client._end_timers)
    timers = client._timers
    assert timers._checks
    client.close()
    assert not timers._checks


def test_queries_of_a_client_that_left_are_dropped(
    participant: Participant, domain_id: int, plain: Any
) -> None:
    server = participant.create_responder(NODE, KILL, QoS())
    token = declare_token(plain, domain_id, Kind.CLIENT, KILL_END)
    gid = gid_of(plain_key(plain, domain_id, Kind.CLIENT, KILL_END))
    querier = ready_querier(plain, kill_key(domain_id))
    querier.get(callback(print), payload=HEADER + b"ask", attachment=pack_attachment(1, gid))
    wait_until(lambda: server._queries)
    # Zenoh tells nothing of a token that ends before it was told of.
    wait_until(lambda: gid in {end.gid for end in participant.graph.service_ends()})
    token.undeclare()
    wait_until(lambda: not server._queries)


def test_late_readers_get_the_last_samples_in_order(
    participant: Participant, start_peer: Callable[..., Peer]
) -> None:
    writer = participant.create_writer(NODE, TOPIC, LATCHED)
    for number in range(7):
        writer.write(HEADER + bytes([number]))
    same = participant.create_reader(NODE, TOPIC, LATCHED._replace(depth=10))
    assert [sample.data[4] for sample in take_all(same, 5)] == [2, 3, 4, 5, 6]
    few = participant.create_reader(NODE, TOPIC, LATCHED._replace(depth=3))
    assert [sample.data[4] for sample in take_all(few, 3)] == [4, 5, 6]
    peer = start_peer()
    far, _ = peer("reader", list(TOPIC[:3]), list(LATCHED))
    heard: list[str] = []
    wait_until(lambda: heard.extend(peer("take", far)) or len(heard) >= 5)
    assert [bytes.fromhex(data)[4] for data in heard] == [2, 3, 4, 5, 6]
    volatile = participant.create_reader(NODE, TOPIC, QoS())
    writer.write(HEADER + b"\x07")
    assert [sample.data[4] for sample in take_all(volatile, 1)] == [7]


def test_a_late_writer_of_another_process_is_heard_from_its_first_sample(
    participant: Participant, start_peer: Callable[..., Peer]
) -> None:
    reader = participant.create_reader(NODE, TOPIC, LATCHED)
    peer = start_peer()
    end, gid = peer("writer", list(TOPIC[:3]), list(LATCHED))
    for number in range(3):
        peer("write", end, (HEADER + bytes([number])).hex())
    samples = take_all(reader, 3)
    assert [sample.data[4] for sample in samples] == [0, 1, 2]
    assert {sample.publisher_gid.hex() for sample in samples} == {gid}
    wait_until(lambda: peer("matched", end) == reader.matched_count() == 1)
    assert reader.take_event(Event.MATCHED) == Matched(1, 1, 1, 1)
    assert reader.take_event(Event.LIVELINESS_CHANGED) == LivelinessChanged(1, 0, 1, 0)
    peer.program.end()
    wait_until(lambda: reader.matched_count() == 0)
    assert reader.take_event(Event.MATCHED) == Matched(1, 0, 0, -1)
    assert reader.take_event(Event.LIVELINESS_CHANGED) == LivelinessChanged(0, 0, -1, 0)


def test_what_a_writer_wrote_before_it_knew_of_the_reader_is_asked_for(
    participant: Participant, plain: Any, domain_id: int
) -> None:
    """A writer whose first sample that arrives isn't its first one: it has kept others, of which nothing tells."""
    reader = participant.create_reader(NODE, TOPIC, LATCHED)
    key = key_of(TOPIC, domain_id)
    asked: list[str] = []

    def answer(query: Any) -> None:
        asked.append(str(query.selector))
        for number in (2, 1, 3):
            query.reply(key, HEADER + bytes([number]), attachment=pack_attachment(number, GID))
        query.reply(key, HEADER + b"other", attachment=pack_attachment(1, bytes(16)))
        query.reply(key, HEADER + b"bad", attachment=b"")
        plain.put(key, HEADER + b"\4", attachment=pack_attachment(4, GID))
        query.drop()

    pattern = f"{key}/@adv/pub/{plain.zid()}/7/_"
    queryable = plain.declare_queryable(pattern, callback(answer))
    probe = plain.declare_querier(pattern)
    wait_until(lambda: probe.matching_status.matching)
    end = time.monotonic() + 30
    while not asked and time.monotonic() < end:
        plain.put(key, HEADER + b"\3", attachment=pack_attachment(3, GID))
        wait_until(lambda: asked or time.monotonic() > end)
    numbers: list[int] = []

    def take_from_the_writer() -> list[int]:
        # Zenoh's own query of the reader, which may be answered too, brings the other writer's sample.
        taken = iter(reader.take, None)
        numbers.extend(sample.data[4] for sample in taken if sample.publisher_gid == GID)
        return numbers

    wait_until(lambda: len(take_from_the_writer()) >= 4)
    plain.put(key, HEADER + b"\5", attachment=pack_attachment(5, GID))
    wait_until(lambda: len(take_from_the_writer()) >= 5)
    assert numbers == [1, 2, 3, 4, 5]
    assert any("_max=5" in selector for selector in asked)
    queryable.undeclare()


def test_no_more_than_the_queue_takes_is_held_of_a_fast_writer(
    participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    reader: Any = participant.create_reader(NODE, TOPIC, LATCHED)
    monkeypatch.setattr(reader, "_catch_up", lambda _: None)  # the earlier samples take long

    def arrive(number: int) -> None:
        attachment = zenoh.ZBytes(pack_attachment(number, GID))
        payload = zenoh.ZBytes(HEADER + struct.pack("<I", number))
        reader._on_sample(argparse.Namespace(attachment=attachment, payload=payload))

    for number in range(7, 1007):
        arrive(number)
        assert len(reader._held[GID]) <= 2 * LATCHED.depth
    reader._release(GID)
    taken = [struct.unpack("<I", sample.data[4:])[0] for sample in iter(reader.take, None)]
    assert taken == [1002, 1003, 1004, 1005, 1006]
    arrive(500)  # Zenoh's own query brings an old one again
    assert reader.take() is None
    arrive(1007)
    assert reader.take() is not None


def test_all_is_received_of_a_writer_that_keeps_all(participant: Participant) -> None:
    keep_all = QoS(history=HistoryPolicy.KEEP_ALL)
    reader = participant.create_reader(NODE, TOPIC, keep_all)
    writer = participant.create_writer(NODE, TOPIC, keep_all)
    for number in range(5000):
        writer.write(HEADER + struct.pack("<I", number))
    assert [struct.unpack("<I", sample.data[4:])[0] for sample in take_all(reader, 5000)] == list(range(5000))


def test_two_hashes_of_one_type_are_not_matched_and_told(
    participant: Participant, capsys: pytest.CaptureFixture[str]
) -> None:
    writer = participant.create_writer(NODE, TOPIC, QoS())
    other = participant.create_reader(NODE, TOPIC._replace(type_hash=OTHER_HASH), QoS())
    same = participant.create_reader(NODE, TOPIC, QoS())
    wait_until(lambda: same.matched_count() == 1)
    writer.write(HEADER + b"x")
    take_all(same, 1)
    assert other.take() is None
    assert other.matched_count() == 0
    assert writer.matched_count() == 1
    told = capsys.readouterr().err
    assert f"{HASH} here, {OTHER_HASH} there" in told
    assert f"{OTHER_HASH} here, {HASH} there" in told
    assert "nothing passes between the writer of /robot/chatter and the subscription of /tests/here" in told


def test_a_server_of_another_hash_is_named_to_its_client(participant: Participant) -> None:
    server = participant.create_responder(NODE, KILL._replace(type_hash=OTHER_HASH), QoS())
    client = participant.create_requester(NODE, KILL, QoS())
    assert not client.is_ready()
    assert "a server of /kill, /tests/here, has another definition" in client.incompatibility()
    assert "a client of /kill, /tests/here, has another definition" in server.incompatibility()
    with pytest.raises(ForeignPeerError, match="another definition"):
        client.send(HEADER)
    server.close()
    assert client.incompatibility() == ""


def test_a_reader_without_a_hash_hears_all_and_a_writer_or_service_without_is_an_error(
    participant: Participant, capsys: pytest.CaptureFixture[str]
) -> None:
    reader = participant.create_reader(NODE, TOPIC._replace(type_hash=""), QoS())
    writers = [
        participant.create_writer(NODE, TOPIC._replace(type_hash=type_hash), QoS())
        for type_hash in (HASH, OTHER_HASH)
    ]
    assert reader.matched_count() == 2
    for writer in writers:
        writer.write(HEADER + b"x")
    assert len(take_all(reader, 2)) == 2
    assert "nothing passes" not in capsys.readouterr().err
    with pytest.raises(WireError, match="the hash of std_msgs/msg/String is unknown"):
        participant.create_writer(NODE, TOPIC._replace(type_hash=""), QoS())
    with pytest.raises(WireError, match="the hash of turtlesim/srv/Kill is unknown"):
        participant.create_responder(NODE, KILL._replace(type_hash=""), QoS())


def test_native_names_are_the_same_topic_and_raw_names_have_no_prefix(participant: Participant) -> None:
    native = TOPIC._replace(is_native=True)
    writer = participant.create_writer(NODE, native, QoS())
    reader = participant.create_reader(NODE, TOPIC, QoS())
    writer.write(HEADER + b"x")
    take_all(reader, 1)
    assert {end.topic.name for end in participant.graph.endpoints()} == {"/robot/chatter"}
    assert {(end.topic.name, end.topic.type_name) for end in participant.graph.raw_endpoints()} == {
        ("/robot/chatter", "std_msgs::msg::dds_::String_")
    }


def test_incompatible_endpoints_are_told_and_pass_samples(participant: Participant) -> None:
    writer = participant.create_writer(NODE, TOPIC, QoS(reliability=ReliabilityPolicy.BEST_EFFORT))
    reader = participant.create_reader(NODE, TOPIC, QoS())
    for end in (writer, reader):
        assert end.take_event(Event.INCOMPATIBLE_QOS).total_count == 1
        assert end.matched_count() == 1
        assert end.take_event(Event.MATCHED) == Matched(1, 1, 1, 1)
    assert reader.take_event(Event.LIVELINESS_CHANGED) == LivelinessChanged(1, 0, 1, 0)
    writer.write(HEADER + b"x")
    take_all(reader, 1)
    assert participant.graph.delivers_incompatible()
    writer.close()
    assert reader.matched_count() == 0
    assert reader.take_event(Event.MATCHED) == Matched(1, 0, 0, -1)


def test_a_reader_hears_of_peers_after_another_one_of_its_topic_has_closed(participant: Any) -> None:
    first, second = (participant.create_reader(NODE, TOPIC, QoS()) for _ in range(2))
    first.close()
    writer = participant.create_writer(NODE, TOPIC, QoS())
    assert (second.matched_count(), writer.matched_count()) == (1, 1)
    writer.close()
    assert second.matched_count() == 0
    second.close()
    assert participant.graph._watchers == {}


BEST_AVAILABLE = QoS(
    ReliabilityPolicy.BEST_AVAILABLE,
    DurabilityPolicy.BEST_AVAILABLE,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
)
STRICT = QoS(
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
    deadline_ns=10**12,
    liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
)


@pytest.mark.parametrize("deadline_ns", [INFINITE_NS, BEST_AVAILABLE_NS])
@pytest.mark.parametrize("kind", [Kind.PUBLISHER, Kind.SUBSCRIPTION])
def test_best_available_peers_of_rmw_zenoh_match_and_are_compatible(
    participant: Participant, domain_id: int, plain: Any, kind: Kind, deadline_ns: int
) -> None:
    end: Any
    if kind is Kind.PUBLISHER:
        end = participant.create_reader(NODE, TOPIC, STRICT._replace(deadline_ns=INFINITE_NS))
    else:
        end = participant.create_writer(NODE, TOPIC, QoS(ReliabilityPolicy.BEST_EFFORT))
    qos = BEST_AVAILABLE._replace(deadline_ns=deadline_ns, liveliness_lease_ns=deadline_ns)
    theirs = End(TOPIC.name, TOPIC.type_name, HASH, qos)
    token = declare_token(plain, domain_id, kind, theirs)
    wait_until(lambda: end.matched_count() == 1)
    assert end.take_event(Event.INCOMPATIBLE_QOS) is None
    (peer,) = [info for info in participant.graph.endpoints() if info.gid != end.gid]
    assert "/4:4:,10:" in plain_key(plain, domain_id, kind, theirs)
    assert peer.qos == qos
    token.undeclare()
    wait_until(lambda: end.matched_count() == 0)


def test_samples_bear_the_numbers_of_their_writer_and_of_their_arrival(
    participant: Participant, plain: Any, domain_id: int
) -> None:
    reader = participant.create_reader(NODE, TOPIC, QoS())
    writer = participant.create_writer(NODE, TOPIC, QoS())
    for _ in range(2):
        writer.write(HEADER + b"x")
    key = key_of(TOPIC, domain_id)
    taken = take_all(reader, 2)
    wait_until(lambda: plain.put(key, HEADER, attachment=pack_attachment(7, GID)) or reader._waiting)
    taken += take_all(reader, 1)[:1]
    numbers = [(sample.publication_sequence_number, sample.reception_sequence_number) for sample in taken]
    assert numbers == [(1, 0), (2, 1), (7, 2)]


def test_late_readers_samples_are_numbered_in_their_order(participant: Participant) -> None:
    writer = participant.create_writer(NODE, TOPIC, LATCHED)
    for _ in range(7):
        writer.write(HEADER + b"x")
    reader = participant.create_reader(NODE, TOPIC, LATCHED)
    taken = take_all(reader, 5)
    assert [sample.publication_sequence_number for sample in taken] == [3, 4, 5, 6, 7]
    assert [sample.reception_sequence_number for sample in taken] == [0, 1, 2, 3, 4]


def test_names_of_peers_are_shown_as_data_and_few_of_them(
    participant: Participant, plain: Any, domain_id: int, capsys: pytest.CaptureFixture[str]
) -> None:
    reader = participant.create_reader(NODE, TOPIC, QoS())
    client = participant.create_requester(NODE, KILL, QoS())
    hostile = "\x1b]0;OWNED\x07\nall is well\u202e" + 1000 * "x"
    session = str(plain.zid())
    count = 3 * MAX_REPORTS
    tokens = []
    for number in range(count):
        end = End(TOPIC.name, TOPIC.type_name, f"RIHS01_{number}{hostile}", QoS())
        node = NodeName("/", hostile)
        token = Token(domain_id, session, number, number, Kind.PUBLISHER, "/", node, end)
        tokens.append(plain.liveliness().declare_token(token_key(token)))
    server = token._replace(kind=Kind.SERVER, end=End(KILL.name, KILL.type_name, hostile, QoS()))
    tokens.append(plain.liveliness().declare_token(token_key(server)))
    wait_until(lambda: len([end for end in participant.graph.endpoints() if end.is_writer]) == count)
    wait_until(client.incompatibility)
    told = capsys.readouterr().err + client.incompatibility()
    assert r"\x1b]0;OWNED\x07\x0aall is well\u202exxx" in told
    assert not set("\x1b\x07\u202e") & set(told)
    lines = told.splitlines()
    assert len(lines) == MAX_REPORTS + 1
    assert all("tfloom: nothing passes" in line for line in lines[:-1])
    assert max(map(len, lines)) < 1000
    assert lines[MAX_REPORTS - 1].endswith("`ros2 topic info -v /robot/chatter` lists them")
    assert reader.matched_count() == 0
    for declared in tokens:
        declared.undeclare()


@pytest.mark.parametrize("what", ["lease of a peer", "own lease", "deadline"])
def test_times_of_a_nanosecond_cost_no_core(
    what: str, participant: Participant, plain: Any, domain_id: int
) -> None:
    manual = QoS(liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_ns=1)
    end: Any
    if what == "lease of a peer":
        end = participant.create_reader(NODE, TOPIC, QoS())
        token = declare_token(
            plain, domain_id, Kind.PUBLISHER, End(TOPIC.name, TOPIC.type_name, HASH, manual)
        )
        wait_until(lambda: (end.take_event(Event.LIVELINESS_CHANGED) or (0, 0))[1])
        token.undeclare()
        wait_until(lambda: end.matched_count() == 0)
        assert end.take_event(Event.LIVELINESS_CHANGED)[:2] == (0, 0)
    else:
        qos = manual if what == "own lease" else QoS(deadline_ns=1)
        end = participant.create_writer(NODE, TOPIC, qos)
        end.write(HEADER + b"x")
        event = Event.LIVELINESS_LOST if what == "own lease" else Event.DEADLINE_MISSED
        wait_until(lambda: end.take_event(event))
        end.write(HEADER + b"x")
        wait_until(lambda: end.take_event(event))
        end.close()
    wait_until(lambda: not participant._timers._checks)


def test_lease_that_is_over_is_looked_at_again_when_it_is_renewed() -> None:
    timers = Timers()
    events = EndpointEvents(READER_EVENTS, "")
    looks: list[float] = []

    class Lease(_Lease):
        def _check(self, now_s: float) -> float:
            looks.append(now_s)
            return super()._check(now_s)

    lease = Lease(events, 1e-9, timers)
    wait_until(lambda: not timers._checks)
    assert len(looks) == 1
    for count in (2, 3):
        lease.renew()
        wait_until(lambda: not timers._checks)
        assert len(looks) == count
    assert events.take(Event.LIVELINESS_CHANGED)[:2] == (-1, 1)
    assert not lease.end()
    lease.renew()
    assert not timers._checks
    timers.close()


def test_checks_are_called_in_the_order_of_their_times_and_not_without_end() -> None:
    timers = Timers()
    calls: list[tuple[str, float]] = []
    start_s = time.monotonic()

    def often(now_s: float) -> float:
        calls.append(("often", now_s))
        return now_s

    def once(now_s: float) -> float:
        calls.append(("once", now_s))
        return math.inf

    never = timers.add(start_s + 0.02, once)
    number = timers.add(start_s, often)
    timers.add(start_s + 0.05, once)
    timers.remove(never)
    wait_until(lambda: "once" in dict(calls))
    timers.remove(number)
    assert timers._checks == {}
    times = [now_s for name, now_s in calls if name == "often"]
    assert min(later - earlier for earlier, later in pairwise(times)) >= MIN_PERIOD_S
    assert dict(calls)["once"] >= start_s + 0.05
    for _ in range(1000):  # what is removed long before its time is not kept
        timers.remove(timers.add(start_s + 1e6, once))
    assert len(timers._next) < 100
    timers.close()
    assert timers._next == []


def test_lost_samples_are_counted_by_the_gaps_of_each_writer(
    participant: Participant, plain: Any, domain_id: int
) -> None:
    reader = participant.create_reader(NODE, TOPIC, QoS(depth=100))
    key = key_of(TOPIC, domain_id)

    def put(number: int, gid: bytes = GID) -> None:
        plain.put(key, HEADER + b"x", attachment=pack_attachment(number, gid))

    wait_until(lambda: put(1) or reader.take())
    queue = ReadyQueue()
    reader.notify_event(Event.MESSAGE_LOST, queue, 4)
    assert queue.wait(0) == [4]
    for number in (2, 3, 5, 4, 6, 9, 10, 10_000):
        put(number)
    for number in (7, 8, 20):
        put(number, bytes(16))
    put(21, bytes(16))
    wait_until(lambda: (reader.take_event(Event.MESSAGE_LOST) or (0, 0))[0] or None)
    wait_until(lambda: reader.events._statuses[Event.MESSAGE_LOST].total_count >= 2 + 9989 + 11)
    assert reader.events._statuses[Event.MESSAGE_LOST].total_count == 2 + 9989 + 11


def test_a_flood_of_unknown_writers_takes_bounded_memory() -> None:
    from tfloom.rmw.zenoh.events import MAX_WRITERS, LostSamples

    lost = LostSamples()
    for number in range(3 * MAX_WRITERS):
        lost.add(number.to_bytes(16, "big"), 1)
        lost.add(number.to_bytes(16, "big"), 3)
    assert len(lost._last) == MAX_WRITERS
    assert len(lost._missing) <= MAX_WRITERS


def test_expired_samples_are_dropped(participant: Participant) -> None:
    lived = LATCHED._replace(lifespan_ns=200_000_000)
    writer = participant.create_writer(NODE, TOPIC, lived)
    reader = participant.create_reader(NODE, TOPIC, LATCHED)
    writer.write(HEADER + b"old")
    wait_until(lambda: reader._waiting)
    end = time.monotonic() + 0.3
    wait_until(lambda: time.monotonic() > end)
    assert reader.take() is None
    late = participant.create_reader(NODE, TOPIC, LATCHED)
    writer.write(HEADER + b"new")
    assert [sample.data for sample in take_all(late, 1)] == [HEADER + b"new"]


def test_missed_deadlines_are_counted_on_both_sides(participant: Participant) -> None:
    timed = QoS(deadline_ns=50_000_000)
    writer = participant.create_writer(NODE, TOPIC, timed)
    reader = participant.create_reader(NODE, TOPIC, timed)
    assert writer.take_event(Event.DEADLINE_MISSED) is None
    writer.write(HEADER + b"x")
    wait_until(lambda: reader.events._statuses[Event.DEADLINE_MISSED].total_count >= 2)
    wait_until(lambda: writer.take_event(Event.DEADLINE_MISSED))
    assert reader.take_event(Event.DEADLINE_MISSED).total_count >= 2


def test_a_writer_that_asserts_nothing_is_not_alive_until_it_writes(participant: Participant) -> None:
    manual = QoS(liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_ns=100_000_000)
    writer = participant.create_writer(NODE, TOPIC, manual)
    reader = participant.create_reader(NODE, TOPIC, manual)
    assert reader.take_event(Event.LIVELINESS_CHANGED) == LivelinessChanged(1, 0, 1, 0)
    wait_until(lambda: reader.take_event(Event.LIVELINESS_CHANGED) == LivelinessChanged(0, 1, -1, 1))
    wait_until(lambda: writer.take_event(Event.LIVELINESS_LOST) == (1, 1))
    writer.write(HEADER + b"x")
    wait_until(lambda: reader.events._statuses[Event.LIVELINESS_CHANGED].alive_count == 1)
    writer.close()
    wait_until(lambda: reader.events._statuses[Event.LIVELINESS_CHANGED][:2] == (0, 0))


class Router:
    """The router of a participant, of whose tokens a graph of another session hears nothing by itself."""

    def __init__(self, participant: Any, plain: Any, domain_id: int) -> None:
        self.domain_id = domain_id
        self.plain = plain
        self.open = participant._session.open_client
        self.tokens: list[Any] = []
        self.open_count = 0
        self.is_silent = False

    def open_client(self) -> Any:
        self.open_count += 1
        if self.is_silent:
            raise zenoh.ZError("no answer")
        return self.open()

    def declare(self, key: str) -> str:
        self.tokens.append(self.plain.liveliness().declare_token(key))
        return key

    def key(self, number: int, kind: Kind = Kind.NODE) -> str:
        node = NodeName("/", f"n{number}")
        return token_key(Token(self.domain_id, str(self.plain.zid()), number, number, kind, "/", node, None))


@pytest.fixture
def router(participant: Participant, plain: Any) -> Router:
    return Router(participant, plain, 200)  # a domain that has nothing else


@pytest.fixture
def deaf(router: Router, monkeypatch: pytest.MonkeyPatch) -> Iterator[ZenohGraph]:
    """Yield the graph of a session that is linked to nothing."""
    monkeypatch.setattr(zenoh_announced, "AGAIN_S", 0.01)
    config = zenoh_config.default_configuration(
        {**zenoh_config.session_settings(), "connect/endpoints": [], "scouting/gossip/enabled": False}
    )
    with zenoh.open(config) as session:
        graph = ZenohGraph(session, router.domain_id, str(session.zid()), open_client=router.open_client)
        yield graph
        graph.close()
    assert not [thread for thread in threading.enumerate() if thread.name == "tfloom_zenoh_announced"]


def test_a_graph_is_whole_when_all_tokens_of_the_router_are_here(router: Router, deaf: ZenohGraph) -> None:
    first, second, third = (router.declare(router.key(number)) for number in range(3))
    router.declare(f"{PREFIX}/{router.domain_id}/of/another/form")
    deaf.add_own(first)  # as of another session
    wait_until(lambda: not deaf.is_whole() and router.open_count >= 3)  # it has replied
    deaf.add_own(second)
    router.open_count = 0
    wait_until(lambda: not deaf.is_whole() and router.open_count >= 3)
    deaf.add_own(third)
    wait_until(deaf.is_whole)
    router.open_count = 0
    assert deaf.is_whole()
    assert router.open_count == 0


def test_a_token_that_has_ended_is_awaited_no_longer(router: Router, deaf: ZenohGraph) -> None:
    router.declare(router.key(1))
    wait_until(lambda: not deaf.is_whole() and router.open_count >= 3)
    router.tokens.pop().undeclare()
    wait_until(deaf.is_whole)


def test_a_graph_is_not_whole_while_the_router_is_silent(router: Router, deaf: ZenohGraph) -> None:
    router.is_silent = True
    wait_until(lambda: not deaf.is_whole() and router.open_count >= 3)
    router.is_silent = False
    wait_until(deaf.is_whole)


def test_a_reply_counts_although_its_client_can_not_be_closed(
    router: Router, deaf: ZenohGraph, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Zenoh gives up after some seconds where the router has been stopped meanwhile."""
    closed: list[Any] = []

    class Unclosable:
        def __init__(self) -> None:
            self.session = router.open()
            self.liveliness = self.session.liveliness

        def close(self) -> None:
            self.session.close()
            closed.append(self)
            raise zenoh.ZError("close operation timed out!")

    monkeypatch.setattr(deaf._announced, "_open_client", Unclosable)
    wait_until(deaf.is_whole)
    assert len(closed) == 1


def test_a_graph_that_keeps_no_more_tokens_awaits_none(
    router: Router, deaf: ZenohGraph, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(zenoh_graph, "MAX_TOKENS", 1)
    for number in range(3):
        router.declare(router.key(number))
    deaf.add_own(router.key(0))
    wait_until(deaf.is_whole)


def test_a_graph_that_closes_while_its_router_is_asked_leaves_no_thread(
    router: Router, deaf: ZenohGraph, monkeypatch: pytest.MonkeyPatch
) -> None:
    opening, closing = threading.Event(), threading.Event()

    def open_late() -> Any:
        opening.set()
        closing.wait(30)
        return router.open()

    monkeypatch.setattr(deaf._announced, "_open_client", open_late)
    assert not deaf.is_whole()
    assert opening.wait(30)
    late = threading.Timer(0.1, closing.set)
    late.start()
    deaf.close()
    assert closing.is_set()
    assert not deaf.is_whole()
    assert not [thread for thread in threading.enumerate() if thread.name == "tfloom_zenoh_announced"]
    late.join()


def test_end_does_not_wait_for_a_router_that_does_not_reply() -> None:
    asked = threading.Event()
    silent = SimpleNamespace(
        close=lambda: None, liveliness=lambda: SimpleNamespace(get=lambda *_, **__: asked.set())
    )
    announced = zenoh_announced.AnnouncedTokens(lambda: silent, "**")
    assert not announced.are_here(lambda _: False)
    assert asked.wait(10.0)
    announced.close()
    assert not [thread for thread in threading.enumerate() if thread.name == "tfloom_zenoh_announced"]
    assert not announced.are_here(lambda _: False)  # and nothing is asked any more


def test_the_owner_of_the_router_awaits_nobody_and_others_await_it(
    participant: Participant, domain_id: int
) -> None:
    from tfloom.rmw.zenoh.wire import open_participant

    assert participant.graph.is_whole()
    other = open_participant(domain_id)
    assert not other.graph.is_whole()
    wait_until(other.graph.is_whole)
    assert other.graph.nodes() == [NODE]
    other.close()


def test_a_second_session_is_a_client_with_an_id_of_its_own(
    participant: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "session.json5"
    file.write_text('{id: "c0ffee", mode: "peer"}')
    monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(file))
    with closing(open_session()) as opened, opened.open_client() as client:
        assert opened.zid == "c0ffee"
        assert str(client.zid()) != "c0ffee"
        routers = {str(zid) for zid in opened.session.info.routers_zid()}
        assert {str(zid) for zid in client.info.routers_zid()} == routers


@contextmanager
def slow_link(port: int, bytes_per_s: float) -> Iterator[int]:
    """Yield a port that leads to another one of this machine, and carries no more than so many bytes a second back."""

    def carry(source: socket.socket, destination: socket.socket, rate: float) -> None:
        with suppress(OSError):
            while data := source.recv(1 << 16):
                destination.sendall(data)
                time.sleep(len(data) / rate)

    with socket.create_server(("127.0.0.1", 0)) as server, ExitStack() as opened:

        def serve() -> None:
            here = opened.enter_context(server.accept()[0])
            there = opened.enter_context(socket.create_connection(("127.0.0.1", port)))
            there.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 16)
            backward = threading.Thread(target=carry, args=(there, here, bytes_per_s))
            backward.start()
            carry(here, there, math.inf)
            here.shutdown(socket.SHUT_RDWR)
            backward.join()

        thread = threading.Thread(target=serve)
        thread.start()
        yield server.getsockname()[1]
        thread.join()


def test_large_messages_pass_a_link_that_is_slower_than_their_writer(
    participant: Participant, domain_id: int
) -> None:
    """Their parts wait for room together, one after the other, at the writer and at the router."""
    from tests.oracles.compare_rmw_zenoh import client_session

    large = HEADER + bytes(10_000_000)
    received: list[int] = []
    with (
        slow_link(int(os.environ["TFLOOM_ZENOH_PORT"]), 100e6) as port,
        client_session(port) as session,
    ):
        session.declare_subscriber(
            key_of(TOPIC, domain_id),
            callback(lambda sample: received.append(len(sample.payload))),
        )
        writer = participant.create_writer(NODE, TOPIC, QoS())
        wait_until(lambda: writer.write(HEADER + b"small") or received)
        for number in range(1, 4):
            writer.write(large)
            wait_until(lambda number=number: received.count(len(large)) == number)


def test_a_writer_that_is_closed_raises(participant: Participant) -> None:
    writer = participant.create_writer(NODE, TOPIC, QoS())
    writer.close()
    for operate in (lambda: writer.write(HEADER), writer.assert_liveliness, lambda: writer.wait_for_acks(0)):
        with pytest.raises(ClosedError, match="/robot/chatter: its writer is closed"):
            operate()


def test_what_is_closed_raises_and_leaves_the_graph(participant: Participant) -> None:
    client = participant.create_requester(NODE, KILL, QoS())
    server = participant.create_responder(NODE, KILL, QoS())
    wait_until(client.is_ready)
    server.close()
    wait_until(lambda: not client.is_ready())
    client.close()
    with pytest.raises(ClosedError, match="the client of /kill is closed"):
        client.send(HEADER)
    with pytest.raises(ClosedError, match="the server of /kill is closed"):
        server.send((GID, 1), HEADER)
    assert participant.graph.service_ends() == []
    participant.remove_node(NODE)
    assert participant.graph.nodes() == []
    with pytest.raises(ValueError, match="/tests/here is not a node"):
        participant.remove_node(NODE)
    participant.close()
    participant.close()
    with pytest.raises(ClosedError, match="its participant is closed"):
        participant.create_writer(NODE, TOPIC, QoS())
    with pytest.raises(ClosedError, match="its participant is closed"):
        participant.add_node(NODE)


def test_what_zenoh_refuses_leaves_nothing_behind(
    participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(key: str) -> None:
        raise zenoh.ZError("refused by the test")

    monkeypatch.setattr(participant, "_declare_token", refuse)
    for create, what in (
        (participant.create_writer, TOPIC),
        (participant.create_reader, TOPIC),
        (participant.create_requester, KILL),
        (participant.create_responder, KILL),
    ):
        with pytest.raises(WireError, match="refused by the test"):
            create(NODE, what, QoS())
    monkeypatch.undo()
    assert participant._ends == set()
    assert participant.graph._watchers == {}


def test_samples_and_the_graph_come_back_after_a_routers_death(
    domain_id: int, start_program: Callable[..., Program], start_peer: Callable[..., Peer], monkeypatch
) -> None:
    """Clients of one router, which have no link of their own: all that passes between them passes through it."""

    from tfloom.rmw.zenoh.wire import open_participant

    port = os.environ["TFLOOM_ZENOH_PORT"]
    router = start_program("tfloom", "zenoh", "router")
    router.wait_for(port)
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", 'mode="client"')
    participant = open_participant(domain_id)
    try:
        participant.add_node(NODE)
        reader = participant.create_reader(NODE, TOPIC, LATCHED._replace(depth=100))
        peer = start_peer()
        monkeypatch.delenv("ZENOH_CONFIG_OVERRIDE")  # which the second router would heed
        end, gid = peer("writer", list(TOPIC[:3]), list(LATCHED._replace(depth=100)))
        peer("write", end, (HEADER + b"\0").hex())
        take_all(reader, 1)
        wait_until(lambda: reader.matched_count() == 1)
        router.end()
        wait_until(lambda: reader.matched_count() == 0)
        wait_until(lambda: participant.graph.nodes() == [NODE])
        peer("write", end, (HEADER + b"\1").hex())
        router = start_program("tfloom", "zenoh", "router")
        router.wait_for(port)
        wait_until(lambda: reader.matched_count() == 1)
        wait_until(lambda: len(participant.graph.nodes()) == 2)
        peer("write", end, (HEADER + b"\2").hex())
        samples = take_all(reader, 2)
        assert [sample.data[4] for sample in samples] == [1, 2]
        assert {sample.publisher_gid.hex() for sample in samples} == {gid}
    finally:
        participant.close()


SHARED = "transport/shared_memory/enabled=true"


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="looks at /dev/shm")
@pytest.mark.parametrize(("mine", "theirs"), [(True, True), (True, False), (False, True)])
def test_large_samples_pass_by_shared_memory_only_where_both_ask_for_it(
    domain_id: int, start_peer: Callable[..., Peer], monkeypatch, mine: bool, theirs: bool
) -> None:
    from tfloom.rmw.zenoh.wire import open_participant

    sample = HEADER + bytes(range(250)) * 4000

    def pass_both_ways() -> Peer:
        if theirs:
            monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", SHARED)
        peer = start_peer()
        monkeypatch.delenv("ZENOH_CONFIG_OVERRIDE", raising=False)
        end, _ = peer("writer", list(TOPIC[:3]), list(LATCHED))
        peer("write", end, sample.hex())
        assert take_all(reader, 1)[0].data == sample
        return peer

    if mine:
        monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", SHARED)
    participant = open_participant(domain_id)
    monkeypatch.delenv("ZENOH_CONFIG_OVERRIDE", raising=False)
    try:
        participant.add_node(NODE)
        reader = participant.create_reader(NODE, TOPIC, LATCHED)
        peer = pass_both_ways()
        assert (mine and theirs) == bool(shared_files(peer.pid) & shared_files(os.getpid()))
        # A killed one takes nothing with it, and the next one begins anew.
        os.kill(peer.pid, signal.SIGKILL)
        wait_until(lambda: reader.matched_count() == 0, what="the end of the killed peer")
        pass_both_ways()
    finally:
        participant.close()


def shared_files(pid: int) -> set[str]:
    """Return the files of Zenoh in /dev/shm that a process has mapped."""
    return set(re.findall(r"/dev/shm/\S+\.zenoh", Path(f"/proc/{pid}/maps").read_text()))


IMPORTS = """
import sys, threading, time
import rclpy, zenoh
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String
from tfloom.rmw.zenoh import wire as zenoh_wire
"""
NODE_THAT_HEARS = """
rclpy.init(args=[])
node = Node("ends")
heard = []
publisher = node.create_publisher(String, "chatter", 10)
node.create_subscription(String, "chatter", lambda message: heard.append(message.data), 10)
client = node.create_client(AddTwoInts, "add")
while not heard:
    publisher.publish(String(data="x"))
    rclpy.spin_once(node, timeout_sec=0.1)
print("ready", flush=True)
"""


ENDS = {
    "raise KeyError('main')": (1, "KeyError: 'main'"),
    "threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start(); sys.exit(4)": (4, "ready"),
    "sys.exit(5)": (5, "ready"),
    "node.destroy_node(); rclpy.shutdown(); sys.exit(6)": (6, "ready"),
    "threading.Timer(0.2, lambda: [publisher.publish(String()) for _ in range(5000)]).start(); sys.exit(7)": (
        7,
        "ready",
    ),
}
"""The last line of a program, and its exit code and the last line that it prints."""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
def test_a_program_ends_without_a_hang(domain_id: int, start_program: Callable[..., Program]) -> None:
    outputs = outputs_by_end(start_program, IMPORTS, NODE_THAT_HEARS, ENDS)
    assert [(code, lines[-1]) for code, lines in outputs] == list(ENDS.values()), outputs
    printed = "".join(line for _, lines in outputs for line in lines)
    assert "panicked" not in printed
    assert "FATAL" not in printed


def test_ctrl_c_ends_a_call(domain_id: int, start_program: Callable[..., Program]) -> None:
    import signal

    server = (
        "import rclpy, time; from rclpy.node import Node; from example_interfaces.srv import AddTwoInts\n"
        "rclpy.init(args=[]); node = Node('slow')\n"
        "def serve(request, response):\n    print('asked', flush=True); time.sleep(60)\n"
        "node.create_service(AddTwoInts, 'add', serve); print('serves', flush=True); rclpy.spin(node)"
    )
    slow = start_program("python", "-c", server)
    slow.wait_for("serves")
    program = start_program(
        "python",
        "-c",
        f"{IMPORTS}{NODE_THAT_HEARS}\nthreading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()\n"
        "client.wait_for_service(20)\nclient.call(AddTwoInts.Request())",
    )
    slow.wait_for("asked")
    program.signal(signal.SIGINT)
    assert program.wait() != 0
    assert "panicked" not in program.output


def test_a_callback_that_sleeps_starves_no_other(
    domain_id: int, start_program: Callable[..., Program]
) -> None:
    code = """
import threading, time
import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node
from std_msgs.msg import String
rclpy.init(args=[])
node = Node("sleeper")
group = ReentrantCallbackGroup()
asleep, heard = threading.Event(), []
def sleep(message):
    asleep.set()
    release.wait(60)
release = threading.Event()
node.create_subscription(String, "slow", sleep, 1, callback_group=group)
node.create_subscription(String, "fast", lambda message: heard.append(message.data), 1000, callback_group=group)
slow, fast = node.create_publisher(String, "slow", 10), node.create_publisher(String, "fast", 1000)
executor = MultiThreadedExecutor(3)
executor.add_node(node)
threading.Thread(target=executor.spin, daemon=True).start()
while not asleep.is_set():
    slow.publish(String(data="x"))
    time.sleep(0.01)
for number in range(300):
    fast.publish(String(data=str(number)))
end = time.monotonic() + 30
while len(heard) < 300 and time.monotonic() < end:
    time.sleep(0.01)
print("heard", len(heard), flush=True)
release.set()
executor.shutdown()
rclpy.shutdown()
"""
    program = start_program("python", "-c", code)
    assert program.wait() == 0, program.output
    assert program.lines == ["heard 300"]


def test_a_callback_that_raises_ends_nothing_of_the_wire(
    participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[threading.ExceptHookArgs] = []
    monkeypatch.setattr(threading, "excepthook", told.append)
    reader = participant.create_reader(NODE, TOPIC, QoS(depth=10))
    writer = participant.create_writer(NODE, TOPIC, QoS())

    class Broken(SampleQueue):
        def push(self, *arguments: object) -> None:
            raise KeyError("planted")

    reader.feed(Broken(3))
    writer.write(HEADER + b"x")
    wait_until(lambda: told)
    sink = SampleQueue(10)
    reader.feed(sink)
    writer.write(HEADER + b"y")
    wait_until(lambda: sink.pushed() == 1)
    assert [str(said.exc_value) for said in told] == ["'planted'"]


def test_a_sink_that_sleeps_starves_no_other(participant: Participant) -> None:
    """A push may run the done callback of a wait for a transform."""
    asleep, release = threading.Event(), threading.Event()

    class Sleeps(SampleQueue):
        def push(self, *arguments: object) -> None:
            asleep.set()
            release.wait(60)

    other_topic = TOPIC._replace(name="/robot/other")
    reader, other = (participant.create_reader(NODE, topic, QoS()) for topic in (TOPIC, other_topic))
    reader.feed(Sleeps(3))
    participant.create_writer(NODE, TOPIC, QoS()).write(HEADER + b"x")
    assert asleep.wait(30)
    participant.create_writer(NODE, other_topic, QoS()).write(HEADER + b"y")
    try:
        assert take_all(other, 1)[0].data == HEADER + b"y"
    finally:
        release.set()


def test_without_a_thread_a_reader_is_not_fed(participant: Participant) -> None:
    reader = participant.create_reader(NODE, TOPIC, QoS())
    with no_more_threads(), pytest.raises(WireError, match=NOT_FED):
        reader.feed(SampleQueue(1))
    participant.create_writer(NODE, TOPIC, QoS()).write(HEADER + b"x")
    assert take_all(reader, 1)[0].data == HEADER + b"x"


def test_without_a_thread_for_another_sink_a_reader_keeps_samples_for_the_next_one(
    participant: Participant,
) -> None:
    first, last = SampleQueue(10), SampleQueue(10)
    reader = participant.create_reader(NODE, TOPIC, QoS())
    writer = participant.create_writer(NODE, TOPIC, QoS())
    reader.feed(first)
    writer.write(HEADER + b"a")
    assert pushed(first, 1) == [HEADER + b"a"]
    with no_more_threads(), pytest.raises(WireError, match=NOT_FED):
        reader.feed(SampleQueue(1))
    writer.write(HEADER + b"b")
    reader.feed(last)
    writer.write(HEADER + b"c")
    assert pushed(last, 2) == [HEADER + b"b", HEADER + b"c"]
    assert first.take() == []
    assert [thread.name for thread in threading.enumerate()].count("tfloom_zenoh_feeder") == 1


def test_without_a_thread_for_its_deadline_an_endpoint_is_not_opened(participant: Participant) -> None:
    timed = QoS(deadline_ns=10**9)
    text = "the deadline of /robot/chatter, which takes a thread: can't start"
    with no_more_threads(), pytest.raises(WireError, match=text):
        participant.create_writer(NODE, TOPIC, timed)
    assert participant.graph.endpoints() == []
    participant.create_writer(NODE, TOPIC, timed).write(HEADER)


def test_without_a_thread_for_a_lease_samples_come_and_a_line_tells(
    participant: Participant,
    plain: Any,
    domain_id: int,
    capsys: pytest.CaptureFixture[str],
) -> None:
    manual = QoS(liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_ns=10**9)
    token = declare_token(plain, domain_id, Kind.PUBLISHER, End(*TOPIC[:3], manual))
    wait_until(participant.graph.endpoints)
    with no_more_threads():
        reader = participant.create_reader(NODE, TOPIC, QoS())
    assert capsys.readouterr().err == (
        "tfloom: the liveliness of the publisher of /robot/chatter in /plain is not watched, which takes a thread: "
        "can't start new thread\n"
    )
    assert reader.matched_count() == 1
    token.undeclare()
    wait_until(lambda: reader.matched_count() == 0)


def test_without_xxhash_the_error_says_what_to_install(
    participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "xxhash", None)
    with pytest.raises(NoBackendError, match=r"need xxhash.*pip install 'tfloom\[zenoh\]'"):
        participant.create_writer(NODE, TOPIC, QoS())


def test_no_thread_of_python_is_left(domain_id: int) -> None:
    from tfloom.rmw.zenoh.wire import open_participant

    before = set(threading.enumerate())
    participant = open_participant(domain_id)
    participant.add_node(NODE)
    participant.create_writer(NODE, TOPIC, QoS(deadline_ns=10**9))
    participant.create_responder(NODE, KILL, QoS())
    participant.close()
    assert set(threading.enumerate()) - before == set()


CTRL_C_IN_A_CALLBACK = """
import signal, sys
import rclpy

fired = []

def trace(frame, event, argument):
    if frame.f_code.co_name == "_on_token" and not fired:
        fired.append(frame)
        signal.raise_signal(signal.SIGINT)

rclpy.init()
sys.settrace(trace)
try:
    rclpy.spin(rclpy.create_node("interrupted"))
except KeyboardInterrupt:
    print("interrupted in a callback:", bool(fired))
"""


def test_ctrl_c_in_a_callback_of_zenoh_is_raised_in_the_program(
    start_program: Callable[..., Program],
) -> None:
    """Zenoh calls back on the main thread too, within a declaration, and prints and drops what is raised there."""
    program = start_program("python", "-c", CTRL_C_IN_A_CALLBACK)
    assert program.wait() == 0, program.output
    assert program.output == "interrupted in a callback: True"


CTRL_C_IN_A_CALL = """
import signal, sys, threading
import rclpy
from example_interfaces.srv import AddTwoInts

rclpy.init()
node = rclpy.create_node("interrupted")
client = node.create_client(AddTwoInts, "add")
node.create_service(AddTwoInts, "add", print)
client.wait_for_service(20)

def trace(frame, event, argument):
    if frame.f_code.co_name == "send" and frame.f_code.co_filename.endswith("zenoh/services.py"):
        sys.settrace(None)
        signal.raise_signal(signal.SIGINT)

sys.settrace(trace)
try:
    client.call(AddTwoInts.Request())
except KeyboardInterrupt:
    print("interrupted in a call")
"""


def test_ctrl_c_while_a_request_is_sent_is_raised_by_the_call(start_program: Callable[..., Program]) -> None:
    program = start_program("python", "-c", CTRL_C_IN_A_CALL)
    assert program.wait() == 0, program.output
    assert program.output == "interrupted in a call"
