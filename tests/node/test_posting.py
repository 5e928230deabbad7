"""Which queue an endpoint posts to while threads wait for its data."""

from __future__ import annotations

from tfloom._native import ReadyQueue
from tfloom.node.endpoints.posting import Posting


def test_posts_go_to_the_first_thread_that_waits_and_then_to_the_executor() -> None:
    calls: list[tuple[ReadyQueue | None, int]] = []
    posting = Posting(lambda queue, token: calls.append((queue, token)))
    before, after, first, second, third = (ReadyQueue() for _ in range(5))
    posting.attach(before, 1)
    posting.divert(first, 2)
    posting.divert(second, 3)
    posting.divert(third, 4)
    posting.attach(after, 5)  # the node has changed its executor meanwhile
    assert calls == [(before, 1), (first, 2)]
    posting.restore(second)
    assert len(calls) == 2
    posting.restore(first)
    posting.restore(third)
    assert calls[2:] == [(third, 4), (after, 5)]
    assert [queue.wait(0) for queue in (before, first, second, third, after)] == [[]] * 5
    posting.post()
    assert after.wait(0) == [5]
    posting.attach(None, 0)
    posting.post()
    assert after.wait(0) == []
    assert calls[4:] == [(None, 0)]
