"""Drawn trees: compared with pictures that a person has looked at, and no part over another."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator
from contextlib import closing
from itertools import combinations
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image
from pypdfium2 import PdfDocument
from tests.tf2_tools.kept_pictures import (
    MAX_BLOCK_DIFFERENCE,
    WRITES,
    assert_looks_as_kept,
    grey,
    worst_block,
)
from tests.tf2_tools.tree_pictures import trees

from tfloom.tf2_tools.drawing.fonts import missing_letters
from tfloom.tf2_tools.drawing.pdf import PAGE_LIMIT, pdf_bytes
from tfloom.tf2_tools.drawing.png import png_bytes
from tfloom.tf2_tools.drawing.shapes import Box, Group, Shape, Text
from tfloom.tf2_tools.drawing.shapes import Path as Line
from tfloom.tf2_tools.drawing.svg import svg_text
from tfloom.tf2_tools.tree_pictures.graph import Graph, wrapped
from tfloom.tf2_tools.tree_pictures.pictures import (
    A4,
    GRAPH_SIZE,
    ROW,
    Table,
    draw_page,
    draw_pages,
    one_page,
)
from tfloom.tf2_tools.tree_pictures.tree import FrameTree, build_tree

PICTURES = Path(__file__).parent / "pictures"
"""To write them anew, and look at them: WRITE_PICTURES=1 pytest tests/tf2_tools/tree_pictures/test_pictures.py."""
EXAMPLES: dict[str, Callable[[], FrameTree]] = {
    "12_frames": lambda: trees.robot(12),
    "100_frames": lambda: trees.robot(100),
    "scripts": trees.scripts,
}


@pytest.mark.parametrize("name", EXAMPLES)
def test_pictures_are_those_that_were_looked_at(name: str) -> None:
    tree = EXAMPLES[name]()
    assert not missing_letters("".join(tree.frames))
    assert_looks_as_kept(PICTURES / f"{name}.png", png_bytes(draw_page(tree)))


def test_the_comparison_notices_a_box_instead_of_a_letter() -> None:
    kept = Image.open(PICTURES / "scripts.png").convert("L")
    tree = trees.scripts()
    edges = [edge.record for edge in tree.edges.values()]
    renamed = [edge._replace(child=edge.child.replace("λέιζερ", "\u25a1" * 6)) for edge in edges]
    publishers = {
        edge.child: tree.edges[old.child].publishers for edge, old in zip(renamed, edges, strict=True)
    }
    drawn = grey(png_bytes(draw_page(build_tree(renamed, tree.recorded_at_s, publishers))))
    assert drawn.size != kept.size or worst_block(drawn, kept) >= MAX_BLOCK_DIFFERENCE


@pytest.mark.parametrize(("name", "page", "of_pages"), [("scripts", 1, 1), ("100_frames", 2, 2)])
def test_pages_of_pdf_are_those_that_were_looked_at(name: str, page: int, of_pages: int) -> None:
    with closing(PdfDocument(pdf_bytes(draw_pages(EXAMPLES[name]())))) as document:
        assert len(document) == of_pages
        image = io.BytesIO()
        document[page - 1].render(scale=1.6).to_pil().save(image, "PNG")
    assert_looks_as_kept(PICTURES / f"{name}_page_{page}.png", image.getvalue())


def test_svg_is_the_one_that_was_looked_at() -> None:
    path = PICTURES / "12_frames.svg"
    text = svg_text(draw_page(trees.robot(12)))
    if WRITES:
        path.write_text(text, "utf-8")
    assert text == path.read_text("utf-8")


def words(shapes: list[Shape]) -> Iterator[str]:
    for shape in shapes:
        if isinstance(shape, Group):
            yield from words(shape.shapes)
        elif isinstance(shape, Text):
            yield shape.text


@pytest.mark.parametrize("frames", [12, 100, 400])
def test_each_frame_publisher_and_rate_is_on_the_page(frames: int) -> None:
    tree = trees.robot(frames)
    for pages in ([draw_page(tree)], draw_pages(tree)):
        written = [word for page in pages for word in words(page.shapes)]
        assert set(tree.frames) <= set(written)
        for edge in tree.edges.values():
            assert edge.publishers[0] in written
            assert edge.rate_text in written or edge.state == "static"
    sizes = {(page.width, page.height) for page in draw_pages(tree)}
    if frames > 12:
        assert sizes == {A4}


def test_a_page_of_400_frames_has_the_shape_of_a_screen() -> None:
    page = draw_page(trees.robot(400))
    assert 1.0 < page.width / page.height < 2.2


@pytest.mark.parametrize(
    "tree",
    [
        build_tree([], 0.0),
        build_tree([trees.record("a", "a")], 0.0),
        build_tree([trees.record("世界/🤖" * 40, "\x00\n\t"), trees.record("é" * 300, "世界/🤖" * 40)], 0.0),
        build_tree([trees.record("9" * 5000, "²"), trees.record("9" * 4999, "²")], 1e30),
        trees.chain(60),
        trees.fan(60),
    ],
    ids=["empty", "itself", "unicode", "digits", "chain", "fan"],
)
def test_any_tree_can_be_drawn(tree: FrameTree) -> None:
    page = draw_page(tree)
    svg_text(page).encode()
    assert png_bytes(page).startswith(b"\x89PNG")
    pdf = pdf_bytes(draw_pages(tree))
    assert pdf.startswith(b"%PDF-")
    assert b"/FontFile2" in pdf
    for match in re.findall(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", pdf):
        assert max(map(float, match)) <= PAGE_LIMIT


def test_a_letter_that_no_font_has_is_named() -> None:
    tree = build_tree([trees.record("odd_\U000e0101\ue123", "map")], 0.0)
    written = list(words(draw_page(tree).shapes))
    assert r"odd_\U000e0101\ue123" in written
    assert any(
        line.startswith(
            "No TrueType font here has U+E0101, written as escapes: install one, such as WenQuanYi"
        )
        for line in written
    )


def test_states_are_drawn_as_the_legend_says() -> None:
    svg = svg_text(draw_page(trees.scripts()))
    legend = ["root", "moving", "static", "stale: older than the others"]
    assert [word for word in legend if f">{word}</text>" not in svg] == []
    assert "loop: its parent is one of its descendants" in svg
    assert "<title>база → լազեր\npublished by: default_authority" in svg
    assert 'data-name="very_long_namespace/' in svg


def rectangles(graph: Graph) -> list[tuple[float, float, float, float]]:
    found = []
    for frame in graph.boxes:
        for part, depth, _ in graph.parts(frame):
            breadth = graph.layout.places[frame].breadth
            x, y = (depth, breadth) if graph.sideways else (breadth, depth)
            left, top = (x, y - part.height / 2) if graph.sideways else (x - part.width / 2, y)
            found.append((left, top, left + part.width, top + part.height))
    return found


def overlap(one: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> bool:
    apart = one[2] <= other[0] + 1e-6 or other[2] <= one[0] + 1e-6
    return not (apart or one[3] <= other[1] + 1e-6 or other[3] <= one[1] + 1e-6)


@settings(deadline=None, max_examples=40)
@given(st.data())
def test_parts_of_a_graph_do_not_overlap(data: st.DataObject) -> None:
    names = [f"{'x' * data.draw(st.integers(1, 60))}{i}" for i in range(data.draw(st.integers(1, 12)))]
    records = [
        trees.record(name, data.draw(st.sampled_from(names))) for name in names if data.draw(st.booleans())
    ]
    for sideways in (False, True):
        graph = Graph(build_tree(records, 0.0), sideways=sideways)
        found = rectangles(graph)
        for left, top, right, bottom in found:
            assert left >= -1e-6
            assert right <= graph.width + 1e-6
            assert top >= -1e-6
            assert bottom <= graph.height + 1e-6
        assert not [pair for pair in combinations(found, 2) if overlap(*pair)]


def test_texts_of_a_table_stay_in_their_columns() -> None:
    table = Table(trees.robot(100))
    for row in (shape for shape in table.shapes(range(100), 0.0, 0.0) if isinstance(shape, Group)):
        texts = [shape for shape in row.shapes if isinstance(shape, Text)]
        assert max(text.y for text in texts) - min(text.y for text in texts) < ROW / 3
        ends = [text.x + text.font.width(text.text) for text in texts]
        assert all(end < text.x for end, text in zip(ends, texts[1:], strict=False))
        assert ends[-1] <= table.width + 1e-6


def test_static_transforms_are_dashed_and_stale_ones_grey_in_a_table() -> None:
    tree = build_tree(
        [trees.static("s", "map"), trees.record("m", "map"), trees.record("old", "map", 9.0)], 0.0
    )
    lines = {}
    for shape in one_page(tree).shapes:
        if isinstance(shape, Group) and shape.name != "map":
            pens = [line.pen for line in shape.shapes if isinstance(line, Line) and line.pen]
            lines[shape.name] = bool(pens[-1].dash), pens[-1].color
            box = next(inner_shape for inner_shape in shape.shapes if isinstance(inner_shape, Box))
            assert (box.fill == "#ececec") is (shape.name == "old")
    assert lines == {"s": (True, "#3d74b8"), "m": (False, "#3d74b8"), "old": (False, "#9a9a9a")}


def test_a_tree_becomes_a_table_when_it_is_too_large_for_a_graph() -> None:
    wide = draw_page(trees.fan(40))
    assert any(text == "Published by" for text in words(wide.shapes))
    small = draw_page(trees.robot(12))
    assert small.width < GRAPH_SIZE[0] + 60
    assert any(text == "Broadcaster" for text in words(small.shapes))


def test_long_names_break_after_a_mark() -> None:
    assert wrapped("short") == ["short"]
    assert wrapped("robot_with_a_long_name/base_link", 20) == ["robot_with_a_long_", "name/base_link"]
    assert wrapped("x" * 25, 10) == ["x" * 10, "x" * 10, "x" * 5]
