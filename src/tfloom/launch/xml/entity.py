"""Elements of launch files in XML."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Protocol

from tfloom.launch.core.entity import Entity as BaseEntity
from tfloom.launch.frontend.type_utils import check_is_list_entity
from tfloom.launch.utilities.nearest import did_you_mean, names_with_hints
from tfloom.launch.utilities.type_utils import get_typed_value

__all__ = ["Entity"]


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
