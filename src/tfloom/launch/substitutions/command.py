"""The output of a command."""

from __future__ import annotations

from tfloom.launch.core.base_classes import (
    ParsedSubstitution,
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.substitutions.find_executable import command_of
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["Command"]

_CHOICES = ("fail", "ignore", "warn", "capture")


@expose_substitution("command")
class Command(ParsedSubstitution):
    """What a command writes to its standard output.

    Args:
        command: The command's line, which is split as a shell splits it, and run without a shell.
        on_stderr: What happens if it writes to its standard error: `fail`, `ignore`, `warn` (log it) or `capture` (it
            is a part of the output).
    """

    _arguments = ("command", "on_stderr")
    _optional = 1
    _fault = "command substitution expects 1 or 2 arguments"
    _error = ValueError

    def __init__(self, command: SomeSubstitutionsType, *, on_stderr: SomeSubstitutionsType = "fail") -> None:
        super().__init__()
        self._command = normalize_to_list_of_substitutions(command)
        self._on_stderr = normalize_to_list_of_substitutions(on_stderr)

    @property
    def command(self) -> list[Substitution]:
        """The program and its arguments, as a shell takes them."""
        return self._command

    @property
    def on_stderr(self) -> list[Substitution]:
        """What happens if the command writes to its standard error."""
        return self._on_stderr

    def describe(self) -> str:
        """Return a description for people."""
        return f"Command({described(self._command)})"

    def perform(self, context: LaunchContext) -> str:
        """Run the command, and return its output.

        Raises:
            SubstitutionFailure: the command is not found, fails, or writes to its standard error where that fails.
        """
        import subprocess

        line = perform_substitutions(context, self._command)
        on_stderr = perform_substitutions(context, self._on_stderr)
        if on_stderr not in _CHOICES:
            raise SubstitutionFailure(
                f"expected 'on_stderr' to be one of: 'fail', 'ignore', 'warn' or 'capture', not '{on_stderr}'"
            )
        try:
            result = subprocess.run(
                _command_words(context, line),
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT if on_stderr == "capture" else subprocess.PIPE,
                env=context.environment,
                text=True,
                check=False,
            )
        except FileNotFoundError as error:
            raise SubstitutionFailure(f"file not found: {error}") from error
        except (OSError, ValueError, IndexError) as error:
            raise SubstitutionFailure(f"the command {line!r} cannot be run: {error}") from error
        if result.returncode != 0:
            captured = f"\nCaptured stderr output: {result.stderr}" if result.stderr else ""
            raise SubstitutionFailure(f"executed command failed. Command: {line}{captured}")
        # With `capture`, it is in `result.stdout`, and `result.stderr` is None.
        if result.stderr and on_stderr != "ignore":
            message = (
                f"executed command showed stderr output. Command: {line}\n"
                f"Captured stderr output:\n{result.stderr}"
            )
            if on_stderr == "fail":
                raise SubstitutionFailure(message)
            get_logger().warning(message)
        return result.stdout


def _command_words(context: LaunchContext, line: str) -> list[str]:
    """Return the words of a command's line, the first one replaced by what runs the program.

    Raises:
        ValueError: the line ends within quotes.
        IndexError: it has no words.
    """
    import shlex

    words = shlex.split(line)
    return [*command_of(context, words[0]), *words[1:]]
