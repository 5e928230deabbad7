"""Launch files in YAML: their entities, and their parser."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, NamedTuple, TextIO

from tfloom.launch.core.base_classes import SomeSubstitutionsType
from tfloom.launch.core.entity import Entity as BaseEntity
from tfloom.launch.core.error_places import place_error
from tfloom.launch.files.sources import FrontendLaunchDescriptionSource
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError, read_content
from tfloom.launch.frontend.parser import Parser as BaseParser
from tfloom.launch.frontend.type_utils import check_is_list_entity
from tfloom.launch.utilities.texts import did_you_mean, names_with_hints
from tfloom.launch.utilities.type_utils import is_instance_of

__all__ = ["Entity", "Parser", "Places", "YAMLLaunchDescriptionSource"]


class Places(NamedTuple):
    """Where the elements of a file are."""

    file: str
    """Path of the file."""
    lines: Mapping[int, int]
    """Line of each mapping and list, from 1, by the id of its value."""


class Entity(BaseEntity):
    """An element of a YAML text: a mapping with its attributes, or a list of the elements in it.

    Args:
        element: The mapping or list. Without `type_name`, a mapping of the element's name to it.
        type_name: Name of the element.
        parent: The element that it is in.
    """

    def __init__(self, element: Any, type_name: str | None = None, *, parent: Entity | None = None) -> None:
        if type_name is None:
            type_name, element = _only_item(element)
        self._type_name = type_name
        self._element = element
        self._parent = parent
        self._asked: set[str] = set()
        self._read: set[str] = set()
        self._children_read = False
        self.places: Places = parent.places if parent is not None else Places("", {})
        self._line = self.places.lines.get(id(element))

    @property
    def type_name(self) -> str:
        """Name of the element."""
        return self._type_name

    @property
    def parent(self) -> Entity | None:
        """Element that this one is in."""
        return self._parent

    @property
    def place(self) -> str:
        """File and line, as `file.launch.yaml:3`; "" if they aren't known."""
        return f"{self.places.file}:{self._line}" if self._line is not None else ""

    def set_places(self, places: Places) -> None:
        """Set the places of the element, and of those that will be read from it."""
        self.places = places
        self._line = places.lines.get(id(self._element), 1)

    @property
    def children(self) -> list[BaseEntity]:
        """All elements in this one: the list, or the mapping's item `children`.

        Raises:
            TypeError: there is no list of elements.
            ValueError: the mapping has no `children`.
        """
        self._children_read = True
        listed = self._element
        if isinstance(listed, dict):
            self._asked.add("children")
            if "children" not in listed:
                raise ValueError(f"Expected entity `{self._type_name}` to have children entities.")
            self._read.add("children")
            listed = listed["children"]
        if not isinstance(listed, list):
            raise TypeError(
                f"Expected a dict or list, got {type(listed)}: the elements of `{self._type_name}` are a list"
            )
        return [self._child(element) for element in listed]

    def _child(self, element: Any, type_name: str | None = None) -> Entity:
        try:
            child = Entity(element, type_name, parent=self)
        except TypeError as error:
            line = self.places.lines.get(id(element), self._line)
            error.args = (f"in `{self._type_name}`: {error}",)
            place_error(error, f"{self.places.file}:{line}" if line is not None else "")
            raise
        child._line = self.places.lines.get(id(element), self._line)
        return child

    def assert_entity_completely_parsed(self) -> None:
        """Check that all keys and elements have been read.

        Raises:
            ValueError: some have not, because the action does not have them. The error names all of them.
        """
        if isinstance(self._element, list):
            if not self._children_read:
                raise ValueError(
                    f"Unexpected nested entity(ies) found in `{self._type_name}`: {self._element}"
                )
            return
        unread = [str(key) for key in self._attributes() if key not in self._read]
        if unread:
            listed = names_with_hints(unread, self._asked - self._read)
            raise ValueError(f"Unexpected key(s) found in `{self._type_name}`: {listed}")

    def _attributes(self) -> dict[Any, Any]:
        """Return the mapping; an element without one, as in `- node:`, has no attributes."""
        if isinstance(self._element, dict):
            return self._element
        if self._element is None or isinstance(self._element, list):
            return {}
        raise TypeError(
            f"Expected entity `{self._type_name}` to have attributes, "
            f"got {type(self._element)}: {self._element!r}"
        )

    def get_attr(
        self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True
    ) -> Any:
        """Return an attribute.

        Args:
            name: Its name.
            data_type: str, int, float, bool, `List[…]` of one of them, `List[Entity]` for a list of mappings; None for
                any of them.
            optional: Whether it may be missing, and None is returned.
            can_be_str: Whether it may also be a text, as for substitutions.

        Raises:
            AttributeError: it is missing.
            TypeError: it has another type.
        """
        self._asked.add(name)
        attributes = self._attributes()
        if name not in attributes:
            if optional:
                return None
            near = did_you_mean(name, {str(key) for key in attributes} - self._asked)
            raise AttributeError(f"Can not find attribute '{name}' in Entity '{self._type_name}'{near}")
        self._read.add(name)
        data = attributes[name]
        if check_is_list_entity(data_type):
            if isinstance(data, list) and all(isinstance(element, dict) for element in data):
                return [self._child(element, name) for element in data]
            raise TypeError(
                f"Attribute '{name}' of Entity '{self._type_name}' expected to be a list of dictionaries."
            )
        is_of_numbers = isinstance(data, list) and {type(item) for item in data} == {int, float}
        if not (is_of_numbers and data_type is None) and not is_instance_of(
            data, data_type, can_be_str=can_be_str
        ):
            quoted = f"; a text has quotation marks: '{data}'" if data_type is str and _scalar(data) else ""
            raise TypeError(
                f"Attribute '{name}' of Entity '{self._type_name}' expected to be of type '{data_type}', "
                f"got '{type(data)}'{quoted}"
            )
        return data


