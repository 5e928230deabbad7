"""Fonts for a page of PDF: each letter in the first font that has it, embedded so that readers need no fonts."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import groupby
from typing import NamedTuple

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFError, TTFont
from reportlab.pdfgen.canvas import Canvas

__all__ = ["Font", "printable"]

FACES = (
    ("Vera.ttf", "VeraBd.ttf"),  # part of reportlab
    (
        "DejaVuSans.ttf",
        "DejaVuSans-Bold.ttf",
    ),  # the same with Cyrillic, Greek, Arabic, Hebrew, Armenian, Georgian
    ("arial.ttf", "arialbd.ttf"),
    ("Arial Unicode.ttf", "Arial Unicode.ttf"),
    ("DroidSansFallbackFull.ttf", "DroidSansFallbackFull.ttf"),  # Chinese, Japanese, Korean
    ("DroidSansFallback.ttf", "DroidSansFallback.ttf"),
    ("msyh.ttc", "msyhbd.ttc"),
    ("malgun.ttf", "malgunbd.ttf"),
)
"""Plain and bold, by the names of files that reportlab searches in its own and in the system's font folders."""


class Font(NamedTuple):
    """A size of plain or bold letters."""

    is_bold: bool
    size: float

    @property
    def leading(self) -> float:
        """The distance between lines."""
        return self.size * 1.32

    def width(self, text: str) -> float:
        """Return the length of a line."""
        return sum(pdfmetrics.stringWidth(part, face, self.size) for face, part in self._runs(text))

    def draw(self, canvas: Canvas, x: float, y: float, text: str) -> None:
        """Draw a line from the left end of its baseline."""
        for face, part in self._runs(text):
            canvas.setFont(face, self.size)
            canvas.drawString(x, y, part)
            x += float(pdfmetrics.stringWidth(part, face, self.size))

    def _runs(self, text: str) -> Iterator[tuple[str, str]]:
        for face, letters in groupby(
            text, lambda letter: _face_of(letter, self.is_bold) or FACES[0][self.is_bold]
        ):
            yield face, "".join(letters)


def printable(text: str) -> str:
    r"""Return `text` with each letter that no font has written as `\u4e16`."""
    return "".join(
        letter
        if letter.isprintable() and all(_face_of(letter, is_bold) for is_bold in (False, True))
        else letter.encode("unicode_escape").decode()
        for letter in text
    )


@cache
def _face_of(letter: str, is_bold: bool) -> str | None:
    """Return the name of the first face that has a letter, or None."""
    for names in FACES:
        face = _load(names[is_bold])
        if face is not None and ord(letter) in face.face.charToGlyph:
            return names[is_bold]
    return None


@cache
def _load(file: str) -> TTFont | None:
    try:
        face = TTFont(file, file)
    except (TTFError, OSError):
        return None  # not installed on this machine
    pdfmetrics.registerFont(face)
    return face
