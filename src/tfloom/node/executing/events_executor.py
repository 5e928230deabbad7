"""The events executor, which has the least latency from an event to its callback."""

from __future__ import annotations

from tfloom.node.executing.executor import Executor
from tfloom.node.executing.signals import shutdown_exception

__all__ = ["EventsExecutor"]


class EventsExecutor(Executor):
    """Runs callbacks on the thread that spins, in the order of their events.

    All executors here wait for events, not for sets of entities. `spin` of this one runs all that is ready in one
    pass: it checks neither a timeout nor a condition between two callbacks, and after a shutdown in a callback the
    rest of the pass isn't run. Timers run in the order of their deadlines.
    """

    def spin(self) -> None:
        """Run callbacks until the context, or the executor, is shut down.

        Raises:
            ExternalShutdownException: the context was shut down by a signal, or while this waited.
            KeyboardInterrupt: Ctrl-C, on the main thread.
            Exception: raised by a callback; the rest of the pass is run by the next spin.
            RuntimeError: another thread is spinning this executor.
        """
        self._begin_spin()
        try:
            with self._running:
                self._run_until_shutdown()
        except Exception as error:
            if self._context.is_caused_by_signal(error):  # as in the other executors
                raise shutdown_exception() from error
            raise
        finally:
            self._end_spin()
        if self._context.is_interrupted():  # by a signal that arrived while a callback ran
            raise shutdown_exception()

    def _run_until_shutdown(self) -> None:
        while self._context.ok() and not self._is_shutdown:
            self._collect(None)
            if self._is_shutdown:
                return
            if not self._context.ok():
                raise shutdown_exception()
            self._run_pass()

    def _run_pass(self) -> None:
        """Run one callback of each entity that has posted; an entity whose callback was run stays ready."""
        while self._pass_left:
            self._pass_left -= 1
            token = self._ready.popleft()
            entity = self._entities.get(token)
            if entity is not None and self._goes_at_once(entity):
                self._take_responses(token)
            elif entity is not None:
                taken = self._take(entity, token)
                if taken is not None:
                    self._run_entity(entity, taken)
            elif (task := self._tasks.get(token)) is not None:
                self._run_task(task)
            if self._is_shutdown or not self._context.ok():
                return
