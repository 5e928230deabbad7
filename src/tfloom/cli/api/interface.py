"""The functions of `ros2interface.api`: interfaces, and words that complete their names."""

from __future__ import annotations

from typing import Any

from tfloom.cli.interface import class_to_send
from tfloom.rosidl.yaml_text import message_to_yaml
from tfloom.workspace.interfaces import interface_packages, known_interfaces

__all__ = ["interface_to_yaml", "package_name_completer", "type_completer"]


def type_completer(**_: Any) -> list[str]:
    """Return the full names of all messages, services and actions."""
    return known_interfaces()


def package_name_completer(**_: Any) -> list[str]:
    """Return the names of the packages that define interfaces."""
    return list(interface_packages())


def interface_to_yaml(identifier: str) -> str:
    """Return the defaults of a message, a service's request or an action's goal, as YAML.

    Raises:
        CommandError: there is no such interface.
    """
    return message_to_yaml(class_to_send(identifier)())
