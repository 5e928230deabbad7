"""The functions of `ros2bag.api`: arguments of verbs on bags, and QoS profiles in YAML."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

from tfloom.cli.bag.conventions import bag_path
from tfloom.node.qos.qos import (
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSProfile,
    QoSReliabilityPolicy,
)
from tfloom.node.values.duration import Duration
from tfloom.rmw.typed_names import SERVICE_EVENTS

__all__ = [
    "add_standard_reader_args",
    "check_not_negative_float",
    "check_not_negative_int",
    "check_path_exists",
    "check_positive_float",
    "convert_service_to_service_event_topic",
    "convert_yaml_to_qos_profile",
    "create_bag_directory",
    "dict_to_duration",
    "interpret_dict_as_qos_profile",
    "print_error",
    "print_warn",
]

_Number = TypeVar("_Number", int, float)

_POLICIES = {
    "history": QoSHistoryPolicy,
    "reliability": QoSReliabilityPolicy,
    "durability": QoSDurabilityPolicy,
    "liveliness": QoSLivelinessPolicy,
}
_DURATIONS = frozenset({"deadline", "lifespan", "liveliness_lease_duration"})


def print_error(string: str) -> str:
    """Return the text of an error, marked as one of a verb on bags."""
    return f"[ERROR] [ros2bag]: {string}"


def print_warn(string: str) -> str:
    """Return the text of a warning, marked as one of a verb on bags."""
    return f"[WARN] [ros2bag]: {string}"


def dict_to_duration(time_dict: Mapping[str, int] | None) -> Duration:
    """Return the duration of `sec` and `nsec`; none is a duration of 0.

    Raises:
        ValueError: one of both is missing.
    """
    if not time_dict:
        return Duration()
    try:
        return Duration(seconds=time_dict["sec"], nanoseconds=time_dict["nsec"])
    except KeyError:
        raise ValueError("Time overrides must include both seconds (sec) and nanoseconds (nsec).") from None


def interpret_dict_as_qos_profile(qos_profile_dict: Mapping[str, Any]) -> QoSProfile:
    """Return the profile of a mapping as a file of overrides has it: policies by short names, durations as mappings.

    Raises:
        ValueError: a key is unknown, or a value doesn't fit.
        KeyError: a policy has no such short name.
        InvalidQoSProfileException: neither `history` nor `depth` is given.
    """
    return QoSProfile(**{name: _policy(name, value) for name, value in qos_profile_dict.items()})


def _policy(name: str, value: Any) -> Any:
    if name in _DURATIONS:
        return dict_to_duration(value)
    if name in _POLICIES:
        return _POLICIES[name].get_from_short_key(value)
    if name == "avoid_ros_namespace_conventions":
        if not isinstance(value, bool):
            raise ValueError(f"{name} must be true or false, not {value!r}")
        return value
    if name == "depth":
        return int(value)
    raise ValueError(f"Unexpected key `{name}` for QoS profile.")


def convert_yaml_to_qos_profile(qos_profile_dict: Mapping[str, Mapping[str, Any]]) -> dict[str, QoSProfile]:
    """Return the profiles of a file of overrides by topic; errors as of `interpret_dict_as_qos_profile`."""
    return {topic: interpret_dict_as_qos_profile(profile) for topic, profile in qos_profile_dict.items()}


def create_bag_directory(uri: str) -> str | None:
    """Create the folder of a bag; return the text of the error if it can't be, else None."""
    try:
        Path(uri).mkdir(parents=True)
    except OSError as error:
        return print_error(f"Could not create bag folder '{uri}': {error.strerror}.")
    return None


def check_path_exists(value: str) -> str:
    """Return the path of a bag.

    Raises:
        argparse.ArgumentTypeError: it doesn't exist.
    """
    return bag_path(value)


def check_positive_float(value: str) -> float:
    """Return a number above 0.

    Raises:
        argparse.ArgumentTypeError: it is not such a number.
    """
    return _checked(float, value, lambda number: number > 0, "positive")


def check_not_negative_float(value: str) -> float:
    """Return a number that isn't negative.

    Raises:
        argparse.ArgumentTypeError: it is not such a number.
    """
    return _checked(float, value, lambda number: number >= 0, "non-negative")


def check_not_negative_int(value: str) -> int:
    """Return a whole number that isn't negative.

    Raises:
        argparse.ArgumentTypeError: it is not such a number.
    """
    return _checked(int, value, lambda number: number >= 0, "non-negative")


def _checked(kind: type[_Number], text: str, is_valid: Callable[[_Number], bool], what: str) -> _Number:
    try:
        value = kind(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text} is not the valid type ({kind.__name__})") from None
    if not is_valid(value):
        raise argparse.ArgumentTypeError(f"Value {value} must be {what}.")
    return value


def add_standard_reader_args(parser: argparse.ArgumentParser) -> None:
    """Add the bag's path, and the flag for its storage."""
    from tfloom.bag.rosbag2_names.readers import get_registered_readers

    parser.add_argument("bag_path", type=check_path_exists, help="path of the bag")
    parser.add_argument(
        "-s",
        "--storage",
        default="",
        choices=sorted(get_registered_readers()),
        help="storage of the bag (default: by its metadata)",
    )


def convert_service_to_service_event_topic(services: Sequence[str] | None) -> list[str]:
    """Return the topics on which services publish their events."""
    return [service + SERVICE_EVENTS for service in services or ()]
