"""Each flag of ros2's verbs is accepted here, too."""

from __future__ import annotations

import json
import re
from pathlib import Path

from tests.each import for_each

from tfloom.cli.main import COMMANDS
from tfloom.cli.parser import VerbParser, build_parser

USAGES: dict[str, str | None] = json.loads(
    (Path(__file__).parents[1] / "golden" / "cli_usage.json").read_text("utf-8")
)

NOT_HERE = {}
"""Verbs that ros2 has and we don't, each with its reason."""

OF_SEVERAL = {"param get", "param set", "topic bw", "topic hz"}
"""Verbs that take several of what Jazzy's take one of, as those of later distributions do."""


def parsers(parser: VerbParser) -> dict[str, VerbParser]:
    """Return the parser of each verb by its words, each filled with its arguments."""
    parser.fill()
    if not parser.words:
        return {"": parser}
    return {
        f"{word} {rest}".strip(): subparser
        for word, child in parser.words.items()
        if child.prog.split()[-1] == word  # no alias
        for rest, subparser in parsers(child).items()
    }


VERBS = parsers(build_parser("ros2", COMMANDS))
RECORDED = [verb for verb in USAGES if verb in VERBS and USAGES[verb]]


def test_each_ros2_verb_exists_or_has_a_stated_reason() -> None:
    assert set(USAGES) - set(VERBS) == set(NOT_HERE), (
        "NOT_HERE of tests/cli/test_usage.py: a verb of ros2 that is not here gets a reason"
    )


@for_each(RECORDED)
def test_each_ros2_flag_is_accepted(verb: str) -> None:
    usage = USAGES[verb]
    assert usage is not None
    flags = set(re.findall(r"(?<![\w-])--?[a-zA-Z][\w-]*", usage))
    assert flags <= VERBS[verb]._option_string_actions.keys()


@for_each(RECORDED)
def test_each_positional_argument_is_accepted(verb: str) -> None:
    usage = USAGES[verb]
    assert usage is not None
    usage = usage.split(" Call `")[0]  # The placeholder of the following words.
    positional = re.sub(r"\[-[^\]]*\]|^ros2 ", "", usage).removeprefix(verb).split()
    ours = VERBS[verb].format_usage().removeprefix(f"usage: ros2 {verb}").split()
    names = [word for word in positional if re.fullmatch(r"\[?\w+\]?", word)]
    if verb in OF_SEVERAL:
        assert "..." in " ".join(ours)
        ours = [word.strip("[]") for word in ours]
    else:
        assert ("..." in positional) == ("..." in ours)
    assert [word for word in ours if word in names] == names


@for_each(VERBS)
def test_each_argument_has_help(verb: str) -> None:
    for action in VERBS[verb]._actions:
        assert action.help, f"{verb}: {action.dest} has no help"
    assert VERBS[verb].description
