"""Explanations of lookups whose outcome is known by hand: chain, limits, sentences, and the time-line."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path

import pytest
from tests.tf2_tools.recordings import recorded, transform

from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.lookups.advice import advise, remark
from tfloom.tf2_tools.lookups.lookup import Lookup, Outcome, look_up
from tfloom.tf2_tools.lookups.report import plain_values, report_text
from tfloom.tf2_tools.watch.recorded import RecordedMessage, observe_recorded

START_S = 1_700_000_000
S = 1_000_000_000
TEXTS = Path(__file__).with_name("texts")


def message(
    parent: str, child: str, stamp_s: float, delay_s: float = 0.0, *, x: float = 0.0, static: bool = False
) -> RecordedMessage:
    """Return a message stamped `stamp_s` after the start, and received later by the delay."""
    stamp_ns = START_S * S + round(stamp_s * S)
    sent = transform(parent, child, stamp_ns, (x, 0.0, 0.0))
    return recorded(stamp_ns + round(delay_s * S), sent, topic="/tf_static" if static else "/tf")


def robot() -> list[RecordedMessage]:
    """Return 5 s of a robot: odom at 10 Hz, map at 2 Hz and 0.25 s late, a static laser, and a camera elsewhere."""
    messages = [message("base", "laser", 0.0, x=0.5, static=True), message("rig", "camera", 0.0, static=True)]
    messages += [message("odom", "base", 0.1 * step, x=0.1 * step) for step in range(51)]
    messages += [message("map", "odom", 0.5 * step, 0.25) for step in range(10)]
    return sorted(messages, key=lambda message: message[1])


def looked_up(
    target: str, source: str, at_s: float | None = None, *, messages: Iterable[RecordedMessage] | None = None
) -> Lookup:
    """Look up at a time after the start; None: the latest. Now is 5 s after the start."""
    buffer = Buffer(None)
    buffer.set_log_callback(lambda _severity, _text: None)
    seen = observe_recorded(robot() if messages is None else messages, "drive.mcap", buffer=buffer)
    asked_ns = 0 if at_s is None else START_S * S + round(at_s * S)
    return look_up(
        seen, buffer, target, source, asked_ns=asked_ns, now_ns=(START_S + 5) * S, cache_time_ns=None
    )


def test_a_chain_goes_up_and_down_and_names_what_limits_it() -> None:
    lookup = looked_up("map", "laser")
    assert lookup.outcome == Outcome.SUCCEEDS
    chain = lookup.chain
    assert chain is not None
    assert [(span.name, span.is_up, span.is_static) for span in chain.spans] == [
        ("base -> laser", True, True),
        ("odom -> base", True, False),
        ("map -> odom", True, False),
    ]
    assert chain.first_to_end is chain.spans[2]
    assert lookup.stamp_ns == (START_S + 4) * S + S // 2
    assert lookup.transform is not None
    assert lookup.transform.translation[0] == pytest.approx(4.5 + 0.5)
    down = looked_up("laser", "map").chain
    assert down is not None
    assert [span.is_up for span in down.spans] == [False, False, False]
    assert (advise(lookup), remark(lookup)) == ([], [])


def test_a_chain_over_the_top() -> None:
    messages = [*robot(), message("base", "wheel", 0.0, static=True)]
    chain = looked_up("wheel", "laser", messages=messages).chain
    assert chain is not None
    assert ([span.is_up for span in chain.spans], chain.top) == ([True, False], "base")
    same = looked_up("map", "map").chain
    assert same is not None
    assert same.spans == []


FAILURES = {
    ("map", "laser", 4.9): (
        Outcome.FUTURE,
        ["map -> odom", "is 0.400 s older", "The recording has no later one"],
    ),
    ("map", "laser", -1.0): (Outcome.PAST, ["is 1.00 s newer", "The recording has no earlier one"]),
    ("map", "camera", None): (
        Outcome.NOT_CONNECTED,
        [
            "'camera' is in the tree of 'rig' (2 frames)",
            "'map' in that of 'map' (4 frames)",
            "--child-frame-id rig",
        ],
    ),
    ("map", "Lasr", None): (
        Outcome.UNKNOWN_FRAME,
        ["No transform has the frame 'Lasr'.", "Similar: 'laser'."],
    ),
    ("/map", "laser", None): (Outcome.BAD_NAME, ["start with a slash: use 'map'"]),
}


def test_each_failure_has_its_sentences() -> None:
    wrong = {}
    for (target, source, at_s), (outcome, parts) in FAILURES.items():
        lookup = looked_up(target, source, at_s)
        text = " ".join(advise(lookup))
        missing = [part for part in parts if part not in text]
        if lookup.outcome != outcome or missing or not lookup.error:
            wrong[target, source, at_s] = (lookup.outcome, missing, text)
    assert wrong == {}


@pytest.mark.parametrize("parents", [("left", "right"), ("right", "left")])
def test_a_child_of_two_parents_is_named_whichever_came_last(parents: tuple[str, str]) -> None:
    messages = [message(parents[step % 2], "tool", 0.1 * step) for step in range(10)]
    lookup = looked_up(parents[0], "tool", messages=messages)
    assert lookup.outcome == Outcome.UNKNOWN_FRAME
    assert advise(lookup) == [
        (
            f"'tool' is sent with several parents, of which a buffer keeps the last, now {parents[1]!r}: drive.mcap on "
            "/tf (parent 'left') and drive.mcap on /tf (parent 'right'). Let only one of these send 'tool'."
        )
    ]


def test_a_child_of_two_parents_tears_a_longer_chain() -> None:
    messages = [message("map", "left", 0.0, static=True)]
    messages += [message(("left", "right")[step % 2], "tool", 0.1 * step) for step in range(10)]
    lookup = looked_up("map", "tool", messages=messages)
    assert lookup.outcome == Outcome.NOT_CONNECTED
    text = " ".join(advise(lookup))
    assert "'tool' is sent with several parents, of which a buffer keeps the last, now 'right'" in text
    assert "(parent 'left') and" in text


def test_one_transform_is_valid_at_its_stamp_only() -> None:
    messages = [message("odom", "base", 1.0)]
    lookup = looked_up("odom", "base", 2.0, messages=messages)
    assert lookup.outcome == Outcome.ONE_SAMPLE
    assert "There is one transform of odom -> base, from drive.mcap" in " ".join(advise(lookup))
    assert looked_up("odom", "base", 1.0, messages=messages).outcome == Outcome.SUCCEEDS


def test_edges_without_a_common_time() -> None:
    messages = [message("map", "odom", step / 10) for step in range(5)]
    messages += [message("odom", "base", 3 + step / 10) for step in range(5)]
    lookup = looked_up("map", "base", messages=messages)
    assert lookup.outcome == Outcome.PAST
    assert "no common time, because map -> odom ended before" in " ".join(advise(lookup))


def test_a_loop_is_named() -> None:
    messages = [message("a", "b", 1.0), message("b", "c", 1.0), message("c", "a", 1.0)]
    lookup = looked_up("a", "other", messages=[*messages, message("z", "other", 1.0)])
    assert lookup.outcome in {Outcome.LOOP, Outcome.NOT_CONNECTED}
    inside = looked_up("z", "a", messages=[*messages, message("z", "other", 1.0)])
    assert inside.outcome == Outcome.LOOP
    assert "a -> b -> c -> a" in " ".join(advise(inside))


def test_an_edge_that_is_static_and_moving_is_remarked() -> None:
    messages = [
        message("base", "laser", 0.0, static=True),
        message("base", "laser", 0.1),
        message("base", "laser", 0.2),
    ]
    text = " ".join(remark(looked_up("base", "laser", messages=messages)))
    assert "'laser' has 2 sources" in text
    assert "both static and moving" in text


def test_names_with_a_slash_are_those_that_a_buffer_stores() -> None:
    messages = [message("/base", "/laser", 0.0, static=True)]
    chain = looked_up("base", "laser", messages=messages).chain
    assert chain is not None
    assert [(span.name, span.publishers) for span in chain.spans] == [("base -> laser", "drive.mcap")]
    messages += [message("base", "/laser", 0.1), message("base", "laser", 0.2)]
    assert "both static and moving" in " ".join(remark(looked_up("base", "laser", messages=messages)))
    loop = [message("/a", "/b", 1.0), message("/b", "/a", 1.0)]
    text = " ".join(advise(looked_up("other", "a", messages=[*loop, message("z", "other", 1.0)])))
    assert "It is published by drive.mcap (/b -> /a), drive.mcap (/a -> /b): end one" in text


def test_a_frame_that_buffers_reject_is_no_absent_one() -> None:
    lookup = looked_up("base", "lidar", messages=[*robot(), message("base", "lidar", 0.0, x=math.nan)])
    assert lookup.outcome == Outcome.UNKNOWN_FRAME
    rejected = "buffers reject it, because its numbers are not finite: mend that node."
    assert advise(lookup)[1:] == [f"drive.mcap sends 'base' -> 'lidar' on /tf, but {rejected}"]
    nothing_else = looked_up("base", "lidar", messages=[message("base", "lidar", 0.0, x=math.nan)])
    assert advise(nothing_else) == advise(lookup)[1:]


def test_nothing_was_recorded() -> None:
    lookup = looked_up("map", "base", messages=[])
    assert (lookup.outcome, advise(lookup)) == (Outcome.UNKNOWN_FRAME, ["There is no transform in it."])


@pytest.mark.parametrize(
    ("name", "at_s"), [("latest", None), ("future", 4.9), ("past", -1.0)], ids=["latest", "future", "past"]
)
def test_the_report_is_the_recorded_one(name: str, at_s: float | None) -> None:
    """The time-lines; replace the files after a deliberate change of the text."""
    text = report_text(looked_up("map", "laser", at_s)) + "\n"
    assert text == (TEXTS / f"{name}.txt").read_text("utf-8")


def test_plain_values_have_the_same_facts() -> None:
    values = plain_values(looked_up("map", "laser", 4.9))
    assert (values["outcome"], values["newest_limited_by"], values["top"]) == ("future", "odom", "map")
    assert [link["child"] for link in values["chain"]] == ["laser", "base", "odom"]
    assert values["chain"][1]["publishers"][0]["rate_hz"] == pytest.approx(10.0)
    assert values["chain"][2]["publishers"][0]["delay_mean_s"] == pytest.approx(0.25)
    assert values["chain"][0]["publishers"][0]["delay_mean_s"] is None
