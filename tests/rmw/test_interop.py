"""A DDS program that announces XTypes information: endpoints match by type name, and bytes pass both ways."""

from __future__ import annotations

import struct
import subprocess
from importlib.util import find_spec
from pathlib import Path

import pytest

from tfloom.rmw.cyclone.config import configuration
from tfloom.rmw.qos import DurabilityPolicy, QoS

pytestmark = pytest.mark.skipif(
    find_spec("cyclonedds") is None,
    reason="the peer is the Python package cyclonedds, which has no wheel here",
)
PROGRAM = Path(__file__).parent / "programs" / "idl_string.py"
TEXTS = ["one", "two and a half", "three"]
KEPT = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=10)


def encoded(text: str) -> bytes:
    text_bytes = text.encode() + b"\0"
    return b"\0\1\0\0" + struct.pack("<I", len(text_bytes)) + text_bytes


def test_typed_reader_receives_raw_samples(
    participant, domain_id, node, topic, monkeypatch, start_program
) -> None:
    writer = participant.create_writer(node, topic, KEPT)
    for text in TEXTS:
        writer.write(encoded(text))
    monkeypatch.setenv("CYCLONEDDS_URI", configuration())
    listener = start_program("python", PROGRAM, str(domain_id), "listen")
    assert listener.wait() == 0, listener.output
    assert listener.lines == TEXTS


def test_raw_reader_receives_typed_samples(
    participant, domain_id, node, topic, monkeypatch, start_program, take_data
) -> None:
    monkeypatch.setenv("CYCLONEDDS_URI", configuration())
    talker = start_program("python", PROGRAM, str(domain_id), "talk", stdin=subprocess.PIPE)
    talker.wait_for("talked")
    reader = participant.create_reader(node, topic, KEPT)
    heard = take_data(reader, len(TEXTS))
    assert [data[: len(encoded(text))] for data, text in zip(heard, TEXTS, strict=True)] == [
        encoded(text) for text in TEXTS
    ]
    talker.process.stdin.close()
    assert talker.wait() == 0
