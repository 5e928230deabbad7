"""Queues and sinks on each wire: an endpoint holds those that it posts to and feeds, and no others."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable, Iterator

import psutil
import pytest
from tests.conftest import wait_until
from tests.rmw.conftest import NODES, Wires
from tests.rmw.test_services import KILL
from tests.rmw.test_topics import TOPIC, WAIT_NS, texts

from tfloom._native import ReadyQueue, SampleQueue
from tfloom.rmw.events import Event
from tfloom.rmw.qos import QoS

HERE, THERE = NODES
ROUNDS = 20

Notify = Callable[[ReadyQueue | None, int], None]


def notifiers(wires: Wires) -> Iterator[tuple[str, Notify]]:
    """Return each function that takes a queue, with its name."""
    reader, writer = wires[0].create_reader(HERE, TOPIC, QoS()), wires[0].create_writer(HERE, TOPIC, QoS())
    requester = wires[0].create_requester(HERE, KILL, QoS())
    responder = wires[1].create_responder(THERE, KILL, QoS())
    yield "reader", reader.notify
    yield "event of a reader", lambda queue, token: reader.notify_event(Event.MATCHED, queue, token)
    yield "event of a writer", lambda queue, token: writer.notify_event(Event.MATCHED, queue, token)
    yield "responses", requester.notify
    yield "readiness", requester.notify_ready
    yield "servers", requester.watch_servers
    yield "requests", responder.notify
    yield "graph", wires[0].graph.notify
    yield "sink", SampleQueue(1).notify


def count_descriptors() -> int:
    gc.collect()
    return psutil.Process().num_fds()


@pytest.mark.skipif(not hasattr(psutil.Process, "num_fds"), reason="counts descriptors")
def test_queues_are_freed_that_were_replaced_or_taken_back(wires: Wires) -> None:
    """Each has a descriptor, which a program that waits in a loop would run out of."""
    left = {}
    for name, notify in notifiers(wires):
        notify(ReadyQueue(), 0)
        before = count_descriptors()
        for token in range(ROUNDS):
            notify(ReadyQueue(), token)  # in place of the one before
            notify(None, 0)
        notify(ReadyQueue(), 0)
        left[name] = count_descriptors() - before
    assert {name: count for name, count in left.items() if count > 0} == {}


def test_a_queue_lives_while_tokens_are_posted_to_it(wires: Wires) -> None:
    """Also where Python has let go of it, and when another one has taken its place."""
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    wait_until(lambda: writer.matched_count() and reader.matched_count())
    former, queue = ReadyQueue(), ReadyQueue()
    reader.notify(ReadyQueue(), 1)
    reader.notify_event(Event.MATCHED, ReadyQueue(), 2)
    gc.collect()
    writer.write(texts(1)[0])
    wait_until(reader.take)
    reader.notify(former, 3)
    reader.notify(queue, 4)
    former.wait(0)
    writer.write(texts(2)[0])
    assert 4 in queue.wait(WAIT_NS)
    assert former.wait(0) == []


class KeptSink(SampleQueue):
    """A sink that can be referred to weakly."""


def test_a_sink_is_freed_when_another_one_is_fed_and_at_the_end(wires: Wires) -> None:
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    wait_until(lambda: writer.matched_count() and reader.matched_count())
    sinks: list[weakref.ref[KeptSink]] = []
    for number in range(3):
        sink = KeptSink(1)
        reader.feed(sink)
        sinks.append(weakref.ref(sink))
        writer.write(texts(number)[0])
        wait_until(lambda sink=sink, number=number: [data for data, *_ in sink.take()] == texts(number))
        del sink
    wait_until(lambda: gc.collect() is not None and [ref() is None for ref in sinks] == [True, True, False])
    reader.close()
    wait_until(lambda: gc.collect() is not None and sinks[-1]() is None, what="the release of the last sink")
