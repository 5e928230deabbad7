"""Warnings of limited rate, for causes that hostile input can repeat at will."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.node.log.rcutils_logger import RcutilsLogger

__all__ = ["ThrottledWarning"]

PERIOD_S = 1.0
"""The least time between two warnings [s]."""


class ThrottledWarning:
    """Logs at most one warning each `PERIOD_S`, and drops the others."""

    def __init__(self, logger: RcutilsLogger) -> None:
        self._logger = logger
        self._last_s = -math.inf

    def log(self, text: str) -> None:
        """Log a warning, unless the last one is less than `PERIOD_S` ago."""
        now_s = time.monotonic()
        if now_s - self._last_s >= PERIOD_S:
            self._last_s = now_s
            self._logger.warning(text)
