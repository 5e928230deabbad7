"""Contexts: the state of the library from `init` to `shutdown`."""

from __future__ import annotations

import _thread
import os
import sys
import threading
import weakref
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from itertools import count
from types import MethodType, TracebackType
from typing import TYPE_CHECKING, Any, Protocol

from tfloom._native import block_waits_at_exit
from tfloom.node.context.arguments import Arguments, parse_arguments, warn_of_deprecated_remaps
from tfloom.node.context.topic_types import TopicTypes
from tfloom.node.log import log_output
from tfloom.node.log.log_file import LogFile
from tfloom.node.values.callback_errors import print_error
from tfloom.node.values.exceptions import (
    ExternalShutdownException,
    ForkedProcessError,
    InvalidHandle,
    NotInitializedException,
    RCLError,
    ROSInterruptException,
)
from tfloom.node.values.handle import Handle
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.postponed_interrupt import postponed
from tfloom.ros_imports.guard import ros_repr
from tfloom.ros_imports.ros_distro import CONTEXT_ASKS_FOR_INIT

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom._native import ReadyQueue
    from tfloom.rmw.base import NodeName, Participant

__all__ = ["Context"]

WAKE = 0
"""The token that wakes an executor; no entity has it."""

_contexts: dict[int, weakref.ref[Context]] = {}
"""The contexts that were initialised, by numbers.

A signal's handler looks at them while another thread adds one. So they are in a dict, whose values are copied in a
single operation: a WeakSet raises RuntimeError, and a lock may be held by the thread that the handler has interrupted.
"""
_context_numbers = count()

_NO_NODE = "cannot create node"


class StoppedException(NotInitializedException, ExternalShutdownException):
    """A signal has shut the context down, so no node can be created on it.

    It derives from ExternalShutdownException, so that code that catches the exceptions of `spin` covers node creation.
    """

    def __init__(self) -> None:
        Exception.__init__(self, "a signal has shut the context down")


class DestroyableNode(Protocol):
    """The method of a node that a context calls."""

    def destroy_node(self) -> None:
        """Leave the graph."""


