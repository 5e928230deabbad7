"""Parsers that import a verb when they parse its arguments, so that no other verb is imported."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from importlib import import_module
from typing import Any, NamedTuple, NoReturn, TypeAlias

from tfloom import __version__


class Group(NamedTuple):
    """A command with verbs, such as `topic`."""

    summary: str
    """One line for `--help`."""
    verbs: Mapping[str, str]
    """One line for each verb."""
    hidden: str = ""
    """The `<hidden>` of its flag `--include-hidden-<hidden>`; empty: it has no such flag."""
    aliases: Sequence[str] = ()
    """Other words for it."""
    file: str = ""
    """The module below `tfloom.cli` that its verbs share; empty: each has its own in the group's folder."""
    own_files: Collection[str] = ()
    """The verbs that don't share it, because they load more than the others."""

    def code_of(self, word: str, verb: str) -> VerbCode:
        """Return where the code of a verb is, given the group's word."""
        if self.file and verb not in self.own_files:
            return f"tfloom.cli.{self.file}", verb
        return f"tfloom.cli.{word}.{verb}", ""


VerbCode: TypeAlias = "tuple[str, str]"
"""Where the two functions of a verb are: a module, imported when the verb is called, and the verb if it has several.

The functions are `add_arguments(parser)` and `main(args) -> int`; in a module of several, `add_<verb>_arguments` and
`<verb>_main`.
"""


def load_verb(
    code: VerbCode,
) -> tuple[Callable[[argparse.ArgumentParser], None], Callable[[argparse.Namespace], int]]:
    """Import a verb's module, and return the function that adds the arguments, and the one that runs the verb."""
    name, verb = code
    module = import_module(name)
    if verb:
        return getattr(module, f"add_{verb}_arguments"), getattr(module, f"{verb}_main")
    return module.add_arguments, module.main


AddExtensions: TypeAlias = "Callable[[VerbParser, Any, str], Callable[[], None]]"
"""Adds words to a parser, given its own and a group of entry points; returns what adds them to the help."""


_UNSIZED = partial(argparse.HelpFormatter, width=1 << 20)
"""Makes the formatter with which argparse checks each argument that is added.

One that asks for the terminal's width imports shutil and its compression, a twentieth of a short command's time.
"""


PickValues: TypeAlias = (
    "Callable[[argparse.ArgumentParser, list[str], list[argparse.Action], argparse.Namespace], list[str]]"
)
"""Returns what the user picks for missing arguments: see `cli/shared/picking.py: values_of_missing`."""
_REQUIRED = "the following arguments are required: "
"""How argparse's error about missing arguments begins."""


class _MissingError(Exception):
    """Arguments are missing, which the text names as argparse does."""


