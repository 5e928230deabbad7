"""A picture as SVG. Text stays text, in fonts of whoever looks at it; each group has its description as a title.

It is written here and not by `reportlab.graphics.renderSVG`, whose groups have neither a title, which viewers show as a
tooltip, nor an attribute, by which the web page finds a frame. It also names the one font of a text, without others for
whoever lacks it, fills open lines, and turns each text by a transformation because its axis points upwards.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.sax.saxutils import escape, quoteattr

from tfloom.tf2_tools.drawing.shapes import Box, Curve, Group, Path, Pen, Picture, Point, Shape, Text

FAMILY = "'Bitstream Vera Sans','DejaVu Sans',Verdana,'Noto Sans','Noto Sans CJK SC',sans-serif"


def svg_text(picture: Picture) -> str:
    """Return the picture as an SVG document."""
    width, height = _number(picture.width), _number(picture.height)
    size = f'width="{width}pt" height="{height}pt" viewBox="0 0 {width} {height}"'
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="{FAMILY}">',
        f"<title>{_text(picture.title)}</title>",
        f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
        *_lines(picture.shapes),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def _lines(shapes: Sequence[Shape]) -> Iterator[str]:
    for shape in shapes:
        match shape:
            case Group():
                name = f" data-name={_attribute(shape.name)}" if shape.name else ""
                yield f"<g{name}>"
                if shape.title:
                    yield f"<title>{_text(shape.title)}</title>"
                yield from _lines(shape.shapes)
                yield "</g>"
            case Box():
                yield _box(shape)
            case Path():
                tag = "polygon" if shape.fill else "polyline"
                points = " ".join(_pair(point) for point in shape.points)
                yield f'<{tag} points="{points}"{_paint(shape.pen, shape.fill)}/>'
            case Curve():
                start, *rest = (_pair(point) for point in shape.points)
                yield f'<path d="M{start} C{" ".join(rest)}"{_paint(shape.pen, None)}/>'
            case Text():
                weight = ' font-weight="bold"' if shape.font.is_bold else ""
                yield (
                    f'<text x="{_number(shape.x)}" y="{_number(shape.y)}" font-size="{_number(shape.font.size)}"'
                    f'{weight} fill="{shape.color}" xml:space="preserve">{_text(shape.text)}</text>'
                )


def _box(box: Box) -> str:
    radius = f' rx="{_number(box.radius)}"' if box.radius else ""
    return (
        f'<rect x="{_number(box.x)}" y="{_number(box.y)}" width="{_number(box.width)}"'
        f' height="{_number(box.height)}"{radius}{_paint(box.pen, box.fill)}/>'
    )


def _paint(pen: Pen | None, fill: str | None) -> str:
    text = f' fill="{fill or "none"}"'
    if pen is not None:
        text += f' stroke="{pen.color}" stroke-width="{_number(pen.width)}"'
        if pen.dash:
            text += f' stroke-dasharray="{" ".join(map(_number, pen.dash))}"'
    return text


def _pair(point: Point) -> str:
    return f"{_number(point[0])},{_number(point[1])}"


def _number(value: float) -> str:
    return f"{value:.2f}".rstrip("0").rstrip(".")


def _text(text: str) -> str:
    return escape(_allowed(text))


def _attribute(text: str) -> str:
    return quoteattr(_allowed(text))


def _allowed(text: str) -> str:
    r"""Return `text` with each letter that XML does not allow, and each lone surrogate, written as `\x1b`."""
    return "".join(
        letter
        if letter in "\t\n\r"
        or " " <= letter <= "\ud7ff"
        or "\ue000" <= letter <= "\ufffd"
        or letter > "\uffff"
        else letter.encode("unicode_escape").decode()
        for letter in text
    )
