"""Write the list of files in native/README.md, from the first sentence of each: `python -m tools.native_readme`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

__all__ = ["README", "listed", "readme_text"]

NATIVE = Path(__file__).parents[1] / "native"
README = "README.md"
BEGIN = "<!-- The rest is written by `python -m tools.native_readme`. -->\n"
"""The line after which the list begins."""


def readme_text(native: Path = NATIVE) -> str:
    """Return README.md with a list of the files in the rooms that its table has.

    Raises:
        ValueError: README.md has no line `BEGIN`, or a file doesn't begin with a comment.
    """
    head, begin, _ = (native / README).read_text("utf-8").partition(BEGIN)
    if not begin:
        raise ValueError(f"native/{README} lacks the line {BEGIN.strip()}")
    rooms = re.findall(r"^\| `(\w+)/` \|", head, re.MULTILINE)
    return head + begin + "".join(f"\n{text}" for room in rooms for text in listed(native, room))


def listed(native: Path, room: str) -> Iterator[str]:
    """Yield the heading of a room, and a line for each file in it, or for a header and its source."""
    yield f"## {room}/\n"
    files: dict[str, Path] = {}
    for path in sorted((native / room).iterdir()):
        files[path.stem] = path  # .hpp after .cpp: the header's first sentence is for both
    yield "".join(f"- `{stem}`: {_first_sentence(path)}\n" for stem, path in files.items())


def _first_sentence(path: Path) -> str:
    sign = "#" if path.suffix == ".txt" else "//"
    lines = []
    for line in path.read_text("utf-8").splitlines():
        text = line.removeprefix(sign).strip()
        if not line.startswith(sign) or not text:
            break
        lines.append(text)
    if not lines:
        raise ValueError(
            f"native/{path.parent.name}/{path.name} doesn't begin with a comment that says what it is for"
        )
    return " ".join(lines).split(". ")[0].rstrip(".")


if __name__ == "__main__":
    (NATIVE / README).write_text(readme_text(), "utf-8")
