"""Launch files in XML: their elements with places, as entities, and their parser."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any, Protocol, TextIO
from xml.parsers import expat

from tfloom.common.xml import make_parser, readable
from tfloom.launch.core.base_classes import SomeSubstitutionsType
from tfloom.launch.core.entity import Entity as BaseEntity
from tfloom.launch.files.sources import FrontendLaunchDescriptionSource
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError, read_content
from tfloom.launch.frontend.parser import Parser as BaseParser
from tfloom.launch.frontend.type_utils import check_is_list_entity
from tfloom.launch.utilities.texts import did_you_mean, names_with_hints
from tfloom.launch.utilities.type_utils import get_typed_value

__all__ = ["Element", "Entity", "Parser", "XMLLaunchDescriptionSource", "XmlError", "read_elements"]

_DEEPEST = 100


class XmlError(ValueError):
    """A text isn't well-formed XML, or declares entities.

    Args:
        problem: What is wrong.
        line: Line of the text, from 1.
    """

    def __init__(self, problem: str, line: int) -> None:
        super().__init__(problem)
        self.line = line


class Element:
    """An element with its place, and with the attributes that entities need of those of `xml.etree`.

    Args:
        tag: Its tag.
        attrib: Its attributes.
        place: File and line, as `file.launch.xml:3`.
    """

    def __init__(self, tag: str, attrib: dict[str, str], place: str) -> None:
        self.tag = tag
        self.attrib = attrib
        self.place = place
        self.children: list[Element] = []

    def __iter__(self) -> Iterator[Element]:
        return iter(self.children)


class _Builder:
    """Builds the tree from expat's events."""

    def __init__(self, file: str) -> None:
        self._file = file
        self.parser = make_parser(self._refuse_entity_declaration)
        self._open: list[Element] = []
        self.root: Element | None = None
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._close_element
        self.parser.SkippedEntityHandler = self._refuse_undefined_entity

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        line = self.parser.CurrentLineNumber
        if len(self._open) >= _DEEPEST:
            raise XmlError(f"it is nested deeper than {_DEEPEST} levels", line)
        element = Element(tag, attributes, f"{self._file}:{line}")
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)

    def _close_element(self, _tag: str) -> None:
        self._open.pop()

    def _refuse_entity_declaration(self, name: str) -> None:
        line = self.parser.CurrentLineNumber
        raise XmlError(f"it declares the entity '{name}', which launch files cannot do", line)

    def _refuse_undefined_entity(self, name: str, _is_parameter: object) -> None:
        raise XmlError(f"undefined entity '&{name};'", self.parser.CurrentLineNumber)


def read_elements(text: bytes, file: str) -> Element:
    """Return the root of an XML text.

    Args:
        text: The text, in the encoding that it declares, or UTF-8.
        file: Its path, for the elements' places.

    Raises:
        XmlError: it isn't well-formed, declares entities, or is nested too deep.
    """
    builder = _Builder(file)
    try:
        builder.parser.Parse(readable(text), True)
    except expat.ExpatError as error:
        where = f"line {error.lineno}, column {error.offset}"
        problem = f"it is not well-formed XML: {expat.ErrorString(error.code)}: {where}"
        raise XmlError(problem, error.lineno) from None
    except (
        LookupError,
        UnicodeError,
    ) as error:  # of an encoding that Python doesn't know, or not in the declared one
        raise XmlError(str(error), 1) from None
    if builder.root is None:
        raise XmlError("it is empty", 1)
    return builder.root


class ReadsAsElement(Protocol):
    """An element, of `xml.etree` or read by tfloom."""

    @property
    def tag(self) -> str:
        """Name of the tag."""

    @property
    def attrib(self) -> dict[str, str]:
        """Values of the attributes by their names."""

    def __iter__(self) -> Iterator[ReadsAsElement]: ...


