"""Content filters: which messages of a topic a subscription receives, by an expression about their fields.

The language is DDS's subset of SQL, as Fast DDS reads it: comparisons of a field with a literal, a parameter `%n` or a
field by `=`, `<>`, `!=`, `<`, `>`, `<=`, `>=` and `LIKE`, or by `BETWEEN … AND …`; joined by `AND` and `OR`, which bind
equally and are read from left to right; `NOT`, which binds most; brackets. An expression is compiled once.
"""

from __future__ import annotations

import math
import operator
import re
import struct
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from tfloom._native import ReadyQueue
    from tfloom.rmw.base import Reader, Sample
    from tfloom.rosidl.message import Message

    Value = Callable[[Any], Any]
    """A function from a message to a number or a text; None where the message has no such element."""
    Predicate = Callable[[Any], bool | None]
    """A function from a message to whether it is accepted; None where an element is missing."""

__all__ = ["ContentFilter", "ContentFilterOptions", "FilterError", "FilteringReader"]

MAX_LENGTH = 65_536
"""The longest expression, and the longest parameter [characters]."""
MAX_NESTING = 100
"""How deep brackets and NOT may be nested."""
MAX_PARAMETERS = 100
MAX_REJECTED = 200
"""How many messages are rejected in a row before whoever takes them does something else."""


class ContentFilterOptions(NamedTuple):
    """An expression, and the parameters that it names as `%0`, `%1` and so on."""

    filter_expression: str
    expression_parameters: list[str]


class FilterError(ValueError):
    """An expression can't be used: what is wrong, and where."""


class ContentFilter:
    """A compiled expression.

    Args:
        msg_type: Class of the messages.
        options: The expression; an empty one accepts all.

    Raises:
        FilterError: it can't be used with these messages.
        TypeError: the expression is not a text, or the parameters are not a list of texts.
    """

    def __init__(self, msg_type: type[Message], options: ContentFilterOptions) -> None:
        expression, parameters = options
        if not isinstance(expression, str):
            raise TypeError(f"a filter expression must be a str, got {expression!r}")
        is_list = isinstance(parameters, Sequence) and not isinstance(parameters, str)
        if not is_list or not all(isinstance(text, str) for text in parameters):
            raise TypeError(f"expression parameters must be a list of str, got {parameters!r}")
        if len(parameters) > MAX_PARAMETERS:
            raise FilterError(f"The maximum of expression parameters argument number is {MAX_PARAMETERS}")
        if max(map(len, (expression, *parameters))) > MAX_LENGTH:
            raise FilterError(f"an expression or a parameter is longer than {MAX_LENGTH} characters")
        self.options = ContentFilterOptions(expression, list(parameters))
        parser = _Parser(msg_type, expression, parameters)
        self._predicate: Predicate = parser.parse() if expression else _accept
        self.is_announced = parser.is_portable
        """Whether writers that filter accept all that this does, so that they may be told."""

    def accepts(self, message: Message) -> bool:
        """Return whether the subscription receives a message."""
        return self._predicate(message) is True


def _accept(_: Any) -> bool:
    return True


# Reading an expression

_TOKEN = re.compile(
    r"""\s*(?:
    (?P<text>['`][^']*')
    |(?P<number>[+-]?(?:0[xX][0-9a-fA-F]+|[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?)(?![\w.]))
    |%(?P<parameter>[0-9]{1,2})(?![0-9])
    |(?P<name>[A-Za-z_][A-Za-z0-9_]*(?:\[[0-9]+\])?(?:\.[A-Za-z_][A-Za-z0-9_]*(?:\[[0-9]+\])?)*)
    |(?P<sign><=|>=|<>|!=|[=<>()])
    )""",
    re.VERBOSE,
)
_KEYWORDS = ("AND", "OR", "NOT", "BETWEEN", "LIKE", "TRUE", "FALSE")
_COMPARISONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": operator.eq,
    "<>": operator.ne,
    "!=": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
}
_MAX_UINT64 = 2**64 - 1
_MIN_INT64 = -(2**63)
_TEXT = "text"
_NUMBER = "number"


class _Token(NamedTuple):
    kind: str
    """text, number, parameter, name, sign, keyword or end."""
    text: str
    position: int


class _Operand(NamedTuple):
    """One side of a comparison."""

    kind: str
    """_TEXT or _NUMBER."""
    shown: str
    """As in the expression, for errors."""
    value: Value
    literal: Any = None
    """None for a field."""
    base: str = ""
    """The type of a field."""


