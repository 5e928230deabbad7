r"""CMake's regular expressions, in a time that grows with the text as its length.

Python's `re` is not a stand-in: it reads `a{2}` and `\d` as what they aren't in CMake, and it backtracks, so that
`(a+)+$` takes years on forty letters. An engine without that, such as RE2, would be one more compiled package in each
installation, for a language without counts, classes by name and back references. Its automaton is short enough to be
here: it is in all the states at once in which the text so far could have left it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from enum import Enum
from typing import NamedTuple

from tfloom.workspace.cmake_syntax import MAX_NESTED

__all__ = ["Expression", "RegexError"]

MAX_PATTERN = 10_000
"""Length of the longest expression [bytes]."""
_MOVE_COST = 8
"""What a move takes that isn't known yet, beside its states [steps]."""
_EVERY_BYTE = (1 << 256) - 1


class RegexError(ValueError):
    """A text isn't a regular expression; the error names it, and says why."""

    def __init__(self, pattern: str, reason: str) -> None:
        super().__init__(f"'{pattern[:80]}' isn't a regular expression: {reason}")


class _Kind(Enum):
    BYTES = "bytes"
    SEQUENCE = "sequence"
    EITHER = "either"
    REPEATED = "repeated"
    BEGIN = "begin"
    END = "end"


class _Node(NamedTuple):
    """A part of an expression."""

    kind: _Kind
    parts: tuple[_Node, ...] = ()
    accepted: int = 0
    """Of one byte: the bit of each value that matches."""
    sign: str = ""
    """How it is repeated: `*`, `+` or `?`."""
    has_width: bool = False
    """Whether it matches no empty text."""


class _State(NamedTuple):
    """A state of the automaton."""

    kind: _Kind
    accepted: int
    following: list[int]


_MATCH = 0
"""The state in which the expression has matched."""


class _Place:
    """The states in which a text may have left the automaton, with the moves from there that are known."""

    __slots__ = ("is_match", "moves", "states")

    def __init__(self, states: frozenset[int]) -> None:
        self.states = states
        self.is_match = _MATCH in states
        self.moves: dict[int, _Place] = {}


class Expression:
    """A compiled expression.

    Args:
        pattern: As CMake has it; UTF-8 is matched byte by byte, as there.
        count: Called with the steps that are taken, as they are taken; it may raise an error.

    Raises:
        RegexError: CMake would refuse it, or it is longer than `MAX_PATTERN`.
    """

    def __init__(self, pattern: str, count: Callable[[int], None]) -> None:
        data = pattern.encode("utf-8", "surrogatepass")
        if len(data) > MAX_PATTERN:
            raise RegexError(pattern, f"it has {len(data)} bytes, more than {MAX_PATTERN}")
        count(len(data))
        self._count = count
        self._states = [_State(_Kind.SEQUENCE, 0, [])]
        self._begin = self._add(_Parser(data).whole_expression(), _MATCH)
        # Places are kept with their moves, because most texts lead through the same few.
        self._places: dict[frozenset[int], _Place] = {}

    def is_found_in(self, text: str) -> bool:
        """Return whether a part of a text matches."""
        # All states that the text may have led to are followed at once, so each byte is read once, and no expression
        # takes exponential time. A set of states is a place; the move from it by a byte is computed the first time
        # only.
        place = self._place(self._closed([self._begin], at_begin=True))
        for byte in text.encode("utf-8", "surrogatepass"):
            if place.is_match:
                return True
            following = place.moves.get(byte)
            if following is None:
                following = place.moves[byte] = self._move(place.states, byte)
            place = following
        return _MATCH in self._closed(place.states, at_begin=not text, at_end=True)

    def _add(self, node: _Node, following: int) -> int:
        """Add the states of a part, which lead to a state in the end; return the first one."""
        if node.kind is _Kind.SEQUENCE:
            for part in reversed(node.parts):
                following = self._add(part, following)
            return following
        if node.kind is _Kind.EITHER:
            return self._add_state(node, [self._add(part, following) for part in node.parts])
        if node.kind is not _Kind.REPEATED:
            return self._add_state(node, [following])
        (part,) = node.parts
        if node.sign == "?":
            return self._add_state(node, [self._add(part, following), following])
        # The part leads back to the loop, which must exist first, so the way into the part is added afterwards.
        # `*` begins at the loop, from where the part may be left out; `+` begins in the part.
        loop = self._add_state(node, [following])
        first = self._add(part, loop)
        self._states[loop].following.append(first)
        return first if node.sign == "+" else loop

    def _add_state(self, node: _Node, following: list[int]) -> int:
        self._states.append(_State(node.kind, node.accepted, following))
        return len(self._states) - 1

    def _place(self, states: frozenset[int]) -> _Place:
        return self._places.setdefault(states, _Place(states))

    def _move(self, current: frozenset[int], byte: int) -> _Place:
        """Return the place after a byte; a match may also begin behind it."""
        # An expression is searched for, so it may begin at any byte: the first state is always among the reached ones.
        reached = [self._begin]
        for number in current:
            state = self._states[number]
            if state.accepted >> byte & 1:
                reached += state.following
        self._count(len(current) + _MOVE_COST)
        return self._place(self._closed(reached))

    def _closed(
        self, states: Iterable[int], *, at_begin: bool = False, at_end: bool = False
    ) -> frozenset[int]:
        """Return states with those that they lead to without a byte."""
        # A state of bytes waits for one. `^` and `$` are passed at an end of the text only; all others lead on at once.
        closed: set[int] = set()
        waiting = list(states)
        while waiting:
            number = waiting.pop()
            if number in closed:
                continue
            closed.add(number)
            state = self._states[number]
            if (
                state.kind is _Kind.BYTES
                or (state.kind is _Kind.BEGIN and not at_begin)
                or (state.kind is _Kind.END and not at_end)
            ):
                continue
            waiting += state.following
        self._count(len(closed))
        return frozenset(closed)