class Context:
    """The state of the library from `init` to `shutdown`: arguments, domain, and the participant on the wire.

    Nodes of a context share one participant on the wire, opened with the first of them and closed when the
    context is shut down and the last node is destroyed, or when the program ends.

    As a context manager, it is initialised with the program's arguments unless it is already, and shut down on exit.
    """

    def __init__(self) -> None:
        self._lock = threading.RLock()
        """Guards all below, except what a signal handler uses, because it may interrupt code that holds the lock."""
        self._initialized = False
        """Set once, by `init`."""
        self._valid = False
        """True from `init` to shutdown. Cleared by a signal handler without the lock, and read without it."""
        self._interrupted = False
        """Set by a signal handler, before it clears `_valid`, without the lock."""
        self._hooks: list[Callable[[], Any]] = []
        """Called at shutdown, once."""
        self._queues: list[ReadyQueue] = []
        """Queues of executors. Replaced, never changed, because a signal handler iterates over them."""
        self._participant: Participant | None = None
        """Opened with the first node."""
        self._nodes = 0
        """Number of nodes on the participant."""
        self._abandoned: deque[DestroyableNode] = deque()
        """Nodes that the garbage collector has finalized. Appended and popped without the lock."""
        self._is_from_parent_process = False
        """Whether the parent process, from which this one was forked, used it. Set before the child's first thread."""
        self._tracked: weakref.WeakSet[DestroyableNode] = weakref.WeakSet()
        """Nodes that a program wants to be destroyed at shutdown."""
        self._domain_id: int | None = None
        self._arguments = Arguments()
        self.topic_types = TopicTypes()
        """The types of its nodes' topics."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def init(
        self, args: list[str] | None = None, *, initialize_logging: bool = True, domain_id: int | None = None
    ) -> None:
        """Initialise the context; this can be done once.

        Args:
            args: Command line, program's name included or not; None: `sys.argv`. Its ROS arguments hold for all nodes.
            initialize_logging: Whether to apply the arguments about logging, and to write records to a file.
            domain_id: The domain to join; None: from ROS_DOMAIN_ID.

        Raises:
            RuntimeError: it was initialised before; or `domain_id` is negative.
            RCLInvalidROSArgsError: a ROS argument is malformed.
            UnknownROSArgsError: a ROS argument is unknown.
            RCLError: a configuration file for logging is given, which is not supported.
            TypeError: `args` is a text, or an argument isn't one.
            UnicodeEncodeError: an argument isn't UTF-8.
            ForkedError: the parent process had a node on a wire that can't be opened in a child.
        """
        from tfloom.rmw.forks import check_start

        check_start()
        if domain_id is not None and domain_id < 0:
            raise RuntimeError(f"Domain id ({domain_id}) should not be lower than zero.")
        words = sys.argv if args is None else args
        if isinstance(words, str):
            raise TypeError(f"args must be a list of arguments, not the text {words!r}")
        for word in words:
            if not isinstance(word, str):
                raise TypeError(f"an argument must be a str, not {word!r} of class {type(word).__name__}")
            word.encode()  # raises where a message, or a name on the wire, could not hold it
        arguments = parse_arguments(words)
        if initialize_logging:
            _check_logging(arguments)
        with self._lock:
            if self._initialized:
                raise RuntimeError("Context.init() must only be called once")
            self._arguments = arguments
            self._domain_id = domain_id
            self._initialized = self._valid = True
        if initialize_logging:
            _set_up_logging(arguments)
        warn_of_deprecated_remaps(arguments)
        number = next(_context_numbers)
        contexts = _contexts  # at the interpreter's end, the module's name may be gone before a context is

        def forget(_: object) -> None:
            contexts.pop(number, None)

        _contexts[number] = weakref.ref(self, forget)

    @property
    def arguments(self) -> Arguments:
        """The ROS arguments of `init`."""
        return self._arguments

    @property
    def handle(self) -> Handle:
        """Proxy of the context, for code that expects rclpy's C handle."""
        return Handle(self)

    def get_domain_id(self) -> int:
        """Return the id of the context's domain.

        Raises:
            RuntimeError: before `init`.
        """
        from tfloom.rmw.backends import domain_id_from_environment

        if not self._initialized:
            raise RuntimeError("Context must be initialized before it can have a domain id")
        return domain_id_from_environment() if self._domain_id is None else self._domain_id

    def ok(self) -> bool:
        """Return whether it is initialised and not shut down."""
        return self._valid

    def is_over(self) -> bool:
        """Return whether it was initialised, and has been shut down."""
        return self._initialized and not self._valid

    def is_from_parent_process(self) -> bool:
        """Return whether the parent process, from which this one was forked, used it, so that it can't be used."""
        return self._is_from_parent_process

    def check_not_from_parent_process(self, what: str) -> None:
        """Check that it can be used in this process.

        Args:
            what: What can't be done otherwise, for the error.

        Raises:
            ForkedProcessError: the parent process used it before the fork.
        """
        if self._is_from_parent_process:
            raise ForkedProcessError(what)

    def reset_in_forked_child(self) -> None:
        """Become the parent's context in a forked child: invalid, if the parent had nodes or executors on it."""
        self._lock = threading.RLock()  # a thread of the parent may have held the former one
        if self._participant is None and not self._queues:
            return
        self._is_from_parent_process = True
        self._valid = False
        self._hooks, self._queues, self._participant, self._nodes = [], [], None, 0
        self._abandoned.clear()

    def is_interrupted(self) -> bool:
        """Return whether a signal has shut it down."""
        return self._interrupted

    def is_caused_by_signal(self, error: BaseException) -> bool:
        """Return whether an error follows from the context being shut down by a signal, or at the program's end."""
        return (self._interrupted or _is_ending) and isinstance(
            error, (RCLError, NotInitializedException, ROSInterruptException, ClosedError, InvalidHandle)
        )

    def end_daemon_thread_at_exit(self) -> None:
        """End this thread without a traceback, if it is a daemon thread and the program's end has closed all contexts.

        Python aborts the process if a daemon thread prints, as of an exception, in the moment in which the interpreter
        ends. Code that waits for the thread goes on, as after the exception. A thread of another library keeps the
        exception, because the library may not know what SystemExit means.
        """
        thread = threading.current_thread()
        is_foreign = isinstance(thread, threading._DummyThread)  # noqa: SLF001  # how threading represents it
        if _is_ending and thread.daemon and not is_foreign:
            raise SystemExit

    def shutdown(self) -> None:
        """Shut down: spinning ends, and the callbacks of `on_shutdown` are called on this thread.

        Nothing is done in a forked child for a context that the parent process used.

        Raises:
            RuntimeError: before `init`.
            RCLError: it was shut down before.
        """
        if not self._initialized:
            raise RuntimeError("Context must be initialized before it can be shutdown")
        if not self.try_shutdown() and not self._is_from_parent_process:
            raise RCLError("failed to shutdown: rcl_shutdown already called on the given context")

    def try_shutdown(self) -> bool:
        """Shut down unless that has been done; return whether this call did it."""
        postponed.take()  # the program ends by itself
        # Of several threads that shut down, the one that finds it valid does all the rest.
        with self._lock:
            was_valid, self._valid = self._valid, False
        if not was_valid:
            if self._interrupted:
                self._run_hooks()  # those that are left
                self._destroy_tracked()
            return False
        self._wake_all()
        self._run_hooks()
        self._destroy_tracked()
        self._destroy_abandoned()
        self._close_if_unused()
        return True

    def interrupt(self) -> None:
        """Shut down from a signal handler: take no lock, because the interrupted code may hold it.

        The callbacks of `on_shutdown` are called on a separate thread.
        """
        if self._valid:
            # In this order: a thread that finds the context shut down asks whether a signal did it.
            self._interrupted = True
            self._valid = False
            self._wake_all()
            # Where no thread can be started, the hooks run when the program ends the context.
            with suppress(RuntimeError):
                _thread.start_new_thread(self._run_hooks, ())

    def on_shutdown(self, callback: Callable[[], Any]) -> None:
        """Call `callback()` at shutdown, or at once after shutdown. A bound method does not keep its object alive.

        Raises:
            TypeError: `callback` isn't callable.
        """
        if not callable(callback):
            raise TypeError(f"callback should be a callable, got {type(callback)}")
        if not self._valid:
            callback()
        elif isinstance(callback, MethodType):
            method = weakref.WeakMethod(callback)

            def call_if_alive() -> None:
                alive = method()
                if alive is not None:
                    alive()

            self.add_shutdown_hook(call_if_alive)
        else:
            self.add_shutdown_hook(callback)

    def add_shutdown_hook(self, hook: Callable[[], Any]) -> None:
        """Call `hook()` at shutdown, until `remove_shutdown_hook`; at once after shutdown."""
        with self._lock:
            if not self.is_over():
                self._hooks.append(hook)
                return
        hook()

    def remove_shutdown_hook(self, hook: Callable[[], Any]) -> None:
        """Undo one `add_shutdown_hook`."""
        with self._lock:
            if hook in self._hooks:
                self._hooks.remove(hook)

    def track_node(self, node: DestroyableNode) -> None:
        """Destroy a node at shutdown, after the callbacks of `on_shutdown`, unless nothing else refers to it by then.

        Raises:
            TypeError: no weak reference to `node` can be made.
        """
        with self._lock:
            self._tracked.add(node)

    def untrack_node(self, node: DestroyableNode) -> None:
        """Undo `track_node`; do nothing for a node that isn't tracked."""
        with self._lock:
            self._tracked = weakref.WeakSet(other for other in self._tracked if other is not node)

    def add_queue(self, queue: ReadyQueue) -> None:
        """Post `WAKE` to an executor's queue at shutdown."""
        with self._lock:
            self._queues = [*self._queues, queue]

    def remove_queue(self, queue: ReadyQueue) -> None:
        """Undo `add_queue`."""
        with self._lock:
            self._queues = [other for other in self._queues if other is not queue]

    def _wake_all(self) -> None:
        for queue in self._queues:
            queue.post(WAKE)

    def _run_hooks(self) -> None:
        with self._lock:
            hooks, self._hooks = self._hooks, []
        for hook in hooks:
            _call_hook(hook)

    def join(self, node: NodeName) -> Participant:
        """Add a node to the graph, and return the participant for it.

        Raises:
            NotInitializedException: the context isn't initialised, or shut down.
            ForkedProcessError: the parent process used it before this process was forked.
            StoppedException: a signal has shut it down.
            ConfigurationError, NoBackendError: the wire can't be opened.
        """
        from tfloom.rmw.backends import open_participant

        self._destroy_abandoned()
        with self._lock:
            self.check_not_from_parent_process("cannot create node")
            if not self._valid:
                if not self._interrupted:
                    raise NotInitializedException(_NO_NODE)
                postponed.take()  # this exception takes its place
                raise StoppedException
            if self._participant is None:
                self._participant = open_participant(self._domain_id, self._arguments.enclave or "/")
                _close_at_exit()
            self._participant.add_node(node)
            self._nodes += 1
            return self._participant

    def joining_error(self) -> NotInitializedException | None:
        """Return what `join` raises before `init` and after a shutdown, for callers whose tracebacks shall be short.

        In a forked child it is None: `join` has another error there.
        """
        if self._valid or self._interrupted or self._is_from_parent_process:
            return None
        return NotInitializedException(_NO_NODE)

    def abandon(self, node: DestroyableNode) -> None:
        """Destroy an unreferenced node later: when another joins, or at shutdown.

        It is not destroyed at once, because the garbage collector calls this on any thread, which may hold any lock.
        """
        self._abandoned.append(node)

    @property
    def participant(self) -> Participant | None:
        """The participant of this context's nodes on the wire, and None while there are none."""
        return self._participant

    def _destroy_abandoned(self) -> None:
        while self._abandoned:
            self._abandoned.popleft().destroy_node()

    def _destroy_tracked(self) -> None:
        with self._lock:
            tracked, self._tracked = list(self._tracked), weakref.WeakSet()
        for node in tracked:
            _call_hook(node.destroy_node)

    def leave(self, node: NodeName) -> None:
        """Remove a node from the graph."""
        with self._lock:
            if self._participant is not None:
                self._participant.remove_node(node)
                self._nodes -= 1
        self._close_if_unused()

    def _close_if_unused(self) -> None:
        with self._lock:
            is_unused = not self._valid and self._nodes == 0
        if is_unused:  # no node joins any more
            self._close_participant()

    def _close_participant(self) -> None:
        with self._lock:
            participant, self._participant = self._participant, None
        if participant is not None:
            participant.close()

    def destroy(self) -> None:
        """Shut down unless that has been done, and close the participant with all its nodes."""
        self.try_shutdown()
        self._close_participant()
        self._nodes = 0

    def __enter__(self) -> Self:
        if self._valid:  # by a call of `init`
            return self
        if CONTEXT_ASKS_FOR_INIT and not self._initialized:
            import warnings

            warnings.warn(
                "init() must be called on a Context before using it in a Python context manager. Calling init() with "
                "no arguments, this usage is deprecated",
                stacklevel=2,
            )
        self.init()
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy()


