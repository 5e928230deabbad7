"""Topics that are watched: diagnostic_updater's topic diagnostics and publisher."""

from __future__ import annotations

from typing import Any

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.values.time import Time
from tfloom.sensing.diagnostic_tasks import CompositeDiagnosticTask
from tfloom.sensing.diagnostic_updater import DiagnosticTaskVector
from tfloom.sensing.update_functions import (
    FrequencyStatus,
    FrequencyStatusParam,
    TimeStampStatus,
    TimeStampStatusParam,
)

__all__ = ["DiagnosedPublisher", "HeaderlessTopicDiagnostic", "TopicDiagnostic"]


class HeaderlessTopicDiagnostic(CompositeDiagnosticTask):
    """Watches how often a topic's messages come. Call `tick` at each.

    Args:
        name: The topic; the task is named after it, with ` topic status`.
        diag: Updater that the task is added to.
        freq: Which frequencies are accepted.
    """

    def __init__(self, name: str, diag: DiagnosticTaskVector, freq: FrequencyStatusParam) -> None:
        super().__init__(f"{name} topic status")
        self.diag = diag
        self.freq = FrequencyStatus(freq)
        self.addTask(self.freq)
        self.diag.add(self)

    def tick(self) -> None:
        """Count a message."""
        self.freq.tick()

    def clear_window(self) -> None:
        """Count anew."""
        self.freq.clear()


class TopicDiagnostic(HeaderlessTopicDiagnostic):
    """Watches how often a topic's messages come, and how old they are. Call `tick` at each.

    Args:
        name: The topic; the task is named after it, with ` topic status`.
        diag: Updater that the task is added to.
        freq: Which frequencies are accepted.
        stamp: Which ages are accepted.
    """

    def __init__(
        self, name: str, diag: DiagnosticTaskVector, freq: FrequencyStatusParam, stamp: TimeStampStatusParam
    ) -> None:
        super().__init__(name, diag, freq)
        self.stamp = TimeStampStatus(stamp)
        self.addTask(self.stamp)

    def tick(self, stamp: float | Time | TimeMessage) -> None:  # type: ignore[override]  # as in diagnostic_updater
        """Count a message with its stamp: seconds since the epoch, or a time."""
        self.stamp.tick(stamp)
        super().tick()


class DiagnosedPublisher(TopicDiagnostic):
    """A publisher whose messages, which have a header, are watched.

    Args:
        pub: Publishes them.
        diag: Updater that the task is added to.
        freq: Which frequencies are accepted.
        stamp: Which ages are accepted.
    """

    def __init__(
        self,
        pub: Publisher[Any],
        diag: DiagnosticTaskVector,
        freq: FrequencyStatusParam,
        stamp: TimeStampStatusParam,
    ) -> None:
        super().__init__(pub.topic_name, diag, freq, stamp)
        self.publisher = pub

    def publish(self, message: Any) -> None:
        """Publish a message, and count it with its stamp."""
        self.tick(Time.from_msg(message.header.stamp))
        self.publisher.publish(message)
