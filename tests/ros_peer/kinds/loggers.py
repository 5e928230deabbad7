"""Loggers: levels by name, and which calls with filters are logged."""

from __future__ import annotations

import functools
import random
from collections.abc import Callable
from typing import Any

NAMES = ["a", "a.b", "a.b.c", "a.bc", "b", "é", "a..b"]
SEVERITIES = ["UNSET", "DEBUG", "INFO", "WARN", "ERROR", "FATAL"]
METHODS = ["debug", "info", "warning", "warn", "error", "fatal"]
PLACES = 3


# Differences on purpose


def rows_of(case: Any, theirs: Any, ours: Any) -> set[str | None]:
    """Return the rows of docs/deviations.md that explain the differences of an answer; None for what none explains."""
    if not isinstance(theirs, list) or not isinstance(ours, list) or len(theirs) != len(ours):
        return {None}
    rows: set[str | None] = set()
    fetched = set()
    changed = set()  # places whose first call without filters counts there
    for step, there, here in zip(case["steps"], theirs, ours, strict=True):
        if step[0] != "log":
            rows |= set() if there == here else {None}
            continue
        _, way, name, place, method, options = step
        method = method.replace("warning", "warn")
        if way == "each" and options:
            fetched.add((name, place, method))
        if there == here:
            continue
        if there == "error ValueError" and here in (True, False):
            rows.add("node-log-place")
            changed.add((name, place))
        elif here == "error ValueError" and there in (True, False) and (name, place) in changed:
            rows.add("node-log-place")
        elif not {type(there), type(here)} <= {bool}:
            rows.add(None)
        elif "throttle_duration_sec" in options:
            rows.add("node-log-period")
        else:
            rows.add("node-log-names" if (name, place, method) in fetched else None)
    return rows


def explains(row: str, case: Any, theirs: Any, ours: Any) -> bool:
    rows = rows_of(case, theirs, ours)
    return None not in rows and row in rows


KNOWN = {
    row: functools.partial(explains, row) for row in ["node-log-place", "node-log-period", "node-log-names"]
}


# Drawing


def draw(random: random.Random) -> Any:
    """Return the steps of a program with loggers."""
    return {
        "prefix": f"p{random.randrange(10**9)}",
        "steps": [drawn_step(random) for _ in range(random.randint(2, 14))],
    }


def drawn_step(random: random.Random) -> list[Any]:
    name = random.choice(NAMES)
    roll = random.random()
    if roll < 0.15:
        return ["set", name, random.choice(SEVERITIES)]
    if roll < 0.25:
        return ["get", name]
    if roll < 0.3:
        return ["time", random.choice([0, 1, 2, 5, 60, 100])]
    options: dict[str, Any] = {}
    if random.random() < 0.3:
        options["once"] = random.choice([True, True, False])
    if random.random() < 0.2:
        options["skip_first"] = random.choice([True, True, False])
    if random.random() < 0.25:
        options["throttle_duration_sec"] = random.choice([0, 1, 2.5, 60])
        if random.random() < 0.7:
            options["throttle_time_source_type"] = random.choice(["clock"] * 5 + ["text"])
    if random.random() < 0.03:
        options["unknown"] = 1
    # Few names and places, so that calls meet.
    return [
        "log",
        random.choice(["one", "one", "each"]),
        random.choice(NAMES[:3]),
        random.randrange(PLACES),
        random.choice(METHODS),
        options,
    ]


# Running


def run(case: Any) -> Any:
    """Do the steps, and return what each gave."""
    import rclpy.logging
    from rclpy.clock import ClockType, ROSClock
    from rclpy.logging import LoggingSeverity
    from rclpy.time import Time

    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    kept: dict[str, Any] = {}

    def full(name: str) -> str:
        return f"{case['prefix']}.{name}" if name else ""

    def logger(way: str, name: str) -> Any:
        fetched = rclpy.logging.get_logger(full(name))
        return kept.setdefault(name, fetched) if way == "one" else fetched

    def do(step: list[Any]) -> Any:
        what, *rest = step
        if what == "time":
            clock.set_ros_time_override(Time(seconds=rest[0], clock_type=ClockType.ROS_TIME))
            return None
        if what == "set":
            return rclpy.logging.set_logger_level(full(rest[0]), LoggingSeverity[rest[1]])
        if what == "get":
            found = logger("each", rest[0])
            return [found.get_effective_level().name, found.is_enabled_for(LoggingSeverity.INFO)]
        way, name, place, method, options = rest
        source = options.get("throttle_time_source_type")
        if source == "clock":
            options = {**options, "throttle_time_source_type": clock}
        return CALLS[place](getattr(logger(way, name), method), options)

    return [outcome(functools.partial(do, step)) for step in case["steps"]]


# Each is its own place.
CALLS: list[Callable[[Any, Any], Any]] = [
    lambda log, options: log("first", **options),
    lambda log, options: log("second", **options),
    lambda log, options: log("third", **options),
]


def outcome(call: Callable[[], Any]) -> Any:
    """Return what a call returns, or the class of its error."""
    try:
        return call()
    except Exception as error:  # noqa: BLE001
        return next(f"error {cls.__name__}" for cls in type(error).__mro__ if cls.__module__ == "builtins")