def _check_logging(arguments: Arguments) -> None:
    # The reference's logging backend can't be configured by a file either, and refuses one in the same place.
    if arguments.log_config_file is not None and arguments.external_lib_logs:
        raise RCLError(
            f"failed to initialize logging: --log-config-file {arguments.log_config_file}: the logging backend "
            "doesn't support a configuration file; use --log-level, --log-file-name, ROS_LOG_DIR and "
            "RCUTILS_CONSOLE_OUTPUT_FORMAT, or --disable-external-lib-logs"
        )


def _set_up_logging(arguments: Arguments) -> None:
    for name, level in arguments.log_levels:
        log_output.set_level(name, level)
    file = LogFile(arguments.log_file_name) if arguments.external_lib_logs else None
    log_output.configure(file=file, console=arguments.stdout_logs)


def _call_hook(hook: Callable[[], Any]) -> None:
    try:
        hook()
    except Exception as error:  # the other hooks must run too
        print_error(error)


def live_contexts() -> list[Context]:
    """Return the contexts that are initialised and not shut down."""
    return [context for context in _all_contexts() if context.ok()]


def _all_contexts() -> list[Context]:
    return [context for reference in list(_contexts.values()) if (context := reference()) is not None]


def _reset_all_in_forked_child() -> None:
    for context in _all_contexts():
        context.reset_in_forked_child()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_reset_all_in_forked_child)

_will_close_at_exit = False
_is_ending = False
"""Whether the program's end has begun to close all contexts."""


def _close_at_exit() -> None:
    global _will_close_at_exit  # noqa: PLW0603  # once a process
    if not _will_close_at_exit:
        import atexit

        _will_close_at_exit = True
        atexit.register(_destroy_all)


def _destroy_all() -> None:
    import signal

    global _is_ending  # noqa: PLW0603  # once a process
    _is_ending = True
    # Launchers send Ctrl-C to the process and to its group: the second one is ignored.
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    # A daemon thread that spins must end with the program, not with an exception.
    block_waits_at_exit()
    for context in _all_contexts():
        context.destroy()
