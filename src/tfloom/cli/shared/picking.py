"""Names that the user picks from a list, where a verb was called without them: by fzf, or by their numbers."""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
from collections.abc import Sequence

from tfloom.cli.completion import find_offer
from tfloom.cli.shared.errors import CommandError, standard_input
from tfloom.common.terminal import report
from tfloom.ros_imports.ros_distro import NAMES_ARE_OPTIONAL

__all__ = ["picked", "values_of_missing"]

NO_TERMINAL = "Error: Interactive selection requires a TTY terminal."
NOTHING = "nothing was picked"
_ARGUMENTS = {
    *("topic_name", "topic", "message_type", "topic_type", "service_name", "service_type", "type"),
    *("action_name", "action_type", "node_name", "parameter_name", "parameter_names", "transition"),
    *("container_node_name", "component_uid"),
}
"""The arguments that can be picked: names on the graph, and types."""
_NONE_FOUND, _ENDED = 1, 130
"""Exit codes of fzf: the typed text matched nothing; Esc or Ctrl-C."""


def values_of_missing(
    parser: argparse.ArgumentParser,
    missing: Sequence[str],
    positionals: Sequence[argparse.Action],
    parsed: argparse.Namespace,
) -> list[str]:
    """Return what the user picks for the positional arguments that a command line lacks, all of which are missing.

    Args:
        parser: The parser of the verb.
        missing: The names of the missing arguments, as argparse shows them.
        positionals: The positional arguments of the verb, in order.
        parsed: The arguments that were read; those that are picked are added, because others may depend on them.

    Returns:
        Nothing if one of them can't be picked, as free text, or there is no terminal; then the usage is to be printed.

    Raises:
        CommandError: there is nothing to pick from, nothing was picked, or there is no terminal, in Lyrical.
        KeyboardInterrupt: the user has ended it.
    """
    actions = positionals[: len(missing)]
    if [action.metavar or action.dest for action in actions] != list(missing):
        return []
    if not all(_can_be_picked(parser, action.dest) for action in actions):
        return []
    if not has_terminal():
        if NAMES_ARE_OPTIONAL:
            raise CommandError(NO_TERMINAL)
        return []
    values: list[str] = []
    for action in actions:
        is_several = action.nargs in {"+", "*"}
        chosen = picked(parser, action.dest, parsed, is_several=is_several, takes_the_only=bool(values))
        setattr(parsed, action.dest, chosen if is_several else chosen[0])
        values += chosen
    return values


def has_terminal() -> bool:
    """Return whether a user can pick: standard input and errors are terminals; the output may go elsewhere."""
    return all(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stderr))


def _can_be_picked(parser: argparse.ArgumentParser, argument: str) -> bool:
    return argument in _ARGUMENTS and find_offer(parser.prog.split()[1:], argument) is not None


def picked(
    parser: argparse.ArgumentParser,
    argument: str,
    parsed: argparse.Namespace,
    *,
    is_several: bool = False,
    takes_the_only: bool = False,
) -> list[str]:
    """Return the value that the user picks for an argument of a verb, or the values.

    Args:
        parser: The parser of the verb.
        argument: The argument.
        parsed: The arguments that are known.
        is_several: Whether several may be picked.
        takes_the_only: Whether a single candidate is taken without a question.

    Raises:
        CommandError, KeyboardInterrupt: as `values_of_missing`, which asks for a terminal before.
    """
    offer = find_offer(parser.prog.split()[1:], argument)
    found = [
        name for name in (offer(parsed) if offer else ()) if name.isprintable() and name[:1] not in {"", "-"}
    ]
    # Completion offers names without their first slash, too.
    with_slash = [name for name in found if name.startswith("/")]
    values = sorted(set(with_slash or found))
    what = argument.removesuffix("s").replace("_", " ")
    if not values:
        raise CommandError(f"there is no {what} to pick from")
    if takes_the_only and len(values) == 1:
        return values
    fzf = shutil.which("fzf")
    chosen = _by_number(what, values, is_several) if fzf is None else _by_fzf(fzf, what, values, is_several)
    if not chosen:
        raise CommandError(NOTHING)
    return chosen if is_several else chosen[:1]


def _by_fzf(fzf: str, what: str, values: Sequence[str], is_several: bool) -> list[str]:
    words = [fzf, f"--prompt={what}> ", *(["--multi"] if is_several else [])]
    try:
        # It reads keys from the terminal itself, and draws on standard error.
        ended = subprocess.run(words, input="\n".join(values), stdout=subprocess.PIPE, text=True, check=False)
    except OSError as error:
        raise CommandError(f"{fzf} can't be run: {error.strerror}") from None
    if ended.returncode == _ENDED:
        raise KeyboardInterrupt
    if ended.returncode not in {0, _NONE_FOUND}:
        raise CommandError(f"{fzf} has ended with exit code {ended.returncode}")
    return [line for line in ended.stdout.splitlines() if line in values]


def _by_number(what: str, values: Sequence[str], is_several: bool) -> list[str]:
    width = len(str(len(values)))
    report("\n".join(f"{number:>{width}}  {value}" for number, value in enumerate(values, 1)))
    while True:
        report(f"{what} ({'numbers or names' if is_several else 'number or name'}):")
        line = standard_input().readline()
        if not line:
            raise CommandError(NOTHING)
        chosen = [_named(word, values) for word in line.split()]
        if chosen and all(chosen) and (is_several or len(chosen) == 1):
            return [value for value in chosen if value]


def _named(word: str, values: Sequence[str]) -> str:
    """Return the value that has a number, a name or the only name with such a part; empty if there is none."""
    if word.isdecimal() and 0 < int(word) <= len(values):
        return values[int(word) - 1]
    if word in values:
        return word
    similar = [value for value in values if word in value]
    return similar[0] if len(similar) == 1 else ""
