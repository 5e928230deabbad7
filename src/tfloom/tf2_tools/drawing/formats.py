"""The content of a picture's file by its format."""

from __future__ import annotations

from collections.abc import Sequence

from tfloom.tf2_tools.drawing.shapes import Picture


def file_content(pages: Sequence[Picture], file_format: str) -> bytes | str:
    """Return the content of a file; a format is imported when it is needed.

    Args:
        pages: The pages of a PDF; other formats have one.
        file_format: `pdf`, `png` or `svg`.
    """
    if file_format == "pdf":
        from tfloom.tf2_tools.drawing.pdf import pdf_bytes

        return pdf_bytes(pages)
    (picture,) = pages
    if file_format == "png":
        from tfloom.tf2_tools.drawing.png import png_bytes

        return png_bytes(picture)
    from tfloom.tf2_tools.drawing.svg import svg_text

    return svg_text(picture)
