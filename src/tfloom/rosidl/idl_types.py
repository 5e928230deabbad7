"""Reading of IDL's types: those of members, typedefs and constants."""

from __future__ import annotations

from collections.abc import Iterator

from tfloom.rosidl.definition import (
    AbstractNestableType,
    AbstractType,
    Array,
    BasicType,
    BoundedSequence,
    BoundedString,
    BoundedWString,
    NamespacedType,
    UnboundedSequence,
    UnboundedString,
    UnboundedWString,
)
from tfloom.rosidl.idl_reader import Reader
from tfloom.rosidl.idl_tokens import Token

_BASIC = {
    **{name: name for name in ("boolean", "octet", "char", "wchar", "float", "double")},
    **{f"{sign}int{bits}": f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)},
    "short": "int16",
}
_STRINGS = {"string": (UnboundedString, BoundedString), "wstring": (UnboundedWString, BoundedWString)}
_UNKNOWN = frozenset({"any", "bitmask", "bitset", "fixed", "map", "Object", "struct", "union", "ValueBase"})


class TypeReader:
    """The types of one file. Each function raises ParseError for what can't be read.

    Args:
        reader: The file's tokens.
    """

    def __init__(self, reader: Reader) -> None:
        self.reader = reader
        self.struct_names: set[str] = set()
        """The bare names of the structs read so far."""
        self._typedefs: dict[str, AbstractType] = {}
        self._enums: set[str] = set()
        self._scopes: dict[str, list[str]] = {}
        """The modules of each typedef."""

    def read_type(self) -> AbstractType:
        """Read a type: `double`, `sequence<string<5>, 3>`, `geometry_msgs::msg::Point`, or a typedef's name."""
        token = self.reader.next
        if self.reader.skip("sequence"):
            return self._sequence(token)
        if self.reader.skip(*_STRINGS):
            return self._string(token)
        if (basic := self._basic(token)) is not None:
            return BasicType(basic)
        if self.reader.is_next(*_UNKNOWN):
            raise self.reader.fail(f"a member of ROS is not of the type '{token.text}'")
        return self._named(token)

    def _string(self, token: Token) -> AbstractType:
        unbounded, bounded = _STRINGS[token.text]
        if not self.reader.skip("<"):
            return unbounded()
        size = self.reader.positive("the bound of a string", in_brackets=True)
        self.reader.demand(">", "after the string's bound")
        return bounded(size)

    def _basic(self, token: Token) -> str | None:
        if self.reader.skip("unsigned"):
            return f"u{self._integer()}"
        if self.reader.skip("long"):
            return self._long()
        return _BASIC[token.text] if self.reader.skip(*_BASIC) else None

    def _integer(self) -> str:
        if self.reader.skip("short"):
            return "int16"
        if not self.reader.skip("long"):
            raise self.reader.expected("'short' or 'long' after 'unsigned'")
        return "int64" if self.reader.skip("long") else "int32"

    def _long(self) -> str:
        if self.reader.skip("double"):
            return "long double"
        return "int64" if self.reader.skip("long") else "int32"

    def _sequence(self, token: Token) -> AbstractType:
        self.reader.demand("<", "after 'sequence'")
        element = self._nestable(self.read_type(), token)
        size = (
            self.reader.positive("the bound of a sequence", in_brackets=True)
            if self.reader.skip(",")
            else None
        )
        self.reader.demand(">", "after the sequence's type")
        return UnboundedSequence(element) if size is None else BoundedSequence(element, size)

    def _nestable(self, type_: AbstractType, token: Token) -> AbstractNestableType:
        if not isinstance(type_, AbstractNestableType):
            raise self.reader.fail("an element of a sequence or an array is not itself one in ROS", token)
        return type_

    def _named(self, token: Token) -> AbstractType:
        # A typedef may be named with all of its modules, or without any. Every other name with modules is a message,
        # which may be defined in another file and is looked up later.
        name = self.reader.scoped_name("a type")
        base = name[-1]
        if base in self._typedefs and name[:-1] in ([], self._scopes[base]):
            return self._typedefs[base]
        if base in self._enums and len(name) == 1:
            raise self.reader.fail(
                f"'{base}' is an enumeration, and a member of ROS is not: use uint8, and constants", token
            )
        if len(name) > 1:
            return NamespacedType(name[:-1], base)
        if base in self.struct_names:
            raise self.reader.fail(f"write the full name of the struct '{base}', with its modules", token)
        raise self.reader.fail(
            f"there is no type '{base}' before this line; a message is written 'package::msg::{base}'", token
        )

    def read_declarators(self, base: AbstractType) -> Iterator[tuple[Token, AbstractType]]:
        """Yield the names that follow a type, `a, b[3]`, each with its own type."""
        while True:
            name = self.reader.name("a name after the type")
            sizes: list[int] = []
            while self.reader.skip("["):
                sizes.append(self.reader.positive("the length of an array"))
                self.reader.demand("]", "after the array's length")
            if len(sizes) > 1:
                raise self.reader.fail("an array of ROS has one dimension", name)
            yield name, Array(self._nestable(base, name), sizes[0]) if sizes else base
            if not self.reader.skip(","):
                return

    def read_typedef(self, modules: list[str]) -> None:
        """Read a typedef after its first word; `modules` are those around it."""
        base = self.read_type()
        for name, type_ in self.read_declarators(base):
            if self._typedefs.setdefault(name.text, type_) != type_:
                raise self.reader.fail(f"'{name.text}' is another type before this line", name)
            self._scopes.setdefault(name.text, list(modules))

    def read_enum(self) -> None:
        """Read an enumeration after its first word. ROS ignores those that no member uses."""
        self._enums.add(self.reader.name("the enumeration's name").text)
        self.reader.demand("{", "after the enumeration's name")
        while True:
            self.reader.annotations()
            self.reader.name("the name of an enumerator")
            if not self.reader.skip(","):
                break
        self.reader.demand("}", "after the last enumerator")
