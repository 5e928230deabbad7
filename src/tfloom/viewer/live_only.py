"""What a viewer has of a live graph, beyond transforms and topics."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from tfloom.rmw.base import Participant
    from tfloom.viewer.driving.link import Driving
    from tfloom.viewer.forms.sending import Sending
    from tfloom.viewer.log_lines import LogLines
    from tfloom.viewer.parameters import Parameters
    from tfloom.viewer.tools import Tools

__all__ = ["LiveOnly"]


class LiveOnly(NamedTuple):
    """What a graph has beyond a recording, which has nobody to ask."""

    participant: Participant
    tools: Tools
    driving: Driving
    log: LogLines
    parameters: Parameters
    forms: Sending
