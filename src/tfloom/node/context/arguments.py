"""ROS arguments: the part of a command line after `--ros-args`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from tfloom.common.text import shortened
from tfloom.node.log.log_output import LoggingSeverity
from tfloom.node.parameters.parameter_file import (
    EVERY_NODE,
    ParameterRule,
    checked_value,
    read_parameter_file,
)
from tfloom.node.values.exceptions import RCLError
from tfloom.node.values.names import (
    InvalidNamespaceException,
    NameValidationException,
    expand_topic_name,
    validate_namespace,
    validate_node_name,
    validate_topic_name,
)
from tfloom.node.values.scalars import parse_value
from tfloom.ros_imports.guard import ros_home

__all__ = [
    "Arguments",
    "RCLInvalidROSArgsError",
    "RemapRule",
    "UnknownROSArgsError",
    "parse_arguments",
    "remove_ros_args",
    "warn_of_deprecated_remaps",
]

_FLAGS = {
    "--enable-rosout-logs": ("rosout_logs", True),
    "--disable-rosout-logs": ("rosout_logs", False),
    "--enable-stdout-logs": ("stdout_logs", True),
    "--disable-stdout-logs": ("stdout_logs", False),
    "--enable-external-lib-logs": ("external_lib_logs", True),
    "--disable-external-lib-logs": ("external_lib_logs", False),
}
_TAKES_VALUE = {
    "-r": "remap",
    "--remap": "remap",
    "-p": "param",
    "--param": "param",
    "--params-file": "params_file",
    "--log-level": "log_level",
    "--log-file-name": "log_file_name",
    "--log-config-file": "log_config_file",
    "-e": "enclave",
    "--enclave": "enclave",
}
_PART = r"(?![A-Za-z0-9_]*__)[A-Za-z_][A-Za-z0-9_]*"
_NODE_PREFIX = rf"({_PART}):(?!=|//)"
_TOPIC = rf"(~?/)?{_PART}(/{_PART})*"
_NAMESPACE = rf"/|(/{_PART})+"
_WORD = r"(?<![A-Za-z0-9_])(?!__)[A-Za-z_][A-Za-z0-9_]*"
_NODES_PREFIX = rf"/?(\*\*?|{_WORD})(/(\*\*?|{_WORD}))*:"
_PARAMETER_NAME = rf"(/|{_WORD})(\.?(/|{_WORD}))*"


class RCLInvalidROSArgsError(RCLError):
    """An argument after `--ros-args` is malformed."""

    __module__ = ros_home("rclpy._rclpy_pybind11", __name__)

    def __init__(self, why: str) -> None:
        super().__init__(f"Failed to parse ROS arguments: {why}")


class UnknownROSArgsError(RuntimeError):
    """An argument after `--ros-args` is not a ROS argument."""

    __module__ = ros_home("rclpy._rclpy_pybind11", __name__)

    def __init__(self, unknown: list[str]) -> None:
        words = shortened(", ".join(repr(word) for word in unknown))
        super().__init__(f"Found unknown ROS arguments: [{words}]")
        self.unknown = unknown


class RemapRule(NamedTuple):
    """A rule `[node:]match:=replacement` of the command line, which gives a name another one."""

    node: str | None
    """Name of the node that the rule applies to; None: all nodes."""
    scheme: str
    """"topic", "service" or both ("")."""
    match: str
    """A name before remapping, or `__node` or `__ns`."""
    replacement: str


class Arguments:
    """The ROS arguments of a command line, and the rest of it."""

    def __init__(self) -> None:
        self.remaps: list[RemapRule] = []
        self.parameters: list[ParameterRule] = []
        self.log_levels: list[tuple[str, LoggingSeverity]] = []
        self.log_file_name: str | None = None
        self.log_config_file: str | None = None
        self.enclave: str | None = None
        self.rosout_logs = True
        self.stdout_logs = True
        self.external_lib_logs = True
        self.unknown: list[str] = []
        self.rest: list[str] = []
        self.deprecated_remaps: list[str] = []
        """Remap rules outside the ROS arguments, as ROS 1 has them."""

    def over(self, others: Arguments) -> Arguments:
        """Return the union of both; where both have a value, this one's takes precedence."""
        both = Arguments()
        both.remaps = self.remaps + others.remaps
        both.parameters = others.parameters + self.parameters
        both.rosout_logs = self.rosout_logs and others.rosout_logs
        both.enclave = self.enclave or others.enclave
        return both

    def node_name(self, name: str) -> str:
        """Return the name given by `__node:=`, else `name`."""
        return self._special_name("__node", name, name)

    def namespace(self, name: str, namespace: str) -> str:
        """Return the namespace that `__ns:=` gives the node called `name`, else `namespace`."""
        return self._special_name("__ns", name, namespace)

    def _special_name(self, match: str, node_name: str, otherwise: str) -> str:
        for rule in self.remaps:
            if rule.match == match and rule.node in (None, node_name):
                return rule.replacement
        return otherwise

    def remap(
        self, full_name: str, node_name: str, namespace: str, *, is_service: bool = False
    ) -> str | None:
        """Return a full topic or service name remapped by the first rule that matches; None if none does."""
        scheme = "service" if is_service else "topic"
        for rule in self.remaps:
            if (
                rule.match.startswith("__")
                or rule.scheme not in ("", scheme)
                or rule.node not in (None, node_name)
            ):
                continue
            if expand_topic_name(rule.match, node_name, namespace) == full_name:
                return expand_topic_name(rule.replacement, node_name, namespace)
        return None

    def parameter_overrides(self, full_name: str) -> dict[str, Any]:
        """Return the values given for a node's parameters, by name; the last value for a parameter takes precedence."""
        return {rule.name: rule.value for rule in self.parameters if rule.is_for(full_name)}


