"""The viewer of a live graph: its transforms, its topics, its tools."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import closing, contextmanager
from typing import TYPE_CHECKING

from tfloom.rmw.base import NodeName
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.live import LiveWatch
from tfloom.viewer.driving.link import Driving
from tfloom.viewer.forms.sending import Sending
from tfloom.viewer.live_only import LiveOnly
from tfloom.viewer.log_lines import LogLines
from tfloom.viewer.parameters import Parameters
from tfloom.viewer.program import Viewer
from tfloom.viewer.tools import Tools
from tfloom.viewer.topics import LiveTopics

if TYPE_CHECKING:
    from tfloom.rmw.base import Participant
    from tfloom.viewer.joints import Joints

__all__ = ["live_viewer"]


@contextmanager
def live_viewer(
    participant: Participant,
    *,
    topics: tuple[str, str],
    history_s: float,
    fixed_frame: str = "",
    simulated: bool = False,
    joints: Joints | None = None,
) -> Iterator[Viewer]:
    """Open a viewer of a graph for the block.

    Args:
        participant: The participant that reads and writes.
        topics: The topics of moving and of static transforms.
        history_s: How far the time can be turned back [s].
        fixed_frame: The fixed frame; empty: a usual one, or the root of the largest tree.
        simulated: Whether times are those of /clock.
        joints: The joints that pages move; None: none.
    """
    history_ns = int(history_s * 1e9)
    buffer = Buffer(history_ns)
    buffer.set_log_callback(None)  # the doctor's findings say what is wrong
    node = NodeName("/", f"_tfloom_view_{os.getpid()}")
    participant.add_node(node)
    try:
        with (
            closing(
                LiveWatch(
                    participant,
                    node,
                    buffer=buffer,
                    topics=topics,
                    cache_time_ns=history_ns,
                    simulated=simulated,
                )
            ) as watch,
            closing(Tools(participant, node, watch.now_ns)) as tools,
            closing(Driving(participant, node, watch.now_ns)) as driving,
            closing(LogLines(participant, node)) as log,
            closing(Parameters(participant, node)) as parameters,
            closing(Sending(participant, node, watch.now_ns)) as forms,
        ):
            live_topics = LiveTopics(participant, node, history_ns, watch.now_ns)
            live_only = LiveOnly(participant, node, topics, tools, driving, log, parameters, forms)
            try:
                with Viewer(
                    watch,
                    live_topics,
                    live_only,
                    joints=joints,
                    is_simulated=simulated,
                    history_ns=history_ns,
                    fixed_frame=fixed_frame,
                ) as viewer:
                    yield viewer
            finally:
                live_topics.close_all()
    finally:
        participant.remove_node(node)
