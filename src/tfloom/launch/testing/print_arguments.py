"""The arguments of a launch description, printed."""

from __future__ import annotations

from tfloom.launch.launch_description import LaunchDescription
from tfloom.launch.substitutions.described import described

__all__ = ["print_arguments_of_launch_description"]


def print_arguments_of_launch_description(*, launch_description: LaunchDescription) -> None:
    """Print the arguments that a description declares, with what each is for and its default."""
    print("Arguments (pass arguments as '<name>:=<value>'):")
    arguments = launch_description.get_launch_arguments()
    if not arguments:
        print("\n  No arguments.")
    for action in arguments:
        print(f"\n    '{action.name}':")
        description = action.description or "no description given"
        print("        " + "\n        ".join(str(description).splitlines()))
        if action.default_value is not None:
            print(f"        (default: {described(action.default_value)})")
