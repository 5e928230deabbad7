"""Services on both wires: routing of requests and responses, and the bytes of rmw_cyclonedds."""

from __future__ import annotations

import struct
import threading
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import pytest
from tests.conftest import python_with
from tests.rmw.conftest import NODES, Wires

from tfloom._native import DdsParticipant, DdsReader, DdsWriter, ReadyQueue
from tfloom.rmw import services
from tfloom.rmw.base import NodeName, Participant, RequestId, Sample, Service, Topic
from tfloom.rmw.cyclone import services as cyclone_services
from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.cyclone.config import configuration
from tfloom.rmw.cyclone.library import find_library
from tfloom.rmw.cyclone.services import CycloneClients, CycloneServers, Vendors, end_id
from tfloom.rmw.errors import ClosedError, CongestedError, ForeignPeerError, WireError
from tfloom.rmw.qos import HistoryPolicy, QoS
from tfloom.rmw.services import HeaderRequester, HeaderResponder, RequestsInFlight

KILL = Service("/kill", "turtlesim/srv/Kill", *(f"RIHS01_{digit * 64}" for digit in "123"))
CLIENT, SERVER = NODES
HEADER = b"\0\1\0\0"


@pytest.fixture
def pair(wires: Wires, wait_until: Callable[..., None]) -> tuple[Any, Any]:
    """Return a client, and the server that it is ready for."""
    client = wires[0].create_requester(CLIENT, KILL, QoS())
    server = wires[1].create_responder(SERVER, KILL, QoS())
    wait_until(client.is_ready)
    return client, server


@pytest.fixture
def take(wait_until: Callable[..., None]) -> Callable[[Any], Any]:
    """Wait for an item, and take it."""

    def take(end: Any) -> Any:
        taken: list[Any] = []
        wait_until(lambda: taken.append(end.take()) or taken[-1] is not None)
        return taken[-1]

    return take


def test_request_receives_its_response(wires: Wires, take, wait_until) -> None:
    client = wires[0].create_requester(CLIENT, KILL, QoS())
    assert not client.is_ready()
    server = wires[1].create_responder(SERVER, KILL, QoS())
    wait_until(client.is_ready)
    assert client.incompatibility() == server.incompatibility() == ""
    assert client.send(HEADER + b"ask!") == 1
    request = take(server)
    assert request.data == HEADER + b"ask!"
    assert request.id.sequence_number == 1
    assert len(request.id.client_gid) == 16
    server.send(request.id, HEADER + b"told")
    response = take(client)
    assert response.data == HEADER + b"told"
    assert response.id == request.id
    assert 0 < response.source_stamp_ns <= response.received_stamp_ns
    assert client.take() is None
    assert server.take() is None


def test_each_client_receives_its_responses(wires: Wires, take, wait_until) -> None:
    server = wires[1].create_responder(SERVER, KILL, QoS(depth=1000))
    clients = [wires[i % 2].create_requester(CLIENT, KILL, QoS(depth=1000)) for i in range(5)]
    for client in clients:
        wait_until(client.is_ready)
    sent = {
        (i, client.send(HEADER + bytes([i, n, 0, 0]))): bytes([i, n, 0, 0])
        for n in range(20)
        for i, client in enumerate(clients)
    }
    requests = [take(server) for _ in sent]
    for request in reversed(requests):
        server.send(request.id, request.data)
    got = {}
    for i, client in enumerate(clients):
        for _ in range(20):
            response = take(client)
            got[i, response.id.sequence_number] = response.data[4:]
        assert client.take() is None
    assert got == sent


def test_many_requests_and_responses_wait_for_slow_peers(wires: Wires, pair, take) -> None:
    client, server = pair
    other = wires[0].create_requester(CLIENT, KILL, QoS())
    for number in range(50):
        client.send(HEADER + bytes([number, 0, 0, 0]))
    requests = [take(server) for _ in range(50)]
    for request in requests:
        server.send(request.id, request.data)
    assert [take(client).data[4] for _ in range(50)] == list(range(50))
    assert other.take() is None


def test_server_with_a_small_depth_drops_requests(wires: Wires, take, wait_until) -> None:
    server = wires[1].create_responder(SERVER, KILL, QoS(depth=1))
    client = wires[0].create_requester(CLIENT, KILL, QoS())
    wait_until(client.is_ready)
    for number in range(50):
        client.send(HEADER + bytes([number, 0, 0, 0]))
    wait_until(lambda: take(server).id.sequence_number == 50)
    assert server.take() is None


