"""The functions of `import rclpy`: initialise, create a node, spin, shut down."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from tfloom.common.seconds import timeout_error
from tfloom.node.context.context import Context
from tfloom.node.context.utilities import (
    get_default_context,
    get_rmw_implementation_identifier,
    ok,
    try_shutdown,
)
from tfloom.node.context.utilities import shutdown as _shutdown
from tfloom.node.executing.signals import (
    SignalHandlerOptions,
    install_signal_handlers,
    leave_signal_handlers,
    uninstall_signal_handlers,
)
from tfloom.node.executing.task import Future, future_error
from tfloom.node.executing.temporarily_added import TemporarilyAdded
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.wrong_arguments import executor_error, node_error
from tfloom.ros_imports.ros_distro import set_ros_environment

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType
    from typing import Any

    from typing_extensions import Self

    from tfloom.node.executing.executor import Executor
    from tfloom.node.node import Node
    from tfloom.node.qos.qos import QoSProfile

__all__ = [
    "Context",
    "Future",
    "InitContextManager",
    "Parameter",
    "SignalHandlerOptions",
    "create_node",
    "get_default_context",
    "get_global_executor",
    "get_rmw_implementation_identifier",
    "init",
    "install_signal_handlers",
    "ok",
    "shutdown",
    "spin",
    "spin_once",
    "spin_until_future_complete",
    "try_shutdown",
    "uninstall_signal_handlers",
]

# `rclpy` imports this module, and a program that uses rclpy expects the environment of a sourced ROS.
set_ros_environment()


class InitContextManager:
    """The result of `init`: a context manager that shuts the context down on exit."""

    def __init__(self, context: Context, *, installed_signal_handlers: bool) -> None:
        self.context = context
        """The context that was initialised."""
        self.installed_signal_handlers = installed_signal_handlers
        """Whether `init` has installed handlers of signals, which the exit removes."""

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        is_default = self.context is get_default_context()
        try_shutdown(context=None if is_default else self.context)
        if self.installed_signal_handlers:
            leave_signal_handlers()


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> InitContextManager:
    """Initialise a context: read the ROS arguments, and handle Ctrl-C and SIGTERM.

    As in later releases, `with rclpy.init():` shuts the context down on exit, unless that has been done.

    Args:
        args: Command line; None: `sys.argv`.
        context: The context to initialise; None: the default one.
        domain_id: The domain to join; None: from ROS_DOMAIN_ID.
        signal_handler_options: Which signals to handle; None: both for the default context, else none.

    Raises:
        RuntimeError: the context was initialised before; the default one: and has not been shut down since.
        RCLInvalidROSArgsError: a ROS argument is malformed.
        UnknownROSArgsError: a ROS argument is unknown.
    """
    if signal_handler_options is None:
        is_default = context is None or context is get_default_context()
        signal_handler_options = SignalHandlerOptions.ALL if is_default else SignalHandlerOptions.NO
    if context is None and get_default_context().is_over():
        get_default_context(shutting_down=True)  # by a signal, after which it is still the default
    context = context or get_default_context()
    context.init(args, domain_id=domain_id)
    install_signal_handlers(signal_handler_options)
    return InitContextManager(
        context, installed_signal_handlers=signal_handler_options != SignalHandlerOptions.NO
    )


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut down: every spin returns or raises, and signals are handled as before `init`.

    Args:
        context: The context to shut down; None: the default one.
        uninstall_handlers: Whether to restore the former signal handlers; None: for the default context.

    Raises:
        RuntimeError: the context was never initialised.
        RCLError: it was shut down before; `try_shutdown` accepts that.
    """
    try:
        _shutdown(context=context)
    finally:
        if uninstall_handlers or (uninstall_handlers is None and context is None):
            leave_signal_handlers()


def create_node(
    node_name: str,
    *,
    context: Context | None = None,
    cli_args: list[str] | None = None,
    namespace: str | None = None,
    use_global_arguments: bool = True,
    enable_rosout: bool = True,
    rosout_qos_profile: QoSProfile | int | None = None,
    start_parameter_services: bool = True,
    parameter_overrides: list[Parameter] | None = None,
    allow_undeclared_parameters: bool = False,
    automatically_declare_parameters_from_overrides: bool = False,
    enable_logger_service: bool = False,
) -> Node:
    """Return a new node; the arguments are those of `Node`, with None for the usual QoS of /rosout."""
    from tfloom.node.node import Node
    from tfloom.node.qos.qos import qos_profile_rosout_default

    return Node(
        node_name,
        context=context,
        cli_args=cli_args,
        namespace=namespace,
        use_global_arguments=use_global_arguments,
        enable_rosout=enable_rosout,
        rosout_qos_profile=qos_profile_rosout_default if rosout_qos_profile is None else rosout_qos_profile,
        start_parameter_services=start_parameter_services,
        parameter_overrides=parameter_overrides,
        allow_undeclared_parameters=allow_undeclared_parameters,
        automatically_declare_parameters_from_overrides=automatically_declare_parameters_from_overrides,
        enable_logger_service=enable_logger_service,
    )


def get_global_executor() -> Executor:
    """Return the executor that `spin` and its variants use if none is given."""
    return _getter_of_global_executor()()


@cache
def _getter_of_global_executor() -> Callable[[], Executor]:
    from tfloom.node.executing.executors import get_global_executor as get

    return get


def spin(node: Node, executor: Executor | None = None) -> None:
    """Run a node's callbacks until its context is shut down.

    Raises:
        ExternalShutdownException: a signal has shut the context down; with `executor`, also another thread, but for a
            MultiThreadedExecutor, which returns after both.
        KeyboardInterrupt: Ctrl-C, on the main thread.
        Exception: raised by a callback.
        TypeError: there is no node.
    """
    if (error := node_error("spin", node) or executor_error("spin", executor)) is not None:
        raise error
    executor = executor or get_global_executor()
    with TemporarilyAdded(node, executor):
        executor.spin()


def spin_once(node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None) -> None:
    """Wait for one callback and run it; after `timeout_sec` [s] (None: no limit), return without one."""
    error: Exception | None = node_error("spin_once", node) or executor_error("spin_once", executor)
    if (error := error or timeout_error("spin_once", timeout_sec)) is not None:
        raise error
    executor = executor or get_global_executor()
    with TemporarilyAdded(node, executor):
        executor.spin_once(timeout_sec=timeout_sec)


def spin_until_future_complete(
    node: Node, future: Future[Any], executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Run a node's callbacks until a future is done, or for `timeout_sec` [s] (None: no limit)."""
    name = "spin_until_future_complete"
    error: Exception | None = node_error(name, node) or future_error(future)
    error = error or executor_error(name, executor) or timeout_error(name, timeout_sec)
    if error is not None:
        raise error
    executor = executor or get_global_executor()
    with TemporarilyAdded(node, executor):
        executor.spin_until_future_complete(future, timeout_sec)
