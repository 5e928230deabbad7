"""A page of the documentation, as its code blocks: what is run, and what must be printed.

| block | meaning |
|---|---|
| `python` that begins with `# NAME.py`, `xml` with `<!-- NAME.urdf -->` | a file that the page's commands use |
| `python` | part of the page's program; a `text` block after it is its output |
| `console` | commands after `$ ` that end, and their output; a line `…` matches any lines |
| `console` with `$ source FILE` | holds for the commands that follow |
| `console keep` | one command that runs until the page ends, and its first output |
| `bash` | not run: the comment before it, `<!-- not run: REASON -->`, says why |
| `python example`, `diff`, `yaml`, `dockerfile`, `{…}` | quoted text, or a directive of the site |
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

DOCS = Path(__file__).parents[2] / "docs"
MASKED = re.compile(r"\[\d{10}\.\d{9}\]|(?<=At time )\d+\.\d+|(?<=pid )\[\d+\]")
QUOTED = {
    "python example",
    "diff",
    "yaml",
    "dockerfile",
    "console",
    "console keep",
    "python",
    "text",
    "bash",
    "xml",
}
FILE = re.compile(r"(?:# |<!-- )(\S+\.(?:py|urdf))(?: -->)?\n")


class Block(NamedTuple):
    """A fenced block of a page."""

    kind: str
    text: str
    line: int
    reason: str
    """Why it is not run; empty if there is no such comment."""


class Command(NamedTuple):
    """A command of a console, and its expected output."""

    words: str
    output: list[str]
    is_kept: bool
    line: int


def blocks(path: Path) -> list[Block]:
    """Return the fenced blocks of a page."""
    text = path.read_text("utf-8")
    matches = re.finditer(
        r"(?:<!-- not run: (.+?) -->\n)?^```([^\n`]*)\n((?:.*\n)*?)```$", text, re.MULTILINE
    )
    return [
        Block(match[2].strip(), match[3], text.count("\n", 0, match.start()) + 1, match[1] or "")
        for match in matches
    ]


def files(page: list[Block]) -> dict[str, str]:
    """Return the programs and descriptions that a page shows, by the names of their files."""
    return {
        name[1]: block.text
        for block in page
        if block.kind in {"python", "xml"} and (name := FILE.match(block.text))
    }


def commands(page: list[Block]) -> Iterator[Command]:
    """Yield the commands of a page's consoles."""
    return (step for step in steps(page) if isinstance(step, Command))


def steps(page: list[Block]) -> Iterator[Command | tuple[str, str]]:
    """Yield the commands of a page's consoles, and the files that are saved between them, name and text."""
    for block in page:
        yield from files([block]).items()
        if block.kind not in {"console", "console keep"}:
            continue
        parts = re.split(r"^\$ ", block.text, flags=re.MULTILINE)
        assert not parts[0], f"line {block.line}: text before the first command"
        for part in parts[1:]:
            words, _, output = part.partition("\n")
            yield Command(words, output.splitlines(), block.kind == "console keep", block.line)


def program(page: list[Block]) -> tuple[str, str]:
    """Return the page's program, and its documented output."""
    codes = [block for block in page if block.kind == "python" and not FILE.match(block.text)]
    return "\n".join(block.text for block in codes), "".join(
        block.text for block in page if block.kind == "text"
    )


def pattern(output: list[str]) -> re.Pattern[str]:
    """Return the pattern of lines that begin with `output`, in which `…` stands for any lines."""
    lines = ["(?:.*\n)*?" if line == "…" else _line(line) + "\n" for line in output]
    return re.compile("".join(lines))


def _line(line: str) -> str:
    """Return the pattern of one line; stamps and process ids are masked, and `…` in it stands for any text."""
    return re.escape(MASKED.sub("#", line)).replace("…", ".*")
