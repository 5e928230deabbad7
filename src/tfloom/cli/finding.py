"""The finding of a check of `doctor`."""

from __future__ import annotations

from enum import Enum
from typing import Any, NamedTuple


class Verdict(Enum):
    """The outcome of a check."""

    OK = "ok"
    WARNING = "warning"
    FAILED = "FAILED"


class Finding(NamedTuple):
    """The finding of a check."""

    verdict: Verdict
    summary: str
    advice: str = ""
    """The remedy; empty without one."""
    details: dict[str, Any] = {}  # noqa: RUF012  # never changed

    def as_dict(self) -> dict[str, Any]:
        """Return the finding as JSON values."""
        return {**self._asdict(), "verdict": self.verdict.value.lower()}