class _Parser:
    """Reads one expression: a function for each rule, which returns what it has compiled."""

    def __init__(self, msg_type: type[Message], expression: str, parameters: Sequence[str]) -> None:
        self._msg_type = msg_type
        self._expression = expression
        self._parameters = parameters
        self._tokens = list(self._split())
        self._index = 0
        self._depth = 0
        self.is_portable = True
        """Whether all that was read means in Fast DDS what it means here, or accepts more there."""

    def _error(self, what: str, position: int) -> FilterError:
        return FilterError(f"{what}, at character {position + 1} of {self._expression[:200]!r}")

    def _split(self) -> list[_Token]:
        tokens = []
        text, position = self._expression, 0
        end = len(text.rstrip())
        while position < end:
            match = _TOKEN.match(text, position)
            if match is None:
                raise self._error("this is not a part of a filter expression", position)
            kind = str(match.lastgroup)
            word = match[kind]
            # Keywords are in capital or in small letters alone.
            if kind == "name" and word.upper() in _KEYWORDS and word in (word.upper(), word.lower()):
                kind, word = "keyword", word.upper()
            tokens.append(_Token(kind, word, match.start(str(match.lastgroup))))
            position = match.end()
        tokens.append(_Token("end", "", end))
        return tokens

    def _next(self) -> _Token:
        token = self._tokens[self._index]
        self._index = min(self._index + 1, len(self._tokens) - 1)
        return token

    def _is_next(self, kind: str, *texts: str) -> bool:
        token = self._tokens[self._index]
        return token.kind == kind and token.text in texts

    def _expect(self, kind: str, text: str) -> None:
        if not self._is_next(kind, text):
            raise self._error(f"{text} is missing", self._tokens[self._index].position)
        self._next()

    def parse(self) -> Predicate:
        predicate = self._conditions()
        rest = self._next()
        if rest.kind != "end":
            raise self._error("the expression should end here, or go on with AND or OR", rest.position)
        return predicate

    def _conditions(self) -> Predicate:
        first = self._condition()
        others: list[tuple[bool, Predicate]] = []
        while self._is_next("keyword", "AND", "OR"):
            is_and = self._next().text == "AND"
            others.append((is_and, self._condition()))
        return _joined(first, others) if others else first

    def _condition(self) -> Predicate:
        self._depth += 1
        if self._depth > MAX_NESTING:
            raise self._error(f"it is nested deeper than {MAX_NESTING}", self._tokens[self._index].position)
        if self._is_next("keyword", "NOT"):
            self._next()
            predicate = _inverted(self._condition())
        elif self._is_next("sign", "("):
            self._next()
            predicate = self._conditions()
            self._expect("sign", ")")
        else:
            predicate = self._comparison()
        self._depth -= 1
        return predicate

    def _comparison(self) -> Predicate:
        position = self._tokens[self._index].position
        left = self._operand()
        is_inverted = self._is_next("keyword", "NOT")
        if is_inverted:
            self._next()
        if is_inverted or self._is_next("keyword", "BETWEEN"):
            self._expect("keyword", "BETWEEN")
            low = self._operand()
            self._expect("keyword", "AND")
            predicate = self._between(left, low, self._operand(), position)
            return _inverted(predicate) if is_inverted else predicate
        sign = self._next()
        if sign.text == "LIKE" and sign.kind == "keyword":
            return self._like(left, self._operand(), position)
        if sign.kind != "sign" or sign.text not in _COMPARISONS:
            raise self._error("a comparison is missing: =, <>, <, >, <=, >=, LIKE or BETWEEN", sign.position)
        return self._compared(left, _COMPARISONS[sign.text], self._operand(), position)

    def _compared(
        self, left: _Operand, compare: Callable[[Any, Any], bool], right: _Operand, position: int
    ) -> Predicate:
        if left.literal is not None and right.literal is not None:
            raise self._error("one side of a comparison must be a field", position)
        self._check_same_kind(left, right, position)
        left, right = _in_width_of(left, right), _in_width_of(right, left)
        if right.literal is None and left.literal is None:
            return _both(left.value, compare, right.value)
        if left.literal is not None:
            return _with_constant(right.value, compare, left.literal, is_first=True)
        return _with_constant(left.value, compare, right.literal)

    def _between(self, left: _Operand, low: _Operand, high: _Operand, position: int) -> Predicate:
        if left.literal is not None or low.literal is None or high.literal is None:
            raise self._error("BETWEEN compares a field with two literals or parameters", position)
        above = self._compared(left, operator.ge, low, position)
        return _joined(above, [(True, self._compared(left, operator.le, high, position))])

    def _like(self, left: _Operand, right: _Operand, position: int) -> Predicate:
        self.is_portable = False  # the patterns of Fast DDS are regular expressions
        if {left.kind, right.kind} != {_TEXT}:
            raise self._error("LIKE compares texts", position)
        if left.literal is not None and right.literal is not None:
            raise self._error("one side of a comparison must be a field", position)
        if right.literal is not None:
            return _with_constant(left.value, _matches, _pattern(right.literal))
        # Of a field on the right, the characters stand for themselves.
        return self._compared(left, operator.eq, right, position)

    def _check_same_kind(self, left: _Operand, right: _Operand, position: int) -> None:
        if left.kind != right.kind:
            raise self._error(
                f"{left.shown}, a {left.kind}, can't be compared with {right.shown}, a {right.kind}", position
            )

    def _operand(self) -> _Operand:
        token = self._next()
        if token.kind == "name":
            return self._field(token)
        if token.kind == "parameter":
            number = int(token.text)
            if number >= len(self._parameters):
                given = len(self._parameters)
                raise self._error(
                    f"%{number} needs {number + 1} parameters, and {given} are given", token.position
                )
            return self._literal(self._parameters[number], f"parameter {number} is", token.position)
        if token.kind in {"text", "number", "keyword"}:
            return self._literal(token.text, "this is", token.position)
        raise self._error("a field, a literal or a parameter is missing", token.position)

    def _literal(self, text: str, what: str, position: int) -> _Operand:
        match = _TOKEN.fullmatch(text)
        is_truth = text in {"TRUE", "FALSE", "true", "false"}
        if (
            match is None
            or match.start(str(match.lastgroup))
            or not (match["text"] or match["number"] or is_truth)
        ):
            raise self._error(
                f"{what} neither a number, TRUE or FALSE, nor a text in single quotes", position
            )
        if match["text"]:
            return _Operand(_TEXT, text, _constant(text[1:-1]), text[1:-1])
        if is_truth:
            truth = int(text.upper() == "TRUE")
            return _Operand(_NUMBER, text, _constant(truth), truth)
        number = _number(match["number"])
        if number is None or not (isinstance(number, float) or _MIN_INT64 <= number <= _MAX_UINT64):
            raise self._error(f"{what} not a number of 64 bits", position)
        return _Operand(_NUMBER, text, _constant(number), number)

    def _field(self, token: _Token) -> _Operand:
        from tfloom.rosidl.class_search import find_field_class
        from tfloom.rosidl.parse import parse_type

        message_class: type[Message] | None = self._msg_type
        steps: list[tuple[str, int | None]] = []
        type_ = None
        for part in token.text.split("."):
            name, _, index = part.rstrip("]").partition("[")
            if message_class is None or name not in message_class._FIELDS:  # ours
                raise self._error(
                    f"field not found: {self._msg_type._TYPE_NAME} has no {token.text}", token.position
                )
            type_ = parse_type(message_class._FIELDS[name])
            steps.append((name, self._checked_index(type_, index, token)))
            message_class = None if type_.is_primitive else find_field_class(type_.base)
        if type_ is None or message_class is not None:
            raise self._error(f"{token.text} is a message: name one of its fields", token.position)
        is_text = type_.base in {"string", "wstring"}
        self.is_portable = self.is_portable and type_.base != "wstring"  # no text of Fast DDS equals one
        convert = str if is_text else _CONVERSIONS.get(type_.base, int)
        return _Operand(
            _TEXT if is_text else _NUMBER, token.text, _reading(tuple(steps), convert), base=type_.base
        )

    def _checked_index(self, type_: Any, index: str, token: _Token) -> int | None:
        if not type_.shape and index:
            raise self._error(f"{token.text}: what has an index is not an array", token.position)
        if not type_.shape:
            return None
        if not index:
            raise self._error(f"{token.text}: the array needs an index, as [0]", token.position)
        number = int(index) if len(index) < 20 else _MAX_UINT64
        if type_.length and number >= type_.length:
            raise self._error(f"{token.text}: the index is greater than {type_.length - 1}", token.position)
        return number


