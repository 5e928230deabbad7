"""Content filters of our subscriptions beside publishers of the real rclpy: those send only what is accepted."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom.interfaces.std_msgs.msg import Int64, String
from tfloom.node.context.context import Context
from tfloom.node.endpoints.content_filter import ContentFilterOptions
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node

from .conftest import THEIRS, End, StartEnd

pytestmark = pytest.mark.ros


class Filtered:
    """A subscription of ours, what its callback got, and how many samples have arrived for it."""

    def __init__(
        self, node: Node, executor: SingleThreadedExecutor, kind: Any, topic: str, *filter_: Any
    ) -> None:
        self.got: list[Any] = []
        self.arrived = 0
        self._executor = executor
        self.subscription = node.create_subscription(
            kind,
            topic,
            lambda message: self.got.append(message.data),
            100,
            content_filter_options=ContentFilterOptions(*filter_),
        )
        accepts = self.subscription._accepts

        def count(sample: Any) -> bool:
            self.arrived += 1
            return accepts(sample)

        self.subscription._accepts = count
        self.subscription.filter_samples(count)

    def after(self, peer: End, *values: Any) -> tuple[list[Any], int]:
        """Return what the callback gets of values that the peer publishes, and how many samples arrive."""
        self.got.clear()
        self.arrived = 0
        peer("publish", "end", *values)
        peer("acknowledged", "end", 10.0)
        end = time.monotonic() + 0.3  # nothing tells that no more will come
        while time.monotonic() < end:
            self._executor.spin_once(0.02)
        return self.got.copy(), self.arrived

    def until_arriving(self, peer: End, count: int, *values: Any) -> tuple[list[Any], int]:
        """As `after`, repeated until so many arrive: the peer learns of a filter a moment later."""
        end = time.monotonic() + 20.0
        while (found := self.after(peer, *values))[1] != count:
            assert time.monotonic() < end, found
        return found


@pytest.fixture
def subscribe(domain_id: int) -> Iterator[Callable[..., Filtered]]:
    context = Context()
    context.init(args=[], domain_id=domain_id)
    node = Node("filtering", context=context)
    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        yield lambda *arguments: Filtered(node, executor, *arguments)
    node.destroy_node()
    context.try_shutdown()


def publisher(start_end: StartEnd, kind: str, topic: str) -> End:
    end = start_end(THEIRS, "talker")
    end("publisher", "end", kind, topic, {"reliability": "RELIABLE", "durability": "VOLATILE", "depth": 100})
    return end


def test_writers_send_only_what_is_accepted(subscribe: Callable[..., Filtered], start_end: StartEnd) -> None:
    ten = list(range(10))
    talker = publisher(start_end, "number", "/numbers")
    listener = subscribe(Int64, "/numbers", "data > %0", ["5"])
    assert listener.until_arriving(talker, 4, *ten) == ([6, 7, 8, 9], 4)
    listener.subscription.set_content_filter("data < %0 OR data = %1", ["2", "7"])
    assert listener.until_arriving(talker, 3, *ten) == ([0, 1, 7], 3)
    listener.subscription.set_content_filter("", [])
    assert listener.until_arriving(talker, 10, *ten) == (ten, 10)
    listener.subscription.set_content_filter("data BETWEEN 3 AND 4", [])
    assert listener.until_arriving(talker, 2, *ten) == ([3, 4], 2)


def test_patterns_are_not_left_to_writers(subscribe: Callable[..., Filtered], start_end: StartEnd) -> None:
    """They mean something else there: a filter of theirs would drop what ours accepts."""
    words = ["a+b", "aab", "c"]
    talker = publisher(start_end, "text", "/words")
    listener = subscribe(String, "/words", "data = 'c'", [])
    assert listener.until_arriving(talker, 1, *words) == (["c"], 1)
    listener.subscription.set_content_filter("data LIKE 'a+%'", [])
    assert listener.until_arriving(talker, 3, *words) == (["a+b"], 3)
