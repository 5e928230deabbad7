"""Shapes in each format: where they are drawn, and texts that are hostile to the format."""

from __future__ import annotations

import io
import math
import os
import shutil
from collections.abc import Iterator
from pathlib import Path as FilePath
from xml.etree import ElementTree as ET

import pytest
from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen
from PIL import Image

from tfloom.tf2_tools.drawing import fonts
from tfloom.tf2_tools.drawing.fonts import Font, elided, missing_letters, printable
from tfloom.tf2_tools.drawing.pdf import pdf_bytes
from tfloom.tf2_tools.drawing.png import MAX_PIXELS, png_bytes
from tfloom.tf2_tools.drawing.shapes import Box, Curve, Group, Path, Pen, Picture, Text
from tfloom.tf2_tools.drawing.svg import svg_text

PLAIN = Font(is_bold=False, size=10.0)
BOLD = Font(is_bold=True, size=10.0)
RED = Pen("#ff0000", 2.0)


def image_of(*shapes: Box | Path | Curve | Text) -> Image.Image:
    return Image.open(io.BytesIO(png_bytes(Picture(100.0, 50.0, list(shapes), "test"))))


def pixel(image: Image.Image, x: float, y: float) -> object:
    return image.getpixel((round(x * 2), round(y * 2)))


def test_png_has_two_pixels_for_each_point() -> None:
    image = image_of(Box(10.0, 5.0, 20.0, 10.0, "#00ff00"), Path([(50.0, 0.0), (50.0, 50.0)], RED))
    assert image.size == (200, 100)
    assert round(image.info["dpi"][0]) == 144
    assert [pixel(image, *point) for point in ((20, 10), (8, 10), (50, 25))] == [
        (0, 255, 0),
        (255, 255, 255),
        (255, 0, 0),
    ]


def test_dashes_cover_their_share_of_a_line() -> None:
    image = image_of(Path([(0.0, 25.0), (100.0, 25.0)], Pen("#000000", 2.0, (6.0, 4.0))))
    dark = sum(image.convert("L").getpixel((x, 50)) < 128 for x in range(200))  # type: ignore[operator]
    assert dark == pytest.approx(120, abs=12)


def test_curves_begin_and_end_at_their_points() -> None:
    image = image_of(Curve(((10.0, 10.0), (10.0, 40.0), (90.0, 10.0), (90.0, 40.0)), RED))
    assert pixel(image, 10, 11) == pixel(image, 90, 39) == (255, 0, 0)


def test_a_huge_picture_has_fewer_pixels() -> None:
    image = Image.open(io.BytesIO(png_bytes(Picture(20_000.0, 8_000.0, [], "huge"))))
    assert math.prod(image.size) <= MAX_PIXELS * 1.01


def test_svg_escapes_what_xml_does_not_allow() -> None:
    hostile = "<script>&\"'\x00\x1b\ud800"
    group = Group([Text(0.0, 10.0, hostile, PLAIN, "#000000")], hostile, hostile)
    root = ET.fromstring(svg_text(Picture(10.0, 10.0, [group], hostile)))
    names = [element.get("data-name") for element in root.iter() if element.get("data-name")]
    assert names == ["<script>&\"'\\x00\\x1b\\ud800"]
    assert not [element for element in root.iter() if element.tag.endswith("script")]


def test_a_pdf_is_the_same_each_time_and_has_a_page_for_each_picture() -> None:
    pages = [Picture(100.0, 50.0, [Text(5.0, 20.0, "b", BOLD, "#000000")], "test")] * 3
    assert pdf_bytes(pages) == pdf_bytes(pages)
    assert pdf_bytes(pages).count(b"/Type /Page\n") + pdf_bytes(pages).count(b"/Type /Page ") == 3


@pytest.fixture
def fresh_fonts() -> Iterator[None]:
    """Have fonts be searched anew, in the test and after it."""
    cached = (fonts.face_of, fonts._system_faces, fonts._load_file)
    for function in cached:
        function.cache_clear()
    yield
    for function in cached:
        function.cache_clear()


def write_font(path: FilePath, letters: str) -> FilePath:
    """Write a TrueType font whose letters are filled squares."""
    pen = TTGlyphPen(None)
    pen.moveTo((0, 0))
    for corner in ((0, 800), (800, 800), (800, 0)):
        pen.lineTo(corner)
    pen.closePath()
    names = [".notdef", *(f"letter{ord(letter):x}" for letter in letters)]
    builder = FontBuilder(1000)
    builder.setupGlyphOrder(names)
    builder.setupCharacterMap({ord(letter): f"letter{ord(letter):x}" for letter in letters})
    builder.setupGlyf(dict.fromkeys(names, pen.glyph()))
    builder.setupHorizontalMetrics(dict.fromkeys(names, (1000, 0)))
    builder.setupHorizontalHeader(ascent=800, descent=-200)
    builder.setupNameTable({"familyName": path.stem, "styleName": "Regular", "psName": path.stem})
    builder.setupOS2(sTypoAscender=800)
    builder.setupPost()
    builder.save(path)
    return path


