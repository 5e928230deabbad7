"""OpenCV: whichever of its distributions is installed. The only file that imports it.

None of them is a dependency, because each (`opencv-python`, `opencv-python-headless`, `opencv-contrib-python` …) has
the package `cv2`: a second one would overwrite the user's.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

__all__ = ["load_opencv"]

_PACKAGE = "opencv-python-headless"


@lru_cache(maxsize=1)
def load_opencv() -> Any:
    """Return the module `cv2`.

    Raises:
        ImportError: OpenCV is not installed, or a library that it needs is missing.
    """
    try:
        import cv2
    except ModuleNotFoundError as error:
        if error.name != "cv2":
            raise
        text = f"cv_bridge and image_geometry need OpenCV, which is not installed: pip install {_PACKAGE}"
        raise ModuleNotFoundError(text, name="cv2") from None
    except ImportError as error:
        # Mostly libGL.so.1, of the distributions that can open windows.
        text = f"the installed OpenCV cannot be imported: {error}; {_PACKAGE} needs no libraries of a display"
        raise ImportError(text, name="cv2") from None
    return cv2
