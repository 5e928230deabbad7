"""`rosidl_parser.parser`: parsing of ROS's dialect of IDL (.idl files). An error is a `ParseError`.

A file defines one message, service or action: one, two or three structs, in modules such as `my_interfaces::msg`. Of
IDL 4.2, ROS has modules, structs, constants, typedefs, enumerations, annotations and #include.
"""

from __future__ import annotations

from typing import NamedTuple

from tfloom.rosidl.definition import (
    CONSTANT_MODULE_SUFFIX,
    AbstractGenericString,
    AbstractWString,
    Action,
    Annotation,
    BasicType,
    BoundedString,
    BoundedWString,
    Constant,
    IdlContent,
    IdlFile,
    IdlLocator,
    Include,
    Member,
    Message,
    NamespacedType,
    Service,
    Structure,
)
from tfloom.rosidl.idl_reader import Reader
from tfloom.rosidl.idl_tokens import Token
from tfloom.rosidl.idl_types import TypeReader
from tfloom.rosidl.parse import read_text

_MAX_MODULES = 20
_PARTS = {1: ("",), 2: ("_Request", "_Response"), 3: ("_Goal", "_Result", "_Feedback")}
"""The suffixes of a file's structs, by their number."""


def parse_idl_file(locator: IdlLocator, png_file: None = None) -> IdlFile:
    """Parse a file.

    Args:
        locator: Its path.
        png_file: None: tfloom draws no syntax trees.

    Raises:
        ParseError: the file is not IDL as ROS has it; the text has the line and column.
        OSError: it can't be read.
        NotImplementedError: `png_file` is not None.
    """
    if png_file is not None:
        raise NotImplementedError("parse_idl_file() draws no syntax trees: leave png_file out")
    path = locator.get_absolute_path()
    return IdlFile(locator, parse_content(read_text(path), str(path)))


def parse_idl_string(idl_string: str, png_file: None = None) -> IdlContent:
    """Parse a text.

    Args:
        idl_string: The content of an .idl file.
        png_file: None: tfloom draws no syntax trees.

    Raises:
        ParseError: it is not IDL as ROS has it; the text has the line and column.
        NotImplementedError: `png_file` is not None.
    """
    if png_file is not None:
        raise NotImplementedError("parse_idl_string() draws no syntax trees: leave png_file out")
    return parse_content(idl_string, "<idl>")


def parse_content(text: str, path: str) -> IdlContent:
    """Return the includes of a text, and the message, service or action that it defines.

    Raises:
        ParseError: it is not IDL as ROS has it; the text has `path`, line and column.
    """
    return _Parser(text, path).content()


class _Struct(NamedTuple):
    message: Message
    name: Token