def test_tokens_are_posted_for_requests_responses_and_readiness(wires: Wires, take, wait_until) -> None:
    asked, answered, ready = ReadyQueue(), ReadyQueue(), ReadyQueue()
    client = wires[0].create_requester(CLIENT, KILL, QoS())
    client.notify_ready(ready, 3)
    assert ready.wait(0) == [3]
    server = wires[1].create_responder(SERVER, KILL, QoS())
    assert ready.wait(5_000_000_000) == [3]
    wait_until(client.is_ready)
    server.notify(asked, 1)
    client.notify(answered, 2)
    wait_until(lambda: asked.wait(0) == [] and answered.wait(0) == [])
    client.send(HEADER + b"ask!")
    assert asked.wait(5_000_000_000) == [1]
    server.send(take(server).id, HEADER + b"told")
    assert answered.wait(5_000_000_000) == [2]
    ready.wait(0)
    server.close()
    assert ready.wait(5_000_000_000) == [3]
    wait_until(lambda: not client.is_ready())


def test_watch_of_servers_goes_on_after_a_wait_for_one(wires: Wires) -> None:
    watched, waited = ReadyQueue(), ReadyQueue()
    client = wires[0].create_requester(CLIENT, KILL, QoS())
    client.watch_servers(watched, 4)
    assert watched.wait(0) == [4]
    client.notify_ready(waited, 5)
    assert waited.wait(0) == [5]
    client.notify_ready(None)
    assert watched.wait(0) == [4]
    wires[1].create_responder(SERVER, KILL, QoS())
    assert watched.wait(5_000_000_000) == [4]
    assert waited.wait(0) == []
    client.watch_servers(None)


def test_closed_endpoints_deliver_nothing(pair, take) -> None:
    client, server = pair
    client.send(HEADER + b"ask!")
    request = take(server)
    client.close()
    client.close()
    server.send(request.id, HEADER + b"nobody hears it")
    server.close()
    server.close()
    with pytest.raises(ClosedError):
        client.send(HEADER + b"ask!")
    with pytest.raises(ClosedError):
        server.send(request.id, HEADER + b"told")


def test_graph_lists_servers_and_clients_separately_from_topics(wires: Wires, wait_until) -> None:
    client = wires[0].create_requester(CLIENT, KILL, QoS())
    server = wires[1].create_responder(SERVER, KILL, QoS())
    for wire in wires:
        wait_until(lambda w=wire: sum(end.node is not None for end in w.graph.service_ends()) == 2)
        ends = {end.is_server: end for end in wire.graph.service_ends()}
        assert [(end.name, end.type_name) for end in ends.values()] == [("/kill", "turtlesim/srv/Kill")] * 2
        assert (ends[True].node, ends[True].gid) == (SERVER, server.gid)
        assert (ends[False].node, ends[False].gid) == (CLIENT, client.gid)
        assert wire.graph.endpoints() == []


def test_many_calls_from_two_threads(wires: Wires, wait_until) -> None:
    server = wires[1].create_responder(SERVER, KILL, QoS(depth=1000))
    asked = ReadyQueue()
    server.notify(asked, 1)
    stop = threading.Event()

    def serve() -> None:
        while not stop.is_set():
            asked.wait(50_000_000)
            while request := server.take():
                server.send(request.id, request.data)

    def call(results: list[int]) -> None:
        client = wires[0].create_requester(CLIENT, KILL, QoS(depth=1000))
        answered = ReadyQueue()
        client.notify(answered, 1)
        wait_until(client.is_ready)
        for _ in range(200):
            number = client.send(HEADER + b"ask!")
            while (response := client.take()) is None:
                assert answered.wait(5_000_000_000)
            results.append(response.id.sequence_number == number)

    results: list[int] = []
    threads = [
        threading.Thread(target=serve),
        *(threading.Thread(target=call, args=[results]) for _ in range(2)),
    ]
    for thread in threads:
        thread.start()
    for thread in threads[1:]:
        thread.join(60)
    stop.set()
    threads[0].join(60)
    assert results == [True] * 400


@pytest.fixture
def bare(domain_id: int) -> Iterator[DdsParticipant]:
    """Yield a plain DDS participant, without ROS."""
    bare = DdsParticipant(find_library(), domain_id, configuration(), b"")
    yield bare
    bare.close()


REQUESTS = ("rq/killRequest", "turtlesim::srv::dds_::Kill_Request_")
RESPONSES = ("rr/killReply", "turtlesim::srv::dds_::Kill_Response_")


def test_writers_keep_requests_until_they_are_acknowledged(
    participant: Participant, node: NodeName, wait_until
) -> None:
    """Those of topics keep their depth, which is the user's choice; a killed client must not hold up a server."""
    participant.create_responder(node, KILL, QoS())
    participant.create_requester(node, KILL, QoS())
    participant.create_writer(node, Topic("/kill", "std_msgs/msg/String", ""), QoS())

    def kept() -> dict[str, HistoryPolicy]:
        return {
            end.topic.name: end.qos.history
            for end in participant.graph.raw_endpoints()
            if end.is_writer and "kill" in end.topic.name
        }

    wait_until(lambda: len(kept()) == 3)
    assert kept() == {
        "rq/killRequest": HistoryPolicy.KEEP_ALL,
        "rr/killReply": HistoryPolicy.KEEP_LAST,
        "rt/kill": HistoryPolicy.KEEP_LAST,
    }


