"""Nodes: a name on the graph, with publishers, subscriptions, services, timers and parameters."""

from __future__ import annotations

from types import FunctionType
from typing import TYPE_CHECKING

from tfloom.node.base.node_base import NodeBase, as_profile, profile_error
from tfloom.node.builtin.parameter_service import ParameterService
from tfloom.node.builtin.rosout import Rosout
from tfloom.node.builtin.time_source import TimeSource
from tfloom.node.builtin.type_description_service import TypeDescriptionService
from tfloom.node.context.arguments import Arguments, parse_arguments, warn_of_deprecated_remaps
from tfloom.node.context.utilities import get_default_context
from tfloom.node.parameters.parameter import PARAMETER_SEPARATOR_STRING, Parameter, no_parameter_error
from tfloom.node.qos.qos import QoSProfile, qos_profile_rosout_default
from tfloom.node.values.duration import S_TO_NS
from tfloom.node.values.names import namespace_error, node_name_error
from tfloom.node.values.type_support import MsgType, SrvType, SrvTypeRequest, SrvTypeResponse
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from tfloom.node.context.context import Context

__all__ = [
    "HIDDEN_NODE_PREFIX",
    "PARAMETER_SEPARATOR_STRING",
    "S_TO_NS",
    "MsgType",
    "Node",
    "SrvType",
    "SrvTypeRequest",
    "SrvTypeResponse",
]

HIDDEN_NODE_PREFIX = "_"


# Private names are mangled, because programs derive from Node and choose their own names.
class Node(NodeBase):
    """A node: a name on the graph, under which it publishes, subscribes, and has parameters and timers.

    Its callbacks run while an executor that it was added to spins. A reference to anything that it created keeps it
    alive. An unreferenced node leaves the graph when another node is created, or at shutdown.

    Args:
        node_name: Its name; `-r __node:=` on the command line replaces it.
        context: The context it belongs to; None: the default one.
        cli_args: Arguments for this node alone, `--ros-args` included; they take precedence over the program's.
        namespace: Its namespace, with or without the first slash; None: the root. `-r __ns:=` replaces it.
        use_global_arguments: Whether the program's ROS arguments apply to it.
        enable_rosout: Whether its log records are published on /rosout.
        rosout_qos_profile: QoS of that; a number is the depth of a KEEP_LAST history.
        start_parameter_services: Whether it has services that read and set its parameters.
        parameter_overrides: First values of parameters; they take precedence over those of the command line.
        allow_undeclared_parameters: Whether parameters may be set that aren't declared.
        automatically_declare_parameters_from_overrides: Whether each parameter that is given a first value is
            declared at once.
        enable_logger_service: Whether it has services that read and set the levels of loggers.

    Raises:
        NotInitializedException: the context isn't initialised, or shut down.
        InvalidNodeNameException: the name isn't valid.
        InvalidNamespaceException: the namespace isn't valid.
        TypeError: a name is not a text, an override is not a Parameter, or `rosout_qos_profile` neither a profile
            nor a number.
        ValueError: `rosout_qos_profile` is a negative number.
        RCLInvalidROSArgsError: one of `cli_args` is malformed.
    """

    PARAM_REL_TOL = 1e-6

    __time_source: TimeSource | None = None

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        rosout_qos_profile: QoSProfile | int = qos_profile_rosout_default,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        if (error := node_name_error(node_name)) is not None:
            raise error
        full_namespace = (
            f"/{namespace}" if isinstance(namespace, str) and namespace[:1] != "/" else namespace or "/"
        )
        if (error := namespace_error(full_namespace)) is not None:
            raise error
        if (error := no_parameter_error(parameter_overrides or ())) is not None:
            raise error
        if (error := profile_error(rosout_qos_profile)) is not None:
            raise error
        context = context or get_default_context()
        if (error := context.joining_error()) is not None:
            raise error
        own_arguments = parse_arguments(cli_args or [])
        warn_of_deprecated_remaps(own_arguments)
        arguments = own_arguments.over(context.arguments if use_global_arguments else Arguments())
        NodeBase.__init__(
            self,
            node_name,
            context=context,
            arguments=arguments,
            namespace=full_namespace,
            parameter_overrides=parameter_overrides or [],
            allow_undeclared_parameters=allow_undeclared_parameters,
            declare_overrides=automatically_declare_parameters_from_overrides,
        )
        try:
            if enable_rosout and arguments.rosout_logs:
                Rosout(self, as_profile(rosout_qos_profile))
            self.__time_source = TimeSource(node=self)
            self.__time_source.attach_clock(self.get_clock())
            if start_parameter_services:
                ParameterService(self)
            if enable_logger_service:
                # Imported here, because it is off by default and the import costs start-up time.
                from tfloom.node.builtin.logging_service import LoggingService

                LoggingService(self)
            TypeDescriptionService(self)
        except BaseException:
            self.destroy_node()
            raise

    def __repr__(self) -> str:
        return ros_repr(self)

    def destroy_node(self) -> None:
        """Leave the executor and the graph, and destroy all that was created. Destroying again does nothing."""
        time_source, self.__time_source = self.__time_source, None
        if time_source is not None:
            time_source.detach_node()
        NodeBase.destroy_node(self)


# The errors of Python about missing and unexpected arguments have this name.
for _method in vars(NodeBase).values():
    if isinstance(_method, FunctionType):
        _method.__qualname__ = f"Node.{_method.__name__}"
