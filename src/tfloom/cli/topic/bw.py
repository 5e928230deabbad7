"""Print the bandwidth of a topic, or of several."""

from __future__ import annotations

import argparse
from functools import partial

from tfloom.cli.topic import rates
from tfloom.rmw.base import Sample
from tfloom.rosidl.message import Message

UNITS = {"MB": (1e6, 2), "KB": (1e3, 2), "B": (1.0, 0)}
"""Size [bytes] and decimals of each unit."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic bw`."""
    rates.add_arguments(parser, window=100)
    rates.add_topics(parser, "topic")


def main(args: argparse.Namespace) -> int:
    """Print the bandwidth each second, until Ctrl-C; of several topics, a table."""
    names = rates.topics_of(args)
    arrived: dict[str, _Arrived] = {}

    def on_sample(name: str, sample: Sample, _: type[Message], came_s: float) -> None:
        arrived.setdefault(name, _Arrived(args.window)).add(len(sample.data), came_s)

    if len(names) != 1:
        rates.watch_several(args, names, on_sample, lambda now_s: _table(arrived, now_s))
        return 0
    (name,) = names

    def report(now_s: float) -> None:
        if name in arrived and (sizes := arrived[name].take()):
            print(bandwidth_text(sizes, now_s - arrived[name].since_s))

    print(f"Subscribed to [{name}]")
    rates.watch(args, name, partial(on_sample, name), report)
    return 0


class _Arrived:
    """The sizes [bytes] and times [s] of a topic's newest messages."""

    def __init__(self, window: int) -> None:
        self._sizes = rates.Window(window)
        self._times = rates.Window(window)

    def add(self, size: int, came_s: float) -> None:
        """Add a message."""
        if self._times.is_beyond(came_s):
            self._times.values.clear()
            self._sizes.values.clear()
        self._sizes.add(size)
        self._times.add(came_s)

    @property
    def since_s(self) -> float:
        """Time of the oldest message [s]."""
        return self._times.values[0]

    def take(self) -> list[float]:
        """Return the sizes; none if there are fewer than two, or nothing new since the last call."""
        if len(self._sizes.values) < 2 or not self._sizes.is_new:
            return []
        self._sizes.is_new = False
        return list(self._sizes.values)


def _table(arrived: dict[str, _Arrived], now_s: float) -> list[str]:
    """Return a line for each topic that has had messages since the last table."""
    rows = []
    for name, messages in sorted(arrived.items()):
        if sizes := messages.take():
            numbers = _numbers(sizes, now_s - messages.since_s)
            rows.append([name, f"{numbers[0]}/s", f"{len(sizes)}", *numbers[1:]])
    if not rows:
        return ["no new messages"]
    return rates.table_lines(["topic", "bandwidth", "messages", "mean", "min", "max"], rows)


def bandwidth_text(sizes: list[float], duration_s: float) -> str:
    """Return the two lines on messages of these sizes [bytes] in a time [s]; the rate determines the unit."""
    rate, mean, least, greatest = _numbers(sizes, duration_s)
    return f"{rate}/s from {len(sizes)} messages\n\tMessage size mean: {mean} min: {least} max: {greatest}"


def _numbers(sizes: list[float], duration_s: float) -> tuple[str, ...]:
    """Return bandwidth, mean, least and greatest size, each with the unit."""
    mean, least, greatest, _ = rates.spread(sizes)
    per_second = sum(sizes) / duration_s if duration_s > 0 else float("inf")
    unit = next(unit for unit, (size, _) in UNITS.items() if per_second >= size or unit == "B")
    size, digits = UNITS[unit]
    return tuple(f"{value / size:.{digits}f} {unit}" for value in (per_second, mean, least, greatest))
