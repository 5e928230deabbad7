"""Every pair of reliability, durability and depth, with what a late joiner receives."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import pytest

from .conftest import FROM_US, End, Ends

pytestmark = pytest.mark.ros

RELIABILITIES = ("RELIABLE", "BEST_EFFORT")
DURABILITIES = ("TRANSIENT_LOCAL", "VOLATILE")
QUALITIES = list(itertools.product(RELIABILITIES, DURABILITIES))
PAIRS = list(itertools.product(QUALITIES, QUALITIES))
DEPTHS = [(1, 1), (10, 3), (3, 10)]
"""Of the writer, and of the reader."""

numbers = itertools.count()


def incompatible_policies(offered: tuple[str, str], requested: tuple[str, str]) -> set[str]:
    """Return the policies of which more is requested than offered."""
    return {
        policy
        for policy, strongest, offer, request in zip(
            ("RELIABILITY", "DURABILITY"), ("RELIABLE", "TRANSIENT_LOCAL"), offered, requested, strict=True
        )
        if request == strongest != offer
    }


def qos(quality: tuple[str, str], depth: int) -> dict[str, Any]:
    return {"reliability": quality[0], "durability": quality[1], "depth": depth}


def name(quality: tuple[str, str]) -> str:
    return "/".join(quality).lower()


def open_pair(
    ends: Ends, offered: dict[str, Any], requested: dict[str, Any], kind: str = "text"
) -> tuple[str, str]:
    """Open a writer and a reader of a new topic; return its name and the key of both."""
    key = f"end{next(numbers)}"
    topic = f"/pairs/{key}"
    ends.reader("subscription", key, kind, topic, requested)
    ends.writer("publisher", key, kind, topic, offered)
    return topic, key


@pytest.mark.row("QoS pairs")
@pytest.mark.parametrize("depths", DEPTHS, ids=[f"depths {a} and {b}" for a, b in DEPTHS])
@pytest.mark.parametrize(
    ("offered", "requested"), PAIRS, ids=[f"{name(a)} offered, {name(b)} requested" for a, b in PAIRS]
)
def test_pair_connects_or_both_sides_report_why_not(
    ends: Ends,
    offered: tuple[str, str],
    requested: tuple[str, str],
    depths: tuple[int, int],
    wait_until: Callable[..., None],
) -> None:
    wanted = incompatible_policies(offered, requested)
    _, key = open_pair(ends, qos(offered, depths[0]), qos(requested, depths[1]))
    if wanted:
        for end in ends:
            wait_until(lambda end=end: end("incompatible", key), what=f"the event of {end.vendor}")
            assert set(end("incompatible", key)) <= wanted
        ends.writer("publish", key, "unseen")
        expect_nothing_before_a_marker(ends, wait_until)
        assert [end("matches", key) for end in ends] == [0, 0]
        assert ends.reader("received", key) == []
    else:
        wait_until_matched(ends, key, wait_until)
        sent = [f"message {number}" for number in range(5)]
        for count, text in enumerate(sent, 1):
            ends.writer("publish", key, text)
            wait_until(lambda count=count: ends.reader("count", key) >= count, what=text)
        assert ends.reader("received", key) == sent
        if "RELIABLE" == offered[0] == requested[0]:
            expect_the_last(ends, key, depths, wait_until)
        assert [end("incompatible", key) for end in ends] == [[], []]
    for end in ends:
        end("close", key)


def wait_until_matched(ends: Ends, key: str, wait_until: Callable[..., None]) -> None:
    for end in ends:
        wait_until(lambda end=end: end("matches", key) == 1, what=f"a match at {end.vendor}")


def expect_nothing_before_a_marker(ends: Ends, wait_until: Callable[..., None]) -> None:
    """Pass a message on another topic, after which one that was published before would have arrived."""
    reliable = qos(("RELIABLE", "VOLATILE"), 1)
    _, key = open_pair(ends, reliable, reliable)
    wait_until_matched(ends, key, wait_until)
    ends.writer("publish", key, "marker")
    wait_until(lambda: ends.reader("count", key) == 1, what="the marker")
    for end in ends:
        end("close", key)


def expect_the_last(ends: Ends, key: str, depths: tuple[int, int], wait_until: Callable[..., None]) -> None:
    """A reader that does not take keeps as many of the last messages as its depth."""
    ends.reader("forget", key)
    ends.reader("hold")
    sent = [f"kept {number}" for number in range(12)]
    ends.writer("publish", key, *sent)
    assert ends.writer("acknowledged", key, 30.0)
    ends.reader("resume")
    wait_until(lambda: ends.reader("received", key)[-1:] == sent[-1:], what=f"{sent[-1]}")
    settle(ends.reader)
    assert ends.reader("received", key) == sent[-depths[1] :]


def settle(end: End) -> None:
    """Let an executor call what was ready before."""
    for _ in range(3):
        end("nodes")


@pytest.mark.row("late joiners")
@pytest.mark.parametrize("depths", DEPTHS, ids=[f"depths {a} and {b}" for a, b in DEPTHS])
def test_late_joiner_receives_the_last_messages(
    ends: Ends, depths: tuple[int, int], wait_until: Callable[..., None]
) -> None:
    lasting = ("RELIABLE", "TRANSIENT_LOCAL")
    key = f"late{next(numbers)}"
    sent = [f"early {number}" for number in range(12)]
    ends.writer("publisher", key, "text", f"/{key}", qos(lasting, depths[0]))
    ends.writer("publish", key, *sent)
    ends.reader("hold")
    ends.reader("subscription", key, "text", f"/{key}", qos(lasting, depths[1]))
    wait_until(lambda: ends.writer("matches", key) == 1, what="a match")
    assert ends.writer("acknowledged", key, 30.0)
    ends.reader("resume")
    kept = sent[-min(depths) :]
    wait_until(lambda: ends.reader("count", key) >= len(kept), what=f"{len(kept)} messages")
    assert ends.reader("received", key) == kept
    ends.writer("publish", key, "live")
    wait_until(lambda: ends.reader("received", key)[-1:] == ["live"], what="the live message")
    assert ends.reader("received", key) == [*kept, "live"]
    for end in ends:
        end("close", key)


@pytest.mark.row("late joiners")
@pytest.mark.parametrize("reliability", RELIABILITIES)
@pytest.mark.parametrize(
    "durability", DURABILITIES, ids=[f"{durability.lower()} offered" for durability in DURABILITIES]
)
def test_late_volatile_reader_receives_what_follows_alone(
    ends: Ends, direction: str, durability: str, reliability: str, wait_until: Callable[..., None]
) -> None:
    key = f"late{next(numbers)}"
    ends.writer("publisher", key, "text", f"/{key}", qos(("RELIABLE", durability), 10))
    ends.writer("publish", key, "early")
    ends.reader("subscription", key, "text", f"/{key}", qos((reliability, "VOLATILE"), 10))
    wait_until_matched(ends, key, wait_until)
    ends.writer("publish", key, "live")
    wait_until(lambda: "live" in ends.reader("received", key), what="the live message")
    received = ends.reader("received", key)
    if direction == FROM_US and (durability, reliability) == ("TRANSIENT_LOCAL", "RELIABLE"):
        # libddsc announces all that the writer keeps, and Fast DDS requests it, although its reader is volatile.
        received = [text for text in received if text != "early"]
    assert received == ["live"]
    for end in ends:
        end("close", key)
