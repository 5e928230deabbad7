"""Fonts of pictures: each letter in the first font that has it, so that the same text has the same width anywhere."""

from __future__ import annotations

import unicodedata
from collections.abc import Container, Iterator
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFError, TTFont

FACES = (
    ("Vera.ttf", "VeraBd.ttf"),  # part of reportlab
    (
        "DejaVuSans.ttf",
        "DejaVuSans-Bold.ttf",
    ),  # the same with Cyrillic, Greek, Arabic, Hebrew, Armenian, Georgian
    ("wqy-microhei.ttc", "wqy-microhei.ttc"),  # Chinese, Japanese, Korean, Cyrillic, Greek: the extra `fonts`
    ("arial.ttf", "arialbd.ttf"),
    ("Arial Unicode.ttf", "Arial Unicode.ttf"),
    ("DroidSansFallbackFull.ttf", "DroidSansFallbackFull.ttf"),  # Chinese, Japanese, Korean
    ("DroidSansFallback.ttf", "DroidSansFallback.ttf"),
    ("msyh.ttc", "msyhbd.ttc"),
    ("malgun.ttf", "malgunbd.ttf"),
)
"""Plain and bold, by the names of files that are searched in packages and in reportlab's and the system's folders."""

PACKAGES = {
    "wqy-microhei.ttc": ("paperang_p2_fonts_cjk", "fonts"),
    "DejaVuSans.ttf": ("matplotlib", "mpl-data/fonts/ttf"),
    "DejaVuSans-Bold.ttf": ("matplotlib", "mpl-data/fonts/ttf"),
}
"""Python packages with a font, if they are installed, and the folder in them."""

EXTRA = "tfloom[fonts]"
"""What to install for the letters of most scripts."""

UNKNOWN_WIDTH = 0.62
"""Width of a letter that no font here has [em]; wide ones have 1."""


@dataclass(frozen=True, eq=False)
class Face:
    """One font file that has been loaded; two faces are equal if they are the same object."""

    name: str
    """Its name in reportlab."""
    path: str
    glyphs: Container[int]
    """The code points that it has."""


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
        return sum(self._run_width(face, part) for face, part in self.runs(text))

    def runs(self, text: str) -> Iterator[tuple[Face | None, str]]:
        """Yield the parts of a line with the face that has their letters, or None."""
        for face, letters in groupby(text, lambda letter: face_of(letter, self.is_bold)):
            yield face, "".join(letters)

    def placed_runs(self, x: float, text: str) -> Iterator[tuple[Face, float, str]]:
        """Yield the parts of a line that begins at `x`: face, left end, letters."""
        for face, part in self.runs(text):
            yield face or plain_face(self.is_bold), x, part
            x += self._run_width(face, part)

    def _run_width(self, face: Face | None, part: str) -> float:
        if face is None:
            return self.size * sum(
                1.0 if unicodedata.east_asian_width(letter) in "WF" else UNKNOWN_WIDTH for letter in part
            )
        return float(pdfmetrics.stringWidth(part, face.name, self.size))


def missing_letters(text: str) -> str:
    """Return the printable letters of `text` that no font here has, each once and in order."""
    return "".join(letter for letter in sorted(set(text)) if letter.isprintable() and not _has_glyph(letter))


def printable(text: str) -> str:
    r"""Return `text` with each letter that no font has written as `\u4e16`."""
    return "".join(
        letter if letter.isprintable() and _has_glyph(letter) else letter.encode("unicode_escape").decode()
        for letter in text
    )


def elided(text: str, font: Font, width: float) -> str:
    """Return `text`, or as much of its start and its end as fits into `width` with `…` between them."""
    if font.width(text) <= width:
        return text
    keep = len(text) - 1
    while keep > 2:
        start = (keep + 1) // 2
        short = f"{text[:start]}…{text[len(text) - (keep - start) :]}"
        excess = font.width(short) - width
        if excess <= 0.0:
            return short
        keep -= max(1, int(excess / font.size))
    return text[:1] + "…"


def _has_glyph(letter: str) -> bool:
    return all(face_of(letter, is_bold) for is_bold in (False, True))


@cache
def face_of(letter: str, is_bold: bool) -> Face | None:
    """Return the first face that has a letter, or None."""
    for names in FACES:
        face = _load(names[is_bold])
        if face is not None and ord(letter) in face.glyphs:
            return face
    return None


def plain_face(is_bold: bool) -> Face:
    """Return the face of Latin letters, which is always there."""
    face = _load(FACES[0][is_bold])
    if face is None:
        raise FileNotFoundError(f"reportlab has no {FACES[0][is_bold]}: reinstall reportlab")
    return face


@cache
def _load(file: str) -> Face | None:
    for path in (*_paths_in_packages(file), file):
        try:
            font = TTFont(file, path)
        except (TTFError, OSError):
            continue  # not installed on this machine
        pdfmetrics.registerFont(font)
        return Face(file, str(font.face.filename), font.face.charToGlyph)
    return None


def _paths_in_packages(file: str) -> Iterator[str]:
    """Yield where a file is in an installed package; the package is not imported."""
    package, folder = PACKAGES.get(file, ("", ""))
    spec = find_spec(package) if package else None
    for place in (spec.submodule_search_locations or ()) if spec else ():
        yield str(Path(place) / folder / file)
