"""Waits for a server: their wake-ups and their ends."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Iterator

import pytest

from tfloom._native import ReadyQueue
from tfloom.rmw.base import NodeName, Participant, Service
from tfloom.rmw.local import wire as local
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared.waiting import wait_for_token, wait_until_ready

KILL = Service("/kill", "turtlesim/srv/Kill")
NODE = NodeName("/", "node")


@pytest.fixture
def participant(domain_id: int) -> Iterator[Participant]:
    participant = local.open_participant(domain_id)
    participant.add_node(NODE)
    yield participant
    participant.close()


def test_arriving_server_ends_the_wait(participant: Participant) -> None:
    client = participant.create_requester(NODE, KILL, QoS())
    looks: list[bool] = []

    def is_ready() -> bool:
        looks.append(client.is_ready())
        if len(looks) == 1:
            threading.Thread(target=participant.create_responder, args=(NODE, KILL, QoS())).start()
        return looks[-1]

    # The period of checks is an hour, so that only the match can wake the wait.
    assert wait_until_ready(client, is_ready, time.monotonic() + 60, look_again_s=3600)
    assert looks[0] is False
    assert looks[-1] is True


def test_timeout_ends_the_wait(participant: Participant) -> None:
    client = participant.create_requester(NODE, KILL, QoS())
    looks: list[bool] = []
    is_ready = lambda: bool(looks.append(False))  # noqa: E731
    assert not wait_until_ready(client, is_ready, time.monotonic())
    assert looks == [False]


def test_token_in_the_queue_of_the_caller_ends_the_wait(participant: Participant) -> None:
    client = participant.create_requester(NODE, KILL, QoS())
    queue, closed = ReadyQueue(), threading.Event()

    def is_ready() -> bool:
        closed.set()
        queue.post(7)
        return False

    is_open = lambda: not closed.is_set()  # noqa: E731
    assert not wait_until_ready(client, is_ready, queue=queue, is_open=is_open, look_again_s=3600)


def test_queue_of_the_caller_gets_no_token_after_the_wait(participant: Participant) -> None:
    client = participant.create_requester(NODE, KILL, QoS())
    queue = ReadyQueue()
    assert wait_until_ready(client, lambda: True, queue=queue)
    queue.wait(0)
    participant.create_responder(NODE, KILL, QoS())
    assert client.is_ready()
    assert queue.wait(0) == []


def test_exception_of_is_ready_ends_the_wait(participant: Participant) -> None:
    client = participant.create_requester(NODE, KILL, QoS())

    def is_ready() -> bool:
        raise LookupError("no such thing")

    with pytest.raises(LookupError, match="no such thing"):
        wait_until_ready(client, is_ready)


def test_token_ends_a_wait_without_limit() -> None:
    queue = ReadyQueue()
    queue.post(1)
    wait_for_token(queue, math.inf)
    queue.post(2)
    wait_for_token(queue, time.monotonic() - 1)
    assert queue.wait(0) == [2]  # the time had passed: no wait
