# cyclonedds reads its annotations as types, so they can't be put off: no `from __future__ import annotations`.
"""The payload as cyclonedds' Python API has it."""

from dataclasses import dataclass

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import sequence, uint8


@dataclass
class Bytes(IdlStruct, typename="bench.Bytes"):
    data: sequence[uint8]