class VerbParser(argparse.ArgumentParser):
    """A parser for one word of the command line, which adds its arguments or verbs when it parses.

    A verb's `code` is imported then, and adds the arguments. For a `group`, a parser for each of its verbs is
    created then, because parsers for all verbs of all groups would lengthen the start by a half. For an extension,
    `fill_extension` is called then, with this parser.
    """

    def __init__(
        self,
        *args: Any,
        code: VerbCode | None = None,
        group: Group | None = None,
        fill_extension: Callable[[VerbParser], None] | None = None,
        add_extensions: AddExtensions | None = None,
        pick: PickValues | None = None,
        **options: Any,
    ) -> None:
        super().__init__(*args, **{"formatter_class": _UNSIZED, **options})
        self._code = code
        self._group = group
        self._fill_extension = fill_extension
        self._words: dict[str, VerbParser] = {}
        self._add_extensions = add_extensions
        self._add_late_words: Callable[[], Callable[[], None]] | None = None
        """Adds the words of extensions, which are looked for if a word is unknown, and for the help."""
        self._add_help_lines: Callable[[], None] | None = None
        """Adds these words to the help, for which all of the extensions are imported."""
        self._hint_after_error: Callable[[argparse.Namespace], str] | None = None
        """Of a verb: returns what follows an error about its arguments, from those that were read before."""
        self._parsed = argparse.Namespace()
        self.pick = pick
        """Picks values for the missing arguments of a verb; None: they are an error."""
        self._can_pick = False
        """Whether arguments that are missing may be picked from a list, which is done once."""

    @property
    def words(self) -> dict[str, VerbParser]:
        """The parsers of the words that may follow."""
        if self._group is not None or self._fill_extension is not None:
            self.fill()
        self._look_for_late_words()
        return self._words

    def add_words(self, extension_group: str) -> Any:
        """Add the positional argument for the next word; argparse's messages use its placeholder.

        Args:
            extension_group: Group of the entry points by which installed packages add words.
        """
        self.set_defaults(run_verb=_print_help(self))
        words = self.add_subparsers(
            title="Commands",
            metavar=f"Call `{self.prog} <command> -h` for more detailed usage.",
            parser_class=VerbParser,
        )
        self._words = words.choices

        if self._add_extensions is not None:
            self._add_late_words = partial(self._add_extensions, self, words, extension_group)
        return words

    def take_extension_words(self, words: Any, add_help_lines: Callable[[], None]) -> None:
        """Take the words of an extension's own verbs, and what adds them to the help."""
        self._words = words.choices
        self._add_help_lines = add_help_lines

    def _look_for_late_words(self) -> None:
        add_late_words, self._add_late_words = self._add_late_words, None
        if add_late_words is not None:
            self._add_help_lines = add_late_words()

    def format_help(self) -> str:
        """Return the help, with the words of extensions."""
        self._look_for_late_words()
        add_help_lines, self._add_help_lines = self._add_help_lines, None
        if add_help_lines is not None:
            add_help_lines()
        self._fit_to_terminal()
        return super().format_help()

    def format_usage(self) -> str:
        """Return the usage."""
        self._fit_to_terminal()
        return super().format_usage()

    def _fit_to_terminal(self) -> None:
        if self.formatter_class is _UNSIZED:
            self.formatter_class = argparse.HelpFormatter

    def fill(self) -> None:
        """Import the verb or the extension and add its arguments, or add the verbs of the group; once."""
        if self._group is not None:
            group, self._group = self._group, None
            _fill_group(self, group)
        if self._fill_extension is not None:
            fill_extension, self._fill_extension = self._fill_extension, None
            fill_extension(self)
        if self._code is not None:
            code, self._code = self._code, None
            add_arguments, main = load_verb(code)
            add_arguments(self)
            self.set_defaults(run_verb=main, verb_parser=self)
            self._hint_after_error = getattr(import_module(code[0]), "hint_after_error", None)

    def parse_args(  # type: ignore[override]
        self, args: Sequence[str] | None = None, namespace: argparse.Namespace | None = None
    ) -> argparse.Namespace:
        """Parse as argparse does; the error about an unknown flag has the nearest known one."""
        parsed, unknown = self.parse_known_args(args, namespace)
        if unknown:
            verb = getattr(parsed, "verb_parser", self)
            flags = [flag for flag in verb.flags() if flag.startswith("--")]
            near = _did_you_mean(next((word for word in unknown if word.startswith("--")), ""), flags)
            self.error(f"unrecognized arguments: {' '.join(unknown)}{near}")
        return parsed

    def flags(self) -> list[str]:
        """Return the flags that have been added."""
        return list(self._option_string_actions)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is self._words and value not in self._words:
            self._look_for_late_words()
        try:
            super()._check_value(action, value)
        except argparse.ArgumentError as error:
            error.message += _did_you_mean(str(value), [str(choice) for choice in action.choices or ()])
            raise

    def parse_known_args(  # type: ignore[override]
        self, args: Sequence[str] | None = None, namespace: argparse.Namespace | None = None
    ) -> tuple[argparse.Namespace, list[str]]:
        """Parse as argparse does, after adding the verb's arguments."""
        self.fill()
        self._parsed = argparse.Namespace() if namespace is None else namespace
        self._can_pick = self.pick is not None
        try:
            return super().parse_known_args(args, self._parsed)
        except _MissingError as error:
            values = self._values_of_missing(str(error))
            self._parsed = argparse.Namespace() if namespace is None else namespace
            return super().parse_known_args([*values, *(args or ())], self._parsed)
        finally:
            self._can_pick = False

    def _values_of_missing(self, message: str) -> list[str]:
        """Return what the user picks for missing arguments; print the usage and exit if they can't be picked."""
        self._can_pick = False
        missing = message.removeprefix(_REQUIRED).split(", ")
        values = self.pick(self, missing, self._get_positional_actions(), self._parsed) if self.pick else []
        if not values:
            self.error(message)
        return values

    def error(self, message: str) -> NoReturn:
        """Print the usage and an error, with the verb's hint, and exit."""
        if self._can_pick and message.startswith(_REQUIRED):
            raise _MissingError(message)
        hint = "" if self._hint_after_error is None else self._hint_after_error(self._parsed)
        super().error(f"{message}{hint}")


