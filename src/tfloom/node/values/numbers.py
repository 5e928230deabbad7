"""What is said of a period, a rate or a timeout that is no number."""

from __future__ import annotations

from tfloom.given_text import given_text

__all__ = ["duration_error", "given_time", "no_time_of", "not_a_number", "timeout_error"]


def not_a_number(what: str, given: object) -> str:
    """Return what is needed, as `a period in seconds`, and what a program gave."""
    return f"needs {what}, as 0.5, got {given_text(given)}"


def no_time_of(name: str, seconds: object, nanoseconds: object) -> str:
    """Return which of the arguments of a Time or a Duration is no number."""
    if not hasattr(seconds, "__float__"):
        return f"{name} {not_a_number('seconds', seconds)}"
    given = given_text(nanoseconds)
    return f"{name} needs nanoseconds, as 500, got {given}"


def given_time(given: object) -> str:
    """Return the end of an error's text: what was given in place of a time's or a duration's message."""
    has_message = hasattr(given, "to_msg") and not isinstance(given, type)
    hint = ", which is one of rclpy: use it as it is" if has_message else ""
    return f", got {given_text(given)}{hint}"


def duration_error(needed: str, given: object) -> TypeError:
    """Return the error of what was given in place of a Duration; `needed` begins its text."""
    seconds = given if isinstance(given, (int, float)) else "…"
    return TypeError(
        f"{needed}, got {given!r} of class {type(given).__name__}: write Duration(seconds={seconds})"
    )


def timeout_error(call: str, timeout_sec: object) -> TypeError | None:
    """Return the error of a timeout [s] that `call` got and that is neither None nor a number; None if it is one."""
    if timeout_sec is None or hasattr(timeout_sec, "__float__"):
        return None
    nanoseconds = getattr(timeout_sec, "nanoseconds", None)
    meant = f": write {nanoseconds / 1e9:g}" if isinstance(nanoseconds, int) else ""
    return TypeError(f"{call}() {not_a_number('a timeout in seconds', timeout_sec)}{meant}")
