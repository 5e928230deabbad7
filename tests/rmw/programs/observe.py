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


def main() -> None:
    participant = DomainParticipant(int(sys.argv[1]))
    wanted = int(sys.argv[2])
    topics = (BuiltinTopicDcpsParticipant, BuiltinTopicDcpsPublication, BuiltinTopicDcpsSubscription)
    readers = [BuiltinDataReader(participant, topic) for topic in topics]
    found: dict[str, dict[str, object]] = {}
    end = time.monotonic() + 20
    while sum(str(entry.get("topic_name")).startswith("rt/") for entry in found.values()) < wanted:
        for reader, kind in zip(readers, ("participant", "publication", "subscription"), strict=True):
            for sample in reader.take(N=100):
                found[str(sample.key)] = describe(sample, kind)
        if time.monotonic() > end:
            break
        time.sleep(0.01)
    for entry in found.values():
        print(json.dumps(entry), flush=True)


def describe(sample: object, kind: str) -> dict[str, object]:
    names = {name: getattr(sample, name) for name in ("topic_name", "type_name") if hasattr(sample, name)}
    return {"kind": kind, "key": str(sample.key), **names, "qos": [str(policy) for policy in sample.qos]}


main()
