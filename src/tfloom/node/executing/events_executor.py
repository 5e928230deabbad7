"""The executor with the least between an event and its callback."""

from __future__ import annotations

from tfloom.node.executing.executor import Executor
from tfloom.node.values.exceptions import ExternalShutdownException

__all__ = ["EventsExecutor"]


class EventsExecutor(Executor):
    """Runs callbacks on the thread that spins, in the order of the events that brought them about.

    All executors here wait for events rather than for sets of entities. This one's `spin` runs all that has come in
    one go: it looks between two callbacks neither at a timeout nor at a condition, and what a callback that shuts
    down leaves undone stays undone. Timers run in order of their deadlines.
    """

    def spin(self) -> None:
        """Run callbacks until the context, or the executor, is shut down.

        Raises:
            ExternalShutdownException: the context was shut down by a signal, or while this waited.
            KeyboardInterrupt: Ctrl-C, on the main thread.
            Exception: whatever a callback raises; what has come and wasn't run is run by the next spin.
            RuntimeError: another thread spins this executor.
        """
        self._begin_spin()
        try:
            with self._running:
                self._run_until_shutdown()
        except Exception as error:
            if self._context.explains(error):  # as in the other executors
                raise ExternalShutdownException from error
            raise
        finally:
            self._spinning.release()
        if self._context.is_interrupted():  # by a signal that came while a callback ran
            raise ExternalShutdownException

    def _run_until_shutdown(self) -> None:
        while self._context.ok() and not self._is_shutdown:
            self._collect(None)
            if self._is_shutdown:
                return
            if not self._context.ok():
                raise ExternalShutdownException
            self._run_pass()

    def _run_pass(self) -> None:
        """Run one thing of each entity that has posted; who had one stays ready."""
        while self._pass_left:
            self._pass_left -= 1
            token = self._ready.popleft()
            entity = self._entities.get(token)
            if entity is not None:
                taken = self._take(entity, token)
                if taken is not None:
                    self._run_entity(entity, taken)
            elif (task := self._tasks.get(token)) is not None:
                self._run_task(task)
            if self._is_shutdown or not self._context.ok():
                return
