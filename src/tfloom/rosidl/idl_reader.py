"""Reading of IDL's small parts: names, literals, constant expressions and annotations."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from tfloom.rosidl.definition import Annotation
from tfloom.rosidl.idl_tokens import Token, tokens
from tfloom.rosidl.idl_values import LEVELS, IdlValue, apply_sign, combine, parse_integer, parse_string
from tfloom.rosidl.parse import ParseError

_MAX_NESTING = 50
"""How many parentheses and signs may be nested in one another."""


class Reader:
    """The tokens of a text, read one after the other.

    Args:
        text: An IDL text.
        path: Its path, for errors.

    Raises:
        ParseError: there is no token at a place. So does each function, for what can't be read.
    """

    def __init__(self, text: str, path: str) -> None:
        self.path = path
        self._tokens = list(tokens(text, path))
        self._at = 0
        self._has_shifts = True
        """Whether `>>` is an operator where the text is read now."""
        self.constants: dict[str, IdlValue] = {}
        """The constants read so far, by bare name."""

    @property
    def next(self) -> Token:
        """The next token, which stays the next."""
        return self._tokens[self._at]

    def take(self) -> Token:
        """Return the next token, and go on to the one that follows."""
        token = self._tokens[self._at]
        if token.kind != "end":
            self._at += 1
        return token

    def fail(self, reason: str, token: Token | None = None) -> ParseError:
        """Return an error at a token, by default the next."""
        return ParseError(self.path, *(token or self.next).position, reason)

    def expected(self, what: str) -> ParseError:
        """Return the error that something else was expected at the next token."""
        got = "the end of the file" if self.next.kind == "end" else f"'{self.next.text}'"
        return self.fail(f"expected {what}, got {got}")

    def is_next(self, *texts: str) -> bool:
        """Return whether the next token is a word or a mark of these."""
        return self.next.kind in {"word", "mark"} and self.next.text in texts

    def skip(self, *texts: str) -> bool:
        """Go past the next token if it is one of these; return whether it was."""
        is_match = self.is_next(*texts)
        if is_match:
            self._at += 1
        return is_match

    def demand(self, text: str, where: str) -> Token:
        """Return the next token, which must be a certain mark."""
        if not self.is_next(text):
            raise self.expected(f"'{text}' {where}")
        return self.take()

    def name(self, what: str) -> Token:
        """Return the next token, which must be a word."""
        if self.next.kind != "word":
            raise self.expected(what)
        return self.take()

    def scoped_name(self, what: str) -> list[str]:
        """Return the parts of a name such as `geometry_msgs::msg::Point`."""
        self.skip("::")
        parts = [self.name(what).text]
        while self.skip("::"):
            parts.append(self.name("a name after '::'").text)
        return parts

    def positive(self, what: str, *, in_brackets: bool = False) -> int:
        """Return the value of a constant expression that must be an integer of 1 or more.

        Args:
            what: What it is, for errors.
            in_brackets: Whether a `>` after it ends a type, as in `sequence<string<5>>`.
        """
        start = self.next
        # There, `>>` ends two types. A shift has to be in parentheses, as in a template argument of C++.
        self._has_shifts = not in_brackets
        value = self.expression()
        self._has_shifts = True
        if isinstance(value, bool) or not isinstance(value, int) or value < 1:
            raise self.fail(f"{what} is an integer of 1 or more, not {value!r}", start)
        return value

    def expression(self, *, take_name: Callable[[list[str]], IdlValue] | None = None) -> IdlValue:
        """Return the value of a constant expression.

        Args:
            take_name: Returns the value of a name that is not a constant; by default such a name is an error.
        """
        return self._binary(0, 0, take_name)

    def _binary(self, level: int, depth: int, take_name: Callable[[list[str]], IdlValue] | None) -> IdlValue:
        if level == len(LEVELS):
            return self._unary(depth, take_name)
        value = self._binary(level + 1, depth, take_name)
        # Operands of this level are expressions of the next, which binds more. The loop makes operators of one level
        # combine from the left: a - b - c is (a - b) - c.
        while (operator := self._operator(LEVELS[level])) is not None:
            right = self._binary(level + 1, depth, take_name)
            value = self._calculate(operator, partial(combine, operator.text, value, right))
        return value

    def _operator(self, operators: tuple[str, ...]) -> Token | None:
        """Take the next token if it is one of these operators; `>>` is two tokens, because it may end two types."""
        token = self.next
        if ">>" in operators and self._has_shifts and self.is_next(">"):
            # A shift only if nothing is between the two marks.
            after = self._tokens[self._at + 1]
            line, column = token.position
            if after.text == ">" and after.position == (line, column + 1):
                self._at += 2
                return Token("mark", ">>", token.position)
        return self.take() if self.is_next(*operators) else None

    def _calculate(self, token: Token, value: Callable[[], IdlValue]) -> IdlValue:
        try:
            return value()
        except (ValueError, OverflowError) as error:
            raise self.fail(str(error), token) from None

    def _unary(self, depth: int, take_name: Callable[[list[str]], IdlValue] | None) -> IdlValue:
        token = self.next
        if depth > _MAX_NESTING:
            raise self.fail(f"an expression is nested more than {_MAX_NESTING} deep")
        if self.skip("-", "+", "~"):
            operand = self._unary(depth + 1, take_name)
            return self._calculate(token, partial(apply_sign, token.text, operand))
        if self.skip("("):
            has_shifts, self._has_shifts = self._has_shifts, True
            value = self._binary(0, depth + 1, take_name)
            self._has_shifts = has_shifts
            self.demand(")", "after the expression")
            return value
        return self._primary(take_name)

    def _primary(self, take_name: Callable[[list[str]], IdlValue] | None) -> IdlValue:
        token = self.next
        if token.kind == "integer":
            return self._calculate(self.take(), partial(parse_integer, token.text))
        if token.kind == "float":
            return float(self.take().text.rstrip("dD"))
        if token.kind == "string":
            value = ""
            while self.next.kind == "string":
                value += parse_string(self.take().text)
            return value
        if self.is_next("TRUE", "FALSE"):
            return self.take().text == "TRUE"
        if token.kind != "word" and not self.is_next("::"):
            raise self.expected("a value")
        name = self.scoped_name("a value")
        if name[-1] in self.constants:
            return self.constants[name[-1]]
        if take_name is None:
            raise self.fail(f"there is no constant '{'::'.join(name)}' before this line", token)
        return take_name(name)

    def annotations(self) -> list[Annotation]:
        """Return the annotations that come next: `@key`, `@unit("m")`, `@default (value=3)`."""
        annotations: list[Annotation] = []
        while self.skip("@"):
            name = "::".join(self.scoped_name("an annotation's name after '@'"))
            annotations.append(Annotation(name, self._parameters() if self.skip("(") else None))
        return annotations

    def _parameters(self) -> IdlValue | dict[str, IdlValue]:
        named: dict[str, IdlValue] = {}
        # `(3)` is a value alone, `(value=3, unit="m")` has names. A word decides nothing, because it may be a constant:
        # so look at the token after it, which is `=` for a name.
        while not self.skip(")"):
            after = self._tokens[min(self._at + 1, len(self._tokens) - 1)]
            if self.next.kind != "word" or after.text != "=" or after.kind != "mark":
                if named:
                    raise self.expected("a parameter's name, followed by '='")
                value = self.expression(take_name="::".join)
                self.demand(")", "after the annotation's value")
                return value
            name = self.take()
            if name.text in named:
                raise self.fail(f"the parameter '{name.text}' is given twice", name)
            self.take()
            named[name.text] = self.expression(take_name="::".join)
            if not self.skip(",") and not self.is_next(")"):
                raise self.expected("',' or ')' after the annotation's parameter")
        return named
