"""The state of a launch: its events and handlers, variables, launch configurations and environment."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, MutableMapping, Sequence
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.common.text import shortened
from tfloom.launch.core.event import Event
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.launch.core.run_state import HandlesEvents, RunState
from tfloom.launch.logs.logging import get_logger
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop, Future

__all__ = ["LaunchContext", "Locals"]


class Performs(Protocol):
    """A substitution, as the context needs it."""

    def perform(self, context: Any) -> str:
        """Return the text that the substitution stands for."""


class Locals:
    """The context's variables as attributes, which can be read."""

    def __init__(self, variables: Mapping[str, Any]) -> None:
        self.__dict__.update(variables)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(
            f"context.locals does not contain attribute '{name}', it contains: [{', '.join(self.__dict__)}]"
        )

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"can't set attribute '{name}', locals are read-only")


class LaunchContext(HasPrivateNames):
    """The state that entities share while a description is launched.

    All members are used by the thread that runs the launch.

    Args:
        argv: The arguments of the launch's command line.
        noninteractive: Whether no terminal is there, so that Ctrl-C does not reach the processes by themselves.
    """

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False) -> None:
        self._argv = list(argv) if argv is not None else []
        self._noninteractive = noninteractive
        self.run_state = RunState()
        """Events and their handlers; the service changes it."""
        self._globals: dict[str, Any] = {}
        self._locals: dict[str, Any] = {}
        self._locals_stack: list[dict[str, Any]] = []
        self._launch_configurations: dict[str, str] = {}
        self.declared_arguments: list[str] = []
        """Names of the arguments whose declaration has been visited."""
        self._launch_configurations_stack: list[dict[str, str]] = []
        self._initial_environment = dict(os.environ)
        self._environment_stack: list[dict[str, str]] = []
        self._logger = get_logger("launch.launch_context")

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def argv(self) -> list[str]:
        """Arguments of the launch's command line."""
        return self._argv

    @property
    def noninteractive(self) -> bool:
        """Whether the launch has no terminal."""
        return self._noninteractive

    @property
    def is_shutdown(self) -> bool:
        """Whether a Shutdown event has been handled."""
        return self.run_state.is_shutdown

    @property
    def asyncio_loop(self) -> AbstractEventLoop | None:
        """Loop that runs the launch; None while it doesn't run."""
        return self.run_state.loop

    def _set_is_shutdown(self, state: bool) -> None:
        """Set `is_shutdown`; tests of actions call this."""
        self.run_state.is_shutdown = state

    def _set_asyncio_loop(self, loop: AbstractEventLoop | None) -> None:
        """Set `asyncio_loop`; tests of actions call this."""
        self.run_state.loop = loop

    def add_completion_future(self, completion_future: Future[Any]) -> None:
        """Keep the launch running until a future is done."""
        self.run_state.add_future(completion_future)

    # Variables

    def extend_globals(self, extensions: dict[str, Any]) -> None:
        """Add variables that stay for the whole launch.

        Raises:
            ValueError: a variable has one of the names.
        """
        for name in extensions:
            if name in self._globals:
                raise ValueError(f"cannot overwrite existing global '{name}'")
        self._globals.update(extensions)

    def extend_locals(self, extensions: dict[str, Any]) -> None:
        """Add variables that stay until `_pop_locals`."""
        self._locals.update(extensions)

    def remove_local(self, name: str) -> None:
        """Remove a variable that `extend_locals` has added, if it is there."""
        self._locals.pop(name, None)

    def _push_locals(self) -> None:
        self._locals_stack.append(dict(self._locals))

    def _pop_locals(self) -> None:
        if not self._locals_stack:
            raise RuntimeError("locals stack unexpectedly empty")
        self._locals = self._locals_stack.pop()

    def get_locals_as_dict(self) -> dict[str, Any]:
        """Return all variables, those of the whole launch included."""
        return {**self._globals, **self._locals}

    @property
    def locals(self) -> Locals:
        """Variables of the place that is executed, as attributes."""
        return Locals(self.get_locals_as_dict())

    # Launch configurations

    @property
    def launch_configurations(self) -> dict[str, str]:
        """Values of launch arguments and configurations, by name."""
        return self._launch_configurations

    def _push_launch_configurations(self) -> None:
        self._launch_configurations_stack.append(dict(self._launch_configurations))

    def _pop_launch_configurations(self) -> None:
        if not self._launch_configurations_stack:
            raise RuntimeError("launch configurations stack unexpectedly empty")
        self._launch_configurations = self._launch_configurations_stack.pop()

    # Environment

    @property
    def environment(self) -> MutableMapping[str, str]:
        """Environment variables, which started processes inherit: `os.environ`."""
        return os.environ

    def _push_environment(self) -> None:
        self._environment_stack.append(dict(os.environ))

    def _pop_environment(self) -> None:
        if not self._environment_stack:
            raise RuntimeError("environment stack unexpectedly empty")
        self._replace_environment(self._environment_stack.pop())

    def _reset_environment(self) -> None:
        self._replace_environment(self._initial_environment)

    def _replace_environment(self, environment: Mapping[str, str]) -> None:
        before = dict(os.environ)
        os.environ.clear()
        try:
            os.environ.update(environment)
        except (ValueError, OSError) as error:
            os.environ.clear()
            os.environ.update(before)
            names = shortened(", ".join(map(repr, environment)))
            raise ValueError(f"the environment can't be replaced by one of {names}: {error}") from error

    # Events

    @property
    def _event_queue(self) -> SimpleQueue[Event]:
        """Events to handle, by the name that tests of actions use."""
        return self.run_state.events

    @property
    def _event_handlers(self) -> Sequence[HandlesEvents]:
        """Event handlers, by the name that tests of actions use."""
        return self.run_state.handlers

    def register_event_handler(self, event_handler: HandlesEvents, append: bool = False) -> None:
        """Add a handler, before the others, or after them if `append`."""
        if append:
            self.run_state.handlers.append(event_handler)
        else:
            self.run_state.handlers.appendleft(event_handler)

    def unregister_event_handler(self, event_handler: HandlesEvents) -> None:
        """Remove a handler.

        Raises:
            ValueError: it was not registered.
        """
        self.run_state.handlers.remove(event_handler)

    def would_handle_event(self, event: Event) -> bool:
        """Return whether any handler handles an event. The exception of a matcher ends the launch that runs."""
        for handler in tuple(self.run_state.handlers):
            try:
                if handler.matches(event):
                    return True
            except Exception as error:
                if self.run_state.report is None:
                    raise
                # The caller goes on: it prints what a process has written, for example.
                self.run_state.report(error)
        return False

    def emit_event_sync(self, event: Event) -> None:
        """Add an event to those that the service handles, in order."""
        self._logger.debug("emitting event synchronously: '%s'", event.name)
        self.run_state.emit(event)

    async def emit_event(self, event: Event) -> None:
        """Add an event to those that the service handles, in order."""
        self._logger.debug("emitting event: '%s'", event.name)
        self.run_state.emit(event)

    def perform_substitution(self, substitution: Performs) -> str:
        """Return a substitution's text."""
        return substitution.perform(self)
