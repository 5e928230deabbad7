"""What a recorder is asked to record, and how."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from tfloom.bag.topic_choice import TopicChoice
from tfloom.rmw.qos import QoS

__all__ = ["RecordOptions"]


@dataclass
class RecordOptions:
    """The options of a recorder; the bag's are in `WriterSettings`."""

    choice: TopicChoice = field(default_factory=TopicChoice)
    is_discovery_disabled: bool = False
    """Whether only topics are recorded that exist at the start."""
    polling_interval_s: float = 0.1
    include_hidden_topics: bool = False
    include_unpublished_topics: bool = False
    ignore_leaf_topics: bool = False
    """Whether topics without a subscription, but for the recorder's own, are left out."""
    qos_overrides: Mapping[str, QoS] = field(default_factory=dict)
    """The subscriptions' profiles, by topic."""
    is_start_paused: bool = False
    use_sim_time: bool = False
    has_keyboard: bool = True
