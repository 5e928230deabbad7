"""The spin of a node on a thread that the library starts for it, whose end nobody would notice."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.node.values.call_all import report_exception
from tfloom.node.values.exceptions import ExternalShutdownException

if TYPE_CHECKING:
    from tfloom.node.executing.executor import Executor

__all__ = ["spin_on_own_thread"]


def spin_on_own_thread(executor: Executor) -> None:
    """Run callbacks until the context, or the executor, is shut down.

    The exception of a callback is reported by `threading.excepthook`, and the next callback runs: if the thread ended,
    the program would go on without the transforms, or the timers of a launch, that it waits for.

    Raises:
        RuntimeError: another thread is spinning this executor.
    """
    with executor._long_spin():  # noqa: SLF001  # ours
        while executor.context.ok() and not executor._is_shutdown:  # noqa: SLF001  # ours
            try:
                executor.spin_once()
            except ExternalShutdownException:  # noqa: PERF203
                return
            except Exception:  # noqa: BLE001  # of a program's callback
                report_exception()
