"""A diagnosis: all checks of a subject, and the report of what they found, as text and as JSON's values."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

from tfloom.tf2_tools.diagnosis.catalogue import GROUPS, Kind, Limits, Severity
from tfloom.tf2_tools.diagnosis.finding import Finding
from tfloom.tf2_tools.diagnosis.name_checks import check_names
from tfloom.tf2_tools.diagnosis.rate_checks import check_rates
from tfloom.tf2_tools.diagnosis.subject import Subject
from tfloom.tf2_tools.diagnosis.time_checks import check_stamps
from tfloom.tf2_tools.diagnosis.topic_checks import check_topics, check_uses
from tfloom.tf2_tools.diagnosis.tree_checks import check_tree
from tfloom.tf2_tools.diagnosis.value_checks import check_values
from tfloom.tf2_tools.text import counted

CHECKS = (check_tree, check_names, check_values, check_stamps, check_rates, check_topics, check_uses)
SHOWN = 5
"""Number of lines of evidence that the text has of one finding."""
MAX_WIDTH = 110
INDENT = " " * 9


def diagnose(subject: Subject, limits: Limits | None = None, ignored: Collection[str] = ()) -> list[Finding]:
    """Return the findings on a subject, the errors first, each in order of their codes.

    Args:
        subject: What to check.
        limits: The thresholds; None: the usual ones.
        ignored: Codes of findings to leave out.
    """
    limits = limits or Limits()
    findings = [
        finding for check in CHECKS for finding in check(subject, limits) if finding.code not in ignored
    ]
    return sorted(
        findings,
        key=lambda finding: (finding.kind.severity is not Severity.ERROR, finding.code, finding.summary),
    )


class Report(NamedTuple):
    """What was looked at and what was found, as text, as JSON, and as an exit code."""

    subject: Subject
    findings: Sequence[Finding]
    origin: str
    """What was looked at, in words: `the graph`, or the name of a file."""
    is_strict: bool = False
    """Whether warnings count as failures."""

    def count(self, severity: Severity) -> int:
        """Return the number of findings of a severity."""
        return sum(finding.kind.severity is severity for finding in self.findings)

    @property
    def exit_code(self) -> int:
        """1 if there is an error, or a warning that counts; else 0."""
        return int(self.count(Severity.ERROR) > 0 or (self.is_strict and bool(self.findings)))

    def as_dict(self) -> dict[str, object]:
        """Return the report as JSON values."""
        observation = self.subject.seen
        return {
            "origin": self.origin,
            "is_live": observation.is_live,
            "is_simulated": self.subject.is_simulated,
            "duration_s": round(self.subject.duration_s, 3),
            "frames": len(self.subject.frames),
            "edges": len(self.subject.tree.parents),
            "publishers": len(observation.publishers),
            "transforms": sum(edge.statistics.count for edge in observation.edges),
            "roots": self.subject.tree.roots(),
            "errors": self.count(Severity.ERROR),
            "warnings": self.count(Severity.WARNING),
            "exit_code": self.exit_code,
            "findings": [finding.as_dict() for finding in self.findings],
        }

    def head(self) -> str:
        """Return the line that says what was looked at."""
        observation, tree = self.subject.seen, self.subject.tree
        counts = [
            counted(len(self.subject.frames), "frame"),
            counted(len(tree.roots()), "tree"),
            counted(len(observation.publishers), "publisher"),
            counted(sum(edge.statistics.count for edge in observation.edges), "transform"),
        ]
        unknown = "" if observation.is_live else "; a recording does not name publishers"
        simulated = ", by /clock" if self.subject.is_simulated else ""
        return f"{self.origin}, {self.subject.duration_s:.1f} s{simulated}: {', '.join(counts)}{unknown}"

    def end(self) -> str:
        """Return the last line."""
        if not self.findings:
            return "no findings"
        errors = counted(self.count(Severity.ERROR), "error")
        warnings = counted(self.count(Severity.WARNING), "warning")
        return f"{errors}, {warnings}; `tfloom tf doctor --explain CODE` says more of one"


def body(finding: Finding, width: int = MAX_WIDTH) -> Iterator[str]:
    """Yield the lines of a finding that follow its code and severity, of at most `width` columns where words allow."""
    first, *rest = _wrapped_lines(finding.summary, INDENT, width=width)
    yield first.lstrip()
    yield from rest
    for evidence in finding.evidence[:SHOWN]:
        yield from _wrapped_lines(f"- {evidence.text}", INDENT, f"{INDENT}  ", width)
    if len(finding.evidence) > SHOWN:
        yield f"{INDENT}- and {len(finding.evidence) - SHOWN} more"
    yield from _wrapped_lines(f"mend: {finding.kind.mend}", INDENT, f"{INDENT}      ", width)


def explanation(kind: Kind) -> str:
    """Return all that the catalogue has of a kind of findings."""
    lines = [f"{kind.code} ({kind.severity.value}, {GROUPS[kind.code[2]].lower()}): {kind.title}"]
    for title, text in (("meaning", kind.meaning), ("cause", kind.cause), ("mend", kind.mend)):
        lines += _wrapped_lines(f"{title + ':':<9}{text}", "  ", " " * 11)
    return "\n".join(lines)


def _wrapped_lines(text: str, indent: str, further: str | None = None, width: int = MAX_WIDTH) -> list[str]:
    return textwrap.wrap(
        text,
        min(width, MAX_WIDTH),
        initial_indent=indent,
        subsequent_indent=indent if further is None else further,
        break_long_words=False,
        break_on_hyphens=False,
    )
