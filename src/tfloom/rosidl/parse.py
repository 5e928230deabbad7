"""Parsing of definitions (.msg, .srv, .action). An error is a `ParseError` with file, line and column."""

from __future__ import annotations

import re
from functools import lru_cache

from tfloom.rosidl import spec
from tfloom.rosidl.literal import parse_value
from tfloom.rosidl.type_text import split_type

TYPE_CHECKING = False
if TYPE_CHECKING:
    from pathlib import Path

_TYPE = re.compile(r"(?P<base>[A-Za-z][\w/]*)(?:<=(?P<bound>\d+))?(?:\[(?:(?:<=)?\d+)?\])?")
_FIELD_NAME = re.compile(r"(?!.*__)[a-z][a-z0-9_]*(?<!_)")
_CONSTANT_NAME = re.compile(r"(?!.*__)[A-Z][A-Z0-9_]*(?<!_)")
_MESSAGE_NAME = re.compile(r"[A-Z][A-Za-z0-9]*")
_PACKAGE_NAME = re.compile(r"(?!.*__)[a-z][a-z0-9_]*(?<!_)")
_LINE = re.compile(r"\s*(?P<type>(?:<=|[^\s=])+)\s*(?P<name>[^\s=]*)\s*(?P<equals>=?)\s*")
_SECTIONS = {"msg": 1, "srv": 2, "action": 3}


class ParseError(ValueError):
    """A definition that can't be parsed. The text starts with `file:line:column:`."""

    def __init__(self, path: str, line: int, column: int, reason: str) -> None:
        super().__init__(f"{path}:{line}:{column}: {reason}")
        self.path, self.line, self.column, self.reason = path, line, column, reason


def read_text(path: Path) -> str:
    """Return the text of a definition's file.

    Raises:
        ParseError: it is not UTF-8 text.
        OSError: it can't be read.
    """
    data = path.read_bytes()
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        column = error.start - (data.rfind(b"\n", 0, error.start) + 1) + 1
        raise ParseError(
            str(path), line, column, f"octet {data[error.start]:#04x} isn't UTF-8 text"
        ) from None


def parse_interface(text: str, name: str, path: str | None = None) -> spec.Interface:
    """Parse the text of a definition.

    Args:
        text: The content of the file.
        name: `package/kind/Name`; the kind (msg, srv or action) determines how many parts `---` divides the text into.
        path: Path of the text, for errors; by default `package/kind/Name.kind`.

    Raises:
        ParseError: the text is not such a definition.
        ValueError: `name` is not an interface name.
    """
    package, kind, _ = _split_name(name)
    parser = _Parser(package, path or f"{name}.{kind}")
    parts = parser.parts(text, _SECTIONS[kind])
    if kind == "msg":
        return parser.message(name, parts[0])
    if kind == "srv":
        return spec.service(
            name, parser.message(f"{name}_Request", parts[0]), parser.message(f"{name}_Response", parts[1])
        )
    suffixes = ("Goal", "Result", "Feedback")
    goal, result, feedback = (
        parser.message(f"{name}_{s}", part) for s, part in zip(suffixes, parts, strict=True)
    )
    return spec.action(name, goal, result, feedback)


@lru_cache(4096)
def parse_type(text: str, package: str = "") -> spec.Type:
    """Parse a field's type: `float64[36]`, `string<=10[<=5]`, `Point`, `geometry_msgs/Point[]`.

    Raises:
        ValueError: it is not a type; the text has the reason.
    """
    match = _TYPE.fullmatch(text)
    if match is None:
        raise ValueError(f"'{text}' is not a type")
    base = _resolve(match["base"], package)
    if match["bound"] is not None and base not in spec.STRINGS:
        raise ValueError(f"only strings have a bound of characters, '{match['base']}' has none")
    _, bound, shape, length = split_type(text)
    if length == 0 and shape in {"array", "bounded"}:
        raise ValueError(f"'{text}': the length must be 1 or more")
    if match["bound"] is not None and bound == 0:
        raise ValueError(f"'{text}': the bound must be 1 or more")
    return spec.Type(base, bound, shape, length)


def without_comment(line: str) -> str:
    """Return a line of a definition without its comment, stripped on the right."""
    return line[: _comment_start(line)].rstrip()


def message_in_field(line: str, package: str) -> str | None:
    """Return the full name of the message that is the type of the field on a line of a definition.

    Args:
        line: Any line.
        package: The definition's package, to which a bare name belongs.

    Returns:
        None for a field of a primitive type, a constant, or a line without a member.
    """
    match = _LINE.match(without_comment(line))
    if match is None or match["equals"] or not match["name"]:
        return None
    try:
        type_ = parse_type(match["type"], package)
    except ValueError:
        return None
    return None if type_.is_primitive else type_.base


def _split_name(name: str) -> tuple[str, str, str]:
    parts = name.split("/")
    if len(parts) != 3 or parts[1] not in _SECTIONS or not _PACKAGE_NAME.fullmatch(parts[0]):
        raise ValueError(f"'{name}' is not an interface name such as geometry_msgs/msg/Twist")
    if not _MESSAGE_NAME.fullmatch(parts[2]):
        raise ValueError(f"'{parts[2]}' is not an interface name: letters and digits, the first a capital")
    return parts[0], parts[1], parts[2]


