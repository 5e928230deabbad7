"""Checks of the messages that a definition refers to: each exists, and none contains itself."""

from __future__ import annotations

from typing import Protocol

from tfloom.ros_imports.distributions import INTERFACES
from tfloom.rosidl import sources, spec
from tfloom.rosidl.parse import ParseError

MAX_NESTING = 100
"""How many messages may be nested in one another."""


class Definitions(Protocol):
    """Where definitions are found: the module `sources`, or a package that is being built."""

    def find_source(self, name: str) -> sources.Source | None:
        """As `sources.find_source`."""

    def find_message(self, name: str) -> spec.Message:
        """As `sources.find_message`."""

    def is_package(self, package: str) -> bool:
        """As `sources.is_package`."""


class UnknownMessageError(ParseError):
    """A field's type is a message that there is no definition of."""

    def __init__(self, place: ParseError, name: str) -> None:
        super().__init__(place.path, place.line, place.column, place.reason)
        self.name = name


def check_references(interface: spec.Interface, definitions: Definitions = sources) -> None:
    """Check that all messages referred to exist, and that none contains itself.

    Raises:
        UnknownMessageError: one is unknown; the text names the file and line of the field, as of the next.
        ParseError: one contains itself, is nested more than `MAX_NESTING` deep, or can't be parsed.
    """
    messages = {message.name: message for message in spec.messages_of(interface)}
    sound: set[str] = set()

    def visit(message: spec.Message, above: tuple[str, ...]) -> None:
        chain = (*above, message.name)
        for field in message.fields:
            name = field.type.base
            if field.type.is_primitive or name in sound:
                continue
            if name in chain:
                circle = " -> ".join((*chain[chain.index(name) :], name))
                raise _at(definitions, message, field, f"a message contains itself: {circle}")
            if len(chain) > MAX_NESTING:
                raise _at(definitions, message, field, f"messages are nested more than {MAX_NESTING} deep")
            try:
                nested = messages.get(name) or definitions.find_message(name)
            except LookupError as error:
                reason = f"{error}{_missing_package(definitions, name)}"
                raise UnknownMessageError(_at(definitions, message, field, reason), name) from None
            visit(nested, chain)
        sound.add(message.name)

    for message in messages.values():
        visit(message, ())


def _at(definitions: Definitions, message: spec.Message, field: spec.Field, reason: str) -> ParseError:
    source = definitions.find_source(sources.definition_name(message.name))
    return ParseError(source.path if source else message.name, *field.position, reason)


def _missing_package(definitions: Definitions, name: str) -> str:
    """Return an addition to the error about an unknown message if its whole package is missing; else empty text."""
    package = name.partition("/")[0]
    if definitions.is_package(package):
        return ""
    if package in INTERFACES.ros_packages:
        return f": {package} comes with the distribution {INTERFACES.name}, which is not installed"
    return f": the package '{package}' is neither on AMENT_PREFIX_PATH nor one of tfloom's own"
