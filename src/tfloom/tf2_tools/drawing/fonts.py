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
    # The same with Cyrillic, Greek, Arabic, Hebrew, Armenian, Georgian.
    ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf"),
    ("arial.ttf", "arialbd.ttf"),
    ("Arial Unicode.ttf", "Arial Unicode.ttf"),
    ("msyh.ttc", "msyhbd.ttc"),
    ("malgun.ttf", "malgunbd.ttf"),
)
"""Plain and bold, by the names of files that are searched in packages and in reportlab's and the system's folders.

They come first so that a picture looks the same on most machines. Letters that none of them has, as Chinese ones on
Linux, are searched in the fonts that fontconfig lists.
"""

PACKAGES = {
    "DejaVuSans.ttf": ("matplotlib", "mpl-data/fonts/ttf"),
    "DejaVuSans-Bold.ttf": ("matplotlib", "mpl-data/fonts/ttf"),
}
"""Python packages with a font, if they are installed, and the folder in them."""

FONT_LIST_TIMEOUT_S = 10.0
"""Time in which fontconfig lists the fonts that have a letter; longer only while it reads new fonts."""

_BOLD = 180
"""Least weight of bold fonts, as fontconfig counts it: demibold."""

UNKNOWN_WIDTH = 0.62
"""Width of a letter that no font here has [em]; wide ones have 1."""


@dataclass(frozen=True, eq=False)
class Face:
    """One font file that has been loaded; two faces are equal if they are the same object."""

    name: str
    """Its name in reportlab."""
    path: str
    index: int
    """Number of the font in the file, which may be a collection."""
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
    return _system_face(ord(letter), is_bold)


def _system_face(code: int, is_bold: bool) -> Face | None:
    """Return a face of the system's that has a code point; one that already serves for other letters, if possible."""
    loaded = _system_faces(is_bold)
    for face in loaded:
        if code in face.glyphs:
            return face
    for path, index in _system_fonts(code, is_bold):
        new = _load_file(f"{Path(path).name} {index}", path, index)
        if new is not None and code in new.glyphs:
            loaded.append(new)
            return new
    return None


@cache
def _system_faces(is_bold: bool) -> list[Face]:  # noqa: ARG001  # the key of the cache
    """Return the list of the system's faces that are in use, which grows."""
    return []


def _system_fonts(code: int, is_bold: bool) -> list[tuple[str, int]]:
    """Return the path and index of each TrueType font that has a code point, those of the wanted weight first.

    The source is the command `fc-list` of fontconfig; without it the list is empty. Other kinds of fonts are left out,
    because reportlab embeds TrueType alone.
    """
    import subprocess

    pattern = f":charset={code:x}:fontformat=TrueType"
    command = ["fc-list", "--format", "%{file}\t%{index}\t%{weight}\n", pattern]
    try:
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=FONT_LIST_TIMEOUT_S,
            check=False,
            errors="replace",
        )
    except (OSError, subprocess.TimeoutExpired):
        return []
    fonts = []
    for line in done.stdout.splitlines():
        path, index, weight = (*line.split("\t"), "", "")[:3]
        # The weight of a variable font is a range, in which each weight is.
        has_weight = not weight.isdigit() or (int(weight) >= _BOLD) == is_bold
        # The upper half of an index is an instance of a variable font, which reportlab does not know.
        if index.isdigit() and int(index) < 1 << 16:
            fonts.append((not has_weight, path, int(index)))
    return [(path, index) for _, path, index in sorted(fonts)]


def plain_face(is_bold: bool) -> Face:
    """Return the face of Latin letters, which is always there."""
    face = _load(FACES[0][is_bold])
    if face is None:
        raise FileNotFoundError(f"reportlab has no {FACES[0][is_bold]}: reinstall reportlab")
    return face


@cache
def _load(file: str) -> Face | None:
    for path in (*_paths_in_packages(file), file):
        face = _load_file(file, path, 0)
        if face is not None:
            return face
    return None


@cache
def _load_file(name: str, path: str, index: int) -> Face | None:
    """Return a font of a file, registered in reportlab; None if it is not on this machine, or no TrueType font."""
    try:
        font = TTFont(name, path, subfontIndex=index)
    except (TTFError, OSError):
        return None
    pdfmetrics.registerFont(font)
    return Face(name, str(font.face.filename), index, font.face.charToGlyph)


def _paths_in_packages(file: str) -> Iterator[str]:
    """Yield where a file is in an installed package; the package is not imported."""
    package, folder = PACKAGES.get(file, ("", ""))
    spec = find_spec(package) if package else None
    for place in (spec.submodule_search_locations or ()) if spec else ():
        yield str(Path(place) / folder / file)