def _resolve(base: str, package: str) -> str:
    """Return the full name of a type: a bare name is of the same package, except `Header`."""
    if base in spec.PRIMITIVES:
        return base
    parts = base.split("/")
    if parts == ["Header"] and package != "std_msgs":
        return "std_msgs/msg/Header"
    if len(parts) == 1 and package and _MESSAGE_NAME.fullmatch(base):
        return f"{package}/msg/{base}"
    if len(parts) == 2:
        parts.insert(1, "msg")
    plain = parts[-1].replace("_", "") if len(parts) == 3 and parts[1] != "msg" else parts[-1]
    if len(parts) != 3 or parts[1] not in _SECTIONS or not _MESSAGE_NAME.fullmatch(plain):
        raise ValueError(f"'{base}' is neither a primitive type nor a message's name")
    return "/".join(parts)


class _Line:
    """A line without its comment, and its number."""

    def __init__(self, number: int, text: str) -> None:
        self.number = number
        self.text = without_comment(text)
        self.comment = text[_comment_start(text) + 1 :].strip()


def _comment_start(text: str) -> int:
    """Return the index of the first # that is not inside quotes."""
    quote = ""
    escaped = False
    for i, letter in enumerate(text):
        if quote:
            if letter == quote and not escaped:
                quote = ""
            escaped = letter == "\\" and not escaped
        elif letter in "\"'":
            quote = letter
        elif letter == "#":
            return i
    return len(text) if not quote or "#" not in text else text.index("#")


class _Parser:
    def __init__(self, package: str, path: str) -> None:
        self.package = package
        self.path = path

    def fail(self, line: _Line, column: int, reason: str) -> ParseError:
        return ParseError(self.path, line.number, column + 1, reason)

    def parts(self, text: str, count: int) -> list[list[_Line]]:
        parts: list[list[_Line]] = [[]]
        line = _Line(1, "")
        for number, raw in enumerate(text.replace("\r\n", "\n").replace("\t", " ").split("\n"), 1):
            line = _Line(number, raw)
            if line.text.strip() != "---":
                parts[-1].append(line)
            elif len(parts) == count:
                raise self.fail(line, 0, f"the definition has {count - 1} lines '---', this is one too many")
            else:
                parts.append([])
        if len(parts) < count:
            raise self.fail(
                line, 0, f"the definition has {len(parts)} of its {count} parts, divided by '---'"
            )
        return parts

    def message(self, name: str, lines: list[_Line]) -> spec.Message:
        fields: dict[str, spec.Field] = {}
        constants: dict[str, spec.Constant] = {}
        for line in lines:
            if not line.text:
                continue
            member, column = self._member(line)
            if member.name in fields or member.name in constants:
                raise self.fail(line, column, f"'{member.name}' is defined twice")
            if isinstance(member, spec.Constant):
                constants[member.name] = member
            else:
                fields[member.name] = member
        return spec.Message(name, tuple(fields.values()), tuple(constants.values()), _head_comment(lines))

    def _member(self, line: _Line) -> tuple[spec.Field | spec.Constant, int]:
        match = _LINE.match(line.text)
        if match is None:
            raise self.fail(line, 0, "expected 'type name'")
        try:
            type_ = parse_type(match["type"], self.package)
        except ValueError as error:
            raise self.fail(line, match.start("type"), str(error)) from None
        name, column, rest = match["name"], match.start("name"), line.text[match.end() :]
        if not name:
            raise self.fail(line, column, f"'{match['type']}' is not followed by a name")
        if match["equals"]:
            return self._constant(line, type_, name, column, rest, match.end()), column
        if not _FIELD_NAME.fullmatch(name):
            raise self.fail(
                line,
                column,
                f"'{name}' is not a field name: lower case letters, digits and single underscores",
            )
        default = self._value(line, type_, rest, match.end()) if rest else None
        position = (line.number, match.start("type") + 1)
        return spec.Field(name, type_, default, line.comment, position), column

    def _constant(
        self, line: _Line, type_: spec.Type, name: str, column: int, rest: str, at: int
    ) -> spec.Constant:
        if not type_.is_primitive or type_.shape:
            raise self.fail(line, 0, f"a constant has a plain primitive type, not '{type_}'")
        if not _CONSTANT_NAME.fullmatch(name):
            raise self.fail(
                line, column, f"'{name}' is not a constant's name: upper case letters, digits and underscores"
            )
        return spec.Constant(name, type_, self._value(line, type_, rest, at), line.comment)

    def _value(self, line: _Line, type_: spec.Type, text: str, at: int) -> spec.Value:
        if not type_.is_primitive:
            raise self.fail(line, at, f"a field of type '{type_}' takes no default")
        try:
            return parse_value(type_, text)
        except ValueError as error:
            raise self.fail(line, at, str(error)) from None


def _head_comment(lines: list[_Line]) -> str:
    """Return the comment before the first member and before the first empty line."""
    head: list[str] = []
    for line in lines:
        if line.text or not line.comment:
            break
        head.append(line.comment)
    return " ".join(head)
