"""The queue that executors wait for, and the sink that keeps samples."""

from __future__ import annotations

import os
import signal
import threading
import time

import pytest

from tfloom._native import ReadyQueue, SampleQueue

GID = bytes(range(16))


def test_tokens_are_unique_and_in_order_of_posting() -> None:
    queue = ReadyQueue()
    for token in (3, 1, 3, 2, 1):
        queue.post(token)
    assert queue.wait(0) == [3, 1, 2]
    assert queue.wait(0) == []
    queue.post(1)
    assert queue.wait(-1) == [1]


def test_wait_returns_after_its_timeout() -> None:
    start = time.monotonic()
    assert ReadyQueue().wait(20_000_000) == []
    assert 0.02 <= time.monotonic() - start < 5


def test_a_post_wakes_the_waiting_thread() -> None:
    queue = ReadyQueue()
    taken: list[int] = []
    waiter = threading.Thread(target=lambda: taken.extend(queue.wait(-1)))
    waiter.start()
    queue.post(7)
    waiter.join(10)
    assert taken == [7]


def test_no_token_is_lost_between_many_threads() -> None:
    queue = ReadyQueue()
    posters = [
        threading.Thread(target=lambda base=base: [queue.post(base + i) for i in range(1000)])
        for base in (0, 10_000, 20_000)
    ]
    for poster in posters:
        poster.start()
    taken: list[int] = []
    while len(taken) < 3000:
        tokens = queue.wait(10_000_000_000)
        assert tokens
        taken += tokens
    for base in (0, 10_000, 20_000):
        assert [token for token in taken if base <= token < base + 1000] == list(range(base, base + 1000))


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="needs a signal sent to a thread")
def test_signal_handler_runs_at_once_and_its_exception_is_raised() -> None:
    handled = threading.Event()

    class StopError(Exception):
        pass

    def handle(number: int, frame: object) -> None:
        if handled.is_set():
            raise StopError
        handled.set()
        threading.Timer(0.02, os.kill, [os.getpid(), signal.SIGUSR1]).start()

    before = signal.signal(signal.SIGUSR1, handle)
    try:
        threading.Timer(0.02, os.kill, [os.getpid(), signal.SIGUSR1]).start()
        with pytest.raises(StopError):
            ReadyQueue().wait(-1)
    finally:
        signal.signal(signal.SIGUSR1, before)
    assert handled.is_set()


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="needs a signal sent to a thread")
def test_a_signal_that_interrupts_no_system_call_ends_the_wait() -> None:
    """A signal between the check for signals and the wait is one; so is one delivered on another thread, as here."""

    class StopError(Exception):
        pass

    def handle(number: int, frame: object) -> None:
        raise StopError

    about_to_wait = threading.Event()

    def interrupt() -> None:
        about_to_wait.wait()
        time.sleep(0.05)  # so that the main thread waits
        signal.pthread_kill(threading.get_ident(), signal.SIGUSR1)

    def wait() -> None:
        about_to_wait.set()
        queue.wait(-1)

    queue = ReadyQueue()
    rescue = threading.Timer(10, queue.post, [1])
    other = threading.Thread(target=interrupt)
    before = signal.signal(signal.SIGUSR1, handle)
    read_end, write_end = os.pipe()
    os.set_blocking(write_end, False)
    former = signal.set_wakeup_fd(write_end)
    try:
        other.start()
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGUSR1})
        rescue.start()
        with pytest.raises(StopError):
            wait()
        assert signal.set_wakeup_fd(write_end) == write_end, "a program's own descriptor is restored"
        assert os.read(read_end, 10) == bytes([signal.SIGUSR1]), "it receives the signals of the wait"
    finally:
        about_to_wait.set()
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGUSR1})
        signal.set_wakeup_fd(former)
        signal.signal(signal.SIGUSR1, before)
        rescue.cancel()
        other.join()
        os.close(read_end)
        os.close(write_end)
    assert queue.wait(0) == []


def test_sample_queue_keeps_the_newest() -> None:
    queue = SampleQueue(2)
    for i in range(5):
        queue.push(bytes([0, 1, 0, 0, i]), i, 10 + i, GID)
    assert queue.pushed() == 5
    assert queue.take() == [(bytes([0, 1, 0, 0, i]), i, 10 + i, GID) for i in (3, 4)]
    assert queue.take() == []


def test_sample_queue_of_depth_0_counts() -> None:
    queue = SampleQueue(0)
    queue.push(b"data", 1, 2, GID)
    assert queue.pushed() == 1
    assert queue.take() == []


def test_a_gid_has_sixteen_bytes() -> None:
    with pytest.raises(ValueError, match="publisher_gid must have 16 bytes"):
        SampleQueue(1).push(b"data", 1, 2, GID[:15])


def push(sink: SampleQueue) -> None:
    sink.push(b"\0\1\0\0", 0, 0, GID)


def test_sink_posts_for_quiet_waits() -> None:
    queue, sink = ReadyQueue(), SampleQueue(5)
    sink.notify(queue, 4)
    push(sink)
    push(sink)
    assert queue.wait(0) == []
    queue.post(9)
    assert queue.wait(0, quiet=True) == [9, 4]
    assert (sink.take_pushed(), sink.take_pushed()) == (True, False)
    assert queue.wait(0, quiet=True) == []
    push(sink)
    assert queue.wait(-1, quiet=True) == [4]


def test_sink_wakes_only_a_quiet_wait() -> None:
    queue, sink = ReadyQueue(), SampleQueue(5)
    sink.notify(queue, 4)
    taken: list[list[int]] = []
    waiter = threading.Thread(target=lambda: taken.extend([queue.wait(-1), queue.wait(-1, quiet=True)]))
    waiter.start()
    push(sink)
    waiter.join(0.05)
    assert taken == []
    queue.post(1)
    waiter.join(10)
    assert taken == [[1], [4]]


def test_push_wakes_a_quiet_wait() -> None:
    queue, sink = ReadyQueue(), SampleQueue(5)
    sink.notify(queue, 4)
    taken: list[int] = []
    waiter = threading.Thread(target=lambda: taken.extend(queue.wait(10_000_000_000, quiet=True)))
    waiter.start()
    waiter.join(0.05)
    push(sink)
    waiter.join(5)
    assert taken == [4]


def test_pushes_before_notify_are_posted_to_the_new_queue() -> None:
    first, second, sink = ReadyQueue(), ReadyQueue(), SampleQueue(5)
    push(sink)
    sink.notify(first, 1)
    sink.notify(None, 0)
    assert first.wait(0, quiet=True) == []
    sink.notify(second, 2)
    assert second.wait(0, quiet=True) == [2]
    assert sink.take_pushed()
    sink.notify(first, 3)
    assert first.wait(0, quiet=True) == []
