"""Measure where the CPU time of a round trip goes: `python -m benchmarks.node.budget [--svg FILE]`.

The processes of `round_trip` run, one message or call in flight, and `perf` samples both of them meanwhile. Each sample
is counted for the binary in which it was taken: the kernel, the DDS library, Python, or tfloom's extension. The rest of
the time of a trip is waiting: for the other process, and for the processor.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median
from typing import NamedTuple
from xml.sax.saxutils import escape

from benchmarks.node.round_trip import Pair

START_S = 0.5
"""Time that perf takes to attach."""
MEASURED_S = 3.0
KINDS = {"a String there and back": ("String", "spin_once"), "a service call": ("service", "call_async")}
PARTS = {
    "kernel": ("[kernel", "[vdso]", "[unknown]"),
    "libddsc": ("ddsc",),
    "tfloom's C++": ("_native",),
    "Python": ("",),
}
"""Texts in the names of a part's binaries, of which the first match counts: the last part is all others, with libc."""


class Budget(NamedTuple):
    """Times of a trip [us]."""

    trip: float
    """By the clock, p50."""
    asking: dict[str, float]
    """CPU time of the asking process, by part."""
    answering: dict[str, float]


def part_of(binary: str) -> str:
    """Return the part to which a binary belongs."""
    return next(part for part, names in PARTS.items() if any(name in binary for name in names))


def shares(recording: Path) -> dict[str, float]:
    """Return the share of each part in a recording of perf."""
    command = ["perf", "report", "-i", recording, "--sort", "dso", "--stdio", "-q", "-t", "|"]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    share_of = dict.fromkeys(PARTS, 0.0)
    for line in filter(None, map(str.strip, text.splitlines())):
        percent, _, binary = line.partition("|")
        share_of[part_of(binary.strip())] += float(percent.rstrip("% ")) / 100
    total = sum(share_of.values())
    if not 0.9 < total < 1.1:
        raise RuntimeError(f"the parts of perf's report are {total:.0%} of its samples")
    return share_of


def record(process: subprocess.Popen[str], recording: Path) -> subprocess.Popen[bytes]:
    """Start perf on a process."""
    command = ["perf", "record", "-q", "-F", "5000", "-o", str(recording), "-p", str(process.pid)]
    return subprocess.Popen(command, stderr=subprocess.DEVNULL)


def cpu_us(process: subprocess.Popen[str]) -> float:
    """Return the CPU time of a process, all threads, in user mode and in the kernel [us]."""
    fields = Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK") * 1e6


def measure(kind: str, way: str) -> Budget:
    """Return the budget of a kind of trips, as in `round_trip.measure`."""
    with contextlib.ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        pair = Pair("tfloom", kind, way, stack)
        pair.measure()
        pair.turns_us.clear()
        processes = (pair.asking, pair.answering)
        recordings = [folder / "asking", folder / "answering"]
        recorders = [
            record(process, recording) for process, recording in zip(processes, recordings, strict=True)
        ]
        time.sleep(START_S)
        before = [cpu_us(process) for process in processes]
        end = time.monotonic() + MEASURED_S
        while time.monotonic() < end:
            pair.measure()
        after = [cpu_us(process) for process in processes]
        for recorder in recorders:
            recorder.terminate()
            recorder.wait()
        times_us = [time_us for turn in pair.turns_us for time_us in turn]
        trips = len(times_us)
        asking, answering = (
            {part: share * (used - unused) / trips for part, share in shares(recording).items()}
            for recording, used, unused in zip(recordings, after, before, strict=True)
        )
        return Budget(median(times_us), asking, answering)


def table(name: str, budget: Budget) -> str:
    """Return the rows of a kind."""
    rows = [
        f"{name}: {budget.trip:.0f} us by the clock, p50",
        f"  {'CPU [us]':<16}{'asking':>10}{'answering':>12}",
    ]
    rows += [f"  {part:<16}{budget.asking[part]:>10.1f}{budget.answering[part]:>12.1f}" for part in PARTS]
    sums = sum(budget.asking.values()), sum(budget.answering.values())
    return "\n".join([*rows, f"  {'sum':<16}{sums[0]:>10.1f}{sums[1]:>12.1f}"])


COLOURS = {"kernel": "#4a6fa5", "libddsc": "#8fb8de", "tfloom's C++": "#e8a33d", "Python": "#c4c4c4"}
LIGHT_TEXT = ("kernel",)
"""The parts with colours that need white digits."""
CLOCK_COLOUR = "#c0392b"
WIDTH_PX, BAR_PX, LEFT_PX, RIGHT_PX = 800, 560, 170, 780
LEGEND_PX, GROUP_PX, ROW_PX, THICK_PX, AXIS_PX = 34, 96, 28, 24, 44
"""Heights: of the legend, of a kind of trips, of the distance between its bars, of a bar, of the axis."""
DIGIT_PX, MARGIN_PX = 8.3, 2.0
END = 'text-anchor="end"'


def text(x: float, y: float, content: str, style: str = "") -> str:
    """Return the SVG of a text with its base line at `y`."""
    return f'<text x="{x:.1f}" y="{y:.1f}"{f" {style}" if style else ""}>{escape(content)}</text>'


