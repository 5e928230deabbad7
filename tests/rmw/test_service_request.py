"""A request of a service without a node: its response, and the servers that come, leave, or respond with nonsense."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable
from typing import Any

import pytest
from tests.rmw.conftest import NODES, Wires

from tfloom._native import ReadyQueue
from tfloom.interfaces.std_srvs.srv import Trigger
from tfloom.rmw.base import RequestId, Response
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared.service_request import ServiceRequest, ServiceRequestError
from tfloom.rmw.typed_names import service_of
from tfloom.rosidl import cdr

CLIENT, SERVER = NODES
REQUEST = cdr.encode(Trigger.Request())
TWO_MEGABYTES = 2_000_000


class FakeWire:
    """A participant with one client, of which the test decides what its servers are."""

    def __init__(self) -> None:
        self.ready = True
        self.receiving = {"a"}
        self.connected = {"a"}
        self.responses: list[Response] = []
        self.given_up: list[tuple[list[int], bool]] = []
        self.reason = ""
        self.sent = 0
        self.is_closed = False

    def create_requester(self, *_: object) -> FakeWire:
        return self

    def notify(self, queue: ReadyQueue, token: int) -> None:
        self.queue, self.token = queue, token

    watch_servers = notify

    def is_ready(self) -> bool:
        return self.ready

    def incompatibility(self) -> str:
        return self.reason

    def receiving_servers(self) -> frozenset[str]:
        return frozenset(self.receiving)

    def connected_servers(self) -> frozenset[str]:
        return frozenset(self.connected)

    def send(self, data: bytes) -> int:
        assert data == REQUEST
        self.sent += 1
        return self.sent

    def give_up(self, numbers: Iterable[int], *, is_lost: bool = False) -> None:
        self.given_up.append((list(numbers), is_lost))

    def take(self) -> Response | None:
        return self.responses.pop(0) if self.responses else None

    def respond(self, number: int, text: str) -> None:
        data = cdr.encode(Trigger.Response(message=text))
        self.responses.append(Response(data, RequestId(bytes(16), number), 0, 0))

    def leave(self) -> None:
        self.ready = False
        self.receiving.clear()

    def close(self) -> None:
        self.is_closed = True


@pytest.fixture
def wire() -> Any:
    return FakeWire()


@pytest.fixture
def request_(wire: Any) -> ServiceRequest:
    return ServiceRequest(wire, CLIENT, "/stop", Trigger, ReadyQueue())


def test_response_of_a_server_that_has_left_in_one_direction_is_awaited(
    wire: Any, request_: ServiceRequest
) -> None:
    request_.ask(REQUEST)
    assert request_.take() is None
    wire.leave()  # but `connected` still has it
    assert request_.take() is None
    wire.respond(1, "stopped")
    assert request_.take().message == "stopped"
    assert not wire.given_up


def test_response_that_arrives_with_the_news_of_its_servers_end_is_taken(
    wire: Any, request_: ServiceRequest
) -> None:
    request_.ask(REQUEST)
    request_.take()
    wire.leave()
    wire.connected.clear()
    wire.respond(1, "stopped")
    assert request_.take().message == "stopped"


def test_server_that_leaves_without_a_response_is_told_and_another_one_is_asked_anew(
    wire: Any, request_: ServiceRequest
) -> None:
    request_.ask(REQUEST)
    request_.take()
    wire.leave()
    wire.connected = {"b"}  # another one, which has not received the request
    with pytest.raises(ServiceRequestError, match="the server of /stop has left without a response"):
        request_.take()
    assert wire.given_up == [([1], True)]
    assert not request_.is_sent
    wire.ready, wire.receiving = True, {"b"}
    request_.ask(REQUEST)
    assert wire.given_up == [([1], True)]
    assert request_.take() is None
    assert request_.is_sent
    wire.respond(2, "stopped")
    assert request_.take().message == "stopped"


def test_nothing_is_sent_before_a_server_receives_it(wire: Any, request_: ServiceRequest) -> None:
    request_.ask(REQUEST, server_s=60.0)
    wire.leave()
    assert request_.take() is None
    wire.ready = True  # of another thread's look: it has left meanwhile
    assert request_.take() is None
    assert not wire.sent
    wire.receiving = {"a"}
    request_.take()
    assert wire.sent == 1
    request_.take()
    assert wire.sent == 1


def test_response_to_an_earlier_request_is_dropped(wire: Any, request_: ServiceRequest) -> None:
    request_.ask(REQUEST)
    request_.take()
    request_.ask(REQUEST)
    assert wire.given_up == [([1], False)]
    assert not request_.is_sent
    request_.take()
    wire.respond(1, "first")
    assert request_.take() is None
    wire.respond(1, "first")
    wire.respond(2, "second")
    assert request_.take().message == "second"


def test_waits_end_at_their_times_with_a_sentence(wire: Any, request_: ServiceRequest) -> None:
    wire.ready = False
    request_.ask(REQUEST, server_s=0.05)
    with pytest.raises(ServiceRequestError, match=r"there is no server of /stop: waited 0\.05 s for it"):
        request_.wait()
    wire.ready = True
    request_.ask(REQUEST, response_s=0.05, server_s=0.0)
    with pytest.raises(ServiceRequestError, match=r"no response from /stop within 0\.05 s"):
        request_.wait()
    assert wire.given_up == [([1], False)]
    request_.ask(REQUEST, response_s=math.inf)
    calls: list[float] = []

    def meanwhile() -> None:
        calls.append(time.monotonic())
        if len(calls) == 3:
            wire.respond(2, "stopped")
            wire.queue.post(wire.token)

    assert request_.wait(meanwhile).message == "stopped"
    assert len(calls) == 3


def test_incompatible_server_and_a_damaged_response_are_told(wire: Any, request_: ServiceRequest) -> None:
    wire.ready, wire.reason = False, "it speaks another form"
    request_.ask(REQUEST)
    with pytest.raises(ServiceRequestError, match="it speaks another form"):
        request_.take()
    wire.ready = True
    request_.take()
    wire.responses.append(Response(b"\0\1\0\0\1", RequestId(bytes(16), 1), 0, 0))
    with pytest.raises(ServiceRequestError, match="the response of /stop can't be decoded"):
        request_.take()
    request_.close()
    assert wire.is_closed


def test_response_of_a_server_that_leaves_at_once_arrives(wires: Wires, wait_until: Any) -> None:
    for number in range(5):
        name = f"/stop_{number}"
        server = wires[1].create_responder(SERVER, service_of(Trigger, name), QoS())
        request = ServiceRequest(wires[0], CLIENT, name, Trigger, ReadyQueue())
        request.ask(REQUEST, server_s=30.0, response_s=30.0)
        asked: list[Any] = []
        wait_until(
            lambda ask=request, taken=asked, end=server: ask.take() or taken.append(end.take()) or taken[-1]
        )
        server.send(asked[-1].id, cdr.encode(Trigger.Response(message=TWO_MEGABYTES * "m")))
        server.close()
        assert len(request.wait().message) == TWO_MEGABYTES
        request.close()
