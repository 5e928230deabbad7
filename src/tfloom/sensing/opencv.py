"""OpenCV, if it is installed. The only file that imports it.

It is optional: with it, images are resampled faster, and more file formats can be read and written.
"""

from __future__ import annotations

from functools import lru_cache
from importlib import import_module
from typing import Any

__all__ = ["find_opencv"]


@lru_cache(maxsize=1)
def find_opencv() -> Any:
    """Return the module `cv2`, or None if it is not installed or lacks a shared library."""
    try:
        return import_module("cv2")
    except ImportError:
        return None
