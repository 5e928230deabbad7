"""What a lookup gives, and if it fails, why."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

from tfloom.tf2.buffer import LATEST, Buffer
from tfloom.tf2.errors import (
    BackwardExtrapolationException,
    ConnectivityException,
    ForwardExtrapolationException,
    InvalidArgumentException,
    NoDataForExtrapolationException,
    TransformException,
)
from tfloom.tf2.transform import StampedTransform
from tfloom.tf2_tools.lookups.chain import Chain, find_chain, tree_of
from tfloom.tf2_tools.watch.model import Observation

__all__ = ["Lookup", "Outcome", "look_up"]


class Outcome(Enum):
    """How a lookup ends."""

    SUCCEEDS = "succeeds"
    BAD_NAME = "bad_name"
    UNKNOWN_FRAME = "unknown_frame"
    LOOP = "loop"
    NOT_CONNECTED = "not_connected"
    FUTURE = "future"
    PAST = "past"
    ONE_SAMPLE = "one_sample"


@dataclass(frozen=True)
class Lookup:
    """A lookup of target_from_source in what a transform listener has received."""

    target: str
    source: str
    asked_ns: int
    """The requested stamp [ns since epoch]; 0: the latest."""
    now_ns: int
    cache_time_ns: int | None
    """Length of the buffer's history; None: no limit."""
    seen: Observation
    outcome: Outcome
    error: str
    """tf2's text; empty if the lookup succeeds."""
    transform: StampedTransform | None
    chain: Chain | None
    """None if the frames are not connected, or one is unknown."""
    parents: Mapping[str, str]
    """The parent of each child in the buffer."""

    @property
    def missing(self) -> list[str]:
        """Of the two frames, those that no received transform has."""
        frames = {*self.parents, *self.parents.values()}
        return [frame for frame in dict.fromkeys((self.target, self.source)) if frame not in frames]

    @property
    def stamp_ns(self) -> int:
        """The stamp that is needed: the requested one, or the newest that all edges have; 0 if all are static."""
        if self.asked_ns != LATEST:
            return self.asked_ns
        limit = self.chain.first_to_end if self.chain is not None else None
        return limit.newest_ns if limit is not None else 0


def look_up(
    seen: Observation,
    buffer: Buffer,
    target: str,
    source: str,
    *,
    asked_ns: int = LATEST,
    now_ns: int,
    cache_time_ns: int | None,
) -> Lookup:
    """Look up a transform, and find out what prevents it.

    Args:
        seen: What has been observed.
        buffer: What a transform listener holds of it.
        target: The target frame.
        source: The source frame.
        asked_ns: The stamp [ns since epoch]; 0: the latest.
        now_ns: The time [ns since epoch].
        cache_time_ns: Length of the buffer's history; None: no limit.
    """
    transform, error, outcome = None, "", Outcome.SUCCEEDS
    tree = tree_of(buffer)
    try:
        transform = buffer.lookup(target, source, asked_ns)
    except TransformException as failure:
        error = str(failure)
        outcome = _outcome(failure, is_missing=target not in tree or source not in tree)
    # The chain is looked for after a failure, too: frames may be connected and yet have no time in common.
    chain = find_chain(buffer, seen, target, source)
    return Lookup(
        target, source, asked_ns, now_ns, cache_time_ns, seen, outcome, error, transform, chain, tree.parents
    )


_OUTCOMES = {
    InvalidArgumentException: Outcome.BAD_NAME,
    ConnectivityException: Outcome.NOT_CONNECTED,
    BackwardExtrapolationException: Outcome.PAST,
    ForwardExtrapolationException: Outcome.FUTURE,
    NoDataForExtrapolationException: Outcome.ONE_SAMPLE,
}


def _outcome(failure: TransformException, *, is_missing: bool) -> Outcome:
    outcome = _OUTCOMES.get(type(failure), Outcome.LOOP)
    if is_missing and outcome != Outcome.BAD_NAME:
        return Outcome.UNKNOWN_FRAME
    return outcome
