"""The time of a recording that is played."""

from __future__ import annotations

from tfloom.viewer.frames import Span
from tfloom.viewer.playback import Playback

S = 1_000_000_000
SPAN = Span(10 * S, 20 * S)


def test_time_stands_runs_and_ends() -> None:
    now_s = 0.0
    playback = Playback(lambda: now_s)
    assert (playback.now_ns(SPAN), playback.is_playing) == (10 * S, False)
    playback.play(SPAN)
    now_s = 2.5
    assert playback.now_ns(SPAN) == 12_500_000_000
    playback.pause(SPAN)
    now_s = 100.0
    assert (playback.now_ns(SPAN), playback.is_playing) == (12_500_000_000, False)
    playback.play(SPAN)
    now_s = 200.0
    assert (playback.now_ns(SPAN), playback.is_playing) == (20 * S, False)
    playback.play(SPAN)  # from the start again
    assert (playback.now_ns(SPAN), playback.is_playing) == (10 * S, True)


def test_time_is_held_within_the_recording() -> None:
    playback = Playback()
    playback.pause(SPAN, 15 * S)
    assert playback.now_ns(SPAN) == 15 * S
    playback.pause(SPAN, 99 * S)
    assert playback.now_ns(SPAN) == 20 * S


def test_time_begins_later_and_begins_there_again() -> None:
    now_s = 0.0
    playback = Playback(lambda: now_s)
    playback.start_ns = 13 * S
    assert playback.now_ns(SPAN) == 13 * S
    playback.play(SPAN)
    now_s = 100.0
    assert (playback.now_ns(SPAN), playback.is_playing) == (20 * S, False)
    playback.play(SPAN)
    assert (playback.now_ns(SPAN), playback.is_playing) == (13 * S, True)
    playback.pause(SPAN, 10 * S)  # by the slider, it goes back to the beginning
    assert playback.now_ns(SPAN) == 10 * S