def parse_arguments(arguments: Sequence[str]) -> Arguments:
    """Read the parts of a command line between `--ros-args` and `--` or the end, and the remap rules elsewhere.

    Raises:
        RCLInvalidROSArgsError: a ROS argument has no value, or a malformed one.
        UnknownROSArgsError: an argument between `--ros-args` and `--` is not a ROS argument.
    """
    parsed = Arguments()
    words = iter(arguments)
    for word in words:
        if word == "--ros-args":
            _parse_ros_part(parsed, words)
        elif _parse_deprecated_remap(parsed, word):
            parsed.deprecated_remaps.append(word)
        else:
            parsed.rest.append(word)
    if parsed.unknown:
        raise UnknownROSArgsError(parsed.unknown)
    return parsed


def remove_ros_args(arguments: Sequence[str]) -> list[str]:
    """Return a command line without its ROS arguments."""
    return parse_arguments(arguments).rest


def _parse_ros_part(parsed: Arguments, words: Iterator[str]) -> None:
    for word in words:
        if word == "--":
            return
        if word in _FLAGS:
            setattr(parsed, *_FLAGS[word])
        elif word in _TAKES_VALUE:
            value = next(words, None)
            if value is None:
                raise RCLInvalidROSArgsError(f"{word} needs a value: {_EXPECTED[_TAKES_VALUE[word]]}")
            _PARSERS[_TAKES_VALUE[word]](parsed, word, value)
        elif word != "--ros-args":
            parsed.unknown.append(word)


def _argument_error(flag: str, value: str, why: str) -> RCLInvalidROSArgsError:
    return RCLInvalidROSArgsError(f"cannot understand '{flag} {shortened(value)}': {why}")


def _split_assignment(flag: str, value: str) -> tuple[str, str]:
    left, assign, right = value.partition(":=")
    if not assign or not left:
        raise _argument_error(flag, value, f"expected {_EXPECTED[_TAKES_VALUE[flag]]}")
    return left, right


def _split_node_prefix(text: str) -> tuple[str | None, str]:
    match = re.match(_NODE_PREFIX, text)
    return (match.group(1), text[match.end() :]) if match else (None, text)


def _parse_remap(parsed: Arguments, flag: str, value: str) -> None:
    left, replacement = _split_assignment(flag, value)
    node, match = _split_node_prefix(left)
    scheme = ""
    for prefix in ("topic", "service"):
        if match.startswith(f"ros{prefix}://"):
            scheme, match = prefix, match[len(prefix) + 6 :]
    pattern, names = _TOPIC, [match, replacement]
    try:
        if match in ("__node", "__name"):
            match, pattern, names = "__node", _PART, [replacement]
            validate_node_name(replacement)
        elif match == "__ns":
            pattern, names = _NAMESPACE, [replacement]
            validate_namespace(replacement)
        else:
            validate_topic_name(match)
            validate_topic_name(replacement)
    except NameValidationException as error:
        raise _argument_error(flag, value, f"'{shortened(error.name)}': {error.error_msg}") from None
    for name in names:
        if not re.fullmatch(pattern, name):
            why = f"'{shortened(name)}': a rule has no substitutions, and no '__' or '//'"
            raise _argument_error(flag, value, why)
    parsed.remaps.append(RemapRule(node, scheme, match, replacement))