def _only_item(element: Any) -> tuple[str, Any]:
    if not isinstance(element, dict) or len(element) != 1:
        actual_element = ", ".join(map(repr, element)) if isinstance(element, dict) else repr(element)
        raise TypeError(
            f"Subentities must be a dictionary of length one, of the tag to its attributes, and not {actual_element}"
        )
    name, value = next(iter(element.items()))
    return str(name), value


def _scalar(value: Any) -> bool:
    return isinstance(value, (int, float, bool))


class Parser(BaseParser):
    """Reads launch files in YAML."""

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return `yaml` and `yml`."""
        return {"yaml", "yml"}

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """Return the root of a launch file, and its parser.

        Args:
            file: Its path, or the open file.

        Raises:
            OSError: the file cannot be read.
            InvalidFrontendLaunchFileError: it isn't YAML, or not a mapping with one key.
        """
        name, content = read_content(file)
        return _root(content, name), cls()


def _is_text(plain: str) -> bool:
    """Return whether a plain scalar is a text in ROS's files of parameters: 12:30, 0b11, 1_000, 2026-01-31."""
    from tfloom.node.values.scalars import parse_scalar

    return isinstance(parse_scalar(plain), str)


def _root(content: bytes, name: str) -> Entity:
    from tfloom.common.yaml import YamlError, load_placed  # loads yaml

    try:
        tree, lines = load_placed(content.decode(), mark_quoted=True, is_text=_is_text)
    except YamlError as error:
        message = f"{name}:{error.line}: {error}" if error.line is not None else f"{name}: {error}"
        raise InvalidFrontendLaunchFileError.with_message(message, error) from error
    except UnicodeDecodeError as error:
        raise InvalidFrontendLaunchFileError.with_message(
            f"{name}: it is not UTF-8: {error}", error
        ) from error
    if not isinstance(tree, dict) or not tree:
        actual_root = "it is empty" if not tree else f"it is a {type(tree).__name__}"
        message = f"{name}:1: {actual_root}, and should be a dictionary with the key 'launch'"
        raise InvalidFrontendLaunchFileError.with_message(message)
    if len(tree) > 1:
        keys = ", ".join(f"'{key}'" for key in tree)
        message = f"{name}:1: Expected only one root, 'launch', and there are {keys}"
        raise InvalidFrontendLaunchFileError.with_message(message)
    root = Entity(tree)
    root.set_places(Places(name, lines))
    return root


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """The launch description in a YAML file.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(launch_file_path, method="interpreted YAML launch file", parser=Parser)
