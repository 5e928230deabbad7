"""Check the transforms of the graph, or of a recording: what is wrong, who causes it, and how to mend it.

The exit code is 0 without a finding, or with warnings alone; 1 with an error, or with `--strict` with any finding; 2 if
the arguments are wrong or nothing could be read.
"""

from __future__ import annotations

import argparse
import os
import shutil
import sys
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.graph import MAX_WAIT_S
from tfloom.cli.shared.names import full_topic_name
from tfloom.cli.shared.numbers import seconds, tolerance
from tfloom.common.terminal import report, unescaped
from tfloom.tf2_tools.diagnosis.catalogue import KINDS, Limits, Severity
from tfloom.tf2_tools.watch.model import STATIC_TOPIC, TF_TOPIC

if TYPE_CHECKING:
    from tfloom.tf2_tools.diagnosis.finding import Finding
    from tfloom.tf2_tools.diagnosis.report import Report
    from tfloom.tf2_tools.diagnosis.subject import Subject

DURATION_S = 5.0
MIN_WIDTH = 50
"""Least number of columns into which the report is wrapped."""
MAX_FINDINGS_OF_CODE = 20
"""Number of findings of one code that the text has."""
UNUSABLE = 2
"""Exit code where nothing could be checked."""
COLOURS = {Severity.ERROR: "31", Severity.WARNING: "33"}
LIMIT_OPTIONS = {
    "--min-rate": ("min_rate_hz", "HZ", "a frame is rare below this rate"),
    "--max-gap": ("max_gap_s", "S", "a frame that is away for longer pauses"),
    "--max-jitter": ("max_jitter", "RATIO", "standard deviation of a period, in mean periods"),
    "--max-ahead": ("max_ahead_s", "S", "how far a stamp may be ahead of now"),
    "--max-skew": ("max_skew_s", "S", "how far all stamps of a publisher may be off"),
    "--max-jump": ("max_jump_m", "M", "a longer step is a teleport"),
    "--max-speed": ("max_speed_m_s", "M/S", "and only if it is faster than this"),
    "--max-turn": ("max_turn_deg", "DEG", "a wider turn within one step is a teleport"),
    "--max-norm-error": ("max_norm_error", "LENGTH", "how far a quaternion's length may differ from 1"),
}
"""The option of each field of `Limits`: the field, the placeholder, the help."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `tf doctor`."""
    parser.add_argument(
        "path", nargs="?", type=Path, help="a bag, or a YAML file of static transforms; without it: the graph"
    )
    parser.add_argument("-b", "--bag", type=Path, metavar="PATH", help="the same as the positional path")
    parser.add_argument(
        "--seconds",
        type=seconds,
        default=DURATION_S,
        metavar="S",
        help=f"how long to listen ({DURATION_S:g})",
    )
    parser.add_argument("--json", action="store_true", help="print the report as JSON")
    parser.add_argument(
        "--topics", action="store_true", help="check the frames in the headers of all topics as well"
    )
    parser.add_argument(
        "--tf-topic", metavar="TOPIC", default=TF_TOPIC, help=f"topic of transforms ({TF_TOPIC})"
    )
    parser.add_argument(
        "--tf-static-topic", metavar="TOPIC", default=STATIC_TOPIC, help=f"of static ones ({STATIC_TOPIC})"
    )
    parser.add_argument(
        "--spin-time",
        type=seconds,
        default=MAX_WAIT_S,
        metavar="S",
        help=f"longest time of discovery ({MAX_WAIT_S:g}; it ends when nothing new arrives)",
    )
    parser.add_argument("--strict", action="store_true", help="count warnings as failures")
    parser.add_argument(
        "--ignore",
        nargs="+",
        action="extend",
        default=[],
        metavar="CODE",
        type=_code,
        help="codes to leave out",
    )
    explained = parser.add_mutually_exclusive_group()
    explained.add_argument("--explain", metavar="CODE", type=_code, help="print what a code means, and end")
    explained.add_argument("--list", action="store_true", help="print all codes, and end")
    limits = parser.add_argument_group("thresholds")
    for option, (field, placeholder, summary) in LIMIT_OPTIONS.items():
        usual = Limits._field_defaults[field]
        limits.add_argument(
            option,
            dest=field,
            type=tolerance,
            default=usual,
            metavar=placeholder,
            help=f"{summary} ({usual:g})",
        )


