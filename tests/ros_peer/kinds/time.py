"""Time: Time, Duration, their arithmetic with numbers of every class, and clocks that jump."""

from __future__ import annotations

import functools
import json
import math
import operator
import random
import warnings
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

NUMPY = [
    *(f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)),
    *("float16", "float32", "float64", "longdouble", "bool_"),
]
LIMIT = 2**63
OPERATORS = ["add", "sub", "lt", "le", "gt", "ge", "eq", "ne"]
CLOCK_TYPES = ["ROS_TIME", "SYSTEM_TIME", "STEADY_TIME"]


# Differences on purpose


def rows_of(case: Any, theirs: Any, ours: Any) -> set[str | None]:
    """Return the rows of docs/deviations.md that explain the differences of an answer; None for what none explains."""
    if case["what"] == "timeout":
        return {timeout_row(case, theirs, ours)}
    if case["what"] == "operation" and is_sum_of_durations(case, theirs, ours):
        return {"node-duration-sums"}
    if "np." in repr(case):
        # A number of numpy has the answer of the number of Python that it stands for.
        return {"node-number-widths" if json.loads(json.dumps(run(plain(case)))) == ours else None}
    return {None}


def is_sum_of_durations(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether both answers are equal but for the sum of two durations, which Jazzy's refuse."""
    kinds, operation = (case["left"][0], case["right"][0]), case["operator"]
    if kinds != ("Duration", "Duration") or operation not in {"add", "sub"}:
        return False
    if {**ours, "result": None} != {**theirs, "result": None} or theirs["result"] != "error TypeError":
        return False
    left, right = (int(ours[side][1].partition("=")[2].rstrip(")")) for side in ("left", "right"))
    total = getattr(operator, operation)(left, right)
    expected = (
        ["Duration", f"Duration(nanoseconds={total})"] if -LIMIT <= total < LIMIT else "error OverflowError"
    )
    return bool(ours["result"] == expected)


def timeout_row(case: Any, theirs: Any, ours: Any) -> str | None:
    is_long = theirs == "error OverflowError" or (theirs[0] == "int" and int(theirs[1]) >= LIMIT - 1024)
    if is_long and ours == ["int", "-1"]:
        return "node-long-timeouts"
    return "node-number-widths" if "np." in case["seconds"][0] else None


def plain(spec: Any) -> Any:
    """Return a case whose numbers of numpy are Python's."""
    if isinstance(spec, dict):
        return {name: plain(part) for name, part in spec.items()}
    if not isinstance(spec, list) or spec[:1] == ["number"]:
        return spec
    if spec and isinstance(spec[0], str) and spec[0].startswith("np."):
        held = number(spec)
        return ["int", str(int(held))] if "int" in spec[0] or "bool" in spec[0] else ["float", float(held)]
    return [plain(part) for part in spec]


def explains(row: str, case: Any, theirs: Any, ours: Any) -> bool:
    rows = rows_of(case, theirs, ours)
    return None not in rows and row in rows


ROWS = ["node-number-widths", "node-long-timeouts", "node-duration-sums"]
KNOWN = {row: functools.partial(explains, row) for row in ROWS}


# Drawing


def draw(random: random.Random) -> Any:
    """Return a case: two values and an operation of both; a value of a message; or a clock's life."""
    what = random.choice(["operation"] * 6 + ["message", "timeout", "clock"])
    if what == "timeout":
        return {"what": what, "seconds": drawn_number(random)}
    if what == "clock":
        steps = [drawn_step(random) for _ in range(random.randint(1, 6))]
        thresholds = [drawn_threshold(random) for _ in range(2)]
        return {"what": what, "thresholds": thresholds, "steps": steps}
    if what == "message":
        kind = random.choice(["Time", "Duration"])
        return {
            "what": what,
            "kind": kind,
            "sec": drawn_number(random),
            "nanosec": drawn_number(random),
            "clock": random.choice(CLOCK_TYPES),
        }
    return {
        "what": what,
        "left": drawn_value(random),
        "right": drawn_value(random),
        "operator": random.choice(OPERATORS),
    }


def drawn_value(random: random.Random) -> Any:
    if random.random() < 0.1:
        return ["number", drawn_number(random)]
    kind = random.choice(["Time", "Duration"])
    parts = {name: drawn_number(random) for name in ("seconds", "nanoseconds") if random.random() < 0.7}
    clock = random.choice(CLOCK_TYPES) if random.random() < 0.3 else "SYSTEM_TIME"
    return [kind, parts, clock]


def drawn_number(random: random.Random) -> list[Any]:
    whole = [
        0,
        1,
        2,
        5,
        -1,
        100,
        127,
        128,
        2**31 - 1,
        2**31,
        LIMIT - 1,
        LIMIT,
        -LIMIT,
        9223372036,
        9223372037,
        10**400,
    ]
    broken = [
        0.0,
        -0.0,
        0.1,
        0.5,
        1.5,
        -0.25,
        1e-9,
        1e-10,
        4.999999999,
        1e9,
        1e10,
        1e300,
        math.inf,
        -math.inf,
        math.nan,
    ]
    # No texts, bytes and lists, which the real one repeats 1e9 times.
    others = [["None"], ["complex", "1j"], ["Fraction", "1/3"], ["Decimal", "0.1"]]
    roll = random.random()
    if roll < 0.08:
        return random.choice(others)
    if roll < 0.45:
        number = random.choice(whole) if random.random() < 0.7 else random.randint(-(10**12), 10**12)
        return ["int", str(number)]
    if roll < 0.75:
        return ["float", random.choice(broken) if random.random() < 0.7 else random.uniform(-1e6, 1e6)]
    name = random.choice(NUMPY)
    if "float" in name or name == "longdouble":
        return [f"np.{name}", random.choice(broken)]
    return [f"np.{name}", random.choice([0, 1, 2, 5, 100, 127])]


def drawn_step(random: random.Random) -> list[Any]:
    if random.random() < 0.2:
        return ["active", random.choice([True, False])]
    return ["time", random.choice([0, 1, 5, 10**9, 5 * 10**9, random.randint(0, 10**10)])]


def drawn_threshold(random: random.Random) -> list[Any]:
    sizes = [None, 1, -1, 0, 10**9, -(10**9), 10**10]
    return [random.choice(sizes), random.choice(sizes), random.choice([True, False])]


# Running


MAKERS: dict[str, Callable[..., Any]] = {
    "int": int,
    "float": float,
    "None": lambda: None,
    "complex": complex,
    "Fraction": Fraction,
    "Decimal": Decimal,
}


def number(spec: list[Any]) -> Any:
    """Return the number that was drawn."""
    name, *rest = spec
    if name.startswith("np."):
        import numpy as np

        with np.errstate(all="ignore"):
            return getattr(np, name[3:])(*rest)
    return MAKERS[name](*rest)


def value(spec: list[Any]) -> Any:
    """Return the Time, Duration or number that was drawn."""
    from rclpy.clock import ClockType
    from rclpy.duration import Duration
    from rclpy.time import Time

    kind, parts, *clock = spec
    if kind == "number":
        return number(parts)
    numbers = {name: number(part) for name, part in parts.items()}
    if kind == "Duration":
        return Duration(**numbers)
    return Time(**numbers, clock_type=ClockType[clock[0]])


def run(case: Any) -> Any:
    """Compute what the case says."""
    warnings.simplefilter("ignore")
    return {"operation": run_operation, "message": run_message, "timeout": run_timeout, "clock": run_clock}[
        case["what"]
    ](case)


def run_operation(case: Any) -> Any:
    left, right = outcome(lambda: value(case["left"])), outcome(lambda: value(case["right"]))
    answer = {"left": shown(left), "right": shown(right)}
    if "error" in f"{left}{right}":
        return answer
    answer["result"] = shown(outcome(lambda: getattr(operator, case["operator"])(left, right)))
    answer["same"] = outcome(lambda: bool(left == value(case["left"])))
    if hasattr(left, "to_msg"):
        answer["message"] = outcome(lambda: repr(left.to_msg()))
        answer["from the message"] = outcome(lambda: shown(type(left).from_msg(left.to_msg())))
    if hasattr(left, "seconds_nanoseconds"):
        answer["parts"] = outcome(lambda: str(left.seconds_nanoseconds()))
    return answer


def run_message(case: Any) -> Any:
    from builtin_interfaces import msg
    from rclpy.clock import ClockType
    from rclpy.duration import Duration
    from rclpy.time import Time

    message = getattr(msg, case["kind"])(sec=number(case["sec"]), nanosec=number(case["nanosec"]))
    if case["kind"] == "Time":
        return outcome(lambda: shown(Time.from_msg(message, clock_type=ClockType[case["clock"]])))
    return outcome(lambda: shown(Duration.from_msg(message)))


def run_timeout(case: Any) -> Any:
    from rclpy.utilities import timeout_sec_to_nsec

    return shown(outcome(lambda: timeout_sec_to_nsec(number(case["seconds"]))))


def run_clock(case: Any) -> Any:
    from rclpy.clock import ClockType, JumpThreshold, ROSClock
    from rclpy.duration import Duration
    from rclpy.time import Time

    clock = ROSClock()
    heard: list[Any] = []
    handles = []  # which the clock of the real one doesn't keep

    def in_ns(size: int | None) -> Any:
        return None if size is None else Duration(nanoseconds=size)

    def register(index: int, forward: int | None, backward: int | None, on_change: bool) -> Any:
        threshold = JumpThreshold(
            min_forward=in_ns(forward), min_backward=in_ns(backward), on_clock_change=on_change
        )
        handles.append(
            clock.create_jump_callback(
                threshold,
                pre_callback=lambda: heard.append([index, "before"]),
                post_callback=lambda jump: heard.append([index, int(jump.clock_change), size_of(jump)]),
            )
        )
        return "registered"

    def size_of(jump: Any) -> Any:
        # From and to the system's time it differs in each run.
        return jump.delta.nanoseconds if abs(jump.delta.nanoseconds) < 10**17 else "far"

    registered = [
        outcome(functools.partial(register, index, *each)) for index, each in enumerate(case["thresholds"])
    ]
    times = []
    for what, argument in case["steps"]:
        if what == "active":
            clock._set_ros_time_is_active(argument)
        else:
            clock.set_ros_time_override(Time(nanoseconds=argument, clock_type=ClockType.ROS_TIME))
        now_ns = clock.now().nanoseconds
        times.append([clock.ros_time_is_active, now_ns if now_ns < 10**17 else "far"])
    return {"registered": registered, "heard": heard, "times": times}


def shown(thing: Any) -> Any:
    """Return a value with its type, as text."""
    return thing if isinstance(thing, str) else [type(thing).__name__, repr(thing)]


def outcome(call: Callable[[], Any]) -> Any:
    """Return what a call returns, or the class of its error."""
    try:
        return call()
    except Exception as error:  # noqa: BLE001
        return next(f"error {cls.__name__}" for cls in type(error).__mro__ if cls.__module__ == "builtins")