def _parse_deprecated_remap(parsed: Arguments, word: str) -> bool:
    """Add a remap rule without its flag, as ROS 1 has them; return False if the word is not one."""
    if ":=" not in word:
        return False
    try:
        _parse_remap(parsed, "-r", word)
    except RCLInvalidROSArgsError:
        return False
    return True


def warn_of_deprecated_remaps(arguments: Arguments) -> None:
    """Log a warning for each remap rule that has effect outside the ROS arguments."""
    if not arguments.deprecated_remaps:
        return
    from tfloom.node.log.logging import get_logger

    for rule in arguments.deprecated_remaps:
        get_logger("rcl").warning(
            f"Found remap rule '{rule}'. This syntax is deprecated. Use '--ros-args --remap {rule}' instead."
        )


def _parse_param(parsed: Arguments, flag: str, value: str) -> None:
    left, text = _split_assignment(flag, value)
    prefix = re.match(_NODES_PREFIX, left)
    name = left[prefix.end() :] if prefix else left
    if not re.fullmatch(_PARAMETER_NAME, name):
        raise _argument_error(
            flag, value, f"{shortened(repr(name))} is not a parameter's name, as robot.max_speed"
        )
    try:
        parameter = checked_value(name, parse_value(text, nothing=None))
    except ValueError as error:
        raise _argument_error(flag, value, str(error)) from None
    if parameter is None:
        raise _argument_error(flag, value, "the parameter has no value; write '' for an empty string")
    if isinstance(parameter, dict):
        raise _argument_error(flag, value, "a parameter's value can't be a mapping")
    parsed.parameters.append(ParameterRule(_nodes(prefix.group()) if prefix else EVERY_NODE, name, parameter))


def _nodes(prefix: str) -> str:
    """Return the pattern for `node:`, a name in any namespace, or `/pattern:`, as in a parameter file."""
    pattern = prefix.removesuffix(":")
    if re.fullmatch(_WORD, pattern):
        return f"{EVERY_NODE}/{pattern}"
    return pattern if pattern.startswith("/") else f"/{pattern}"


def _parse_params_file(parsed: Arguments, flag: str, value: str) -> None:
    try:
        rules = read_parameter_file(value)
    except (OSError, ValueError) as error:
        raise _argument_error(flag, value, str(error)) from None
    parsed.parameters.extend(rules)


def _parse_log_level(parsed: Arguments, flag: str, value: str) -> None:
    name, assign, level = value.rpartition(":=")
    try:
        severity = LoggingSeverity[level.upper()]
    except KeyError:
        level_names = ", ".join(severity.name.lower() for severity in LoggingSeverity)
        why = f"'{shortened(level)}' is not a level; known are {level_names}"
        raise _argument_error(flag, value, why) from None
    if assign and not name:
        raise _argument_error(flag, value, f"expected {_EXPECTED['log_level']}")
    parsed.log_levels.append((name, severity))


def _parse_log_file_name(parsed: Arguments, flag: str, value: str) -> None:
    if "/" in value or not value:
        raise _argument_error(
            flag, value, "expected a file's name without a directory (that is ROS_LOG_DIR's)"
        )
    parsed.log_file_name = value


def _parse_log_config_file(parsed: Arguments, flag: str, value: str) -> None:
    if not value:
        raise _argument_error(flag, value, "expected a file's name")
    parsed.log_config_file = value


def _parse_enclave(parsed: Arguments, flag: str, value: str) -> None:
    try:
        validate_namespace(value)
    except InvalidNamespaceException as error:
        raise _argument_error(flag, value, error.error_msg.replace("namespace", "enclave")) from None
    parsed.enclave = value


_PARSERS = {
    "remap": _parse_remap,
    "param": _parse_param,
    "params_file": _parse_params_file,
    "log_level": _parse_log_level,
    "log_file_name": _parse_log_file_name,
    "log_config_file": _parse_log_config_file,
    "enclave": _parse_enclave,
}
_EXPECTED = {
    "remap": "[node:]from:=to",
    "param": "[node:]name:=value",
    "params_file": "a YAML file",
    "log_level": "LEVEL or logger:=LEVEL",
    "log_file_name": "a file's name",
    "log_config_file": "a file",
    "enclave": "a path such as /robot",
}