def _number(text: str) -> float | None:
    """Return an integer, decimal, hexadecimal after 0x or octal after 0, or a float; None for `08` and the like."""
    digits = text.lstrip("+-")
    sign = -1 if text.startswith("-") else 1
    try:
        if digits[:2] in {"0x", "0X"}:
            return sign * int(digits, 16)
        if not digits.isdigit():
            return float(text)
        return (
            sign * int(digits, 8 if digits.startswith("0") else 10) if len(digits) < 30 else math.inf * sign
        )
    except ValueError:
        return None


def _byte(value: Any) -> int:
    """Return a value of type `byte`, which is one of bytes, as a number."""
    return value[0] if isinstance(value, bytes) else int(value)


_CONVERSIONS: dict[str, Callable[[Any], Any]] = {"float32": float, "float64": float, "byte": _byte}


def _in_width_of(operand: _Operand, other: _Operand) -> _Operand:
    """Return a literal as the field that it is compared with would hold it, in which 0.1 is another number."""
    if operand.literal is None or other.base != "float32":
        return operand
    try:
        (value,) = struct.unpack("f", struct.pack("f", operand.literal))
    except OverflowError:
        return operand
    return operand._replace(literal=value)


# What an expression is compiled to


def _constant(value: Any) -> Value:
    return lambda _: value


