"""Names of nodes, namespaces, topics and services: validation, and expansion to full names."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from tfloom.ros_imports.guard import ros_home

# ROS's own names end in "Exception".

__all__ = [
    "HIDDEN_TOPIC_PREFIX",
    "TOPIC_SEPARATOR_STRING",
    "InvalidNamespaceException",
    "InvalidNodeNameException",
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "NameValidationException",
    "expand_topic_name",
    "expansion_error",
    "full_name_error",
    "full_node_name",
    "name_error",
    "namespace_error",
    "node_name_error",
    "topic_or_service_is_hidden",
    "validate_full_topic_name",
    "validate_namespace",
    "validate_node_name",
    "validate_topic_name",
]

TOPIC_SEPARATOR_STRING = "/"
HIDDEN_TOPIC_PREFIX = "_"

# DDS allows 255 bytes, of which the longest prefix and suffix, "rq/" and "Reply", take 8.
TOPIC_NAME_LIMIT = 247
NAMESPACE_LIMIT = 245
NODE_NAME_LIMIT = 255

_Finding = tuple[str, int]
_SUBSTITUTED = ("node", "ns", "namespace")
_UNBALANCED = "topic name must not have unmatched (unbalanced) curly braces '{}'"
_SUBSTITUTION = re.compile(r"\{([^{}]*)\}")


class NameValidationException(ValueError):
    """A name is not valid in ROS.

    Attributes:
        name_type: Kind of name, e.g. "node name".
        name: The name.
        error_msg: The rule that it violates.
        invalid_index: Index of the first invalid character, from 0.
    """

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  '{name}'\n   {' ' * invalid_index}^")
        self.name_type = name_type
        self.name = name
        self.error_msg = error_msg
        self.invalid_index = invalid_index


class InvalidNamespaceException(NameValidationException):
    """A namespace is not valid."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("namespace", name, error_msg, invalid_index)


class InvalidNodeNameException(NameValidationException):
    """A node's name is not valid."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("node name", name, error_msg, invalid_index)


class InvalidTopicNameException(NameValidationException):
    """A topic's name is not valid."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("topic name", name, error_msg, invalid_index)


class InvalidServiceNameException(NameValidationException):
    """A service's name is not valid."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("service name", name, error_msg, invalid_index)


def _text_error(what: str, name: object) -> TypeError:
    return TypeError(f"a {what} must be a str, not {name!r} of class {type(name).__name__}")


def _first_match_index(pattern: str, text: str) -> int | None:
    match = re.search(pattern, text)
    return match.start() if match else None


def _check_node_name(name: str) -> _Finding | None:
    if not name:
        return "node name must not be empty", 0
    at = _first_match_index(r"[^A-Za-z0-9_]", name)
    if at is not None:
        return "node name must not contain characters other than alphanumerics or '_'", at
    if name[0].isdigit():
        return "node name must not start with a number", 0
    if len(name) > NODE_NAME_LIMIT:
        return f"node name length should not exceed '{NODE_NAME_LIMIT}'", NODE_NAME_LIMIT
    return None


def _check_absolute(name: str, what: str) -> _Finding | None:
    """Check the rules common to full topic names and namespaces; `name` isn't empty."""
    at = _first_match_index(r"[^A-Za-z0-9_/]", name)
    if at is not None:
        return f"{what} must not contain characters other than alphanumerics, '_', or '/'", at
    at = _first_match_index(r"(?<=/)/", name)
    if at is not None:
        return f"{what} must not contain repeated '/'", at
    at = _first_match_index(r"/[0-9]", name)
    if at is not None:
        return f"{what} must not have a token that starts with a number", at + 1
    return None


def _check_namespace(namespace: str) -> _Finding | None:
    if not namespace:
        return "namespace must not be empty", 0
    if namespace[0] != "/":
        return "namespace must be absolute, it must lead with a '/'", 0
    if len(namespace) > 1 and namespace[-1] == "/":
        return "namespace must not end with a '/', unless only a '/'", len(namespace) - 1
    finding = _check_absolute(namespace, "namespace")
    if finding is None and len(namespace) > NAMESPACE_LIMIT:
        return f"namespace should not exceed '{NAMESPACE_LIMIT}'", NAMESPACE_LIMIT
    return finding