class _Parser:
    def __init__(self, text: str, path: str) -> None:
        self.reader = Reader(text, path)
        self.types = TypeReader(self.reader)
        self.modules: list[str] = []
        self.includes: list[Include] = []
        self.structs: list[_Struct] = []
        self.constants: dict[str, list[Constant]] = {}
        """The constants of each module, by the module's bare name."""

    def content(self) -> IdlContent:
        while self.reader.next.kind != "end":
            self._definition()
        # The definitions of a file may come in any order, so constants are added to their structs at the end. A module
        # such as Point_Constants belongs to the struct Point.
        content = IdlContent()
        content.elements += self.includes
        for struct in self.structs:
            module = struct.message.structure.namespaced_type.name + CONSTANT_MODULE_SUFFIX
            struct.message.constants += self.constants.get(module, [])
        element = self._element()
        if isinstance(element, Action):
            # An action needs types of ROS's own, which the file may include by itself, too.
            written = {include.locator for include in self.includes}
            content.elements += [
                include for include in element.implicit_includes if include.locator not in written
            ]
        content.elements.append(element)
        return content

    def _element(self) -> Message | Service | Action:
        suffixes = _PARTS.get(len(self.structs))
        if suffixes is None:
            last = self.structs[-1].name if self.structs else None
            raise self.reader.fail(
                "a file defines one message, service or action, which is 1, 2 or 3 structs; "
                f"this one has {len(self.structs)}",
                last,
            )
        # All structs must be of one module, and have one name with the suffixes of their kind, in this order. A file
        # with Foo_Request and Bar_Response would otherwise become a service that nobody meant.
        types = [struct.message.structure.namespaced_type for struct in self.structs]
        base = types[0].name.removesuffix(suffixes[0])
        for struct, type_, suffix in zip(self.structs, types, suffixes, strict=True):
            if (type_.namespaces, type_.name) != (types[0].namespaces, base + suffix) or not base:
                module = "::".join(types[0].namespaces)
                wanted = " and ".join(f"{module}::{base or 'Name'}{ending}" for ending in suffixes)
                raise self.reader.fail(f"a file with {len(suffixes)} structs has {wanted}", struct.name)
        whole = NamespacedType(types[0].namespaces, base)
        messages = [struct.message for struct in self.structs]
        if len(messages) == 1:
            return messages[0]
        return Service(whole, *messages) if len(messages) == 2 else Action(whole, *messages)

    def _definition(self) -> None:
        if self.reader.next.kind == "include":
            self.includes.append(Include(self.reader.take().text.split("include", 1)[1].strip()[1:-1]))
            return
        annotations = self.reader.annotations()
        token = self.reader.next
        if self.reader.skip("module"):
            self._module()
        elif self.reader.skip("const"):
            self._constant(annotations)
        elif self.reader.skip("struct"):
            self._struct(annotations)
        elif self.reader.skip("typedef"):
            self.types.read_typedef(self.modules)
        elif self.reader.skip("enum"):
            self.types.read_enum()
        elif token.kind == "word":
            raise self.reader.fail(
                f"'{token.text}' starts no definition of ROS's IDL: it has module, struct, const, typedef and enum"
            )
        else:
            raise self.reader.expected("a definition: module, struct, const, typedef or enum")
        self.reader.demand(";", f"after the {token.text}")

    def _module(self) -> None:
        name = self.reader.name("the module's name")
        if len(self.modules) == _MAX_MODULES:
            raise self.reader.fail(f"modules are nested more than {_MAX_MODULES} deep", name)
        self.reader.demand("{", "after the module's name")
        self.modules.append(name.text)
        while not self.reader.skip("}"):
            self._definition()
        self.modules.pop()

    def _constant(self, annotations: list[Annotation]) -> None:
        start = self.reader.next
        type_ = self.types.read_type()
        name = self.reader.name("the constant's name")
        self.reader.demand("=", "after the constant's name")
        at = self.reader.next
        value = self.reader.expression()
        if not isinstance(type_, (BasicType, AbstractGenericString)):
            raise self.reader.fail("a constant is a number, a boolean or a string", start)
        if isinstance(value, str) != isinstance(type_, AbstractGenericString):
            raise self.reader.fail(f"{value!r} is not a value of the constant's type", at)
        # The type of a string constant is bounded by the length of its value.
        if isinstance(value, str):
            type_ = (BoundedWString if isinstance(type_, AbstractWString) else BoundedString)(len(value))
        constant = Constant(name.text, type_, value)
        constant.annotations, constant.position = annotations, name.position
        constants = self.constants.setdefault(self.modules[-1] if self.modules else "", [])
        if any(other.name == name.text for other in constants):
            raise self.reader.fail(f"'{name.text}' is defined twice", name)
        constants.append(constant)
        self.reader.constants[name.text] = value

    def _struct(self, annotations: list[Annotation]) -> None:
        name = self.reader.name("the struct's name")
        if self.reader.is_next(";"):  # a declaration ahead of the definition
            return
        if self.reader.is_next(":"):
            raise self.reader.fail("a struct of ROS has no base")
        structure = Structure(NamespacedType(self.modules, name.text))
        structure.annotations, structure.position = annotations, name.position
        self.reader.demand("{", "after the struct's name")
        while not self.reader.skip("}"):
            self._members(structure)
        if not structure.members:
            raise self.reader.fail(
                "a struct has one member or more: ROS gives an empty one the member "
                "'uint8 structure_needs_at_least_one_member'",
                name,
            )
        self.structs.append(_Struct(Message(structure), name))
        self.types.struct_names.add(name.text)

    def _members(self, structure: Structure) -> None:
        annotations = self.reader.annotations()
        base = self.types.read_type()
        for name, type_ in self.types.read_declarators(base):
            if any(other.name == name.text for other in structure.members):
                raise self.reader.fail(f"'{name.text}' is defined twice", name)
            member = Member(type_, name.text)
            member.annotations += annotations
            member.position = name.position
            structure.members.append(member)
        self.reader.demand(";", "after the member")
