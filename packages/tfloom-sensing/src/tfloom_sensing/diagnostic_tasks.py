"""The tasks of diagnostic_updater, which fill a status."""

from __future__ import annotations

from collections.abc import Callable

from tfloom_sensing.diagnostic_status_wrapper import DiagnosticStatusWrapper

__all__ = ["CompositeDiagnosticTask", "DiagnosticTask", "FunctionDiagnosticTask"]


class DiagnosticTask:
    """A task with a name; the base class of tasks, which override `run`."""

    def __init__(self, name: str) -> None:
        self.name = name

    def getName(self) -> str:
        """Return the task's name."""
        return self.name

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Fill a status and return it. An updater calls this, on a thread of its node's executor."""
        return stat


class FunctionDiagnosticTask(DiagnosticTask):
    """A task that calls a function.

    Args:
        name: The task's name.
        fn: Fills its argument and returns it.
    """

    def __init__(self, name: str, fn: Callable[[DiagnosticStatusWrapper], DiagnosticStatusWrapper]) -> None:
        super().__init__(name)
        self.fn = fn

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Call the function."""
        return self.fn(stat)


class CompositeDiagnosticTask(DiagnosticTask):
    """Several tasks with one status, which has the values of all tasks and their merged summaries."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.tasks: list[DiagnosticTask] = []

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Run each task with the given summary, and merge the resulting summaries."""
        original, combined = DiagnosticStatusWrapper(), DiagnosticStatusWrapper()
        original.summary(stat)
        for task in self.tasks:
            stat.summary(original)
            stat = task.run(stat)
            combined.mergeSummary(stat)
        stat.summary(combined)
        return stat

    def addTask(self, t: DiagnosticTask) -> None:
        """Add a task."""
        self.tasks.append(t)
