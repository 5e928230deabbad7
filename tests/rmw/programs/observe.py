"""Print each endpoint and participant of a domain that a plain DDS participant discovers, a line of JSON each.

Arguments: the domain, and the number of endpoints on `rt/…` to wait for.
"""

from __future__ import annotations

import json
import sys
import time

from cyclonedds.builtin import (
    BuiltinDataReader,
    BuiltinTopicDcpsParticipant,
    BuiltinTopicDcpsPublication,
    BuiltinTopicDcpsSubscription,
)
from cyclonedds.domain import DomainParticipant

QUIET_S = 0.3


def main() -> None:
    participant = DomainParticipant(int(sys.argv[1]))
    wanted = int(sys.argv[2])
    topics = (BuiltinTopicDcpsParticipant, BuiltinTopicDcpsPublication, BuiltinTopicDcpsSubscription)
    readers = [BuiltinDataReader(participant, topic) for topic in topics]
    entries: dict[str, dict[str, object]] = {}
    changed = start = time.monotonic()
    while time.monotonic() < start + 20:
        for reader, kind in zip(readers, ("participant", "publication", "subscription"), strict=True):
            for sample in reader.take(N=100):
                entries[str(sample.key)] = describe(sample, kind)
                changed = time.monotonic()
        is_there = sum(str(entry.get("topic_name")).startswith("rt/") for entry in entries.values()) >= wanted
        if (
            is_there and time.monotonic() > changed + QUIET_S
        ):  # publications and subscriptions arrive independently
            break
        time.sleep(0.01)
    for entry in entries.values():
        print(json.dumps(entry), flush=True)


def describe(sample: object, kind: str) -> dict[str, object]:
    names = {name: getattr(sample, name) for name in ("topic_name", "type_name") if hasattr(sample, name)}
    return {"kind": kind, "key": str(sample.key), **names, "qos": [str(policy) for policy in sample.qos]}


main()
