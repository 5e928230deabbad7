"""OpenCV, where it is installed. The only file that imports it.

Nothing here needs it. Where it is there it does the same sooner, or reads file formats that Pillow lacks.
"""

from __future__ import annotations

from functools import lru_cache
from importlib import import_module
from typing import Any

__all__ = ["find_opencv"]


@lru_cache(maxsize=1)
def find_opencv() -> Any:
    """Return the module `cv2`, or None where it isn't installed, or can't be loaded for want of a library."""
    try:
        return import_module("cv2")
    except ImportError:
        return None
