"""The type of paths."""

from __future__ import annotations

import os
from typing import Union

__all__ = ["FilePath"]

FilePath = Union[str, bytes, "os.PathLike[str]"]
