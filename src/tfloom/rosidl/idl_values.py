"""Constant expressions of IDL: literals, names of constants, and arithmetic with them."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TypeAlias

IdlValue: TypeAlias = bool | int | float | str

LEVELS: tuple[tuple[str, ...], ...] = (("|",), ("^",), ("&",), ("<<", ">>"), ("+", "-"), ("*", "/", "%"))
"""The operators between two operands, from those that bind least to those that bind most."""
_MAX_SHIFT = 63
_RANGE = range(-(2**63), 2**64)

_ESCAPE = re.compile(r"\\(?:x([0-9a-fA-F]{1,2})|([0-7]{1,3})|u([0-9a-fA-F]{1,4})|(.))")
_LETTERS = {"n": "\n", "t": "\t", "v": "\v", "b": "\b", "r": "\r", "f": "\f", "a": "\a"}


def _quotient(left: int, right: int) -> int:
    """Return the quotient, rounded towards zero as C++ does."""
    quotient = abs(left) // abs(right)
    return quotient if (left < 0) == (right < 0) else -quotient


_INTEGERS: dict[str, Callable[[int, int], int]] = {
    "|": lambda a, b: a | b,
    "^": lambda a, b: a ^ b,
    "&": lambda a, b: a & b,
    "<<": lambda a, b: a << b,
    ">>": lambda a, b: a >> b,
    "%": lambda a, b: a - b * _quotient(a, b),
    "/": _quotient,
}
_NUMBERS: dict[str, Callable[[float, float], float]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
}


def parse_integer(text: str) -> int:
    """Return the integer of a literal: decimal, octal `017` or hexadecimal `0x1F`.

    Raises:
        ValueError: it is not one, or has more than 64 bits.
    """
    if text[:2] in {"0x", "0X"}:
        return _bounded(int(text, 16))
    if text[0] == "0" and len(text) > 1:
        try:
            return _bounded(int(text, 8))
        except ValueError:
            raise ValueError(
                f"'{text}' is not octal: an integer that starts with 0 has the digits 0 to 7"
            ) from None
    return _bounded(int(text) if len(text) < 30 else 2**64)


def parse_string(text: str) -> str:
    """Return the string of a literal in its quotes, with its escape sequences replaced."""
    is_wide = text.startswith("L")

    def letter(match: re.Match[str]) -> str:
        hexadecimal, octal, unicode, plain = match.groups()
        if unicode is not None and not is_wide:
            return match[0]
        if plain is not None:
            return _LETTERS.get(plain, plain)
        return chr(int(octal, 8) if octal is not None else int(hexadecimal or unicode, 16))

    return _ESCAPE.sub(letter, text[2 if is_wide else 1 : -1])


def combine(operator: str, left: IdlValue, right: IdlValue) -> IdlValue:
    """Return the value of two operands.

    Raises:
        ValueError: they have none; the text has the reason.
    """
    if isinstance(left, (bool, str)) or isinstance(right, (bool, str)):
        raise ValueError(f"'{operator}' combines numbers only")  # noqa: TRY004  # a mistake in a text
    if operator in {"/", "%"} and right == 0:
        raise ValueError("a division by zero")
    if isinstance(left, int) and isinstance(right, int):
        if operator in {"<<", ">>"} and not 0 <= right <= _MAX_SHIFT:
            raise ValueError(f"a shift is by 0 to {_MAX_SHIFT} bits, not by {right}")
        if operator in _INTEGERS:
            return _bounded(_INTEGERS[operator](left, right))
        return _bounded(int(_NUMBERS[operator](left, right)))
    if operator not in _NUMBERS:
        raise ValueError(f"'{operator}' combines integers only")
    return float(_NUMBERS[operator](left, right))


def apply_sign(operator: str, value: IdlValue) -> IdlValue:
    """Return the value of `-`, `+` or `~` before an operand.

    Raises:
        ValueError: it has none; the text has the reason.
    """
    if isinstance(value, (bool, str)) or (operator == "~" and not isinstance(value, int)):
        raise ValueError(
            f"'{operator}' is followed by {'an integer' if operator == '~' else 'a number'} only"
        )
    if operator == "~":
        return ~int(value)
    return -value if operator == "-" else value


def _bounded(value: int) -> int:
    if value not in _RANGE:
        raise ValueError("an integer has 64 bits at most")
    return value
