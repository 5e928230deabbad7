"""The drawn tree: a valid page, embedded fonts, no overlaps."""

from __future__ import annotations

import re
from itertools import combinations
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tfloom.tf2_tools import frame_drawing
from tfloom.tf2_tools.frame_drawing import PAGE_LIMIT, draw_frames, wrapped
from tfloom.tf2_tools.frame_records import FrameRecord
from tfloom.tf2_tools.page_fonts import printable


def record(child: str, parent: str, broadcaster: str = "default_authority") -> FrameRecord:
    return FrameRecord(child, parent, broadcaster, 62.514, 1795257550.785885, 1795257545.769412, 5.016)


def page_size(pdf: bytes) -> tuple[float, float]:
    match = re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", pdf)
    assert match is not None
    return float(match[1]), float(match[2])


def rectangles(drawing: frame_drawing._Drawing) -> list[tuple[float, float, float, float]]:
    found = []
    for frame in drawing.boxes:
        for part, depth, _ in drawing._parts(frame):
            x, y = drawing._point(drawing.layout.places[frame].breadth, depth)
            left, top = (x, y + part.height / 2) if drawing.sideways else (x - part.width / 2, y)
            found.append((left, top - part.height, left + part.width, top))
    return found


def test_page_embeds_its_fonts(tmp_path: Path) -> None:
    path = tmp_path / "frames.pdf"
    draw_frames([record("turtle1", "world"), record("laser", "turtle1")], 1795257550.78, path)
    pdf = path.read_bytes()
    assert pdf.startswith(b"%PDF-")
    assert pdf.count(b"/FontFile2") == 2
    width, height = page_size(pdf)
    assert 200 < width < 400
    assert 250 < height < 500


@pytest.mark.parametrize(
    "records",
    [
        [],
        [record("a", "a")],
        [record("b", "a"), record("a", "b"), record("c", "b")],
        [record("世界/🤖" * 40, "\x00\n\t"), record("é" * 300, "世界/🤖" * 40, "…" * 200)],
        [record(f"f{i + 1}", f"f{i}") for i in range(300)],
        [record(f"f{i}", "root") for i in range(400)],
    ],
    ids=["empty", "itself", "cycle", "unicode", "chain", "fan"],
)
def test_any_tree_can_be_drawn(tmp_path: Path, records: list[FrameRecord]) -> None:
    path = tmp_path / "frames.pdf"
    draw_frames(records, 0.0, path)
    assert max(page_size(path.read_bytes())) <= PAGE_LIMIT


@given(st.data())
def test_drawn_parts_do_not_overlap(data: st.DataObject) -> None:
    names = [f"{'x' * data.draw(st.integers(1, 60))}{i}" for i in range(data.draw(st.integers(1, 12)))]
    records = [record(name, data.draw(st.sampled_from(names))) for name in names if data.draw(st.booleans())]
    for sideways in (False, True):
        drawing = frame_drawing._Drawing(records, sideways=sideways)
        found = rectangles(drawing)
        for left, bottom, right, top in found:
            assert left >= -1e-6
            assert right <= drawing.tree_width + 1e-6
            assert top <= 1e-6
            assert bottom >= -drawing.tree_height - 1e-6
        for one, other in combinations(found, 2):
            apart = (
                one[2] <= other[0] + 1e-6
                or other[2] <= one[0] + 1e-6
                or one[3] <= other[1] + 1e-6
                or other[3] <= one[1] + 1e-6
            )
            assert apart


def test_wide_trees_grow_sideways() -> None:
    fan = [record(f"f{i}", "root") for i in range(40)]
    chain = [record(f"f{i + 1}", f"f{i}") for i in range(8)]
    for records, sideways in ((fan, True), (chain, False)):
        drawings = [frame_drawing._Drawing(records, sideways=turned) for turned in (False, True)]
        assert min(drawings, key=frame_drawing._Drawing.unwieldiness).sideways is sideways


def test_letters_without_a_glyph_are_written_as_escapes() -> None:
    assert printable("très_long") == "très_long"
    assert printable("\ue123a\n") == r"\ue123a\n"  # of the private use area, which no font has


@pytest.mark.parametrize("name", ["лазер", "λέιζερ", "激光", "레이저"])
def test_other_scripts_are_drawn_where_the_machine_has_a_font(tmp_path: Path, name: str) -> None:
    if printable(name) != name:
        pytest.skip("no font of this machine has these letters")
    draw_frames([record(name, "map")], 0.0, tmp_path / "frames.pdf")
    assert (tmp_path / "frames.pdf").read_bytes().count(b"/FontFile2") > 2
    font = frame_drawing.TEXT
    assert font.width(f"map/{name}") == pytest.approx(font.width("map/") + font.width(name))
    assert [part for _, part in font._runs(f"map/{name}")] == ["map/", name]


def test_long_names_break_after_a_mark() -> None:
    assert wrapped("short") == ["short"]
    assert wrapped("robot_with_a_long_name/base_link", 20) == ["robot_with_a_long_", "name/base_link"]
    assert wrapped("x" * 25, 10) == ["x" * 10, "x" * 10, "x" * 5]
