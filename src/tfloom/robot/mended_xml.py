"""XML that is not well-formed, mended as far as TinyXML takes it, which reads descriptions in ROS's own programs.

Lines stay where they are, for the errors that follow.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Callable, Iterator

from tfloom.common.xml import declared_encoding
from tfloom.robot.urdf_faults import Remarks

__all__ = ["decoded", "mended"]

_AMPERSAND = re.compile(r"&(?!(?:amp|lt|gt|quot|apos|#[0-9]+|#x[0-9A-Fa-f]+);)")
_CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f]")
_DASHES = "a comment has '--' in it, which XML does not allow"
_LATE = (
    "the XML declaration is not at the start of the text, as in a Python text that begins with a line break"
)


def mended(text: str | bytes, remarks: Remarks) -> str:
    """Return a text without its comments and XML declaration, and with what else can be mended mended.

    Args:
        text: A str, or the bytes of a file.
        remarks: Get a remark for each fault.
    """
    if isinstance(text, bytes):
        text = decoded(text, remarks)
    text = text.removeprefix("\ufeff")
    text = _without("<!--", "-->", text, lambda body, _: "--" in body or body.endswith("-"), _DASHES, remarks)
    text = _without("<?xml ", "?>", text, lambda _, start: start > 0, _LATE, remarks)
    text = _replaced(_CONTROL, "\ufffd", text, "a control character is not allowed in XML", remarks)
    if "<!ENTITY" not in text:  # entities are refused, by their names
        text = _replaced(_AMPERSAND, "&amp;", text, "& is written as &amp; in XML", remarks)
    return text


def _without(
    opening: str, closing: str, text: str, is_wrong: Callable[[str, int], bool], fault: str, remarks: Remarks
) -> str:
    """Return a text without what stands between two marks, but for its line breaks."""
    parts = []
    line, end = 1, 0
    for start, stop in _spans(opening, closing, text):
        parts.append(text[end:start])
        line += parts[-1].count("\n")
        body = text[start + len(opening) : stop - len(closing)]
        if is_wrong(body, start):
            remarks.add(line, fault)
        parts.append("\n" * body.count("\n"))
        line += body.count("\n")
        end = stop
    return "".join([*parts, text[end:]])


def _spans(opening: str, closing: str, text: str) -> Iterator[tuple[int, int]]:
    """Yield where each span begins and ends; one that is not closed is none, and none is looked for behind it.

    A regular expression would look for the end from each beginning, in a time that grows with the square of the text.
    """
    stop = 0
    while (start := text.find(opening, stop)) >= 0:
        end = text.find(closing, start + len(opening))
        if end < 0:
            return
        stop = end + len(closing)
        yield start, stop


def _replaced(pattern: re.Pattern[str], new: str, text: str, fault: str, remarks: Remarks) -> str:
    line, seen = 1, 0
    for match in pattern.finditer(text):
        line += text.count("\n", seen, match.start())
        seen = match.start()
        remarks.add(line, fault)
    return pattern.sub(new, text)


def decoded(data: bytes, remarks: Remarks) -> str:
    """Return the text of a file by the encoding that it declares, else as UTF-8, else as Latin-1.

    Args:
        data: The file's content.
        remarks: Get a remark if it is not the first of these.
    """
    name = declared_encoding(data) or "utf-8"
    for encoding in dict.fromkeys((name, "utf-8")):
        try:
            codecs.lookup(encoding)
            return data.decode(encoding)
        except UnicodeDecodeError as error:
            line = data.count(b"\n", 0, error.start) + 1
            octet = f"the octet {data[error.start]:#04x} is not text in {encoding}"
            remarks.add(line, f"{octet}: save the file as UTF-8", "encoding")
        except LookupError:  # not known, or not of text, as zlib
            remarks.add(1, f"the encoding '{encoding}' is not known, so the text is read as UTF-8")
    return data.decode("latin-1")
