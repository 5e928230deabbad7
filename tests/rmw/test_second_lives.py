"""What follows an end on each wire: the next endpoint, node and participant are whole, and the former ones silent."""

from __future__ import annotations

from importlib import import_module

import pytest
from tests.conftest import wait_until
from tests.rmw.conftest import NODES, WIRES, Wires
from tests.rmw.test_services import KILL
from tests.rmw.test_topics import TOPIC, WAIT_NS, texts

from tfloom._native import ReadyQueue
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.events import Event, Matched
from tfloom.rmw.qos import QoS
from tfloom.rmw.zenoh.wire import ZenohParticipant

HERE, THERE = NODES
LIVES = 3
TOKENS = range(10, 10 + LIVES)


def test_the_next_reader_takes_what_is_written_in_its_life(wires: Wires) -> None:
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    queue = ReadyQueue()
    for life, token in enumerate(TOKENS):
        reader = wires[1].create_reader(THERE, TOPIC, QoS())
        wait_until(lambda reader=reader: writer.matched_count() == 1 and reader.matched_count() == 1)
        reader.notify(queue, token)
        writer.write(texts(life)[0])
        assert token in queue.wait(WAIT_NS)
        taken: list[bytes] = []
        wait_until(
            lambda reader=reader, taken=taken, life=life: (
                taken.extend(s.data for s in iter(reader.take, None)) or texts(life)[0] in taken
            )
        )
        if isinstance(wires[0], ZenohParticipant) and life:
            # A router passes a message on to whoever listens when it gets there.
            taken = [text for text in taken if text != texts(99)[0]]
        assert taken == texts(life)
        reader.close()
        reader.close()
        wait_until(lambda: writer.matched_count() == 0)
        writer.write(texts(99)[0])  # which nobody hears
        assert set(queue.wait(0)) <= {token}


def test_the_next_writer_is_heard_and_the_former_one_refuses(wires: Wires) -> None:
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    for life in range(LIVES):
        writer = wires[0].create_writer(HERE, TOPIC, QoS())
        wait_until(lambda writer=writer: writer.matched_count() == 1 and reader.matched_count() == 1)
        writer.write(texts(life)[0])
        taken: list[bytes] = []
        wait_until(lambda taken=taken: taken.extend(s.data for s in iter(reader.take, None)) or taken)
        assert taken == texts(life)
        writer.close()
        writer.close()
        with pytest.raises(ClosedError):
            writer.write(texts(life)[0])
        wait_until(lambda: reader.matched_count() == 0)


def test_the_events_of_the_next_endpoint_begin_at_zero(wires: Wires) -> None:
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    for total, token in enumerate(TOKENS, 1):
        writer = wires[0].create_writer(HERE, TOPIC, QoS())
        queue = ReadyQueue()
        writer.notify_event(Event.MATCHED, queue, token)
        wait_until(lambda writer=writer: writer.matched_count() == 1 and reader.matched_count() == 1)
        assert queue.wait(WAIT_NS) == [token]
        wait_until(lambda writer=writer: writer.take_event(Event.MATCHED) == Matched(1, 1, 1, 1))
        writer.close()
        wait_until(lambda: reader.matched_count() == 0)
        seen = reader.take_event(Event.MATCHED)
        assert isinstance(seen, Matched)
        assert (seen.total_count, seen.current_count) == (total, 0)
        assert set(queue.wait(0)) <= {token}
        assert writer.take_event(Event.MATCHED) is None


def test_the_next_client_and_server_of_a_service_hear_no_former_ones(wires: Wires) -> None:
    for life in range(LIVES):
        data = texts(life)[0]
        server = wires[1].create_responder(THERE, KILL, QoS())
        former = wires[0].create_requester(HERE, KILL, QoS())
        wait_until(former.is_ready)
        former.send(texts(50)[0])
        requests = []
        wait_until(lambda server=server, requests=requests: requests.append(server.take()) or requests[-1])
        former.close()
        former.close()
        client = wires[0].create_requester(HERE, KILL, QoS())
        wait_until(client.is_ready)
        server.send(requests[-1].id, texts(51)[0])  # to nobody
        client.send(data)
        wait_until(lambda server=server, requests=requests: requests.append(server.take()) or requests[-1])
        assert requests[-1].data == data
        server.send(requests[-1].id, data)
        responses = []
        wait_until(
            lambda client=client, responses=responses: responses.append(client.take()) or responses[-1]
        )
        assert responses[-1].data == data
        assert client.take() is None
        server.close()
        server.close()
        with pytest.raises(ClosedError):
            server.send(requests[-1].id, data)
        wait_until(lambda client=client: not client.is_ready())
        client.close()


def test_the_next_node_of_a_name_is_on_the_graph_once(wires: Wires) -> None:
    def names() -> list[str]:
        return [node.full for participant in wires[0].graph.participants() for node in participant.nodes]

    def writers() -> list[str]:
        return [
            end.node.full
            for end in wires[0].graph.endpoints()
            if end.topic.name == TOPIC.name and end.node is not None
        ]

    for _ in range(LIVES):
        wait_until(lambda: names().count(THERE.full) == 1)
        writer = wires[1].create_writer(THERE, TOPIC, QoS())
        wait_until(lambda: writers() == [THERE.full])
        writer.close()
        wires[1].remove_node(THERE)
        wait_until(lambda: THERE.full not in names() and writers() == [])
        with pytest.raises(ValueError, match=r"\S"):
            wires[1].remove_node(THERE)
        wires[1].add_node(THERE)


def test_a_participant_follows_one_that_was_closed(
    wires: Wires, domain_id: int, request: pytest.FixtureRequest
) -> None:
    module = import_module(f"tfloom.rmw.{WIRES[request.node.callspec.params['wires']]}.wire")
    here = wires[0].create_reader(HERE, TOPIC, QoS())
    guest = THERE._replace(name="guest")

    def names() -> list[str]:
        return [node.name for participant in wires[0].graph.participants() for node in participant.nodes]

    for life in range(LIVES):
        participant = module.open_participant(domain_id)
        participant.add_node(guest)
        writer = participant.create_writer(guest, TOPIC, QoS())
        wait_until(lambda writer=writer: writer.matched_count() == 1 and here.matched_count() == 1)
        wait_until(lambda: names().count("guest") == 1)
        writer.write(texts(life)[0])
        taken: list[bytes] = []
        wait_until(lambda taken=taken: taken.extend(s.data for s in iter(here.take, None)) or taken)
        assert taken == texts(life)
        participant.close()
        participant.close()
        wait_until(lambda: here.matched_count() == 0 and "guest" not in names())
        with pytest.raises(ClosedError):
            participant.create_writer(guest, TOPIC, QoS())