def legend() -> list[str]:
    """Return the names of the colours and of the line, in a row."""
    lines = []
    x = 14.0
    for part, colour in COLOURS.items():
        lines.append(f'<rect x="{x:.1f}" y="12" width="14" height="14" fill="{colour}"/>')
        lines.append(text(x + 20, 24, part))
        x += 20 + 8 * len(part) + 24
    lines.append(clock_line(x + 7, 9, 29))
    lines.append(text(x + 20, 24, "a trip by the clock, p50; the bars are CPU time"))
    return lines


def clock_line(x: float, top: float, bottom: float) -> str:
    return (
        f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{top}" y2="{bottom}" stroke="{CLOCK_COLOUR}" stroke-width="2"/>'
    )


def bar(y: float, side: str, parts: dict[str, float], clock: float, px_per_us: float) -> list[str]:
    """Return the parts of a process one after the other, each with its digits if they fit, and their sum.

    Digits are in the middle of their part, or of what the line at `clock` leaves of it on one side.
    """
    lines = [text(LEFT_PX - 10, y + 17, side, END)]
    x = float(LEFT_PX)
    for part, colour in COLOURS.items():
        length = parts[part] * px_per_us
        lines.append(
            f'<rect x="{x:.1f}" y="{y}" width="{length:.1f}" height="{THICK_PX}" fill="{colour}" stroke="white"/>'
        )
        digits = f"{parts[part]:.0f}"
        cut = min(max(clock, x), x + length)
        begin, end = max((x, cut), (cut, x + length), key=lambda piece: piece[1] - piece[0])
        if end - begin >= DIGIT_PX * len(digits) + 2 * MARGIN_PX:
            fill = ' fill="white"' if part in LIGHT_TEXT else ""
            lines.append(text((begin + end) / 2, y + 17, digits, f'text-anchor="middle"{fill}'))
        x += length
    return [*lines, text(RIGHT_PX, y + 17, f"{sum(parts.values()):.0f} µs", END)]


def axis(y: float, most_us: float, px_per_us: float) -> list[str]:
    """Return a line with ticks at round numbers, at most eight of them."""
    step = next(
        candidate
        for candidate in (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 10**6)
        if most_us / candidate <= 8
    )
    lines = [f'<line x1="{LEFT_PX}" x2="{LEFT_PX + BAR_PX}" y1="{y}" y2="{y}" stroke="#666666"/>']
    for us in range(0, int(most_us) + 1, step):
        x = LEFT_PX + us * px_per_us
        lines.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{y}" y2="{y + 5}" stroke="#666666"/>')
        lines.append(text(x, y + 19, str(us), 'text-anchor="middle"'))
    return [*lines, text(LEFT_PX - 10, y + 19, "µs", END), text(RIGHT_PX, y + 19, "sum", END)]


def drawing(budgets: dict[str, Budget]) -> str:
    """Return an SVG: a bar for each process, its CPU time of a trip by part, and the time of a trip by the clock."""
    most_us = max(
        max(sum(budget.asking.values()), sum(budget.answering.values()), budget.trip)
        for budget in budgets.values()
    )
    px_per_us = BAR_PX / most_us
    height = LEGEND_PX + GROUP_PX * len(budgets) + AXIS_PX
    font = 'font-family="DejaVu Sans, Verdana, sans-serif" font-size="13"'
    size = f'width="{WIDTH_PX}" height="{height}" viewBox="0 0 {WIDTH_PX} {height}"'
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} {font}>',
        '<rect width="100%" height="100%" fill="white"/>',
        *legend(),
    ]
    for index, (name, budget) in enumerate(budgets.items()):
        top = LEGEND_PX + index * GROUP_PX
        first = top + 36
        clock = LEFT_PX + budget.trip * px_per_us
        lines.append(text(14, top + 28, name, 'font-weight="bold"'))
        lines += bar(first, "asking process", budget.asking, clock, px_per_us)
        lines += bar(first + ROW_PX, "answering", budget.answering, clock, px_per_us)
        lines.append(clock_line(clock, first - 4, first + ROW_PX + THICK_PX + 3))
        lines.append(
            text(clock, first - 8, f"{budget.trip:.0f} µs", f'text-anchor="middle" fill="{CLOCK_COLOUR}"')
        )
    lines += axis(height - AXIS_PX + 12, most_us, px_per_us)
    return "\n".join([*lines, "</svg>", ""])


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node.budget", description=__doc__)
    parser.add_argument("--json", action="store_true", help="print the numbers as JSON")
    parser.add_argument("--svg", type=Path, metavar="FILE", help="draw the numbers")
    options = parser.parse_args()
    if shutil.which("perf") is None:
        print("the budget needs Linux's perf: apt-get install linux-perf", file=sys.stderr)
        return 1
    budgets = {name: measure(*kind) for name, kind in KINDS.items()}
    if options.svg is not None:
        options.svg.write_text(drawing(budgets), "utf-8")
    if options.json:
        print(json.dumps({name: budget._asdict() for name, budget in budgets.items()}, indent=1))
    else:
        print("\n".join(table(name, budget) for name, budget in budgets.items()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