VERB_ALIASES = {"doctor": ("wtf",)}
"""Other words for first words that have no verbs."""

_FOLDERS = frozenset({"doctor"})
"""Commands without verbs whose files are in a folder."""


def build_parser(
    prog: str,
    commands: Mapping[str, str | Group],
    add_extensions: AddExtensions | None = None,
    pick: PickValues | None = None,
) -> VerbParser:
    """Return the parser of the whole command line, without importing the verbs' modules.

    Args:
        prog: Name of the command: `tfloom` or `ros2`.
        commands: A summary or a group for each first word.
        add_extensions: Adds what installed packages add to these.
        pick: Picks values for the missing arguments of verbs.
    """
    top = VerbParser(
        prog=prog,
        add_extensions=add_extensions,
        description="TF2, turtlesim and the ROS 2 workflow, with no ROS installed.",
        epilog=f"`{prog} --version` prints the version.",
    )
    name = prog if prog == "tfloom" else f"{prog} (tfloom)"
    # Omitted from the usage text, which equals the reference's.
    top.add_argument("--version", action="version", version=f"{name} {__version__}", help=argparse.SUPPRESS)
    top.add_argument(
        "--use-python-default-buffering",
        action="store_true",
        help="keep Python's output buffering; without it, each line is written at once",
    )
    words = top.add_words("ros2cli.command")
    for word, command in commands.items():
        if isinstance(command, str):
            summary = command
            options: dict[str, Any] = {
                "aliases": VERB_ALIASES.get(word, ()),
                "code": (command_module(word), ""),
            }
        else:
            summary = command.summary
            options = {"aliases": command.aliases, "group": command, "add_extensions": add_extensions}
            options["pick"] = pick
        words.add_parser(word, help=summary, description=summary, prog=f"{prog} {word}", **options)
    return top


def help_since(distribution: str, text: str) -> str:
    """Return the help of a flag that ROS 2 has from a distribution on: it is accepted before, and not shown."""
    from tfloom.ros_imports import ros_distro  # which `--version` and `--help` don't need

    return text if ros_distro.since(distribution) else argparse.SUPPRESS


def command_module(word: str) -> str:
    """Return the module of a command without verbs: `cli/WORD.py`, or `command.py` in a folder of that name."""
    return f"tfloom.cli.{word}.command" if word in _FOLDERS else f"tfloom.cli.{word}"


def _fill_group(parser: VerbParser, group: Group) -> None:
    word = parser.prog.rpartition(" ")[2]
    if group.hidden:
        parser.add_argument(
            f"--include-hidden-{group.hidden}",
            action="store_true",
            help=f"include {group.hidden} with a part that begins with an underscore",
        )
    verbs = parser.add_words(f"ros2{word}.verb")
    for verb, summary in group.verbs.items():
        verbs.add_parser(
            verb,
            help=summary,
            description=summary,
            prog=f"{parser.prog} {verb}",
            code=group.code_of(word, verb),
            pick=parser.pick,
        )


def _did_you_mean(word: str, known: Sequence[str]) -> str:
    import difflib

    near = difflib.get_close_matches(word, known, 1, 0.6)
    return f"\ndid you mean {near[0]}?" if near else ""


def _print_help(parser: argparse.ArgumentParser) -> Any:
    def print_help(_: argparse.Namespace) -> int:
        parser.print_help()
        return 0

    return print_help
