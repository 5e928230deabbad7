"""The text of a launch description's entities, as `ros2 launch --print` shows it."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.actions.event_actions import EmitEvent, RegisterEventHandler
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.log import Log
from tfloom.launch.core.base_classes import (
    LaunchDescriptionEntity,
    SomeSubstitutionsType,
    described,
    normalize_to_list_of_entities,
)
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import BaseEventHandler
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions

__all__ = [
    "LaunchIntrospector",
    "format_action",
    "format_entities",
    "format_event_handler",
    "format_substitutions",
    "indent",
    "tree_like_indent",
]

_STEP = 4
"""The number of spaces of an indentation."""


def indent(lines: list[str], indention: str = " " * _STEP) -> list[str]:
    """Return lines with an indentation before each."""
    return [indention + line for line in lines]


def tree_like_indent(lines: list[str]) -> list[str]:
    """Return indented lines with the branches of a tree in place of spaces; a line without indentation is left out."""
    lines = [line for line in lines if line.startswith(" " * _STEP)]
    texts = [line.lstrip() for line in lines]
    depths = [len(line) - len(text) for line, text in zip(lines, texts, strict=True)]
    drawn = []
    for i, (depth, text) in enumerate(zip(depths, texts, strict=True)):
        is_last = i + 1 == len(lines)
        branch = "├── " if not is_last and depth <= depths[i + 1] else "└── "
        trunk = "" if depth == _STEP else ("│" if not is_last else " ").ljust(depth - _STEP)
        drawn.append(trunk + branch + text)
    return drawn


def format_entities(entities: Iterable[LaunchDescriptionEntity]) -> list[str]:
    """Return the lines of several entities."""
    lines = []
    for entity in entities:
        lines += format_action(entity) if isinstance(entity, Action) else [f"Unknown entity('{entity}')"]
    return lines


def format_substitutions(substitutions: SomeSubstitutionsType) -> str:
    """Return the text of substitutions, with ` + ` between."""
    return described(normalize_to_list_of_substitutions(substitutions))


def format_event_handler(event_handler: BaseEventHandler) -> list[str]:
    """Return the lines of an event handler and of the entities that it returns."""
    if not hasattr(event_handler, "describe"):
        return [f"EventHandler('{hex(id(event_handler))}')"]
    description, entities = event_handler.describe()
    flat = normalize_to_list_of_entities(entities if isinstance(entities, list) else [entities])
    return [description, *indent(format_entities(flat))]


def format_action(action: Action) -> list[str]:
    """Return the lines of an action."""
    if isinstance(action, Log):
        return [f"{type(action).__name__}({format_substitutions(action.msg)})"]
    if isinstance(action, EmitEvent):
        return [f"EmitEvent(event='{action.event.name}')"]
    if isinstance(action, ExecuteProcess):
        return [_format_process(action)]
    if isinstance(action, RegisterEventHandler):
        handler = action.event_handler
        return [f"RegisterEventHandler('{handler}'):", *indent(format_event_handler(handler))]
    return [f"Action('{action}')"]


def _format_process(action: ExecuteProcess) -> str:
    command = ", ".join(map(format_substitutions, action.cmd))
    folder = None if action.cwd is None else f"'{format_substitutions(action.cwd)}'"
    variables = None
    if action.env is not None:
        pairs = (f"{format_substitutions(name)}: {format_substitutions(value)}" for name, value in action.env)
        variables = "{" + ", ".join(pairs) + "}"
    return f"ExecuteProcess(cmd=[{command}], cwd={folder}, env={variables}, shell={action.shell})"


class LaunchIntrospector:
    """Describes launch descriptions for people."""

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        """Return the description's repr, and below it the tree of its entities."""
        entities = tree_like_indent(indent(format_entities(launch_description.entities)))
        return "\n".join([f"{launch_description}", *entities])
