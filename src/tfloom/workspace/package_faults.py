"""Faults of a package's package.xml and setup.py that stop its build, each as a sentence."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from xml.etree import ElementTree as ET

from tfloom.common.xml import read_tree

MAX_NAME = 200
"""Letters that the name of a package may have: files are named after it, with more behind, and have at most 255."""
_SPACE = "\N{NO-BREAK SPACE}"
_CURLY = str.maketrans(
    dict.fromkeys(
        "\N{LEFT DOUBLE QUOTATION MARK}\N{RIGHT DOUBLE QUOTATION MARK}\N{DOUBLE LOW-9 QUOTATION MARK}", '"'
    )
    | dict.fromkeys("\N{LEFT SINGLE QUOTATION MARK}\N{RIGHT SINGLE QUOTATION MARK}", "'")
    | {_SPACE: " "}
)
_NAME_TAG = re.compile(r"<name>\s*([A-Za-z0-9_-]+)\s*</name>")


def find_manifest_fault(path: Path) -> str | None:
    """Return what is wrong with the XML of a package.xml, with line and column, or None.

    A file whose outermost tag isn't `package` is not a package's, and has no fault.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        return f"{path}: can't be read: {error.strerror}"
    try:
        root = read_tree(data)
    except ET.ParseError as error:
        if b"<package" not in data:
            return None
        line, column = error.position
        reason = str(error).partition(":")[0]
        fault = _not_utf8(data) or f"not XML: {reason}: {_advice(reason)}"
        return f"{path}:{line}:{column + 1}: {fault}"
    if root.tag != "package":
        return None
    problem = _find_tag_fault(root)
    return None if problem is None else f"{path}: {problem}"


def _find_tag_fault(root: ET.Element) -> str | None:
    for tag in ("name", "version", "description", "maintainer", "license"):
        if not any(_says_something(element) for element in root.findall(tag)):
            return f"the tag <{tag}> is missing: add <{tag}>…</{tag}>"
    length = len((root.findtext("name") or "").strip())
    if length > MAX_NAME:
        return f"the name of the package is too long: it has {length} letters, but may have {MAX_NAME}"
    return None


def _says_something(element: ET.Element) -> bool:
    # A maintainer may have an address alone. The text of others may be in elements of XHTML:
    # `<description><p>…</p></description>`.
    return bool("".join(element.itertext()).strip() or element.get("email"))


def _not_utf8(data: bytes) -> str | None:
    """Return what is wrong with the text of a file that isn't UTF-8, or None."""
    try:
        data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        return f"octet {data[error.start]:#04x} isn't UTF-8 text: save the file as UTF-8"
    return None


def _advice(reason: str) -> str:
    if "mismatched tag" in reason:
        return "close each tag before the one around it, as <a><b></b></a>"
    if "invalid token" in reason:
        return "write & as &amp; and < as &lt;"
    return "every tag that opens must close"


def name_in_manifest(path: Path) -> str:
    """Return the name of the package in a package.xml that may be broken, or of its folder if no file can have that."""
    try:
        match = _NAME_TAG.search(path.read_text("utf-8", "replace"))
    except OSError:
        match = None
    return match[1] if match and len(match[1]) <= MAX_NAME else path.parent.name[:MAX_NAME]


def find_setup_fault(path: Path) -> str | None:
    """Return what is wrong with the syntax of a setup.py, with its line and what to type, or None."""
    try:
        text = path.read_text("utf-8")
    except OSError as error:
        return f"{path}: can't be read: {error.strerror}"
    except UnicodeDecodeError as error:
        return f"{path}: octet {error.object[error.start]:#04x} isn't UTF-8 text: save the file as UTF-8"
    try:
        ast.parse(text, str(path))
    except SyntaxError as error:
        return _explain(path, text, error)
    except ValueError as error:  # a null character
        return f"{path}: {error}"
    return None


def _explain(path: Path, text: str, error: SyntaxError) -> str:
    lines = text.splitlines()
    number = error.lineno or 1
    line = lines[number - 1] if number <= len(lines) else ""
    curly = [letter for letter in line if ord(letter) in _CURLY]
    if not curly:
        return f"{path}:{number}:{error.offset or 1}: {error.msg}: {line.strip()}"
    where = f"{path}:{number}:{line.index(curly[0]) + 1}"
    rest = sum(any(ord(letter) in _CURLY for letter in later_line) for later_line in lines[number:])
    more = f"\n{rest} more line{'s' * (rest > 1)} below have them, too" if rest else ""
    what = "no-break spaces U+00A0" if curly[0] == _SPACE else f"curly quotes {curly[0]}"
    return (
        f"{where}: {what} from a web page are not Python's: type this line as\n"
        f"    {line.strip().translate(_CURLY)}{more}"
    )
