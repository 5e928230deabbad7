"""The functions and classes of `ros2doctor.api`: the checks of `ros2 doctor`, for other programs."""

from __future__ import annotations

from collections.abc import Callable, Collection

from tfloom.cli.doctor.finding import Finding, Verdict

__all__ = ["DoctorCheck", "DoctorReport", "Report", "Result", "generate_reports", "run_checks"]


class Report:
    """What a check has found out, as lines.

    Args:
        name: The subject.
    """

    __slots__ = ["items", "name"]

    def __init__(self, name: str) -> None:
        self.name = name
        self.items: list[tuple[str, str]] = []

    def add_to_report(self, item_name: str, item_info: str) -> None:
        """Add a line: its name and its value."""
        self.items.append((item_name, item_info))


class Result:
    """How many errors and warnings a check has found."""

    __slots__ = ["error", "warning"]

    def __init__(self) -> None:
        self.error = 0
        self.warning = 0

    def add_error(self) -> None:
        """Count an error."""
        self.error += 1

    def add_warning(self) -> None:
        """Count a warning."""
        self.warning += 1


class DoctorCheck:
    """The base class of checks."""

    def category(self) -> str:
        """Return the subject."""
        raise NotImplementedError

    def check(self) -> Result:
        """Check it."""
        raise NotImplementedError


class DoctorReport:
    """The base class of reports."""

    def category(self) -> str:
        """Return the subject."""
        raise NotImplementedError

    def report(self) -> Report:
        """Return what there is to say."""
        raise NotImplementedError


def run_checks(
    *, include_warnings: bool = False, exclude_packages: bool = False
) -> tuple[set[str], int, int]:
    """Run the checks of `ros2 doctor`.

    Args:
        include_warnings: Whether warnings count as failures.
        exclude_packages: Whether to leave out the versions, and the origin of each package.

    Returns:
        The names of the checks that failed, how many these are, and how many were run.
    """
    findings = _findings(exclude_packages)
    failed = {
        name
        for name, finding in findings.items()
        if finding.verdict is Verdict.FAILED or (include_warnings and finding.verdict is Verdict.WARNING)
    }
    return failed, len(failed), len(findings)


def generate_reports(
    *, categories: Collection[str] | None = None, exclude_packages: bool = False
) -> list[Report]:
    """Return a report of each check.

    Args:
        categories: The names of the checks; None for all.
        exclude_packages: As for `run_checks`.
    """
    reports = []
    for name, finding in _findings(exclude_packages, categories).items():
        report = Report(name)
        report.add_to_report("verdict", finding.verdict.value.lower())
        report.add_to_report("summary", finding.summary)
        for key, value in finding.details.items():
            report.add_to_report(key, str(value))
        reports.append(report)
    return reports


def _findings(exclude_packages: bool, categories: Collection[str] | None = None) -> dict[str, Finding]:
    from tfloom.cli.doctor.checks import checks

    chosen: dict[str, Callable[[], Finding]] = checks(exclude_packages=exclude_packages)
    return {name: check() for name, check in chosen.items() if categories is None or name in categories}
