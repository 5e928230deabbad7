"""The base class of `ros2`'s own verbs, for programs that run them or derive from them."""

from __future__ import annotations

import argparse
from typing import Any, ClassVar

from tfloom.cli.parser import VerbCode, load_verb
from tfloom.cli.plugins.extensions import VerbExtension
from tfloom.cli.shared.errors import CommandError
from tfloom.common.terminal import report

__all__ = ["BuiltinVerb"]

_OF_COMMANDS: dict[str, Any] = {
    "include_hidden_topics": False,
    "include_hidden_services": False,
    "prog": "ros2",
}
"""What the parsers of commands give their verbs beside their own arguments."""


class BuiltinVerb(VerbExtension):
    """A verb of `ros2`. A derived class adds arguments, or does something before and after the verb.

    The verb's code is in functions: to override a private method of a class of the reference has no effect here.
    """

    CODE: ClassVar[VerbCode]
    """Where the verb's two functions are, whose module is imported when one of them is called."""

    def __init_subclass__(cls, *, module: str = "", verb: str = "") -> None:
        super().__init_subclass__()
        if module:  # of a verb of ours; a derived class has that of its base
            cls.CODE = (module, verb)

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        """Add the verb's arguments to a parser."""
        load_verb(self.CODE)[0](parser)

    def main(self, *, args: argparse.Namespace) -> int | str | None:
        """Run the verb; return its exit code, None for 0, or the text of an error.

        Args:
            args: What a parser with the verb's arguments has read. An optional argument that it lacks has its default.
        """
        parser = argparse.ArgumentParser(add_help=False)
        add_arguments, run = load_verb(self.CODE)
        add_arguments(parser)
        optional = {action.dest: action.default for action in parser._actions if not action.required}
        optional |= parser._defaults  # argparse has no other way to ask for what a parser gives
        complete = argparse.Namespace(**{**_OF_COMMANDS, **optional, **vars(args)})
        try:
            code: int | None = run(complete)
        except CommandError as error:
            if error.exit_code == 1:
                return str(error)
            report(error)
            return error.exit_code
        return code
