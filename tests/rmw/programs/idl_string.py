# No `from __future__ import annotations`, because cyclonedds evaluates annotations as types.
"""Write or read std_msgs/msg/String on `rt/chatter`, with the classes and types of cyclonedds' Python API.

Arguments: the domain, and `talk` or `listen`. Prints the received messages; ends after three.
"""

import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

TEXTS = ["one", "two and a half", "three"]
QOS = Qos(
    Policy.Reliability.Reliable(10**9),
    Policy.Durability.TransientLocal,
    Policy.History.KeepLast(10),
    Policy.DurabilityService(0, Policy.History.KeepLast(10), -1, -1, -1),
    Policy.DataRepresentation(use_cdrv0_representation=True),
)


@dataclass
class String(IdlStruct, typename="std_msgs.msg.dds_.String_"):
    data: str


def main() -> None:
    participant = DomainParticipant(int(sys.argv[1]))
    topic = Topic(participant, "rt/chatter", String, qos=QOS)
    if sys.argv[2] == "talk":
        writer = DataWriter(participant, topic, qos=QOS)
        for text in TEXTS:
            writer.write(String(text))
        print("talked", flush=True)
        sys.stdin.read()
        return
    reader = DataReader(participant, topic, qos=QOS)
    heard = 0
    while heard < len(TEXTS):
        for sample in reader.take(N=10):
            print(sample.data, flush=True)
            heard += 1
        time.sleep(0.005)


main()
