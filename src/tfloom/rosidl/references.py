"""Checks of the messages that a definition refers to: each exists, and none contains itself."""

from __future__ import annotations

from tfloom.rosidl import definition_files, sources, spec
from tfloom.rosidl.parse import ParseError

MOST_NESTED = 100
"""How many messages may be nested in one another."""


def check_references(interface: spec.Interface) -> None:
    """Check that all messages referred to exist, and that none contains itself.

    Raises:
        ParseError: one is unknown, contains itself, is nested more than `MOST_NESTED` deep, or can't be parsed; the
            text names the file and line of the field.
    """
    known = {message.name: message for message in spec.messages_of(interface)}
    sound: set[str] = set()

    def visit(message: spec.Message, above: tuple[str, ...]) -> None:
        chain = (*above, message.name)
        for field in message.fields:
            name = field.type.base
            if field.type.is_primitive or name in sound:
                continue
            if name in chain:
                circle = " -> ".join((*chain[chain.index(name) :], name))
                raise _at(message, field, f"a message contains itself: {circle}")
            if len(chain) > MOST_NESTED:
                raise _at(message, field, f"messages are nested more than {MOST_NESTED} deep")
            try:
                nested = known.get(name) or sources.find_message(name)
            except LookupError as error:
                raise _at(message, field, f"{error}{_missing_package(name)}") from None
            visit(nested, chain)
        sound.add(message.name)

    for message in known.values():
        visit(message, ())


def _at(message: spec.Message, field: spec.Field, reason: str) -> ParseError:
    source = sources.find_source(sources.definition_name(message.name))
    return ParseError(source.path if source else message.name, *field.position, reason)


def _missing_package(name: str) -> str:
    """Return an addition to the error about an unknown message if its whole package is missing; else empty text."""
    package = name.partition("/")[0]
    if sources.is_package(package):
        return ""
    if package in definition_files.EXTRA_PACKAGES:
        return f": {package} comes with the distribution tfloom-interfaces, which is not installed"
    return f": the package '{package}' is neither on AMENT_PREFIX_PATH nor one of tfloom's own"
