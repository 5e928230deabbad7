"""All checks of a subject."""

from __future__ import annotations

from collections.abc import Collection

from tfloom.tf2_tools.diagnosis.catalogue import Limits, Severity
from tfloom.tf2_tools.diagnosis.finding import Finding
from tfloom.tf2_tools.diagnosis.name_checks import check_names
from tfloom.tf2_tools.diagnosis.rate_checks import check_rates
from tfloom.tf2_tools.diagnosis.subject import Subject
from tfloom.tf2_tools.diagnosis.time_checks import check_stamps
from tfloom.tf2_tools.diagnosis.topic_checks import check_topics, check_uses
from tfloom.tf2_tools.diagnosis.tree_checks import check_tree
from tfloom.tf2_tools.diagnosis.value_checks import check_values

CHECKS = (check_tree, check_names, check_values, check_stamps, check_rates, check_topics, check_uses)


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
