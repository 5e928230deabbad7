"""Observations made of single transforms, without a wire."""

from __future__ import annotations

import math

from tests.tf2_tools.diagnosis.faulty_nodes import edge

from tfloom._native import TfObserver
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.base import EndpointInfo, NodeName
from tfloom.rosidl import cdr
from tfloom.tf2_tools.diagnosis.catalogue import Limits
from tfloom.tf2_tools.diagnosis.finding import Finding
from tfloom.tf2_tools.diagnosis.report import diagnose
from tfloom.tf2_tools.diagnosis.subject import FrameUse, Subject
from tfloom.tf2_tools.watch.model import Description, observation_of

START_S = 1000.0
S = 1_000_000_000


class Scene:
    """Publishers of transforms, and the times at which these arrive."""

    def __init__(self, *, is_live: bool = True) -> None:
        self._observer = TfObserver()
        self._known: dict[bytes, Description] = {}
        self._is_live = is_live
        self._last_s = START_S
        self.endpoints: list[EndpointInfo] = []
        self.headers: list[FrameUse] = []

    def gid(self, node: str, process: int = 1) -> bytes:
        """Return the gid of a node's publisher in a process, as DDS gives it: that of the participant, and a number."""
        number = sum(map(ord, node)) % 2**32
        gid = bytes([1, 16, process]) + bytes(9) + number.to_bytes(4, "big")
        self._known[gid] = Description(NodeName("/", node) if self._is_live else None)
        return gid

    def send(
        self,
        parent: str,
        child: str,
        at_s: float = 0.0,
        *,
        node: str = "node",
        process: int = 1,
        late_s: float = 0.001,
        x: float | None = None,
        yaw: float = 0.0,
        static: bool = False,
    ) -> None:
        """Receive a transform that was stamped `at_s` after the start and arrived `late_s` after that [s]."""
        transform = edge(
            parent,
            child,
            stamp_ns=round((START_S + at_s) * S),
            x=math.sin(at_s) if x is None else x,
            rotation=(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)),
        )
        self._last_s = max(self._last_s, START_S + at_s + late_s)
        data = cdr.encode(TFMessage(transforms=[transform]))
        received_ns = round((START_S + at_s + late_s) * S)
        assert self._observer.record(data, self.gid(node, process), received_ns, static=static)

    def steadily(
        self, parent: str, child: str, count: int = 50, period_s: float = 0.02, **options: object
    ) -> None:
        """Receive transforms at a constant rate."""
        for step in range(count):
            self.send(parent, child, step * period_s, **options)  # type: ignore[arg-type]

    def subject(self) -> Subject:
        """Return what was seen until the last receipt."""
        times_ns = round(START_S * S), round(self._last_s * S)
        seen = observation_of(
            self._observer.snapshot(),
            self._known,
            times_ns,
            endpoints=self.endpoints,
            is_live=self._is_live,
        )
        return Subject(seen, times_ns, self.headers)

    def findings(self, **limits: float) -> list[Finding]:
        """Return the findings by these limits."""
        return diagnose(self.subject(), Limits()._replace(**limits))

    def codes(self, **limits: float) -> list[str]:
        """Return the codes of the findings by these limits."""
        return [finding.code for finding in self.findings(**limits)]
