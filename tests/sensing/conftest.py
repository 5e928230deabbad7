"""OpenCV hidden from the code under test."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import pytest

from tfloom_sensing.opencv import load_opencv


@pytest.fixture
def without_opencv(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Have the code under test find no OpenCV."""
    monkeypatch.setitem(sys.modules, "cv2", None)
    load_opencv.cache_clear()
    yield
    load_opencv.cache_clear()
