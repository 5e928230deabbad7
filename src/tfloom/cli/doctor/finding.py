"""The finding of a check of `doctor`."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType
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
    details: Mapping[str, Any] = MappingProxyType({})

    def as_dict(self) -> dict[str, Any]:
        """Return the finding as JSON values."""
        return {**self._asdict(), "verdict": self.verdict.value.lower(), "details": dict(self.details)}
