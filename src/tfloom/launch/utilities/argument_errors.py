"""What is said of wrong arguments of actions; constructors raise it themselves, so that tracebacks are short."""

from __future__ import annotations

import inspect
from collections.abc import Collection, Iterable, Mapping
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any

from tfloom.common.text import given_text
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, Substitution

__all__ = ["entities_error", "entity_error", "substitutions_error", "unknown_argument_error", "words_error"]


def substitutions_error(what: str, value: object) -> TypeError | None:
    """Return the error of a value that is neither a text nor a substitution nor a list of them; None if it is one."""
    if isinstance(value, (str, Path, Substitution)):
        return None
    if isinstance(value, Iterable) and not isinstance(value, (bytes, Mapping)):
        return None
    meant = f": write {str(value)!r}" if isinstance(value, (int, float)) else ""
    return TypeError(
        f"{what}: '{value}' of type '{type(value).__name__}' is neither a text nor a Substitution "
        f"nor a list of them{meant}"
    )


def words_error(what: str, words: object) -> TypeError | None:
    """Return the error of what is not a list of words of a command line, each a text or substitutions."""
    if isinstance(words, str) and len(words) > 1:  # one letter is the same as a list with it
        return TypeError(f"{what} is a list of words, got {words!r}: write {words.split()}")
    if not isinstance(words, Iterable):
        return TypeError(f"{what} is a list of words, got {words!r} of class {type(words).__name__}")
    if not isinstance(words, Collection):  # an iterator, which is read once
        return None
    errors = (substitutions_error(f"a word of {what}", word) for word in words)
    return next((error for error in errors if error is not None), None)


def unknown_argument_error(action_class: type, given: Iterable[str]) -> TypeError | None:
    """Return the error of a keyword that no constructor of the class or its bases takes; it names the nearest."""
    known = _argument_names(action_class)
    name = next((name for name in given if name not in known), None)
    if name is None:
        return None
    nearest = get_close_matches(name, known, n=1)
    meant = f": did you mean {nearest[0]!r}?" if nearest else ""
    # It begins as the reference's text does, which Python makes: the last constructor's.
    return TypeError(f"Action.__init__() got an unexpected keyword argument {name!r}{meant}")


@cache
def _argument_names(action_class: type) -> frozenset[str]:
    constructors = [vars(base)["__init__"] for base in action_class.__mro__[:-1] if "__init__" in vars(base)]
    return frozenset(name for init in constructors for name in inspect.signature(init).parameters)


def entities_error(what: str, entities: Any) -> TypeError | None:
    """Return the error of what is not a list of entities, or None if it is one."""
    if isinstance(entities, LaunchDescriptionEntity):
        name = type(entities).__name__
        return TypeError(f"'{name}' object is not iterable: {what} needs a list, write [{name}(…)]")
    if not isinstance(entities, Iterable):
        return TypeError(f"{what} needs a list of actions, got {_given(entities)}")
    return None


def entity_error(what: str, entity: Any) -> TypeError | None:
    """Return the error of what is given in place of an action or another entity, or None if it is one."""
    if hasattr(entity, "visit"):
        return None
    asked = ": does the function that creates it return it?" if entity is None else ""
    return TypeError(f"{what} needs actions, got {_given(entity)}{asked}")


def _given(value: object) -> str:
    return "None" if value is None else given_text(value)
