"""Which queue an endpoint posts to while threads wait for its data."""

from __future__ import annotations

from tfloom._native import ReadyQueue
from tfloom.node.endpoints.queue_switch import QueueSwitch


def test_posts_go_to_the_first_thread_that_waits_and_then_to_the_executor() -> None:
    calls: list[tuple[ReadyQueue | None, int]] = []
    switch = QueueSwitch(lambda queue, token: calls.append((queue, token)))
    before, after, first, second, third = (ReadyQueue() for _ in range(5))
    switch.attach(before, 1)
    switch.divert(first, 2)
    switch.divert(second, 3)
    switch.divert(third, 4)
    switch.attach(after, 5)  # the node has changed its executor meanwhile
    assert calls == [(before, 1), (first, 2)]
    switch.restore(second)
    assert len(calls) == 2
    switch.restore(first)
    switch.restore(third)
    assert calls[2:] == [(third, 4), (after, 5)]
    assert [queue.wait(0) for queue in (before, first, second, third, after)] == [[]] * 5
    switch.post()
    assert after.wait(0) == [5]
    switch.attach(None, 0)
    switch.post()
    assert after.wait(0) == []
    assert calls[4:] == [(None, 0)]
