"""What a viewer has of a live graph, beyond transforms and topics."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tfloom.viewer.displays.display import shown_text

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant
    from tfloom.viewer.driving.link import Driving
    from tfloom.viewer.forms.sending import Sending
    from tfloom.viewer.log_lines import LogLines
    from tfloom.viewer.parameters import Parameters
    from tfloom.viewer.tools import Tools

__all__ = ["LiveOnly", "empty_text"]


class LiveOnly(NamedTuple):
    """What a graph has beyond a recording, which has nobody to ask."""

    participant: Participant
    node: NodeName
    """The node whose ends on the graph these are."""
    tf_topics: tuple[str, str]
    """The topics of moving and of static transforms."""
    tools: Tools
    driving: Driving
    log: LogLines
    parameters: Parameters
    forms: Sending


def empty_text(live: LiveOnly) -> str:
    """Return what a scene says in which there is nothing: where is listened, what is missing, and what helps."""
    participant = live.participant
    counts = dict.fromkeys(live.tf_topics, 0)
    for end in participant.graph.endpoints():
        if end.is_writer and end.topic.name in counts:
            counts[end.topic.name] += 1
    publishers = " and ".join(f"{count} of {shown_text(topic)}" for topic, count in counts.items() if count)
    if publishers:
        why = f"No frames yet: there are publishers, {publishers}, of which nothing has come."
    else:
        why = f"No frames yet: nothing publishes {' or '.join(map(shown_text, live.tf_topics))}."
    return f"{why}\nThis page listens on domain {participant.domain_id}. `tfloom doctor` checks what a node can hear."
