"""Check the requirements of programs to run and to discover one another, and print remedies for problems."""

from __future__ import annotations

import argparse
import os
import sys

from tfloom.cli.doctor.checks import checks
from tfloom.cli.doctor.finding import Finding, Verdict
from tfloom.common.terminal import unescaped

COLOURS = {Verdict.OK: "32", Verdict.WARNING: "33", Verdict.FAILED: "31"}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `doctor`."""
    reports = parser.add_mutually_exclusive_group()
    reports.add_argument("-r", "--report", action="store_true", help="print all details")
    reports.add_argument(
        "-rf", "--report-failed", action="store_true", help="print all details of checks that failed"
    )
    parser.add_argument(
        "-ep",
        "--exclude-packages",
        action="store_true",
        help="omit the versions and the origin of each package name",
    )
    parser.add_argument("-iw", "--include-warnings", action="store_true", help="count warnings as failures")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print a line for each check; return 1 if one failed."""
    findings = {name: check() for name, check in checks(exclude_packages=args.exclude_packages).items()}
    failed = [name for name, finding in findings.items() if _counts_as_failure(finding, args)]
    if args.json:
        import json

        print(
            json.dumps([{"check": name, **finding.as_dict()} for name, finding in findings.items()], indent=2)
        )
        return int(bool(failed))
    for name, finding in findings.items():
        print(_coloured(finding.verdict), end="", file=unescaped(sys.stdout))
        print(f"  {name}: {finding.summary}")
        if finding.advice:
            print(f"         {finding.advice}")
        if args.report or (args.report_failed and name in failed):
            for key, value in finding.details.items():
                print(f"         {key}: {value}")
    print(
        f"\n{len(failed)}/{len(findings)} checks failed" if failed else f"\nAll {len(findings)} checks passed"
    )
    if failed:
        print(f"Failed: {', '.join(failed)}")
    return int(bool(failed))


def _counts_as_failure(finding: Finding, args: argparse.Namespace) -> bool:
    return finding.verdict is Verdict.FAILED or (args.include_warnings and finding.verdict is Verdict.WARNING)


def _coloured(verdict: Verdict) -> str:
    text = f"{verdict.value:>7}"
    if sys.stdout.isatty() and "NO_COLOR" not in os.environ:
        return f"\033[{COLOURS[verdict]}m{text}\033[0m"
    return text
