"""Publication of a node's statuses on /diagnostics: diagnostic_updater's Updater."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, overload

from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from tfloom.node.node import Node
from tfloom.node.values.callback_errors import call_all
from tfloom_sensing.diagnostic_status_wrapper import DiagnosticStatusWrapper
from tfloom_sensing.diagnostic_tasks import DiagnosticTask

__all__ = ["DiagnosticArray", "DiagnosticTaskVector", "Updater"]

_Fill = Callable[[DiagnosticStatusWrapper], DiagnosticStatusWrapper]

_NO_HARDWARE_ID = (
    "diagnostic_updater: No HW_ID was set. This is probably a bug. Please report it. For devices that do not have a "
    "HW_ID, set this value to none. This warning only occurs once all diagnostics are OK so it is okay to wait until "
    "the device is open before calling setHardwareID."
)


class DiagnosticTaskVector:
    """Tasks, in the order in which they were added."""

    class DiagnosticTaskInternal:
        """A task in the list: a name and a function that fills a status."""

        def __init__(self, name: str, fn: _Fill) -> None:
            self.name = name
            self.fn = fn

        def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
            """Return the filled status, under the task's name.

            Raises:
                TypeError: the task returned something else.
            """
            stat.name = self.name
            filled = self.fn(stat)
            if not isinstance(filled, DiagnosticStatus):
                raise TypeError(
                    f"the diagnostic task '{self.name}' returned {filled!r}; it must return the status it was given"
                )
            return filled

    def __init__(self) -> None:
        self.lock = threading.RLock()
        """Guards `tasks`, and is held while they run; a task may add and remove tasks."""
        self.tasks: list[DiagnosticTaskVector.DiagnosticTaskInternal] = []

    def addedTaskCallback(self, task: DiagnosticTaskInternal) -> None:
        """Handle the addition of a task; a subclass overrides it."""

    @overload
    def add(self, task: DiagnosticTask, /) -> None: ...
    @overload
    def add(self, name: str, fn: _Fill, /) -> None: ...
    def add(self, *args: Any) -> None:
        """Add a task: a DiagnosticTask, or a name and a function that fills a status and returns it.

        Raises:
            TypeError: it is neither.
        """
        match args:
            case (DiagnosticTask() as task,):
                name, fill = task.getName(), task.run
            case (str() as name, fill) if callable(fill):
                pass
            case _:
                raise TypeError(f"add takes a DiagnosticTask, or a name and a function, not {args}")
        added = self.DiagnosticTaskInternal(name, fill)
        with self.lock:
            self.tasks.append(added)
            self.addedTaskCallback(added)

    def removeByName(self, name: str) -> bool:
        """Remove the first task of a name, and return whether there was one."""
        with self.lock:
            for index, task in enumerate(self.tasks):
                if task.name == name:
                    del self.tasks[index]
                    return True
        return False


class Updater(DiagnosticTaskVector):
    """Runs tasks periodically and publishes their statuses on /diagnostics.

    Args:
        node: Owns the publisher, the timer and the parameters `diagnostic_updater.period` [s] and
            `diagnostic_updater.use_fqn`, whether the names of statuses begin with the node's fully qualified name.
            Parameters that are already declared are used.
        period: Default of `diagnostic_updater.period` [s].
    """

    def __init__(self, node: Node, period: float = 1.0) -> None:
        super().__init__()
        self.node = node
        self.publisher = node.create_publisher(DiagnosticArray, "/diagnostics", 1)
        self.period_parameter = "diagnostic_updater.period"
        self.use_fqn_parameter = "diagnostic_updater.use_fqn"
        self._period = float(self._parameter(self.period_parameter, float(period)))
        self.timer = node.create_timer(self._period, self.update)
        self.verbose = False
        """Whether a warning is logged for each status other than OK."""
        self.hwid = ""
        self.warn_nohwid_done = False
        in_full = self._parameter(self.use_fqn_parameter, False)
        self.node_name = node.get_fully_qualified_name() if in_full else node.get_name()

    def _parameter(self, name: str, default: Any) -> Any:
        if not self.node.has_parameter(name):
            self.node.declare_parameter(name, default)
        return self.node.get_parameter(name).value

    def update(self) -> None:
        """Run all tasks and publish their statuses; the timer calls this.

        The status of a task that raises is an error with the exception's text; the exception is raised afterwards.
        """
        statuses: list[DiagnosticStatus] = []
        raised: list[Callable[[], None]] = []
        with self.lock:
            for task in list(self.tasks):
                try:
                    status = task.run(self._new_status(task.name))
                except Exception as error:  # noqa: BLE001  # raised below, when the other tasks have been published
                    raised.append(partial(_raise, error))
                    status = self._new_status(task.name, f"The task raised {type(error).__name__}: {error}")
                statuses.append(status)
                if self.verbose and status.level != DiagnosticStatus.OK:
                    self.node.get_logger().warn(
                        f"Non-zero diagnostic status. Name: {status.name}, status {status.level!r}: {status.message}"
                    )
        all_ok = all(status.level == DiagnosticStatus.OK for status in statuses)
        if all_ok and not self.hwid and not self.warn_nohwid_done:
            self.node.get_logger().warn(_NO_HARDWARE_ID)
            self.warn_nohwid_done = True
        self.publish(statuses)
        call_all(raised)

    def _new_status(self, name: str, message: str = "No message was set") -> DiagnosticStatusWrapper:
        return DiagnosticStatusWrapper(
            level=DiagnosticStatus.ERROR, name=name, message=message, hardware_id=self.hwid
        )

    @property
    def period(self) -> float:
        """Time between two updates [s]; setting it starts a new timer."""
        return self._period

    @period.setter
    def period(self, period: float) -> None:
        self._period = period
        self.node.destroy_timer(self.timer)
        self.timer = self.node.create_timer(period, self.update)

    def force_update(self) -> None:
        """Run all tasks and publish their statuses now."""
        self.update()

    def broadcast(self, lvl: bytes, msg: str) -> None:
        """Publish one level and message for all tasks, without running them."""
        statuses = []
        with self.lock:
            for task in self.tasks:
                status = DiagnosticStatusWrapper(name=task.name)
                status.summary(lvl, msg)
                statuses.append(status)
        self.publish(statuses)

    def setHardwareID(self, hwid: str) -> None:
        """Set the hardware id of all statuses; `none` for a device without one."""
        self.hwid = hwid

    def publish(self, msg: DiagnosticStatus | Sequence[DiagnosticStatus]) -> None:
        """Publish one status or several, each name prefixed with the node's name."""
        statuses = [msg] if isinstance(msg, DiagnosticStatus) else msg
        message = DiagnosticArray()
        message.header.stamp = self.node.get_clock().now().to_msg()
        message.status = [
            DiagnosticStatus(
                level=status.level,
                name=f"{self.node_name}: {status.name}",
                message=status.message,
                hardware_id=status.hardware_id,
                values=status.values,
            )
            for status in statuses
        ]
        self.publisher.publish(message)

    def addedTaskCallback(self, task: DiagnosticTaskVector.DiagnosticTaskInternal) -> None:
        """Publish that the task's node is starting up."""
        status = DiagnosticStatusWrapper(name=task.name)
        status.summary(DiagnosticStatus.OK, "Node starting up")
        self.publish(status)


def _raise(error: Exception) -> None:
    raise error
