"""Checks of who uses frames: headers of topics, and requests to buffer servers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tfloom.tf2_tools.diagnosis.finding import Evidence, Finding
from tfloom.tf2_tools.diagnosis.limits import Limits
from tfloom.tf2_tools.diagnosis.subject import FrameUse, Subject
from tfloom.tf2_tools.text.counts import counted


def check_uses(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on frames that are named and that no transform holds."""
    yield from _unknown_frames(subject, "TF601", subject.headers, "is in the frame", "message")
    yield from _unknown_frames(subject, "TF602", subject.requests, "requests the frame", "request")


def _unknown_frames(
    subject: Subject, code: str, uses: Sequence[FrameUse], verb: str, what: str
) -> Iterator[Finding]:
    for use in uses:
        if use.frame and use.frame not in subject.frames:
            hint = subject.near(use.frame)
            evidence = Evidence(f"{counted(use.count, what)}{hint}", {"count": use.count, "frame": use.frame})
            summary = f"what {use.source} publishes" if code == "TF601" else str(use.source)
            yield Finding(
                code,
                f"{summary} {verb} {use.frame!r}, which no transform holds",
                [use.source],
                [use.frame],
                [evidence],
            )
