"""check_urdf: check the description of a robot, and print its tree of links."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

from tfloom.common.terminal import report
from tfloom.robot.description import Description
from tfloom.robot.urdf import parse_urdf
from tfloom.robot.urdf_faults import UrdfError

__all__ = ["main"]

FAILED = 255
_FAILURE = "ERROR: Model Parsing the xml failed"


def main(args: list[str] | None = None) -> int:
    """Print the tree of the file that the first argument names; return 0, or 255 if it isn't a valid description."""
    words = sys.argv[1:] if args is None else args
    if not words:
        report("Expect URDF xml file to parse")
        return FAILED
    path = words[0]
    try:
        robot = parse_urdf(Path(path).read_bytes())
    except (OSError, UrdfError) as error:
        reason = (
            f"{path}: {error.strerror}"
            if isinstance(error, OSError)
            else f"{path}:{error.line}: {error.reason}"
        )
        report(f"Error:   {reason}\n{_FAILURE}")
        return FAILED
    refused = [remark for remark in robot.remarks if remark.is_refused]
    for remark in robot.remarks:
        kind = "Error:  " if remark.is_refused else "Warning:"
        report(f"{kind} {path}:{remark.line}: {remark.text}")
    if refused:
        report(_FAILURE)
        return FAILED
    print("\n".join(_lines(robot)))
    return 0


def _lines(robot: Description) -> Iterator[str]:
    children: dict[str, list[str]] = {link: [] for link in robot.links}
    for _, joint in sorted(robot.joints.items()):
        children[joint.parent].append(joint.child)
    yield f"robot name is: {robot.name}"
    yield "---------- Successfully Parsed XML ---------------"
    yield f"root Link: {robot.root} has {len(children[robot.root])} child(ren)"
    # A stack, because a chain of links may be longer than Python's recursion is deep.
    open_links = [iter(enumerate(children[robot.root], 1))]
    while open_links:
        number, link = next(open_links[-1], (0, ""))
        if not number:
            open_links.pop()
            continue
        yield f"{'    ' * len(open_links)}child({number}):  {link}"
        open_links.append(iter(enumerate(children[link], 1)))


if __name__ == "__main__":
    sys.exit(main())
