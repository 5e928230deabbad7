"""Diagnostics of topics: diagnostic_updater's topic diagnostics and publisher."""

from __future__ import annotations

from typing import Any

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.values.time import Time
from tfloom_sensing.diagnostic_tasks import CompositeDiagnosticTask
from tfloom_sensing.diagnostic_updater import DiagnosticTaskVector
from tfloom_sensing.update_functions import (
    FrequencyStatus,
    FrequencyStatusParam,
    TimeStampStatus,
    TimeStampStatusParam,
)

__all__ = ["DiagnosedPublisher", "HeaderlessTopicDiagnostic", "TopicDiagnostic"]


class HeaderlessTopicDiagnostic(CompositeDiagnosticTask):
    """Monitors the frequency of a topic's messages. Call `tick` at each message.

    Args:
        name: The topic; the name of the task is `<name> topic status`.
        diag: Updater to which the task is added.
        freq: Limits of the frequency.
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
        """Reset the count."""
        self.freq.clear()


class TopicDiagnostic(HeaderlessTopicDiagnostic):
    """Monitors the frequency and the age of a topic's messages. Call `tick` at each message.

    Args:
        name: The topic; the name of the task is `<name> topic status`.
        diag: Updater to which the task is added.
        freq: Limits of the frequency.
        stamp: Limits of the age.
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
    """A publisher whose messages, which have a header, are monitored.

    Args:
        pub: The publisher.
        diag: Updater to which the task is added.
        freq: Limits of the frequency.
        stamp: Limits of the age.
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
