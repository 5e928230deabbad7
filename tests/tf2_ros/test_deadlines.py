"""Delayed calls: in order, once, and not at all after cancellation."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

import pytest

from tfloom.tf2_ros import deadlines
from tfloom.tf2_ros.deadlines import call_after


def test_calls_are_made_in_the_order_of_their_times(wait_until: Callable[..., None]) -> None:
    called: list[str] = []
    started = time.monotonic()
    call_after(0.06, lambda: called.append("late"))
    call_after(0.03, lambda: called.append("early"))
    call_after(-1.0, lambda: called.append("at once"))
    wait_until(lambda: len(called) == 3)
    assert called == ["at once", "early", "late"]
    assert time.monotonic() - started >= 0.06


def test_cancelled_call_is_not_made(wait_until: Callable[..., None]) -> None:
    called: list[str] = []
    off = call_after(0.02, lambda: called.append("off"))
    off.cancel()
    call_after(0.04, lambda: called.append("on"))
    wait_until(lambda: called)
    assert called == ["on"]
    off.cancel()  # again does nothing


def test_call_can_cancel_itself_and_add_another() -> None:
    ended = threading.Event()

    def first() -> None:
        mine.cancel()
        call_after(0.0, ended.set)

    mine = call_after(0.01, first)
    assert ended.wait(30)


def test_delay_longer_than_the_longest_wait(
    wait_until: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    broken: list[object] = []
    monkeypatch.setattr(threading, "excepthook", broken.append)
    with deadlines._changed:  # no earlier call
        deadlines._waiting.clear()
        deadlines._functions.clear()
    called: list[str] = []
    endless = call_after(10 * threading.TIMEOUT_MAX, lambda: called.append("endless"))
    for _ in range(2):  # at the first, the thread may be awake
        call_after(0.01, lambda: called.append("short"))
        wait_until(lambda: "short" in called)
        assert called == ["short"]
        called.clear()
    endless.cancel()
    assert broken == []


def test_cancelled_calls_are_removed() -> None:
    for _ in range(5):
        for deadline in [call_after(3600.0, lambda: None) for _ in range(deadlines.MAX_CANCELLED)]:
            deadline.cancel()
    assert len(deadlines._waiting) <= deadlines.MAX_CANCELLED + 2 * len(deadlines._functions)


@pytest.mark.parametrize("error", [RuntimeError("of a user"), SystemExit(3)], ids=["error", "exit"])
def test_call_that_raises_is_reported_and_the_others_are_made(
    error: BaseException, monkeypatch: pytest.MonkeyPatch
) -> None:
    reported: list[threading.ExceptHookArgs] = []
    monkeypatch.setattr(threading, "excepthook", reported.append)
    ended = threading.Event()

    def fail() -> None:
        raise error

    call_after(0.0, fail)
    call_after(0.01, ended.set)  # queued before the first has raised, or after
    assert ended.wait(30)
    assert [args.exc_value for args in reported] == [error]
