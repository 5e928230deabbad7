"""The words of extensions after a command: of those that installed packages add to ours, and of an extension's own."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Collection, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

from tfloom.cli.plugins.entry_points import get_entry_points, get_first_line_doc
from tfloom.cli.shared.errors import CommandError
from tfloom.common.terminal import report
from tfloom.ros_imports.distributions import may_have_entry_points
from tfloom.ros_imports.guard import is_elsewhere

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

    from tfloom.cli.parser import VerbParser

__all__ = ["add_installed_words", "add_subparsers", "add_subparsers_on_demand"]

_Words: TypeAlias = "argparse._SubParsersAction[VerbParser]"  # what argparse returns


def add_installed_words(parser: VerbParser, words: _Words, group: str) -> Callable[[], None]:
    """Add the words that installed packages add to one of our commands, but for those that it has already.

    There are none beside another `rclpy`, which they would use.

    Args:
        parser: The parser of the command.
        words: Its words.
        group: Group of the entry points: `ros2cli.command`, or that of a command's verbs.

    Returns:
        What adds the words to the help; an extension that can't be loaded is a line on stderr instead.
    """
    added: list[EntryPoint] = []
    if may_have_entry_points(group) and not is_elsewhere("rclpy"):
        entry_points = sorted(get_entry_points(group).items())
        added = [entry_point for name, entry_point in entry_points if name not in words.choices]
    for entry_point in added:
        _add_word(words, entry_point, f"{parser.prog} {entry_point.name}", partial(_make_runnable, parser))
    return partial(_add_help_lines, words, added)


def add_subparsers_on_demand(
    parser: VerbParser,
    cli_name: str,
    dest: str,
    group_name: str,
    hide_extensions: Collection[str] | None = None,
    required: bool = True,
    argv: Sequence[str] | None = None,  # in the reference for a look ahead; here each parser waits
) -> _Words:
    """Add the extensions of a group as the words that follow a command; only the typed one is imported.

    Args:
        parser: The command's parser, as `add_arguments` of its extension gets it.
        cli_name: What is typed up to here, as `ros2 foo`.
        dest: Attribute of the parsed arguments that gets the typed word's extension.
        group_name: Group of the entry points.
        hide_extensions: Names of those that no help lists.
        required: Whether a word must follow.
        argv: Not used.
    """
    words = _words_after(parser, cli_name, required)

    def remember(extension: Any, its_parser: VerbParser) -> None:
        its_parser.set_defaults(**{dest: extension})

    entry_points = dict(sorted(get_entry_points(group_name).items()))
    for name, entry_point in entry_points.items():
        _add_word(words, entry_point, f"{cli_name} {name}", remember)
    shown = [entry_point for name, entry_point in entry_points.items() if name not in (hide_extensions or ())]
    parser.take_extension_words(words, partial(_add_help_lines, words, shown))
    return words


def add_subparsers(
    parser: VerbParser,
    cli_name: str,
    dest: str,
    command_extensions: dict[str, Any],
    hide_extensions: Collection[str] | None = None,
    required: bool = True,
) -> _Words:
    """Add extensions that have been created as the words that follow a command; see `add_subparsers_on_demand`."""
    words = _words_after(parser, cli_name, required)
    for name, extension in sorted(command_extensions.items()):
        summary = get_first_line_doc(extension)
        shown: dict[str, Any] = {} if name in (hide_extensions or ()) else {"help": summary}
        word = words.add_parser(name, prog=f"{cli_name} {name}", description=summary, **shown)
        word.set_defaults(**{dest: extension})
        _add_arguments(extension, word)
    return words


def _words_after(parser: VerbParser, cli_name: str, required: bool) -> _Words:
    words: _Words = parser.add_subparsers(
        title="Commands",
        metavar=f"Call `{cli_name} <command> -h` for more detailed usage.",
        required=required,
    )
    return words


def _add_word(
    words: _Words, entry_point: EntryPoint, prog: str, on_load: Callable[[Any, VerbParser], None]
) -> None:
    """Add a word whose extension is imported when its arguments are parsed."""

    def fill(its_parser: VerbParser) -> None:
        import inspect

        extension = _load(entry_point)
        its_parser.description = its_parser.description or inspect.getdoc(extension)
        _add_arguments(extension, its_parser)
        on_load(extension, its_parser)

    words.add_parser(entry_point.name, prog=prog, fill_extension=fill)


def _add_help_lines(words: _Words, entry_points: Sequence[EntryPoint]) -> None:
    """Add the lines of extensions to the help; one that can't be loaded is a line on stderr instead."""
    for entry_point in entry_points:
        try:
            summary = get_first_line_doc(_load(entry_point))
        except CommandError as error:
            report(f"WARNING: {error}")
            continue
        # argparse adds it when the parser is created, which would import the extension for any other word, too. Nothing
        # public adds a line alone.
        words._choices_actions.append(words._ChoicesPseudoAction(entry_point.name, (), summary))


def _load(entry_point: EntryPoint) -> Any:
    """Return an object of the class behind an entry point.

    Raises:
        CommandError: it can't be imported or created; the text has the reason.
    """
    try:
        extension = entry_point.load()()
    except Exception as error:
        what = f"the extension '{entry_point.name}' of {entry_point.group} ({entry_point.value})"
        raise CommandError(f"{what} can't be loaded: {type(error).__name__}: {error}") from error
    extension.NAME = entry_point.name
    return extension


def _add_arguments(extension: Any, parser: VerbParser) -> None:
    import inspect

    add_arguments = extension.add_arguments
    # Extensions for the reference's first releases, and verbs, have no parameter for the words.
    if "argv" in inspect.signature(add_arguments).parameters:
        add_arguments(parser, parser.prog, argv=None)
    else:
        add_arguments(parser, parser.prog)


def _make_runnable(top: VerbParser, extension: Any, parser: VerbParser) -> None:
    """Let a parser's arguments run an extension: a command, whose `main` also takes the parser, or a verb."""

    def run(args: argparse.Namespace) -> int:
        import inspect

        is_command = "parser" in inspect.signature(extension.main).parameters
        try:
            outcome = extension.main(parser=top, args=args) if is_command else extension.main(args=args)
        except RuntimeError as error:  # as in the reference, where extensions raise it for the user
            outcome = str(error)
        if isinstance(outcome, str):
            raise CommandError(outcome)
        return outcome or 0

    parser.set_defaults(run_verb=run, verb_parser=parser)
