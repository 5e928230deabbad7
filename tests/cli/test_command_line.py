"""`ros2cli.cli.main`: the command line, or a command of one's own, as a function."""

from __future__ import annotations

import argparse

import pytest
from ros2cli.cli import main
from ros2cli.command import CommandExtension


class Greeting(CommandExtension):
    """Greet somebody.

    More about it.
    """

    def add_arguments(
        self, parser: argparse.ArgumentParser, cli_name: str, *, argv: list[str] | None = None
    ) -> None:
        del argv
        parser.add_argument("name", help=f"who, after {cli_name}")

    def main(self, *, parser: argparse.ArgumentParser, args: argparse.Namespace) -> int | str | None:
        if args.name == "nobody":
            raise RuntimeError(f"{parser.prog}: there is nobody")
        print("hello", args.name)
        return None


def test_words_are_those_of_ros2(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(argv=["interface", "show", "std_msgs/msg/Empty"]) == 0
    assert main(argv=["interface", "show", "std_msgs/msg/String"]) == 0
    assert "string data" in capsys.readouterr().out
    with pytest.raises(SystemExit):
        main(argv=["no_such_word"], script_name="mine")
    assert "usage: mine" in capsys.readouterr().err


def test_extension_takes_the_words(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(script_name="greet", argv=["you"], extension=Greeting()) is None
    assert capsys.readouterr().out == "hello you\n"
    assert main(script_name="greet", argv=["nobody"], extension=Greeting()) == "greet: there is nobody"
    with pytest.raises(SystemExit):
        main(script_name="greet", argv=["--help"], extension=Greeting())
    text = capsys.readouterr().out
    assert "\n\nGreet somebody\n" in text
    assert "who, after greet" in text
    with pytest.raises(SystemExit):
        main(script_name="greet", argv=["--help"], description="Says hello.", extension=Greeting())
    assert "Says hello." in capsys.readouterr().out
