# No `from __future__ import annotations`, because cyclonedds reads the annotations as types.
"""The payload as a type of cyclonedds' Python API."""

from dataclasses import dataclass

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import sequence, uint8


@dataclass
class Bytes(IdlStruct, typename="bench.Bytes"):
    data: sequence[uint8]
