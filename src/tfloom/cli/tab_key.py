"""The Tab key: argcomplete's protocol, and messages in quotes."""

from __future__ import annotations

import os

from argcomplete.finders import CompletionFinder

from tfloom.cli.completion import complete_argument, fill_typed_verb
from tfloom.cli.parser import VerbParser


def complete(parser: VerbParser) -> None:
    """Answer the shell that has set `_ARGCOMPLETE`, and end the process."""
    fill_typed_verb(parser, os.environ.get("COMP_LINE", ""))
    _Finder()(
        parser,
        always_complete_options=False,
        default_completer=complete_argument,  # type: ignore[arg-type]  # any callable works
    )


class _Finder(CompletionFinder):
    """Puts a message in quotes, where argcomplete would put a backslash before each brace, quote and space."""

    def quote_completions(
        self, completions: list[str], cword_prequote: str, last_wordbreak_pos: int | None
    ) -> list[str]:
        """Return the completions as the shell takes them."""
        if len(completions) == 1 and completions[0].startswith("{") and last_wordbreak_pos is None:
            shell = os.environ.get("_ARGCOMPLETE_SHELL", "")
            if shell == "zsh":  # It escapes by itself, and takes what follows a colon for a description.
                return [completions[0].replace(":", r"\:")]
            if (
                shell == "fish"
            ):  # It escapes by itself what is new; a brace that was typed would stay a wildcard.
                return completions if cword_prequote or os.environ["COMP_LINE"].endswith(" ") else []
            if not cword_prequote:
                return ["'{}'".format(completions[0].replace("'", r"'\''"))]
        return super().quote_completions(completions, cword_prequote, last_wordbreak_pos)
