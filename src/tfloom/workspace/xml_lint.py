"""The check of XML files that `colcon test` runs: whether they are well-formed."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree as ET

from tfloom.common.terminal import report
from tfloom.common.xml import read_tree
from tfloom.workspace.listed_sources import add_paths, files_of


def xmllint_main(argv: Sequence[str] | None = None) -> int:
    """Check XML files and print what is wrong with them; return 1 if that is something, else 0.

    No schema is loaded, because the one that a package.xml names is on the web.

    Args:
        argv: The arguments of the command `ament_xmllint`; None for those of this process.
    """
    parser = argparse.ArgumentParser(description="Check whether XML files are well-formed.")
    parser.add_argument("--extensions", nargs="*", default=["xml"], help="those of the files to check")
    add_paths(parser, "files with these extensions")
    args = parser.parse_args(argv)
    endings = tuple(f".{extension}" for extension in args.extensions)
    invalid = 0
    for path in files_of(args.paths, args.excludes, endings):
        fault = _find_fault(path)
        if fault is None:
            print(f"File '{path}' is valid")
            continue
        invalid += 1
        report(f"File '{path}' is invalid\n{path}:{fault}")
    if invalid:
        report(f"{invalid} files are invalid")
        return 1
    print("No problems found")
    return 0


def _find_fault(path: str) -> str | None:
    """Return the position of a mistake, and what is wrong there; None if nothing is."""
    try:
        read_tree(Path(path).read_bytes())
    except ET.ParseError as error:
        line, column = error.position
        return f"{line}:{column + 1}: {str(error).partition(':')[0]}"
    except OSError as error:
        return f" {error.strerror}"
    return None