def test_requests_on_the_wire_are_header_and_message(domain_id, bare, take, wait_until) -> None:
    participant = cyclonedds.open_participant(domain_id)
    requests = DdsReader(bare, *REQUESTS, QoS(), b"serviceid= 1.10.2;")
    responses = DdsWriter(bare, *RESPONSES, QoS(), b"serviceid= 1.10.2;")
    client = participant.create_requester(CLIENT, KILL, QoS())
    wait_until(lambda: client.is_ready() and requests.matched_count() and responses.matched_count())
    client.send(HEADER + b"ask!")
    data = take(requests)[0]
    assert (data[:4], data[20:]) == (HEADER, b"ask!")
    key, sequence_number = struct.unpack_from("<Qq", data, 4)
    assert sequence_number == 1
    for other_key, text in ((key ^ 1, b"not for you."), (key, b"for you.")):
        responses.write(HEADER + struct.pack("<Qq", other_key, 1) + text)
    assert take(client).data == HEADER + b"for you."
    for end in (requests, responses):
        end.close()
    participant.close()


def test_server_replies_to_requests_in_the_format_of_rmw_cyclonedds(
    domain_id, bare, take, wait_until
) -> None:
    participant = cyclonedds.open_participant(domain_id)
    server = participant.create_responder(SERVER, KILL, QoS())
    requests = DdsWriter(bare, *REQUESTS, QoS(), b"clientid= 1.10.7;")
    wait_until(requests.matched_count)
    for junk in (b"\0", bytes(11), bytes(16)):
        requests.write(HEADER + junk)
    requests.write(HEADER + struct.pack("<Qq", 0x1122334455667788, 42) + b"ask!")
    # The client's reader is created later; the response waits for it.
    request = take(server)
    assert request.data == HEADER + b"ask!"
    assert request.id.sequence_number == 42
    assert request.id.client_gid == struct.pack("<Q", 0x1122334455667788) + bytes(8)
    responses = DdsReader(bare, *RESPONSES, QoS(), b"clientid= 1.10.7;")
    server.send(request.id, HEADER + b"told")
    assert take(responses)[0] == HEADER + struct.pack("<Qq", 0x1122334455667788, 42) + b"told"
    for end in (requests, responses):
        end.close()
    participant.close()


ANSWERS = """
import os, time
from tfloom.rmw.base import NodeName, Service
from tfloom.rmw.cyclone.wire import open_participant
from tfloom.rmw.qos import QoS

participant = open_participant(int(os.environ["ROS_DOMAIN_ID"]))
node = NodeName("/a", "server")
participant.add_node(node)
kill = Service("/kill", "turtlesim/srv/Kill", *(f"RIHS01_{digit * 64}" for digit in "123"))
server = participant.create_responder(node, kill, QoS())
while True:
    request = server.take()
    if request is None:
        time.sleep(0.001)
    else:
        server.send(request.id, request.data)
"""


