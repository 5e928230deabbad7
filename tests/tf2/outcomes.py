"""Whether two buffers answer alike."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import TransformException


def outcome(buffer: Buffer, target: str, source: str, stamp_ns: int) -> object:
    """Return the stamp and the transform of a lookup, or the class and the text of its error."""
    try:
        transform = buffer.lookup(target, source, stamp_ns)
    except TransformException as error:
        return type(error), str(error)
    return transform.stamp_ns, transform.transform


def require_equal(live: Buffer, mapped: Buffer, queries: Iterable[tuple[str, str, int]]) -> None:
    """Check that two buffers answer the queries alike, and have the same frames, listing and frozen bytes."""
    for query in queries:
        assert outcome(live, *query) == outcome(mapped, *query)
    assert mapped.all_frames_as_yaml(200.0) == live.all_frames_as_yaml(200.0)
    assert mapped.frame_names() == live.frame_names()
    assert mapped.cache_time_ns == live.cache_time_ns
    assert mapped.frozen() == live.frozen()
