"""Comparison of pictures with small ones that a person has looked at."""

from __future__ import annotations

import io
import os
from pathlib import Path

from PIL import Image, ImageChops, ImageStat

WRITES = "WRITE_PICTURES" in os.environ
"""Whether to write the pictures anew, to look at them: WRITE_PICTURES=1 pytest tests/tf2_tools."""
MAX_DIFFERENCE = 2.0
"""Mean difference of grey levels, of 255, which other releases of FreeType stay below."""
BLOCK = 24
"""Side of the squares by which pictures are compared, too [pixels]."""
MAX_BLOCK_DIFFERENCE = 30.0
"""Mean difference of a square; that of another letter is above it."""


def assert_looks_as_kept(path: Path, png: bytes) -> None:
    """Fail if a picture differs from the one that is kept by more than another release of FreeType would."""
    drawn = grey(png)
    if WRITES:
        drawn.quantize(8).save(path, optimize=True)
    kept = Image.open(path).convert("L")
    assert drawn.size == kept.size
    assert ImageStat.Stat(ImageChops.difference(drawn, kept)).mean[0] < MAX_DIFFERENCE
    assert worst_block(drawn, kept) < MAX_BLOCK_DIFFERENCE


def grey(png: bytes) -> Image.Image:
    """Return a picture as small as those that are kept."""
    image = Image.open(io.BytesIO(png)).convert("L")
    return image.reduce(2) if image.width > 1000 else image


def worst_block(one: Image.Image, other: Image.Image) -> int:
    """Return the greatest mean difference of a square."""
    return int(ImageChops.difference(one, other).reduce(BLOCK).getextrema()[1])  # `reduce` takes the means
