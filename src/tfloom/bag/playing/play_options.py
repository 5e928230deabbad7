"""What a player is asked to play, and how."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from tfloom.bag.topic_choice import TopicChoice, full_names
from tfloom.rmw.qos import QoS

__all__ = ["PlayOptions", "parse_remaps"]


@dataclass
class PlayOptions:
    """What of a bag is played, and how; without arguments, all of it, once."""

    choice: TopicChoice = field(default_factory=lambda: TopicChoice(all_topics=True, all_services=True))
    rate: float = 1.0
    """How many seconds of the bag are played in a second; above 0."""
    is_loop: bool = False
    remaps: Mapping[str, str] = field(default_factory=dict)
    """Names under which topics are published, by their names in the bag."""
    clock_hz: float = 0.0
    """Frequency of /clock; 0: it is not published regularly."""
    clock_topics: Sequence[str] = ()
    """Topics with each message of which /clock is published before."""
    is_clock_on_all: bool = False
    delay_s: float = 0.0
    """Wait before playing, in each loop."""
    start_offset_s: float = 0.0
    duration_s: float = -1.0
    """How much of the bag is played; negative: all."""
    until_ns: int = -1
    """The last log time that is played [ns since epoch]; negative: no limit."""
    is_start_paused: bool = False
    wait_acked_ms: int = -1
    """The longest wait for acknowledgements at the end; negative: no wait; 0: no limit."""
    qos_overrides: Mapping[str, QoS] = field(default_factory=dict)
    read_ahead: int = 1000
    """Number of messages that are read ahead, at most."""
    has_keyboard: bool = True
    publishes_requests: bool = False
    """Whether recorded requests are sent to services, in place of publishing their events."""
    sends_goals: bool = False
    """Whether recorded goals, cancellations and result requests are sent to action servers, in place of publishing."""
    is_client_source: bool = False
    """Whether requests and goals are those that clients recorded, not those of servers."""
    is_by_sent_time: bool = False
    """Whether messages are played by the times at which they were published, not received."""
    progress_hz: float = 0.0
    """How often a line of progress is printed in a second; negative: with each message; 0: never."""
    progress_lines: int = 2
    """Number of empty lines before that line."""


def parse_remaps(words: Sequence[str]) -> dict[str, str]:
    """Return the remaps of words such as `old:=new`, with full names.

    Raises:
        ValueError: a word isn't one.
    """
    remaps = {}
    for word in words:
        old, sign, new = word.partition(":=")
        if not (sign and old and new):
            raise ValueError(f"'{word}' is not a remap: old_topic:=new_topic")
        old, new = full_names((old, new))
        remaps[old] = new
    return remaps