class _Parser:
    """A position in an expression."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0
        self._depth = 0

    def whole_expression(self) -> _Node:
        """Return the whole expression."""
        node = self._either()
        if self._at < len(self._data):
            raise self._error("a ')' has no '('")
        return node

    def _error(self, reason: str) -> RegexError:
        return RegexError(self._data.decode("utf-8", "replace"), reason)

    def _next(self) -> bytes:
        """Return the next byte; none at the end."""
        return self._data[self._at : self._at + 1]

    def _take(self) -> int:
        self._at += 1
        return self._data[self._at - 1]

    def _either(self) -> _Node:
        branches = [self._sequence()]
        while self._next() == b"|":
            self._at += 1
            branches.append(self._sequence())
        if len(branches) == 1:
            return branches[0]
        return _Node(_Kind.EITHER, tuple(branches), has_width=all(branch.has_width for branch in branches))

    def _sequence(self) -> _Node:
        parts: list[_Node] = []
        while self._next() not in {b"", b"|", b")"}:
            parts.append(self._repeated())
        return _Node(_Kind.SEQUENCE, tuple(parts), has_width=any(part.has_width for part in parts))

    def _repeated(self) -> _Node:
        node = self._atom()
        sign = self._next().decode("latin-1")
        if sign not in {"*", "+", "?"}:
            return node
        if sign != "?" and not node.has_width:
            raise self._error(f"what is before '{sign}' may be empty")
        self._at += 1
        if self._next() in {b"*", b"+", b"?"}:
            raise self._error(f"'{sign}' is followed by another repetition")
        return _Node(_Kind.REPEATED, (node,), sign=sign, has_width=sign == "+")

    def _atom(self) -> _Node:
        byte = self._take()
        sign = chr(byte)
        if sign == "^":
            return _Node(_Kind.BEGIN)
        if sign == "$":
            return _Node(_Kind.END)
        if sign == "(":
            return self._group()
        if sign in "*+?":
            raise self._error(f"nothing is before '{sign}'")
        if sign == "\\" and self._at == len(self._data):
            raise self._error("it ends in a backslash")
        accepted = 1 << (self._take() if sign == "\\" else byte)
        if sign == ".":
            accepted = _EVERY_BYTE
        elif sign == "[":
            accepted = self._set()
        return _Node(_Kind.BYTES, accepted=accepted, has_width=True)

    def _group(self) -> _Node:
        self._depth += 1
        if self._depth > MAX_NESTED:
            raise self._error(f"more than {MAX_NESTED} parentheses are nested")
        node = self._either()
        if self._next() != b")":
            raise self._error("a '(' has no ')'")
        self._at += 1
        self._depth -= 1
        return node

    def _set(self) -> int:
        """Return the bytes of `[…]`. A backslash is a byte there, and so is a `]` or a `-` at its beginning."""
        is_inverse = self._next() == b"^"
        self._at += is_inverse
        accepted = 0
        is_first = True
        while is_first or self._next() != b"]":
            if self._at >= len(self._data):
                raise self._error("a '[' has no ']'")
            byte = self._take()
            last = self._next()
            if byte == ord("-") and not is_first and last not in {b"", b"]"}:
                begin, end = self._data[self._at - 2], self._take()
                if begin > end:
                    raise self._error(f"the range {chr(begin)}-{chr(end)} runs backwards")
                accepted |= (1 << end + 1) - (1 << begin)
            else:
                accepted |= 1 << byte
            is_first = False
        self._at += 1
        return _EVERY_BYTE ^ accepted if is_inverse else accepted