def main(args: argparse.Namespace) -> int:
    """Print the report; return its exit code."""
    if args.explain or args.list:
        return _print_codes(args.explain)
    if args.path is not None and args.bag is not None:
        args.verb_parser.error("give one path, or --bag, not both")
    path = args.path if args.path is not None else args.bag
    from tfloom.rmw.errors import WireError
    from tfloom.tf2_tools.diagnosis.report import Report, diagnose

    try:
        subject = _listened(args) if path is None else _read(path, args)
    except WireError as error:
        raise CommandError(str(error), UNUSABLE) from None
    limits = Limits(**{field: getattr(args, field) for field, _, _ in LIMIT_OPTIONS.values()})
    origin = "the graph" if path is None else str(path)
    report = Report(subject, diagnose(subject, limits, args.ignore), origin, args.strict)
    if args.json:
        from tfloom.cli.shared.listing import print_json

        print_json(report.as_dict())
    else:
        _print_text(report)
    return report.exit_code


def _listened(args: argparse.Namespace) -> Subject:
    from tfloom.cli.shared.graph import settled_participant
    from tfloom.tf2_tools.diagnosis.live import listen

    with settled_participant(args.spin_time) as participant:
        if sys.stderr.isatty():
            report(f"listening for {args.seconds:g} s; Ctrl-C ends it")
        return listen(participant, args.seconds, with_topics=args.topics, topics=_topics(args))


def _read(path: Path, args: argparse.Namespace) -> Subject:
    from tfloom.bag.errors import BagError
    from tfloom.tf2_tools.diagnosis.recorded import read
    from tfloom.tf2_tools.static_file import StaticFileError

    try:
        return read(path, with_topics=args.topics, topics=_topics(args))
    except (BagError, StaticFileError) as error:
        raise CommandError(str(error), UNUSABLE) from None
    except OSError as error:
        raise CommandError(f"{path}: {error.strerror}", UNUSABLE) from None


def _topics(args: argparse.Namespace) -> tuple[str, str]:
    return full_topic_name(args.tf_topic), full_topic_name(args.tf_static_topic)


def _print_codes(code: str | None) -> int:
    from tfloom.tf2_tools.diagnosis.report import explanation

    if code is not None:
        print(explanation(KINDS[code]))
    else:
        for kind in KINDS.values():
            print(f"{kind.code}  {kind.severity.value:<7}  {kind.title}")
    return 0


def _print_text(report: Report) -> None:
    from tfloom.tf2_tools.diagnosis.report import MAX_WIDTH

    columns = shutil.get_terminal_size().columns if sys.stdout.isatty() else MAX_WIDTH
    print(report.head())
    for code, group in groupby(report.findings, key=lambda finding: finding.code):
        findings = list(group)
        for finding in findings[:MAX_FINDINGS_OF_CODE]:
            _print_finding(finding, max(columns, MIN_WIDTH))
        if len(findings) > MAX_FINDINGS_OF_CODE:
            print(f"\n{code}: and {len(findings) - MAX_FINDINGS_OF_CODE} more; `--json` has all")
    print(f"\n{report.end()}")


def _print_finding(finding: Finding, columns: int) -> None:
    from tfloom.tf2_tools.diagnosis.report import body

    lines = body(finding, columns)
    print()
    print(_coloured(finding.code, finding.kind.severity), end=" ", file=unescaped(sys.stdout))
    print(f"{finding.kind.severity.value}: {next(lines)}")
    for line in lines:
        print(line)


def _coloured(text: str, severity: Severity) -> str:
    if sys.stdout.isatty() and "NO_COLOR" not in os.environ:
        return f"\033[{COLOURS[severity]}m{text}\033[0m"
    return text


def _code(text: str) -> str:
    if text.upper() not in KINDS:
        raise argparse.ArgumentTypeError(f"there is no code {text!r}; `--list` prints all")
    return text.upper()
