# cyclonedds reads its annotations as types, so they can't be put off: no `from __future__ import annotations`.
"""std_msgs/msg/String as cyclonedds' Python API has it."""

from dataclasses import dataclass

from cyclonedds.idl import IdlStruct


@dataclass
class String(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str
