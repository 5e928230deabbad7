"""The flags for a source of transforms, common to the verbs of `tf`, and the source they name."""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listen import cli_node, shown_node
from tfloom.cli.shared.names import full_topic_name
from tfloom.cli.shared.numbers import seconds
from tfloom.rmw.backends import domain_id_from_environment
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.static_file import StaticFileError
from tfloom.tf2_tools.watch.model import STATIC_TOPIC, TF_TOPIC, Observation
from tfloom.tf2_tools.watch.sources import LIVE, Source, open_path

__all__ = ["add_arguments", "add_topics", "is_live", "open_source", "opened", "place", "settled", "wait_for"]

WAIT_S = 3.0
"""The longest wait for transforms of a live graph, without --wait [s]."""
LOOK_S = 0.1
"""Period at which a wait looks again, although nothing has come [s]."""
SETTLED_S = 0.5
"""A live graph's edges are all known when no new one has come for this time [s]."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags of a verb that takes transforms from one source."""
    parser.add_argument(
        "-b",
        "--bag",
        metavar="PATH",
        default=LIVE,
        help="a bag, or a .yaml file of static transforms, in place of the live graph",
    )
    add_topics(parser)


def add_topics(parser: argparse.ArgumentParser) -> None:
    """Add the flags that the live graph needs."""
    parser.add_argument("--tf-topic", default=TF_TOPIC, help=f"topic of transforms (default: {TF_TOPIC})")
    parser.add_argument(
        "--tf-static-topic",
        default=STATIC_TOPIC,
        help=f"topic of static transforms (default: {STATIC_TOPIC})",
    )
    parser.add_argument(
        "--wait",
        metavar="S",
        type=seconds,
        default=WAIT_S,
        help=f"longest wait for transforms of a live graph in seconds (default: {WAIT_S:g})",
    )
    parser.add_argument(
        "--spin-time", type=seconds, default=graph.MAX_WAIT_S, help="longest time of discovery in seconds"
    )
    parser.add_argument(
        "-s", "--use-sim-time", action="store_true", help="compare stamps with the time on /clock"
    )


def is_live(name: str) -> bool:
    """Return whether a source's name is the word for the live graph."""
    return name == LIVE


def place(name: str) -> str:
    """Return where a source's transforms come from, for a title: the domain of the live graph, or the path."""
    return f"domain {domain_id_from_environment()}" if is_live(name) else name


@contextmanager
def open_source(args: argparse.Namespace, *, buffer: Buffer | None = None) -> Iterator[Source]:
    """Open the source of --bag, or the live graph, for the block; see `opened`."""
    with opened(args.bag, args, buffer=buffer) as source:
        yield source


@contextmanager
def opened(name: str, args: argparse.Namespace, *, buffer: Buffer | None = None) -> Iterator[Source]:
    """Open a source for the block; discovery of a live graph is complete.

    Args:
        name: `live`, or the path of a bag or of a file of static transforms.
        args: The flags of `add_topics`.
        buffer: A buffer to fill as well.

    Raises:
        CommandError: the file is not such a file.
    """
    topics = full_topic_name(args.tf_topic), full_topic_name(args.tf_static_topic)
    if not is_live(name):
        yield _read(Path(name), topics, buffer)
        return
    from tfloom.cli.shared.sim_time import wait_until_known
    from tfloom.tf2_tools.watch.live import LiveWatch

    with (
        graph.joined_participant() as participant,
        shown_node(participant, cli_node()) as node,
        closing(
            LiveWatch(participant, node, buffer=buffer, topics=topics, simulated=args.use_sim_time)
        ) as watch,
    ):
        graph.wait_until_quiet(participant.graph, args.spin_time, goes_on=True)
        wait_until_known(watch.now_ns)
        yield watch


def _read(path: Path, topics: tuple[str, str], buffer: Buffer | None) -> Source:
    from tfloom.bag.errors import BagError

    try:
        return open_path(path, buffer=buffer, topics=topics)
    except (StaticFileError, BagError) as error:
        raise CommandError(str(error)) from None


def wait_for(source: Source, is_enough: Callable[[Observation], bool], timeout_s: float) -> Observation:
    """Wait until an observation is enough; return it, or the last one after `timeout_s` [s]."""
    end_s = time.monotonic() + timeout_s
    while not is_enough(seen := source.observation()) and time.monotonic() < end_s:
        source.wait(min(end_s, time.monotonic() + LOOK_S))  # because time alone may make it enough
    return seen


def settled(source: Source, timeout_s: float, *, only_static: bool = False) -> Observation:
    """Wait until each publisher has sent something and no new edge has come for `SETTLED_S`; return what is known.

    Args:
        source: The source; there is no wait for one that isn't live.
        timeout_s: The longest wait [s].
        only_static: Whether publishers of moving transforms, and the time without new edges, don't matter.
    """
    count, since_s = -1, time.monotonic()

    def is_enough(seen: Observation) -> bool:
        nonlocal count, since_s
        if not seen.is_live:
            return True
        # The number of edges only grows. Its last change begins the time in which no new edge must come.
        if len(seen.edges) != count:
            count, since_s = len(seen.edges), time.monotonic()
        # A latched static transform arrives soon after the match; so with `only_static` it suffices that each publisher
        # has sent one.
        awaited = [publisher for publisher in seen.publishers if publisher.is_static or not only_static]
        return (
            count > 0
            and all(publisher.traffic is not None for publisher in awaited)
            and (only_static or time.monotonic() >= since_s + SETTLED_S)
        )

    return wait_for(source, is_enough, timeout_s)