def _reading(steps: tuple[tuple[str, int | None], ...], convert: Callable[[Any], Any]) -> Value:
    if len(steps) == 1 and steps[0][1] is None:
        name = steps[0][0]
        return lambda message: convert(getattr(message, name))

    def read(message: Any) -> Any:
        value = message
        for name, index in steps:
            value = getattr(value, name)
            if index is not None:
                if index >= len(value):
                    return None
                value = value[index]
        return convert(value)

    return read


def _both(left: Value, compare: Callable[[Any, Any], bool], right: Value) -> Predicate:
    def predicate(message: Any) -> bool | None:
        first, second = left(message), right(message)
        return None if first is None or second is None else compare(first, second)

    return predicate


def _with_constant(
    value: Value, compare: Callable[[Any, Any], bool], constant: Any, *, is_first: bool = False
) -> Predicate:
    def predicate(message: Any) -> bool | None:
        found = value(message)
        if found is None:
            return None
        return compare(constant, found) if is_first else compare(found, constant)

    return predicate


def _inverted(predicate: Predicate) -> Predicate:
    def inverted(message: Any) -> bool | None:
        outcome = predicate(message)
        return None if outcome is None else not outcome

    return inverted


def _joined(first: Predicate, others: Sequence[tuple[bool, Predicate]]) -> Predicate:
    """Join conditions from left to right, in a loop, because there may be more than Python nests calls."""

    def joined(message: Any) -> bool | None:
        outcome = first(message)
        for is_and, predicate in others:
            if outcome is not is_and and outcome is not None:  # False AND …, True OR …
                continue
            other = predicate(message)
            if other is (not is_and) or outcome is not None:
                outcome = other
        return outcome

    return joined


_Segment = str | re.Pattern[str]


def _pattern(text: str) -> tuple[tuple[_Segment, ...], bool, bool]:
    """Return the parts of a pattern between `%` or `*`, and whether it begins, and ends, with one of these.

    A part with `_` or `?` is a regular expression, in which nothing is repeated: matching takes no longer than the
    lengths of text and pattern multiplied.
    """
    parts = re.split("[%*]+", text)
    segments = tuple(
        re.compile("".join("." if char in "_?" else re.escape(char) for char in part), re.DOTALL)
        if set(part) & set("_?")
        else part
        for part in parts
        if part
    )
    return segments, parts[0] == "" and len(parts) > 1, parts[-1] == "" and len(parts) > 1


def _matches(text: str, pattern: tuple[tuple[_Segment, ...], bool, bool]) -> bool:
    segments, is_open, goes_on = pattern
    position = 0
    for number, segment in enumerate(segments):
        is_last = number == len(segments) - 1 and not goes_on
        found = _find(text, segment, position, is_last=is_last)
        if found is None or (number == 0 and not is_open and found[0] != 0):
            return False
        position = found[1]
    return goes_on or position == len(text) if segments else is_open or not text


def _find(text: str, segment: _Segment, position: int, *, is_last: bool) -> tuple[int, int] | None:
    """Return the span of the first occurrence from a position on; for the last part, of that at the text's end."""
    length = len(segment) if isinstance(segment, str) else _length(segment)
    begin = max(position, len(text) - length) if is_last else position
    if isinstance(segment, str):
        begin = text.find(segment, begin)
        return None if begin < 0 else (begin, begin + length)
    match = segment.search(text, begin)
    return match and match.span()


def _length(segment: re.Pattern[str]) -> int:
    return len(re.sub(r"\\(.)", r"\1", segment.pattern, flags=re.DOTALL))


# Taking from the wire


class FilteringReader:
    """A reader that takes only the messages that a filter accepts; all else is passed on to the reader on the wire.

    Args:
        reader: The reader on the wire.
        accepts: Called with each sample, on the thread that takes.
    """

    def __init__(self, reader: Reader, accepts: Callable[[Sample], bool]) -> None:
        self.reader = reader
        self.accepts = accepts
        self._queue: ReadyQueue | None = None
        self._token = 0

    def __getattr__(self, name: str) -> Any:
        return getattr(self.reader, name)

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """As of a reader."""
        self._queue, self._token = queue, token
        self.reader.notify(queue, token)

    def take_decoded(self, _message_class: type) -> Sample | None:
        """As `take`: the data are bytes."""
        return self.take()

    def take(self) -> Sample | None:
        """Remove the oldest samples up to one that is accepted, and return that; None if there is none."""
        for _ in range(MAX_REJECTED):
            sample = self.reader.take()
            if sample is None or self.accepts(sample):
                return sample
        # The taker is told to come again, because a post may stand for many samples.
        queue = self._queue
        if queue is not None:
            queue.post(self._token)
        return None
