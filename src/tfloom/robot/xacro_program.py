"""xacro: write the XML that a file with macros describes, by the library of this name."""

from __future__ import annotations

import sys

from tfloom.xml_parsers import guard_minidom

__all__ = ["main"]

MISSING = "xacro is not installed: pip install 'tfloom[robot]'"


def main(args: list[str] | None = None) -> int:
    """Expand a file; return the exit code. The library prints errors and help, and raises SystemExit for them."""
    import xml.parsers.expat  # noqa: F401  # the library uses it, and imports it too late for its errors

    try:
        import xacro
    except ImportError as error:
        if error.name != "xacro":
            raise
        print(f"xacro: {MISSING}", file=sys.stderr)
        return 1
    guard_minidom()  # by which the library reads
    if args is not None:
        sys.argv = ["xacro", *args]
    try:
        xacro.main()
    except BrokenPipeError:
        sys.stdout = None  # there is nobody to write to when Python ends
        return 1
    return 0
