"""A lookup as text for a terminal, with a time-line, and as plain values for JSON."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from tfloom.tf2.buffer import LATEST
from tfloom.tf2_tools.lookups.advice import advise, remark
from tfloom.tf2_tools.lookups.chain import Chain, Span
from tfloom.tf2_tools.lookups.lookup import Lookup, Outcome
from tfloom.tf2_tools.text import NS_PER_S, ago, seconds_text
from tfloom.tf2_tools.watch.model import Edge

__all__ = ["TimeLine", "plain_values", "report_text"]
WIDTH = 40
COVERED, EMPTY, MARK = "=", ".", "|"


def report_text(lookup: Lookup) -> str:
    """Return what a lookup gives or why it fails, the chain on a time-line, and what to do."""
    lines = [_heading(lookup)]
    if lookup.error:
        lines.append(f"  {lookup.error}")
    if lookup.chain is not None and lookup.chain.spans:
        lines += ["", *_chain_lines(lookup, lookup.chain)]
    if lookup.transform is not None:
        lines += ["", *_transform_lines(lookup)]
    for sentences in (remark(lookup), advise(lookup)):
        if sentences:
            lines += ["", *sentences]
    return "\n".join(lines)


def _heading(lookup: Lookup) -> str:
    when = "the latest time" if lookup.asked_ns == LATEST else _when(lookup.asked_ns, lookup.now_ns)
    verb = "succeeds" if lookup.outcome == Outcome.SUCCEEDS else "fails"
    return f"The lookup of {lookup.target} from {lookup.source} at {when} {verb}."


def _when(stamp_ns: int, now_ns: int) -> str:
    return f"{stamp_ns / NS_PER_S:.6f} ({ago(stamp_ns, now_ns)})"


def _chain_lines(lookup: Lookup, chain: Chain) -> list[str]:
    now = "now" if lookup.seen.is_live else "the end"
    line = TimeLine(chain.spans, lookup.stamp_ns, lookup.now_ns, now)
    width = max(len(span.name) for span in chain.spans)
    lines = [f"  source {lookup.source}"]
    for place, span in enumerate(chain.spans):
        if place and chain.spans[place - 1].is_up and not span.is_up:
            lines.append(f"  top {chain.top}")
        way = "up  " if span.is_up else "down"
        lines.append(
            f"    {way}  {span.name:<{width}}  {line.row(span)}  {_facts(span, lookup.now_ns)}".rstrip()
        )
    lines.append(f"  target {lookup.target}")
    indent = " " * (width + 12)
    if chain.moving:
        lines.append(f"{indent}{line.axis()}")
    if lookup.stamp_ns:
        text = "the newest time of all" if lookup.asked_ns == LATEST else "the requested time"
        lines.append(f"{indent}{line.pointer(text)}")
    return lines


def _facts(span: Span, now_ns: int) -> str:
    if span.is_static or span.last is None:
        return span.publishers
    rate_hz, delay = span.last.rate_hz, span.last.statistics.delay
    rate = f", {rate_hz:.3g} Hz" if rate_hz else ""
    late = (
        f", delay {seconds_text(delay.mean)}"
        if delay.count and span.last.publisher.traffic is not None
        else ""
    )
    return f"{span.publishers}{rate}{late}, newest {ago(span.newest_ns, now_ns)}"


def _transform_lines(lookup: Lookup) -> list[str]:
    transform = lookup.transform
    if transform is None:
        return []
    x, y, z = transform.translation
    qx, qy, qz, qw = transform.rotation_xyzw
    lines = [
        f"translation {x:.3f}, {y:.3f}, {z:.3f} m",
        f"rotation    {qx:.3f}, {qy:.3f}, {qz:.3f}, {qw:.3f} (x, y, z, w), yaw {_yaw_deg(qx, qy, qz, qw):.2f} deg",
    ]
    chain = lookup.chain
    if chain is None or chain.first_to_end is None or chain.last_to_begin is None:
        return [*lines, "Every edge is static: it is valid at any time."]
    newest, oldest = chain.first_to_end, chain.last_to_begin
    lines.append(
        f"newest time {_when(newest.newest_ns, lookup.now_ns)}: limited by {newest.name} of {newest.publishers}"
    )
    lines.append(
        f"oldest time {_when(oldest.oldest_ns, lookup.now_ns)}: limited by {oldest.name} of {oldest.publishers}"
    )
    return lines


def _yaw_deg(x: float, y: float, z: float, w: float) -> float:
    return math.degrees(math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)))


def plain_values(lookup: Lookup) -> dict[str, Any]:
    """Return a lookup as mappings, lists, texts and numbers; stamps in [ns since epoch], durations in [s]."""
    transform, chain = lookup.transform, lookup.chain
    newest = chain.first_to_end if chain is not None else None
    oldest = chain.last_to_begin if chain is not None else None
    return {
        "target_frame": lookup.target,
        "source_frame": lookup.source,
        "outcome": lookup.outcome.value,
        "asked_ns": lookup.asked_ns,
        "now_ns": lookup.now_ns,
        "error": lookup.error,
        "transform": None
        if transform is None
        else {
            "stamp_ns": transform.stamp_ns,
            "translation": list(transform.translation),
            "rotation_xyzw": list(transform.rotation_xyzw),
        },
        "top": None if chain is None else chain.top,
        "chain": [] if chain is None else [_plain_span(span) for span in chain.spans],
        "newest_ns": None if newest is None else newest.newest_ns,
        "newest_limited_by": None if newest is None else newest.child,
        "oldest_ns": None if oldest is None else oldest.oldest_ns,
        "oldest_limited_by": None if oldest is None else oldest.child,
        "remarks": remark(lookup),
        "advice": advise(lookup),
    }


def _plain_span(span: Span) -> dict[str, Any]:
    return {
        "parent": span.parent,
        "child": span.child,
        "is_static": span.is_static,
        "is_up": span.is_up,
        "oldest_ns": span.oldest_ns,
        "newest_ns": span.newest_ns,
        "sample_count": span.sample_count,
        "publishers": [_plain_source(edge) for edge in span.sources],
    }


def _plain_source(edge: Edge) -> dict[str, Any]:
    statistics = edge.statistics
    delay = None if edge.is_static or not statistics.delay.count else statistics.delay
    return {
        "node": edge.publisher.name,
        "gid": edge.publisher.gid_text,
        "topic": edge.topic,
        "rate_hz": edge.rate_hz,
        "count": statistics.count,
        "delay_mean_s": None if delay is None else delay.mean,
        "delay_greatest_s": None if delay is None else delay.greatest,
    }


class TimeLine:
    """A row for each edge, in which the time that its history covers is filled; columns are of equal time, up to now.

    Args:
        spans: The edges.
        stamp_ns: The time to mark; 0: none.
        now_ns: The time at the right end, unless a stamp is later.
        now: What that time is called.
    """

    def __init__(self, spans: Sequence[Span], stamp_ns: int, now_ns: int, now: str) -> None:
        moving = [span for span in spans if not span.is_static]
        marked = [stamp_ns] if stamp_ns else []
        self._now_ns = now_ns
        self._now = now
        self._stamp_ns = stamp_ns
        self._begin_ns = min([span.oldest_ns for span in moving] + marked, default=now_ns)
        self._end_ns = max([now_ns, *(span.newest_ns for span in moving), *marked])

    def _column(self, stamp_ns: int) -> int:
        length_ns = max(1, self._end_ns - self._begin_ns)
        return round((WIDTH - 1) * (stamp_ns - self._begin_ns) / length_ns)

    def row(self, span: Span) -> str:
        """Return the row of an edge."""
        if span.is_static:
            return " static, valid at any time ".center(WIDTH, COVERED)
        first, last = self._column(span.oldest_ns), self._column(span.newest_ns)
        cells = [COVERED if first <= column <= last else EMPTY for column in range(WIDTH)]
        if self._stamp_ns:
            cells[self._column(self._stamp_ns)] = MARK
        return "".join(cells)

    def axis(self) -> str:
        """Return the row with the times at both ends."""
        left, right = ago(self._begin_ns, self._now_ns), ago(self._end_ns, self._now_ns)
        right = self._now if self._end_ns == self._now_ns else right
        return f"{left}{right.rjust(WIDTH - len(left))}"

    def pointer(self, text: str) -> str:
        """Return the row that points to the marked time, with a text beside it."""
        column = self._column(self._stamp_ns)
        if column + 2 + len(text) <= WIDTH or column < len(text) + 1:
            return f"{' ' * column}^ {text}"
        return f"{text} ^".rjust(column + 1)
