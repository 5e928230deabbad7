"""A first look for what installed packages add by entry points, which most do not."""

from __future__ import annotations

import sys
from pathlib import Path

__all__ = ["may_have_entry_points"]


def may_have_entry_points(group_name: str) -> bool:
    """Return whether the text of a group's name is in the entry points of any installed package.

    It reads the files alone, because `importlib.metadata` takes longer to import, and parses all of them.
    """
    section = f"[{group_name}]".encode()
    for folder in sys.path:
        for pattern in ("*.dist-info/entry_points.txt", "*.egg-info/entry_points.txt"):
            for path in Path(folder).glob(pattern):
                try:
                    if section in path.read_bytes():
                        return True
                except OSError:
                    continue
    return False
