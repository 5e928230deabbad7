"""A node on the in-process wire, OpenCV hidden or wanted, and what OpenCV answered."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any

import pytest
from tests.sensing import opencv_golden

from tfloom.sensing import cv_types, opencv


@pytest.fixture
def without_opencv(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Have the code under test find no OpenCV, wherever it is installed."""
    monkeypatch.setitem(sys.modules, "cv2", None)
    cached = (opencv.find_opencv, cv_types.channels_shift)
    for function in cached:
        function.cache_clear()
    yield
    for function in cached:
        function.cache_clear()


@pytest.fixture(scope="session")
def recorded() -> opencv_golden.Recorded:
    """Return inputs, and what OpenCV made of them."""
    return opencv_golden.recorded()


@pytest.fixture
def cv2() -> Any:
    """Give OpenCV itself."""
    return pytest.importorskip("cv2", reason="needs OpenCV: pip install opencv-python-headless")