def _check_full_topic_name(name: str) -> _Finding | None:
    if not name:
        return "topic name must not be empty", 0
    if name[0] != "/":
        return "topic name must be absolute, it must lead with a '/'", 0
    if name[-1] == "/":
        return "topic name must not end with a '/'", len(name) - 1
    finding = _check_absolute(name, "topic name")
    if finding is None and len(name) > TOPIC_NAME_LIMIT:
        return f"topic length should not exceed '{TOPIC_NAME_LIMIT}'", TOPIC_NAME_LIMIT
    return finding


def _check_characters(name: str) -> _Finding | None:
    """Check a topic's characters from the first to the last, of which the first that is wrong is told."""
    opened: int | None = None
    for at, character in enumerate(name):
        if character == "{" and opened is None:
            opened = at
        elif character == "}":
            if opened is None:
                return _UNBALANCED, at
            opened = None
        elif character == "~" and at > 0:
            return "topic name must not have tilde '~' unless it is the first character", at
        elif opened is not None:
            if character.isdigit() and character.isascii() and at == opened + 1:
                return "substitution name must not start with a number", at
            if not _is_word(character):
                text = "substitution name must not contain characters other than alphanumerics or '_'"
                return text, at
        elif not _is_word(character) and character not in "/~":
            text = "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"
            return text, at
    return None if opened is None else (_UNBALANCED, opened)


def _is_word(character: str) -> bool:
    return character == "_" or (character.isascii() and character.isalnum())


def _check_topic_name(name: str) -> _Finding | None:
    if not name:
        return "topic name must not be empty string", 0
    starts_with_number = "topic name token must not start with a number"
    if re.match(r"[0-9]", name):
        return starts_with_number, 0
    if name[-1] == "/":
        return "topic name must not end with a forward slash", len(name) - 1
    finding = _check_characters(name)
    if finding is not None:
        return finding
    if re.match(r"~[^/].", name):  # of `~a`, the reference takes no notice
        return "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1
    at = _first_match_index(r"(?<=/)[0-9]", name)
    return None if at is None else (starts_with_number, at)


def validate_node_name(node_name: str) -> bool:
    """Return True for a valid node name, such as `my_node`.

    Raises:
        InvalidNodeNameException: the name isn't valid; the exception has the rule and the index.
        TypeError: the name is not a str.
    """
    if (error := node_name_error(node_name)) is not None:
        raise error
    return True


def node_name_error(node_name: object) -> Exception | None:
    """Return what `validate_node_name` raises, or None, for callers whose tracebacks shall be short."""
    if not isinstance(node_name, str):
        return _text_error("node name", node_name)
    finding = _check_node_name(node_name)
    return None if finding is None else InvalidNodeNameException(node_name, *finding)


def validate_namespace(namespace: str) -> bool:
    """Return True for a valid namespace, such as `/` or `/a/b`.

    Raises:
        InvalidNamespaceException: the namespace isn't valid; the exception has the rule and the index.
        TypeError: the namespace is not a str.
    """
    if (error := namespace_error(namespace)) is not None:
        raise error
    return True


def namespace_error(namespace: object) -> Exception | None:
    """Return what `validate_namespace` raises, or None, for callers whose tracebacks shall be short."""
    if not isinstance(namespace, str):
        return _text_error("namespace", namespace)
    finding = _check_namespace(namespace)
    return None if finding is None else InvalidNamespaceException(namespace, *finding)


