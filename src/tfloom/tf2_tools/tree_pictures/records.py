"""A buffer's frames: read from its YAML text, written as a Graphviz graph."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

NO_DATA = "No tf data received"


class FrameRecord(NamedTuple):
    """A frame and its transform from its parent."""

    child: str
    parent: str
    broadcaster: str
    rate: float
    """Rate of the transform [Hz]; 10000 for a single or a static one."""
    most_recent: float
    """Newest stamp [s since epoch]; 0 if static."""
    oldest: float
    """Oldest stamp [s since epoch]; 0 if static."""
    buffer_length: float
    """Time between the two [s]."""

    @property
    def is_static(self) -> bool:
        """Whether the transform is static."""
        return self.most_recent == 0.0 and self.oldest == 0.0

    def label(self) -> list[tuple[str, str]]:
        """Return the properties of the transform for a drawing, as names and values."""
        return [
            ("Broadcaster", self.broadcaster),
            ("Average rate", str(self.rate)),
            ("Buffer length", str(self.buffer_length)),
            ("Most recent transform", str(self.most_recent)),
            ("Oldest transform", str(self.oldest)),
        ]


# Not by a YAML parser, because frame ids such as `yes`, `1.0` or `it's` would change.
_RECORD = re.compile(
    r"(?P<child>.*?): \n"
    r"  parent: '(?P<parent>.*?)'\n"
    r"  broadcaster: '(?P<broadcaster>.*?)'\n"
    r"  rate: (?P<rate>[^\s]+)\n"
    r"  most_recent_transform: (?P<most_recent>[^\s]+)\n"
    r"  oldest_transform: (?P<oldest>[^\s]+)\n"
    r"(?:  transform_delay: [^\s]+\n)?"
    r"  buffer_length: (?P<buffer_length>[^\s]+)\n",
    re.DOTALL,
)
_NUMBERS = ("rate", "most_recent", "oldest", "buffer_length")


def parse_frames_yaml(text: str) -> list[FrameRecord]:
    """Parse the text of `all_frames_as_yaml`; `[]` and an empty text have no frames.

    Raises:
        ValueError: the text is neither, or a number in it is invalid.
    """
    if text.strip() in {"", "[]"}:
        return []
    records = []
    end = 0
    while end < len(text):
        match = _RECORD.match(text, end)
        if match is None:
            raise ValueError(
                f"not the list of frames that a tf2 buffer writes, from here: {text[end : end + 80]!r}"
            )
        fields = match.groupdict()
        numbers = {name: float(fields[name]) for name in _NUMBERS}
        records.append(FrameRecord(fields["child"], fields["parent"], fields["broadcaster"], **numbers))
        end = match.end()
    return records


def parents_of(records: Iterable[FrameRecord]) -> dict[str, str]:
    """Return each child's parent."""
    return {record.child: record.parent for record in records}


def write_gv(records: list[FrameRecord], recorded_at: float) -> str:
    """Return the frames in Graphviz's language.

    Args:
        records: The frames; if empty, the graph has a note instead.
        recorded_at: When they were gathered [s since epoch].
    """
    if not records:
        return f'digraph G {{ "{NO_DATA}" }}'
    lines = ["digraph G {"]
    for record in records:
        label = "".join(f"{name}: {_escaped(value)}\\n" for name, value in record.label())
        lines.append(f'"{_escaped(record.parent)}" -> "{_escaped(record.child)}"[label=" {label}"];')
    parents = parents_of(records)
    root = next((parent for parent in parents.values() if parent not in parents), records[0].child)
    lines += [
        "edge [style=invis];",
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";',
        f'"Recorded at time: {recorded_at}"[ shape=plaintext ] ;',
        f'}}->"{_escaped(root)}";',
    ]
    return "\n".join(lines) + "\n}"


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"')
