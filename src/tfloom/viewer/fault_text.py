"""Why something can't be done or shown, as one sentence for a page."""

from __future__ import annotations

import traceback
from pathlib import Path

from tfloom.rmw.errors import WireError
from tfloom.rosidl.message import DecodeError
from tfloom.tf2.errors import TransformException
from tfloom.viewer.page_command import PageError
from tfloom.viewer.shapes import DisplayError

__all__ = ["fault_text"]


def fault_text(error: Exception) -> str:
    """Return an error's text; of one that nobody thought of, also its type and where it was raised."""
    if isinstance(error, (PageError, DisplayError, DecodeError, WireError, TransformException)):
        return str(error).rstrip()
    said = f"{type(error).__name__}: {error}"
    if frames := traceback.extract_tb(error.__traceback__):
        said += f" ({Path(frames[-1].filename).name}, line {frames[-1].lineno})"
    return said
