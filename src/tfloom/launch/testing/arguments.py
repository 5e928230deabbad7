"""Launch arguments of a test."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.core.base_classes import described
from tfloom.launch.entities.launch_description import LaunchDescription

__all__ = ["parse_launch_arguments", "print_arguments_of_launch_description"]


def parse_launch_arguments(launch_arguments: Iterable[str]) -> list[tuple[str, str]]:
    """Return the names and values of arguments, of which each is `name:=value`; the last value of a name holds.

    Raises:
        RuntimeError: an argument has another form.
    """
    parsed: dict[str, str] = {}
    for argument in launch_arguments:
        name, separator, value = argument.partition(":=")
        if not name or not separator:
            raise RuntimeError(f"malformed launch argument '{argument}', expected format '<name>:=<value>'")
        parsed[name] = value
    return list(parsed.items())


def print_arguments_of_launch_description(*, launch_description: LaunchDescription) -> None:
    """Print the arguments that a description declares, with what each is for and its default."""
    print("Arguments (pass arguments as '<name>:=<value>'):")
    arguments = launch_description.get_launch_arguments()
    conditional = [argument for argument in arguments if argument._conditionally_included]
    for argument in arguments:
        print(f"\n    '{argument.name}':{'*' if argument in conditional else ''}")
        print(f"        {argument.description}")
        if argument.default_value is not None:
            print(f"        (default: {described(argument.default_value)})")
    if not arguments:
        print("\n  No arguments.")
    if conditional:
        print("\n* argument(s) which are only used if specific conditions occur")