def test_server_that_has_just_answered_does_not_wait_for_the_next_heartbeat(
    domain_id: int, start_program, take, wait_until, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It waits for a new client to acknowledge a probe, which libddsc would ask for after the period of heartbeats."""
    if reason := cyclone_services.start_translation(find_library()):
        pytest.skip(f"what is sent is not changed here: {reason}")
    period = "<HeartbeatInterval>20ms</HeartbeatInterval>"
    assert period in configuration(domain_id)
    long_period = '<HeartbeatInterval min="300s" minsched="300s" max="600s">300s</HeartbeatInterval>'
    monkeypatch.setenv("CYCLONEDDS_URI", configuration(domain_id).replace(period, long_period))
    start_program("python", *python_with({"tfloom.rmw.cyclone.services.HANDSHAKE_S": 300.0}, ANSWERS))
    participant = cyclonedds.open_participant(domain_id)
    for number in range(3):
        client = participant.create_requester(CLIENT, KILL, QoS())
        wait_until(client.is_ready)
        client.send(HEADER + bytes([number] * 4))
        assert take(client).data == HEADER + bytes([number] * 4)
    participant.close()


class FakeEnd:
    """An endpoint with these peers connected."""

    gid = bytes(16)

    def __init__(self, *peers: tuple[str, bytes]) -> None:
        self.peers = [(bytes.fromhex(vendor) + bytes(14), user_data) for vendor, user_data in peers]
        self.written: list[bytes] = []
        self.samples: list[Sample] = []
        self.probes = 0
        self.acknowledges = True
        self.room = 1_000_000
        """How many requests it takes."""

    def matched(self) -> list[tuple[bytes, bytes]]:
        return self.peers

    def take(self) -> Sample | None:
        return self.samples.pop(0) if self.samples else None

    def write(self, data: bytes) -> None:
        self.written.append(data)

    def try_write(self, data: bytes) -> bool:
        if not self.room:
            return False
        self.room -= 1
        self.written.append(data)
        return True

    def probe(self) -> None:
        self.probes += 1

    def wait_for_acks(self, timeout_ns: int) -> bool:
        return self.acknowledges

    def close(self) -> None:
        pass


FAST, CYCLONE, OTHER = "010f", "0110", "0101"
AWAITING = bytes.fromhex(FAST) + bytes(13) + b"\4"
"""The reader of a client on Fast DDS."""


@pytest.mark.parametrize(
    ("requests", "responses", "is_ready"),
    [
        ([], [], False),
        ([(CYCLONE, b"serviceid=1;")], [(CYCLONE, b"serviceid=1;")], True),
        ([(CYCLONE, b"serviceid=1;")], [(CYCLONE, b"serviceid=2;")], False),
        ([(CYCLONE, b"serviceid=1;")], [], False),
        ([(CYCLONE, b"")], [(CYCLONE, b"")], True),
        ([(OTHER, b"")], [(OTHER, b"")], False),
        ([(CYCLONE, b"serviceid=1;"), (OTHER, b"")], [(CYCLONE, b"serviceid=1;")], False),
    ],
    ids=[
        "nobody",
        "both",
        "of two servers",
        "half",
        "without ids",
        "another vendor",
        "one of another vendor",
    ],
)
def test_client_is_ready_when_matched_in_both_directions(requests, responses, is_ready: bool) -> None:
    assert CycloneServers(FakeEnd(*requests), FakeEnd(*responses), "/kill", Vendors()).is_ready() is is_ready


def test_question_begins_the_handshake_and_does_not_wait_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cyclone_services, "HANDSHAKE_S", 60.0)
    monkeypatch.setattr(cyclone_services, "PROBE_AGAIN_S", 60.0)
    requests, responses = (FakeEnd((CYCLONE, b"serviceid=1;")) for _ in range(2))
    requests.acknowledges = False
    servers = CycloneServers(requests, responses, "/kill", Vendors())
    assert servers.is_ready()
    assert servers.is_synchronising()
    assert requests.probes == 1
    requests.acknowledges = True
    assert servers.is_ready()
    assert not servers.is_synchronising()
    requests.peers = [*requests.peers, (bytes.fromhex(CYCLONE) + bytes(13) + b"2", b"serviceid=2;")]
    requests.acknowledges = False
    assert servers.is_ready()
    assert servers.is_synchronising()
    assert requests.probes == 2
    # The second server leaves. The first has not acknowledged the second probe.
    requests.peers = requests.peers[:1]
    assert servers.is_ready()
    assert servers.is_synchronising()
    assert requests.probes == 2


def test_server_that_never_acknowledges_is_ready_after_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cyclone_services, "HANDSHAKE_S", 0.0)
    requests, responses = (FakeEnd((CYCLONE, b"serviceid=1;")) for _ in range(2))
    requests.acknowledges = False
    assert CycloneServers(requests, responses, "/kill", Vendors()).is_ready()


def test_reader_that_has_left_is_probed_when_it_returns() -> None:
    writer = FakeEnd()
    handshake = cyclone_services.Handshake(writer)
    readers = [(bytes.fromhex(CYCLONE) + bytes(14), b"")]
    for peers in (readers, readers, [], readers):
        assert handshake.is_complete(peers)
    assert writer.probes == 2


def test_each_new_reader_has_the_whole_time_to_acknowledge(monkeypatch: pytest.MonkeyPatch) -> None:
    now_s = 0.0
    monkeypatch.setattr(cyclone_services, "time", SimpleNamespace(monotonic=lambda: now_s))
    monkeypatch.setattr(cyclone_services, "HANDSHAKE_S", 10.0)
    monkeypatch.setattr(cyclone_services, "PROBE_AGAIN_S", 100.0)
    writer = FakeEnd()
    writer.acknowledges = False
    handshake = cyclone_services.Handshake(writer)
    first, second = ((bytes.fromhex(CYCLONE) + bytes([number] * 14), b"") for number in (1, 2))
    assert not handshake.is_complete([first])
    now_s = 9.0
    assert not handshake.is_complete([first, second])
    now_s = 18.0
    assert not handshake.is_complete([first, second])
    now_s = 19.0
    assert handshake.is_complete([first, second])
    assert writer.probes == 2


def test_reader_that_missed_a_probe_is_probed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    now_s = 0.0
    monkeypatch.setattr(cyclone_services, "time", SimpleNamespace(monotonic=lambda: now_s))
    monkeypatch.setattr(cyclone_services, "PROBE_AGAIN_S", 0.002)
    writer = FakeEnd()
    writer.acknowledges = False
    handshake = cyclone_services.Handshake(writer)
    readers = [(bytes.fromhex(CYCLONE) + bytes(14), b"")]
    probed: list[int] = []
    for milliseconds in range(100):
        now_s = milliseconds / 1000
        before = writer.probes
        assert not handshake.is_complete(readers)
        probed += [milliseconds] * (writer.probes - before)
    assert probed == [0, 2, 6, 14, 30, 62]  # few, because a reader of a killed process never acknowledges
    writer.acknowledges = True
    assert handshake.is_complete(readers)
    assert handshake.is_complete(readers)
    assert len(probed) == writer.probes


@pytest.mark.parametrize("count", [1, 50, 300])
def test_requests_sent_right_after_the_match_arrive(pair, count: int, wait_until) -> None:
    """On DDS, a reader drops what precedes the first heartbeat that it receives from a writer."""
    client, server = pair
    for _ in range(count):
        client.send(HEADER + b"ask!")
    arrived: list[int] = []

    def are_all_there() -> bool:
        arrived.extend(request.id.sequence_number for request in iter(server.take, None))
        return len(arrived) >= count

    wait_until(are_all_there)
    assert arrived == list(range(1, count + 1))


@pytest.mark.parametrize(
    ("vendor", "reason"),
    [(OTHER, ""), (FAST, ", because TFLOOM_FASTDDS_SERVICES is 0")],
    ids=["another", "Fast DDS, off"],
)
def test_no_request_is_sent_to_another_vendor(vendor: str, reason: str) -> None:
    writer = FakeEnd((vendor, b""))
    vendors = Vendors("TFLOOM_FASTDDS_SERVICES is 0", lambda _: "/killer")
    client = HeaderRequester(
        writer, FakeEnd(), CycloneServers(writer, FakeEnd(), "/kill", vendors), b"12345678"
    )
    assert "/kill, /killer, runs on another DDS vendor" in client.incompatibility()
    assert f"services don't{reason}): " in client.incompatibility()
    with pytest.raises(ForeignPeerError, match="start it with RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"):
        client.send(HEADER + b"ask!")
    assert writer.written == []


@pytest.mark.parametrize("knows_address", [True, False])
def test_server_on_fast_dds_is_ready_when_its_address_is_known(
    monkeypatch: pytest.MonkeyPatch, knows_address: bool
) -> None:
    monkeypatch.setattr(cyclone_services, "dds_knows_address", lambda _: knows_address)
    servers = CycloneServers(FakeEnd((FAST, b"")), FakeEnd((FAST, b"")), "/kill", Vendors())
    assert servers.is_ready() is knows_address
    assert not servers.incompatibility()
    assert servers.most_in_flight() == 10


def client_on_fast_dds(
    writer: FakeEnd,
    key: bytes = b"client 1",
    in_flight: RequestsInFlight | None = None,
    reader: FakeEnd | None = None,
) -> HeaderRequester:
    reader = reader or FakeEnd((FAST, b""))
    servers = CycloneServers(writer, reader, "/kill", Vendors())
    return HeaderRequester(writer, reader, servers, key, in_flight or RequestsInFlight())


def test_requests_beyond_what_servers_keep_are_held_until_responses_are_taken() -> None:
    writer, reader, in_flight = FakeEnd((FAST, b"")), FakeEnd((FAST, b"")), RequestsInFlight()
    first, second = (client_on_fast_dds(writer, key, in_flight, reader) for key in (b"client 1", b"client 2"))
    for _ in range(8):
        first.send(HEADER + b"ask!")
        second.send(HEADER + b"ask!")
    assert len(writer.written) == 10
    reader.samples = [
        Sample(HEADER + struct.pack("<8sq", b"client 1", number) + b"say!", 1, 1, b"") for number in (1, 2, 3)
    ]
    for how_many in (11, 12):
        assert first.take() is not None
        assert len(writer.written) == how_many
    second.close()  # its requests no longer count, and those that were held are dropped
    assert first.take() is not None
    assert len(writer.written) == 14


def test_requests_that_are_given_up_are_never_sent() -> None:
    writer = FakeEnd((FAST, b""))
    client = client_on_fast_dds(writer)
    numbers = [client.send(HEADER + bytes([number] * 4)) for number in range(20)]
    assert len(writer.written) == 10
    client.give_up(numbers[:1])  # the server still keeps it
    client.give_up(numbers[10:11])  # it was not sent
    assert len(writer.written) == 10
    # The server has left, and another one has come before this was noticed.
    client.give_up(numbers, is_lost=True)
    assert len(writer.written) == 10
    for _ in range(11):
        client.send(HEADER + b"new!")
    assert [data[-4:] for data in writer.written[10:]] == [b"new!"] * 10


def test_room_opens_when_the_last_server_with_a_limit_leaves() -> None:
    writer = FakeEnd((FAST, b""))
    client = client_on_fast_dds(writer)
    numbers = [client.send(HEADER + b"ask!") for _ in range(11)]
    peers, writer.peers = writer.peers, []
    client.give_up(numbers[:1], is_lost=True)
    writer.peers = peers
    before = len(writer.written)
    for _ in range(10):
        client.send(HEADER + b"ask!")
    assert len(writer.written) == before + 10


def numbers_of(writer: FakeEnd) -> list[int]:
    return [struct.unpack_from("<q", data, 12)[0] for data in writer.written]


def test_requests_that_are_held_go_before_later_ones() -> None:
    writer = FakeEnd((FAST, b""))
    client = client_on_fast_dds(writer)
    for _ in range(12):
        client.send(HEADER + b"ask!")
    assert numbers_of(writer) == list(range(1, 11))
    writer.peers = []  # the server has left, and the limit with it
    client.send(HEADER + b"ask!")
    assert numbers_of(writer) == list(range(1, 14))


def test_client_that_closes_makes_room_for_others() -> None:
    writer, in_flight = FakeEnd((FAST, b"")), RequestsInFlight()
    first, second = (client_on_fast_dds(writer, key, in_flight) for key in (b"client 1", b"client 2"))
    for _ in range(12):
        first.send(HEADER + b"ask!")
    second.send(HEADER + b"mine")
    assert len(writer.written) == 10
    first.close()
    assert [data[-4:] for data in writer.written[10:]] == [b"mine"]


def test_requests_that_are_not_answered_make_room_after_a_time(
    monkeypatch: pytest.MonkeyPatch, wait_until
) -> None:
    writer = FakeEnd((FAST, b""))
    client = client_on_fast_dds(writer)
    with monkeypatch.context() as patched:
        patched.setattr(services, "UNANSWERED_S", 0.05)
        for _ in range(11):
            client.send(HEADER + b"ask!")
        wait_until(lambda: len(writer.written) == 11)  # although nothing else is sent or taken
    for _ in range(12):
        client.send(HEADER + b"ask!")
    assert len(writer.written) < 22
    monkeypatch.setattr(services, "UNANSWERED_S", 0.0)
    client.send(HEADER + b"ask!")
    assert numbers_of(writer) == list(range(1, 25))


def test_one_timer_waits_for_room_and_ends_with_the_client(wait_until) -> None:
    before = set(threading.enumerate())
    client = client_on_fast_dds(FakeEnd((FAST, b"")))

    def timers() -> int:
        new = set(threading.enumerate()) - before
        return sum(isinstance(thread, threading.Timer) for thread in new)

    for _ in range(30):
        client.send(HEADER + b"ask!")
    wait_until(lambda: timers() == 1)
    client.close()
    wait_until(lambda: timers() == 0)


def server_with_a_request(
    monkeypatch: pytest.MonkeyPatch, reader: FakeEnd, writer: FakeEnd, vendor: str = FAST
) -> tuple[HeaderResponder, RequestId]:
    """Return a server that has taken a request of a client, by default on Fast DDS, whose reader isn't matched yet."""
    client = bytes.fromhex(vendor) + bytes(14)
    monkeypatch.setattr(cyclone_services, "dds_inline_client", lambda _: AWAITING)
    reader.peers = [(client, b"")]
    reader.samples = [Sample(HEADER + struct.pack("<8sq", b"client 1", 1) + b"ask!", 1, 1, client)]
    server = HeaderResponder(reader, writer, CycloneClients(reader, writer, "/kill", Vendors()))
    request = server.take()
    assert request is not None
    return server, request.id


def test_response_to_a_client_that_is_matched_late_is_sent_then(
    monkeypatch: pytest.MonkeyPatch, wait_until
) -> None:
    monkeypatch.setattr(services, "CLIENT_WAIT_S", 0.01)
    reader, writer = FakeEnd(), FakeEnd()
    server, request = server_with_a_request(monkeypatch, reader, writer)
    server.send(request, HEADER + b"say!")
    assert writer.written == []
    writer.peers = [(AWAITING, b"")]
    wait_until(lambda: len(writer.written) == 1)


def test_client_on_fast_dds_that_names_its_writer_is_matched(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(services, "CLIENT_WAIT_S", 3600.0)
    reader, writer = FakeEnd(), FakeEnd()
    server, request = server_with_a_request(monkeypatch, reader, writer)
    monkeypatch.setattr(cyclone_services, "dds_inline_client", lambda _: reader.peers[0][0])
    on_a_thread = threading.Thread(target=server.send, args=(request, HEADER + b"say!"), daemon=True)
    on_a_thread.start()
    on_a_thread.join(30)
    assert len(writer.written) == 1
    server.close()


def test_nothing_is_sent_to_a_client_that_has_left(monkeypatch: pytest.MonkeyPatch) -> None:
    for vendor in (FAST, CYCLONE):
        reader, writer = FakeEnd(), FakeEnd((vendor, b""))
        server, request = server_with_a_request(monkeypatch, reader, writer, vendor)
        reader.peers = []
        server.send(request, HEADER + b"say!")
        assert writer.written == []


def test_response_follows_a_probe_of_its_clients_reader(monkeypatch: pytest.MonkeyPatch) -> None:
    reader, writer = FakeEnd(), FakeEnd()
    server, request = server_with_a_request(monkeypatch, reader, writer)
    writer.peers = [(AWAITING, b"")]
    probes_before: list[int] = []
    monkeypatch.setattr(writer, "write", lambda _: probes_before.append(writer.probes))
    server.send(request, HEADER + b"say!")
    assert probes_before == [1]


def test_server_that_closes_ends_the_wait_for_a_late_client(
    monkeypatch: pytest.MonkeyPatch, wait_until
) -> None:
    monkeypatch.setattr(services, "CLIENT_WAIT_S", 0.01)
    monkeypatch.setattr(services, "LATE_CLIENT_WAIT_S", 3600.0)
    raised: list[object] = []
    monkeypatch.setattr(threading, "excepthook", raised.append)
    reader, writer = FakeEnd(), FakeEnd()
    server, request = server_with_a_request(monkeypatch, reader, writer)
    before = set(threading.enumerate())
    server.send(request, HEADER + b"say!")
    (late,) = set(threading.enumerate()) - before

    def refuse(_: bytes) -> None:
        raise ClosedError("closed")

    monkeypatch.setattr(writer, "write", refuse)
    server.close()
    wait_until(lambda: not late.is_alive())
    assert raised == []


def test_clients_that_stay_are_not_counted_at_each_request() -> None:
    reader, writer = FakeEnd(), FakeEnd()
    clients = CycloneClients(reader, writer, "/kill", Vendors())
    counted: list[int] = []
    server = HeaderResponder(reader, writer, clients)
    connected = clients.connected

    def count() -> Any:
        counted.append(1)
        return connected()

    clients.connected = count  # type: ignore[method-assign]
    for number in range(1000):
        gid = bytes.fromhex(CYCLONE) + number.to_bytes(14, "big")
        reader.peers.append((gid, b""))
        reader.samples.append(Sample(HEADER + struct.pack("<Qq", number, 1) + b"ask!", 1, 1, gid))
        assert server.take() is not None
    assert len(server._gids) == 1000
    assert len(counted) < 10


def test_server_forgets_clients_that_have_left() -> None:
    reader, writer = FakeEnd(), FakeEnd()
    server = HeaderResponder(reader, writer, CycloneClients(reader, writer, "/kill", Vendors()))
    for number in range(1000):
        gid = bytes.fromhex(CYCLONE) + number.to_bytes(14, "big")
        reader.peers = [(gid, b"")]  # the one before has left
        reader.samples.append(Sample(HEADER + struct.pack("<Qq", number, 1) + b"ask!", 1, 1, gid))
        assert server.take() is not None
    assert len(server._gids) <= 64


def test_server_remembers_few_keys_of_a_client_that_stays() -> None:
    fickle, steady = (bytes.fromhex(CYCLONE) + bytes(13) + number for number in (b"\1", b"\2"))
    reader = FakeEnd()
    reader.peers = [(fickle, b""), (steady, b"")]
    server = HeaderResponder(reader, FakeEnd(), CycloneClients(reader, FakeEnd(), "/kill", Vendors()))
    for number in range(10_000):
        gid = fickle if number else steady
        reader.samples.append(Sample(HEADER + struct.pack("<Qq", number, 1) + b"ask!", 1, 1, gid))
        assert server.take() is not None
        assert len(server._gids) <= 64
    assert server._gids[bytes(8)] == steady
    assert server._gids[struct.pack("<Q", 9_999)] == fickle


def test_requests_of_another_vendor_are_dropped() -> None:
    reader = FakeEnd((OTHER, b""), (CYCLONE, b"clientid=1;"))
    ask = HEADER + struct.pack("<Qq", 1, 1) + b"ask!"
    gids = [bytes.fromhex(vendor) + bytes(14) for vendor in (OTHER, "0000", CYCLONE)]
    reader.samples = [Sample(ask, 1, 1, gid) for gid in gids]
    server = HeaderResponder(reader, FakeEnd(), CycloneClients(reader, FakeEnd(), "/kill", Vendors()))
    request = server.take()
    assert request is not None
    assert reader.samples == []
    assert "a client of /kill runs on another DDS vendor" in server.incompatibility()


def test_ids_are_written_as_rmw_cyclonedds_writes_them() -> None:
    gid = bytes.fromhex("0110371387877a8a9d403a13000001c1")
    assert end_id(gid, 8) == " 1.10.37.13.87.87.7a.8a.9d.40.3a.13.0.0.0.8"


def client_on_cyclone(
    writer: FakeEnd, in_flight: RequestsInFlight | None = None, key: bytes = b"client 1"
) -> HeaderRequester:
    servers = CycloneServers(writer, FakeEnd(), "/kill", Vendors())
    return HeaderRequester(writer, FakeEnd(), servers, key, in_flight or RequestsInFlight())


def test_requests_that_a_writer_has_no_room_for_are_held_and_sent_in_order(wait_until) -> None:
    writer = FakeEnd((CYCLONE, b""))
    writer.room = 3
    client = client_on_cyclone(writer)
    for _ in range(1000):
        client.send(HEADER + b"ask!")
    assert numbers_of(writer) == [1, 2, 3]
    writer.room = 4
    wait_until(lambda: len(writer.written) == 7)  # although nothing else is sent or taken
    writer.room = 10_000
    wait_until(lambda: len(writer.written) == 1000)
    client.send(HEADER + b"ask!")
    assert numbers_of(writer) == list(range(1, 1002))


class BrokenEnd(FakeEnd):
    """A writer that fails to write where it has room."""

    error: WireError = ClosedError("the writer is closed")

    def try_write(self, data: bytes) -> bool:
        if self.room:
            raise self.error
        return False


@pytest.mark.parametrize("error", [ClosedError("it is closed"), WireError("cannot write: bad parameter")])
def test_request_that_fails_while_it_is_held_does_not_hold_up_those_of_other_clients(
    error: WireError, wait_until, capsys: pytest.CaptureFixture[str]
) -> None:
    in_flight = RequestsInFlight()
    broken, writer = BrokenEnd((CYCLONE, b"")), FakeEnd((CYCLONE, b""))
    broken.error, broken.room, writer.room = error, 0, 0
    first, second = client_on_cyclone(broken, in_flight), client_on_cyclone(writer, in_flight, b"client 2")
    first.send(HEADER + b"ask!")
    second.send(HEADER + b"ask!")
    broken.room = writer.room = 100
    wait_until(lambda: numbers_of(writer) == [1])
    second.send(HEADER + b"ask!")
    assert numbers_of(writer) == [1, 2]
    assert ("was not sent: cannot write" in capsys.readouterr().err) == (not isinstance(error, ClosedError))
    with pytest.raises(WireError, match=str(error)):
        first.send(HEADER + b"ask!")
    assert in_flight._held_size == 0
    third, full = client_on_cyclone(broken, in_flight, b"client 3"), FakeEnd((CYCLONE, b""))
    full.room = broken.room = 0
    third.send(HEADER + b"ask!")
    client_on_cyclone(full, in_flight, b"client 4").send(HEADER + b"ask!")
    full.room = broken.room = 100
    in_flight._room_timer.cancel()  # as if it had not been set yet
    in_flight._room_timer = None
    with pytest.raises(WireError, match=str(error)):
        in_flight._send_held((third.client_gid, 1))
    assert numbers_of(full) == [1]  # what waits behind the one that failed


def test_requests_that_wait_for_room_leave_with_their_client(wait_until) -> None:
    before = set(threading.enumerate())
    writer, in_flight = FakeEnd((CYCLONE, b"")), RequestsInFlight()
    writer.room = 0
    client = client_on_cyclone(writer, in_flight)
    numbers = [client.send(HEADER + b"ask!") for _ in range(10)]
    client.give_up(numbers[:5], is_lost=False)
    writer.room = 2
    wait_until(lambda: numbers_of(writer) == [6, 7])
    client.close()
    writer.room = 100
    wait_until(lambda: set(threading.enumerate()) <= before)
    assert numbers_of(writer) == [6, 7]
    assert in_flight._held_size == 0


@pytest.mark.parametrize(("most", "size"), [(20, 1 << 20), (100_000, 20 * (len(HEADER) + 4))])
def test_held_requests_are_bounded(most: int, size: int, monkeypatch: pytest.MonkeyPatch, wait_until) -> None:
    monkeypatch.setattr(services, "MAX_HELD", most)
    monkeypatch.setattr(services, "MAX_HELD_SIZE", size)
    writer = FakeEnd((CYCLONE, b""))
    writer.room = 0
    client = client_on_cyclone(writer)
    for _ in range(20):
        client.send(HEADER + b"ask!")
    with pytest.raises(
        CongestedError, match=f"20 earlier ones, of {20 * (len(HEADER) + 4)} bytes, wait for servers"
    ):
        client.send(HEADER + b"ask!")
    writer.room = 1000
    wait_until(lambda: numbers_of(writer) == list(range(1, 21)))
    client.send(HEADER + b"ask!")  # there is room again
    wait_until(lambda: numbers_of(writer) == [*range(1, 21), 22])
    client.close()


def test_request_larger_than_all_that_may_be_held_is_held(
    monkeypatch: pytest.MonkeyPatch, wait_until
) -> None:
    monkeypatch.setattr(services, "MAX_HELD_SIZE", 10)
    writer = FakeEnd((CYCLONE, b""))
    writer.room = 0
    client = client_on_cyclone(writer)
    client.send(HEADER + b"more than ten bytes")
    writer.room = 1
    wait_until(lambda: numbers_of(writer) == [1])
    client.close()