def write_font_lister(folder: FilePath, *lines: str) -> None:
    """Write an `fc-list` that prints lines, and counts its calls."""
    program = folder / "fc-list"
    listing = "\n".join(lines)
    program.write_text(f"#!/bin/sh\necho \"$*\" >> {folder}/calls\ncat <<'END'\n{listing}\nEND\n")
    program.chmod(0o755)


@pytest.mark.parametrize("name", ["лазер", "λέιζερ", "კამერა"])
def test_letters_of_other_scripts_have_a_font(name: str) -> None:
    expect_drawn(name)


def expect_drawn(name: str) -> None:
    """Expect that each letter of a name has a glyph, in PDF and PNG."""
    assert printable(name) == name
    assert missing_letters(name) == ""
    for font in (PLAIN, BOLD):
        assert font.width(f"map/{name}") == pytest.approx(font.width("map/") + font.width(name))
        assert [part for _, part in font.runs(f"map/{name}")] == ["map/", name]
    picture = Picture(99.0, 9.0, [Text(0.0, 8.0, name, PLAIN, "#000000")], "")
    assert pdf_bytes([picture]).count(b"/FontFile2") == 1
    assert Image.open(io.BytesIO(png_bytes(picture))).convert("L").getextrema()[0] == 0


@pytest.mark.skipif(os.name != "posix", reason="the stand-in for fc-list is a shell script")
@pytest.mark.usefixtures("fresh_fonts")
def test_letters_are_found_in_the_fonts_that_fontconfig_lists(
    tmp_path: FilePath, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = write_font(tmp_path / "Plain.ttf", "激光雷達")
    bold = write_font(tmp_path / "Heavy.ttf", "激光雷達")
    broken = tmp_path / "Broken.ttf"
    broken.write_bytes(b"no font")
    write_font_lister(
        tmp_path,
        f"{broken}\t0\t80",
        f"{bold}\t0\t200",
        f"{plain}\t0\t80",
        f"{plain}\t65536\t80",  # an instance of a variable font
        "a line of another form",
    )
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    expect_drawn("激光雷達")
    for is_bold, path in ((False, plain), (True, bold)):
        face = fonts.face_of("雷", is_bold)
        assert face is not None
        assert face.path == str(path)
    # One call for each weight, because the face of the first letter has the others.
    calls = (tmp_path / "calls").read_text("utf-8")
    assert calls.count("fontformat") == calls.count(f" :charset={ord('激'):x}:fontformat=TrueType\n") == 2


@pytest.mark.skipif(shutil.which("fc-list") is None, reason="needs fontconfig's command fc-list")
@pytest.mark.usefixtures("fresh_fonts")
def test_fontconfig_itself_lists_a_font(tmp_path: FilePath, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "fonts"
    folder.mkdir()
    font = write_font(folder / "Squares.ttf", "激光雷達")
    configuration = tmp_path / "fonts.conf"
    configuration.write_text(
        f"<fontconfig><dir>{folder}</dir><cachedir>{tmp_path / 'cache'}</cachedir></fontconfig>"
    )
    monkeypatch.setenv("FONTCONFIG_FILE", str(configuration))
    assert fonts._system_fonts(ord("光"), is_bold=False) == [(str(font), 0)]
    assert fonts._system_fonts(ord("a"), is_bold=False) == []
    expect_drawn("激光雷達")


@pytest.mark.usefixtures("fresh_fonts")
def test_letters_without_a_glyph_are_written_as_escapes(
    tmp_path: FilePath, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))  # without fontconfig
    assert printable("\ue123a\n") == r"\ue123a\n"  # of the private use area, which no font has
    monkeypatch.setattr(fonts, "FACES", fonts.FACES[:1])
    assert printable("a激") == r"a\u6fc0"
    assert missing_letters("激光a\n激") == "光激"
    assert PLAIN.width("激") == 10.0


def test_elided_texts_keep_their_ends_and_fit() -> None:
    assert elided("short", PLAIN, 100.0) == "short"
    name = "robot_of_the_third_generation/camera_optical_frame"
    for width in (20.0, 60.0, 150.0, 200.0):
        short = elided(name, PLAIN, width)
        assert PLAIN.width(short) <= width
        start, end = short.split("…")
        assert name.startswith(start)
        assert name.endswith(end)
