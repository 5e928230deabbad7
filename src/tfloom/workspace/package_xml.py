"""What an interface package's `package.xml` declares: its name, and the packages that it depends on."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Manifest(NamedTuple):
    """The tags of a `package.xml` that a build reads."""

    name: str
    run: tuple[str, ...]
    """The packages of `depend` and `exec_depend`, then those of `test_depend`, each once: ament's run dependencies."""
    declared: frozenset[str]
    """The packages of all tags that end in `depend`."""


_RUN_TAGS = ("depend", "exec_depend", "run_depend", "test_depend")


def read_manifest(path: Path) -> Manifest:
    """Return what a `package.xml` declares.

    Raises:
        ValueError: it isn't XML, or has no name; the text has the file, and the line of a mistake.
        OSError: it can't be read.
    """
    from xml.etree import ElementTree as ET

    from tfloom.common.xml import read_tree

    try:
        root = read_tree(path.read_bytes())
    except ET.ParseError as error:
        line, column = error.position
        raise ValueError(f"{path}:{line}:{column + 1}: it isn't XML: {error}") from None
    tags = [(element.tag, (element.text or "").strip()) for element in root]
    names = [text for tag, text in tags if tag == "name" and text]
    if not names:
        raise ValueError(f"{path}: the package has no <name>")
    run = [text for run_tag in _RUN_TAGS for tag, text in tags if tag == run_tag]
    declared = frozenset(text for tag, text in tags if tag.endswith("depend"))
    return Manifest(names[0], tuple(dict.fromkeys(run)), declared)