class Entity(BaseEntity):
    """An element of an XML text.

    Args:
        xml_element: The element.
        parent: The element that it is in.
    """

    def __init__(self, xml_element: ReadsAsElement, *, parent: Entity | None = None) -> None:
        self._element = xml_element
        self._parent = parent
        self._asked: set[str] = set()
        self._read_attributes: set[str] = set()
        self._read_tags: set[str] = set()

    @property
    def type_name(self) -> str:
        """Name of the tag."""
        return self._element.tag

    @property
    def parent(self) -> Entity | None:
        """Element that this one is in."""
        return self._parent

    @property
    def place(self) -> str:
        """File and line, as `file.launch.xml:3`; "" if they aren't known."""
        return str(getattr(self._element, "place", ""))

    @property
    def children(self) -> list[BaseEntity]:
        """All elements in this one."""
        self._read_tags = {child.tag for child in self._element}
        return [Entity(child, parent=self) for child in self._element]

    def assert_entity_completely_parsed(self) -> None:
        """Check that all attributes and elements have been read.

        Raises:
            ValueError: some have not, because the action does not have them. The error names all of them.
        """
        tags = {child.tag for child in self._element} - self._read_tags
        attributes = set(self._element.attrib) - self._read_attributes
        accepted = self._asked - self._read_attributes - self._read_tags
        faults = [
            f"Unexpected {what}(s) found in `{self.type_name}`: {names_with_hints(unread, accepted)}"
            for what, unread in (("nested tag", tags), ("attribute", attributes))
            if unread
        ]
        if faults:
            raise ValueError("; ".join(faults))

    def get_attr(
        self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True
    ) -> Any:
        """Return an attribute, of the type that its text stands for by YAML's rules.

        Args:
            name: Its name.
            data_type: str, int, float, bool, `List[…]` of one of them, `List[Entity]` for the elements with this tag;
                None for what the text looks like. With an attribute `name-sep`, the text is a list with this separator.
            optional: Whether it may be missing, and None is returned.
            can_be_str: Whether a text that is not a value of the type is returned as it is, as for substitutions.

        Raises:
            AttributeError: it is missing.
            TypeError: it has another type.
        """
        self._asked.add(name)
        if check_is_list_entity(data_type):
            children = [Entity(child, parent=self) for child in self._element if child.tag == name]
            if children:
                self._read_tags.add(name)
                return children
        elif name in self._element.attrib:
            return self._value(name, data_type, can_be_str=can_be_str)
        if optional:
            return None
        near = did_you_mean(name, self._unread_names())
        raise AttributeError(
            f"Attribute '{name}' of type '{data_type}' not found in Entity '{self.type_name}'{near}"
        )

    def _value(self, name: str, data_type: Any, *, can_be_str: bool) -> Any:
        value: str | list[str] = self._element.attrib[name]
        self._read_attributes.add(name)
        separator = self._element.attrib.get(f"{name}-sep")
        if separator is not None:
            self._read_attributes.add(f"{name}-sep")
            if not separator:
                raise ValueError(f"Attribute '{name}-sep' of Entity '{self.type_name}' is empty")
            value = self._element.attrib[name].split(separator)
        try:
            return get_typed_value(value, data_type, can_be_str=can_be_str)
        except ValueError as error:
            raise TypeError(
                f"Attribute '{name}' of Entity '{self.type_name}' expected to be of type '{data_type}'. "
                f"'{value}' can not be converted to one of those types"
            ) from error

    def _unread_names(self) -> set[str]:
        return {*self._element.attrib, *(child.tag for child in self._element)} - self._asked


class Parser(BaseParser):
    """Reads launch files in XML."""

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return `xml`."""
        return {"xml"}

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """Return the root of a launch file, and its parser.

        Args:
            file: Its path, or the open file.

        Raises:
            OSError: the file cannot be read.
            InvalidFrontendLaunchFileError: it isn't well-formed XML.
        """
        name, content = read_content(file)
        try:
            return Entity(read_elements(content, name)), cls()
        except XmlError as error:
            message = f"{name}:{error.line}: {error}"
            raise InvalidFrontendLaunchFileError.with_message(message, error) from error


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """The launch description in an XML file.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(launch_file_path, method="interpreted XML launch file", parser=Parser)
