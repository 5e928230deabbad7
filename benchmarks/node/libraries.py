"""Measure nodes with each libddsc of this machine, in turns: `python -m benchmarks.node.libraries [PATH ...]`.

Paths are measured in place of those that are found. The first library is what the others are compared with.
"""

from __future__ import annotations

import argparse
import os
import sys
from statistics import median

from benchmarks.node import listener, round_trip
from tfloom._native import open_dds_library
from tfloom.rmw.cyclone.library import VARIABLE, candidates

TURNS = 3
LISTENED = ((50, 100), (1, 1000))
"""Transforms of a message, and messages a second."""


def measure(path: str) -> dict[str, float]:
    """Return the figures of one turn with a library, by what they are of."""
    os.environ[VARIABLE] = path  # the processes of a measurement inherit it
    figures = {}
    for name, kind, way in (
        ("a String", "String", "spin_once"),
        ("a service call", "service", "call_async"),
    ):
        trip = round_trip.measure(kind, way, ("tfloom",))["tfloom"]
        figures[f"{name} to another process and back, p50 [us]"] = trip.p50_us
        figures[f"{name}, p99 [us]"] = trip.p99_us
    for transforms, rate_hz in LISTENED:
        taken = listener.measure(transforms, rate_hz, ("tfloom",))["tfloom"]
        figures[f"a TransformListener, {rate_hz} Hz x {transforms} [% of a core]"] = taken.percent
    return figures


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node.libraries", description=__doc__)
    parser.add_argument("paths", nargs="*", metavar="PATH")
    paths = parser.parse_args().paths or list(dict.fromkeys(path for _, path in candidates()))
    versions = {path: open_dds_library(path) or "of unknown version" for path in paths}
    turns = {path: [] for path in paths}
    for _ in range(TURNS):
        for path in paths:
            turns[path].append(measure(path))
    first = paths[0]
    print(f"{'libddsc':<56}" + "".join(f"{versions[path]:>10}" for path in paths) + f"{'ratio':>7}")
    for what in turns[first][0]:
        values = [median(turn[what] for turn in turns[path]) for path in paths]
        ratios = "".join(f"{value / values[0]:>7.2f}" for value in values[1:])
        print(f"  {what:<54}" + "".join(f"{value:>10.1f}" for value in values) + ratios)
    return 0


if __name__ == "__main__":
    sys.exit(main())
