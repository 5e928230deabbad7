"""The graph for a command: a participant without a node, and a wait until discovery is complete."""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from itertools import chain

from tfloom._native import ReadyQueue
from tfloom.cli.shared.numbers import seconds
from tfloom.common.terminal import report
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import EndpointInfo, Graph, Participant

QUIET_S = 0.15
"""Discovery is complete when nothing new has arrived for this time [s]."""
MIN_WAIT_S = 0.2
"""The least time to wait [s]."""
PATIENCE_S = 1.0
"""The longest additional wait for missing entities [s]."""
LATE_PEERS_S = 5.0
"""The longest additional wait for participants of Fast DDS, which list their nodes up to 3 s late [s]."""
NOTICE_S = 0.5
"""Wait for these before the user gets a message about it [s]."""
MAX_LATE_S = 3.0
"""The longest additional wait on a busy machine [s]."""
LOOK_S = 0.05
"""Length of one sleep [s]."""
PUNCTUAL_S = 0.005
"""Delay of a sleep's end above which the machine is busy [s]."""
LATE_WEIGHT = 4.0
"""Extra wait per second of oversleeping [s]."""
MAX_WAIT_S = 5.0
"""The longest wait without --spin-time [s]."""
MISSING = (
    "nodes may be missing: not all that programs have announced has arrived (is one stopped, or very busy?)"
)

TOPICS_OF_EVERY_NODE = {
    "/parameter_events": "rcl_interfaces/msg/ParameterEvent",
    "/rosout": "rcl_interfaces/msg/Log",
}
"""The topics that each node publishes, by name, with their types."""


def add_spin_time(parser: argparse.ArgumentParser) -> None:
    """Add the flag for the longest time of discovery."""
    parser.add_argument(
        "--spin-time",
        type=seconds,
        default=MAX_WAIT_S,
        help=f"longest time of discovery in seconds (default {MAX_WAIT_S:g}; it ends when nothing new arrives)",
    )


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the common flags of all verbs that use the graph."""
    add_spin_time(parser)
    parser.add_argument(
        "-s", "--use-sim-time", action="store_true", help="accepted and not used: nothing depends on the time"
    )
    parser.add_argument("--no-daemon", action="store_true", help="accepted and not used: there is no daemon")


@contextmanager
def joined_participant() -> Iterator[Participant]:
    """Join the domain of ROS_DOMAIN_ID for the block."""
    participant = open_participant()
    try:
        yield participant
    finally:
        participant.close()


@contextmanager
def settled_participant(most_s: float) -> Iterator[Participant]:
    """Join the domain for the block, and wait until discovery is complete, at most `most_s` [s]."""
    with joined_participant() as participant:
        wait_until_quiet(participant.graph, most_s)
        yield participant


@contextmanager
def settled_graph(most_s: float) -> Iterator[Graph]:
    """Yield the graph of a participant that joins the domain for the block; see `settled_participant`."""
    with settled_participant(most_s) as participant:
        yield participant.graph


def wait_until_quiet(graph: Graph, most_s: float, *, goes_on: bool = False) -> None:
    """Wait until the graph has not changed for `QUIET_S`: at least `MIN_WAIT_S`, at most `most_s` [s].

    It waits longer while announced entities are missing: up to `PATIENCE_S`, or up to `LATE_PEERS_S` and with a message
    on stderr where they are of Fast DDS. It also does if this process was scheduled late, up to `MAX_LATE_S`, because
    the others may be late, too. Where something is missing after that, a message on stderr says so, unless the graph is
    looked at further (`goes_on`).
    """
    queue = ReadyQueue()
    start = time.monotonic()
    has_told = False
    graph.notify(queue)
    graph.is_whole()  # on Zenoh, this begins to ask the router for what it has, which takes some time
    try:
        # `quiet` is the time at which nothing new has come for long enough. Each change moves it, and each sleep that
        # ended late, because on a busy machine a process that announces itself is late as well.
        seen, changed, late_s = graph.changes(), start, 0.0
        while True:
            now = time.monotonic()
            if (changes := graph.changes()) != seen:  # also what came while this thread was not scheduled
                seen, changed = changes, now
            quiet = max(start + MIN_WAIT_S, changed + QUIET_S) + min(LATE_WEIGHT * late_s, MAX_LATE_S)
            until = min(quiet, start + most_s)
            if not has_told and now >= start + NOTICE_S and (late := graph.late_count()):
                has_told = True
                _print_notice(
                    f"waiting for the nodes of {_participants(late)}, which lists them up to 3 s late"
                )
            if now >= until:
                # It is quiet. Return if all that was announced is here, or if patience is over; otherwise look again in
                # a moment. A process that ends releases its ports and is no longer missing, which posts no token.
                late = graph.late_count()
                patience_s = LATE_PEERS_S if late else PATIENCE_S
                if (is_whole := graph.is_whole()) or now >= min(until + patience_s, start + most_s):
                    if late:
                        _print_notice(f"nodes may be missing: {_participants(late)} did not list them")
                    elif not (is_whole or goes_on):
                        _print_notice(MISSING)
                    return
                until = now + LOOK_S
            asked_s = min(until - now, LOOK_S)
            came = queue.wait(int(asked_s * 1e9) + 1)
            # A sleep that a token ended says nothing of lateness. One that ran its full time should have ended on time.
            if not came:
                late_s += max(0.0, time.monotonic() - now - asked_s - PUNCTUAL_S)
    finally:
        graph.notify(None)


def _participants(count: int) -> str:
    return f"{count} participant{'' if count == 1 else 's'} of Fast DDS"


def _print_notice(text: str) -> None:
    """Print a line on stderr, unless the command completes what is typed on a terminal."""
    if "_ARGCOMPLETE" not in os.environ:
        report(text)


def is_hidden(name: str) -> bool:
    """Return whether a part of the name begins with an underscore."""
    return any(part.startswith("_") for part in name.split("/"))


def types_by_name(names_and_types: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    """Return the types of each name, both in order."""
    types: dict[str, set[str]] = {}
    for name, type_name in names_and_types:
        types.setdefault(name, set()).add(type_name)
    return {name: sorted(types[name]) for name in sorted(types)}


def topic_types(endpoints: Iterable[EndpointInfo]) -> dict[str, list[str]]:
    """Return the types of each topic by the topic's name, both in order."""
    return types_by_name((endpoint.topic.name, endpoint.topic.type_name) for endpoint in endpoints)


def known_topics(endpoints: Iterable[EndpointInfo]) -> dict[str, list[str]]:
    """Return `topic_types` with those of every node, which ros2's own asker has, too, where it finds no other."""
    topics = topic_types(endpoints)
    for name, type_name in TOPICS_OF_EVERY_NODE.items():
        topics[name] = sorted({*topics.get(name, ()), type_name})
    return dict(sorted(topics.items()))


def names_of_type(types: Mapping[str, list[str]], type_name: str, kind: str, *, hidden: bool) -> list[str]:
    """Return which topics or services have a type; without any, print a line on stderr if nobody knows the type.

    Args:
        types: The types of each name.
        type_name: The type.
        kind: msg or srv.
        hidden: Whether hidden names count.
    """
    names = [name for name, kinds in types.items() if type_name in kinds and (hidden or not is_hidden(name))]
    if not names:
        from tfloom.cli.shared.type_names import warn_if_unknown

        warn_if_unknown(type_name, kind, set(chain.from_iterable(types.values())))
    return names