def validate_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True for a valid name before expansion: absolute, relative, `~/private`, with `{node}` or `{ns}`.

    Raises:
        InvalidTopicNameException: the name isn't valid; the exception has the rule and the index.
        InvalidServiceNameException: the same for a service.
        TypeError: the name is not a str.
    """
    if (error := name_error(name, is_service=is_service)) is not None:
        raise error
    return True


def validate_full_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True for a valid full name, such as `/a/chatter`.

    Raises:
        InvalidTopicNameException: the name isn't valid; the exception has the rule and the index.
        InvalidServiceNameException: the same for a service.
        TypeError: the name is not a str.
    """
    if (error := full_name_error(name, is_service=is_service)) is not None:
        raise error
    return True


def name_error(name: object, *, is_service: bool = False) -> Exception | None:
    """Return what `validate_topic_name` raises, or None, for callers whose tracebacks shall be short."""
    return _error_of(_check_topic_name, name, is_service)


def full_name_error(name: object, *, is_service: bool = False) -> Exception | None:
    """Return what `validate_full_topic_name` raises, or None, for callers whose tracebacks shall be short."""
    return _error_of(_check_full_topic_name, name, is_service)


def _error_of(check: Callable[[str], _Finding | None], name: object, is_service: bool) -> Exception | None:
    if not isinstance(name, str):
        return _text_error("service name" if is_service else "topic name", name)
    finding = check(name)
    if finding is None:
        return None
    return (InvalidServiceNameException if is_service else InvalidTopicNameException)(name, *finding)


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """Return the full name of `topic_name` in a node.

    Args:
        topic_name: An absolute name is unchanged; a relative one is in the namespace, `~/x` below the node. `{node}` is
            the node's name; `{ns}` and `{namespace}` its namespace.
        node_name: The node's name.
        node_namespace: Its namespace.

    Raises:
        NameValidationException: one of the three isn't valid, or a substitution is unknown. Its text differs from
            that of the functions that validate names, as in rclpy.
    """
    with _errors_of_expansion():
        validate_topic_name(topic_name)
        validate_node_name(node_name)
        validate_namespace(node_namespace)
        return _expand(topic_name, node_name, node_namespace)


@contextmanager
def _errors_of_expansion() -> Iterator[None]:
    """Give the errors of names within the block the text that they have where names are expanded."""
    try:
        yield
    except NameValidationException as error:
        _give_text_of_expansion(error)
        raise


def _give_text_of_expansion(error: NameValidationException) -> None:
    kind = "node namespace" if isinstance(error, InvalidNamespaceException) else error.name_type
    error.args = (f"{kind} '{error.name}' is invalid: {error.error_msg}",)


def expansion_error(topic_name: object) -> Exception | None:
    """Return what `expand_topic_name` raises of a topic's name, or None, for callers whose tracebacks are short."""
    error = name_error(topic_name) or _unknown_substitution(str(topic_name))
    if isinstance(error, NameValidationException):
        _give_text_of_expansion(error)
    return error


def _expand(topic_name: str, node_name: str, node_namespace: str) -> str:
    below = "" if node_namespace == "/" else node_namespace
    values = dict(zip(_SUBSTITUTED, (node_name, node_namespace, node_namespace), strict=True))
    if (error := _unknown_substitution(topic_name)) is not None:
        raise error
    name = _SUBSTITUTION.sub(lambda match: values[match.group(1)], topic_name)
    if name.startswith("~"):
        return f"{below}/{node_name}{name[1:]}"
    return name if name.startswith("/") else f"{below}/{name}"


def _unknown_substitution(topic_name: str) -> InvalidTopicNameException | None:
    for match in _SUBSTITUTION.finditer(topic_name):
        if match.group(1) not in _SUBSTITUTED:
            return InvalidTopicNameException(
                topic_name, f"unknown substitution: {match.group()}", match.start()
            )
    return None


def full_node_name(namespace: str, name: str) -> str:
    """Return a node's fully qualified name."""
    return f"{namespace.rstrip('/')}/{name}"


def topic_or_service_is_hidden(name: str) -> bool:
    """Return whether a part of the name starts with `_`."""
    return any(part.startswith(HIDDEN_TOPIC_PREFIX) for part in name.split(TOPIC_SEPARATOR_STRING))
