"""A finding: what, who, where, and by which figures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from tfloom.tf2_tools.diagnosis.catalogue import KINDS, Kind

Figure = str | float | int | None
"""A value in JSON."""


class Source(NamedTuple):
    """A publisher or a subscription that a finding names."""

    node: str
    """Full name of its node; empty if unknown, as in a recording."""
    topic: str
    gid: str = ""
    """32 hex digits; empty if unknown."""

    def __str__(self) -> str:
        if not (self.node or self.gid):
            return self.topic
        return f"{self.node or f'an unknown node (GID {self.gid})'} on {self.topic}"


class Evidence(NamedTuple):
    """What was seen of one edge, publisher or topic."""

    text: str
    figures: Mapping[str, Figure] = MappingProxyType({})


class Finding(NamedTuple):
    """One finding, of one or more publishers."""

    code: str
    summary: str
    """A sentence without a full stop, with the names."""
    sources: Sequence[Source] = ()
    frames: Sequence[str] = ()
    evidence: Sequence[Evidence] = ()

    @property
    def kind(self) -> Kind:
        """Its row of the catalogue."""
        return KINDS[self.code]

    def as_dict(self) -> dict[str, object]:
        """Return the finding as JSON values."""
        return {
            "code": self.code,
            "severity": self.kind.severity.value,
            "title": self.kind.title,
            "summary": self.summary,
            "nodes": sorted({source.node for source in self.sources if source.node}),
            "sources": [source._asdict() for source in self.sources],
            "frames": list(self.frames),
            "evidence": [{"text": evidence.text, **evidence.figures} for evidence in self.evidence],
            "mend": self.kind.mend,
        }
