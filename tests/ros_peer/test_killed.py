"""Endpoints that are closed, and processes that are killed and return: the other side goes on with what is there."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable

import pytest

from .conftest import End, Ends, StartEnd, vendors

pytestmark = pytest.mark.ros

STREAM_HZ = 50.0


def kill(end: End) -> None:
    os.kill(end.program.process.pid, signal.SIGKILL)
    end.program.wait()


@pytest.mark.row("closed, and no longer counted")
def test_closed_endpoints_are_no_longer_counted(new_ends: Ends, wait_until: Callable[..., None]) -> None:
    for closing, counting in (new_ends, new_ends[::-1]):
        new_ends.reader("subscription", "closed", "number", "/closed", {})
        new_ends.writer("publisher", "closed", "number", "/closed", {})
        wait_until(lambda: [end("matches", "closed") for end in new_ends] == [1, 1], what="a match")
        closing("close", "closed")
        wait_until(lambda each=counting: each("matches", "closed") == 0, what="no match")
        kind = "PUBLISHER" if closing is new_ends.writer else "SUBSCRIPTION"
        assert kind not in {endpoint["kind"] for endpoint in counting("endpoints", "/closed")}
        counting("close", "closed")


@pytest.mark.row("killed, and returned")
def test_writer_that_was_killed_is_heard_again(
    new_ends: Ends, direction: str, start_end: StartEnd, wait_until: Callable[..., None]
) -> None:
    writer, reader = new_ends
    reader("subscription", "stream", "number", "/stream", {})
    for turn in range(3):
        if turn:
            kill(writer)
            reader("forget", "stream")
            writer = start_end(vendors(direction)[0], "the_writer")
        writer("publisher", "stream", "number", "/stream", {})
        writer("stream", "stream", STREAM_HZ)
        wait_until(lambda: reader("count", "stream") > 10, what="messages")
        got = reader("received", "stream")
        assert got == list(range(got[0], got[0] + len(got)))


@pytest.mark.row("killed, and returned")
def test_reader_that_was_killed_hears_again_and_another_loses_nothing(
    new_ends: Ends, direction: str, start_end: StartEnd, wait_until: Callable[..., None]
) -> None:
    writer, reader = new_ends
    vendor = vendors(direction)[1]
    stayed = start_end(vendor, "another_reader")
    quality = {"depth": 1000}
    for end in (reader, stayed):
        end("subscription", "stream", "number", "/stream", quality)
    writer("publisher", "stream", "number", "/stream", quality)
    wait_until(lambda: writer("matches", "stream") == 2, what="both matches")
    wait_until(lambda: stayed("matches", "stream") == 1 == reader("matches", "stream"), what="both matches")
    writer("stream", "stream", STREAM_HZ)
    for _ in range(2):
        wait_until(lambda each=reader: each("count", "stream") > 10, what="messages")
        kill(reader)
        reader = start_end(vendor, "the_reader")
        reader("subscription", "stream", "number", "/stream", quality)
    wait_until(lambda: reader("count", "stream") > 10, what="messages")
    got = stayed("received", "stream")
    assert got == list(range(len(got)))
    got = reader("received", "stream")
    assert got == list(range(got[0], got[0] + len(got)))
