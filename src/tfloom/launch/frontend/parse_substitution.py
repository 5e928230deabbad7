r"""The substitutions in a text: `$(name argument 'quoted argument' $(nested argument))`.

    template:     (text | substitution)*
    substitution: "$(" name (spaces argument)* spaces? ")"
    argument:     (text | substitution)+ | "'" template "'" | '"' template '"'

A backslash before any character stands for this character alone: `\$(` is not a substitution, `\'` ends no quotation.
Text in an argument without quotation marks has no spaces, parentheses and quotation marks, unless a backslash is before
a parenthesis or quotation mark. Between quotation marks there may be substitutions too; their arguments are not quoted
again, because the other kind of quotation marks is plain text there.
"""

from __future__ import annotations

import re
from typing import Any

from tfloom.launch.core.base_classes import Substitution, TextSubstitution
from tfloom.launch.core.error_places import add_to_error
from tfloom.launch.frontend.expose import instantiate_substitution

__all__ = [
    "SubstitutionSyntaxError",
    "parse_if_substitutions",
    "parse_substitution",
    "replace_escaped_characters",
]

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
_DEEPEST = 50


class SubstitutionSyntaxError(ValueError):
    """A text has an incomplete substitution."""


def replace_escaped_characters(data: str) -> str:
    """Return a text with each backslash and the character after it replaced by this character."""
    return re.sub(r"\\(.)", r"\1", data)


def parse_substitution(string_value: str) -> list[Substitution]:
    r"""Return the texts and substitutions that a text consists of; for an empty one, an empty TextSubstitution.

    Raises:
        SubstitutionSyntaxError: a substitution is incomplete. A text that isn't one has `\$(`.
        RuntimeError: no substitution is exposed with a name.
    """
    if not string_value:
        return [TextSubstitution(text=string_value)]
    return _Reader(string_value).template("", 0)


def parse_if_substitutions(value: Any) -> Any:
    """Return a value with its texts parsed: a text without substitutions, else the list of them.

    Args:
        value: A text, another scalar, which stays, or a list of such.

    Raises:
        ValueError: a list has values of several types, of which substitutions may be any.
    """
    if not isinstance(value, list):
        return _parse_value(value)
    parsed = [_parse_value(item) for item in value]
    if len({type(item) for item in parsed if not isinstance(item, list)}) > 1:
        raise ValueError(f"The result is a non-uniform list: {value}")
    return parsed


def _parse_value(value: Any) -> Any:
    if not isinstance(value, str):
        return value
    parts = parse_substitution(value)
    if len(parts) == 1 and isinstance(parts[0], TextSubstitution):
        return parts[0].text
    return parts


class _Reader:
    """Reads a text from its start to its end.

    `quote` is the quotation mark that the read part is in, or "". It is the mark that ends the part, wherever it stands
    without a backslash. In a nested substitution of a quoted part, it is the one of this part.
    """

    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0

    def template(self, quote: str, level: int) -> list[Substitution]:
        """Read text and substitutions up to the closing mark, or up to the end."""
        return self._parts(quote, quote, level)

    def _parts(self, ends: str, quote: str, level: int) -> list[Substitution]:
        """Read text and substitutions up to one of the characters `ends`."""
        parts: list[Substitution] = []
        begin = self._at
        while self._at < len(self._text) and self._text[self._at] not in ends:
            if self._text[self._at] == "\\" and not self._space_follows(ends):
                self._at += 2
            elif self._text.startswith("$(", self._at):
                self._add_text(parts, begin)
                parts.append(self._substitution(quote, level))
                begin = self._at
            else:
                self._at += 1
        self._at = min(self._at, len(self._text))
        self._add_text(parts, begin)
        return parts

    def _space_follows(self, ends: str) -> bool:
        """Return whether a space that ends the part follows, because a backslash does not change that."""
        return " " in ends and self._text.startswith(" ", self._at + 1)

    def _add_text(self, parts: list[Substitution], begin: int) -> None:
        if begin < self._at:
            text = replace_escaped_characters(self._text[begin : self._at])
            parts.append(TextSubstitution(text=text))

    def _substitution(self, quote: str, level: int) -> Substitution:
        begin = self._at
        if level >= _DEEPEST:
            raise self._error(f"substitutions are nested deeper than {_DEEPEST} levels", begin)
        name = _NAME.match(self._text, begin + 2)
        if name is None:
            raise self._error(r"no name follows '$(' (for the text itself, write '\$(')", begin)
        self._at = name.end()
        args = []
        while self._skip_spaces() and not self._text.startswith(")", self._at):
            args.append(self._argument(quote, level + 1))
        if not self._text.startswith(")", self._at):
            next_text = f"'{self._text[self._at]}'" if self._at < len(self._text) else "the end"
            problem = f"{next_text} is where an argument or ')' should be, in '$({name[0]} …'"
            raise self._error(problem, self._at)
        self._at += 1
        try:
            return instantiate_substitution(name[0], args)
        except Exception as error:
            add_to_error(error, after=f" (in '{self._text[begin : self._at]}')")
            raise

    def _skip_spaces(self) -> bool:
        begin = self._at
        while self._text.startswith(" ", self._at):
            self._at += 1
        return self._at > begin

    def _argument(self, quote: str, level: int) -> list[Substitution]:
        mark = self._text[self._at : self._at + 1]
        if not quote and mark and mark in "'\"":
            begin = self._at
            self._at += 1
            parts = self.template(mark, level)
            if not self._text.startswith(mark, self._at):
                raise self._error(f"the closing {mark} is missing", begin)
            self._at += 1
            return parts
        parts = self._parts(" ()" + (quote or "'\""), quote, level)
        if not parts:
            next_text = f"'{mark}'" if mark else "the end"
            raise self._error(
                rf"{next_text} is where an argument or ')' should be (for the text, write '\{mark}')",
                self._at,
            )
        return parts

    def _error(self, problem: str, at: int) -> SubstitutionSyntaxError:
        return SubstitutionSyntaxError(f"{problem}: column {at + 1} of '{self._text}'")
