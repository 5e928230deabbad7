"""The ROS 2 client library for Python, implemented by tfloom."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.client_library import create_node as create_node
from tfloom.node.client_library import get_global_executor as get_global_executor
from tfloom.node.client_library import init as init
from tfloom.node.client_library import shutdown as shutdown
from tfloom.node.client_library import spin as spin
from tfloom.node.client_library import spin_once as spin_once
from tfloom.node.client_library import spin_until_future_complete as spin_until_future_complete

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rclpy import action as action
    from rclpy import callback_groups as callback_groups
    from rclpy import client as client
    from rclpy import clock as clock
    from rclpy import clock_type as clock_type
    from rclpy import constants as constants
    from rclpy import context as context
    from rclpy import destroyable as destroyable
    from rclpy import duration as duration
    from rclpy import event_handler as event_handler
    from rclpy import exceptions as exceptions
    from rclpy import executors as executors
    from rclpy import expand_topic_name as expand_topic_name
    from rclpy import experimental as experimental
    from rclpy import guard_condition as guard_condition
    from rclpy import impl as impl
    from rclpy import lifecycle as lifecycle
    from rclpy import logging as logging
    from rclpy import logging_service as logging_service
    from rclpy import node as node
    from rclpy import parameter as parameter
    from rclpy import parameter_client as parameter_client
    from rclpy import parameter_event_handler as parameter_event_handler
    from rclpy import parameter_service as parameter_service
    from rclpy import publisher as publisher
    from rclpy import qos as qos
    from rclpy import qos_event as qos_event
    from rclpy import qos_overriding_options as qos_overriding_options
    from rclpy import serialization as serialization
    from rclpy import service as service
    from rclpy import service_introspection as service_introspection
    from rclpy import signals as signals
    from rclpy import subscription as subscription
    from rclpy import task as task
    from rclpy import time as time
    from rclpy import time_source as time_source
    from rclpy import timer as timer
    from rclpy import topic_endpoint_info as topic_endpoint_info
    from rclpy import topic_or_service_is_hidden as topic_or_service_is_hidden
    from rclpy import type_description_service as type_description_service
    from rclpy import type_hash as type_hash
    from rclpy import type_support as type_support
    from rclpy import utilities as utilities
    from rclpy import validate_full_topic_name as validate_full_topic_name
    from rclpy import validate_namespace as validate_namespace
    from rclpy import validate_node_name as validate_node_name
    from rclpy import validate_parameter_name as validate_parameter_name
    from rclpy import validate_topic_name as validate_topic_name
    from rclpy import wait_for_message as wait_for_message
    from rclpy import waitable as waitable
    from tfloom.node.client_library import InitContextManager as InitContextManager
    from tfloom.node.context.context import Context as Context
    from tfloom.node.context.utilities import get_default_context as get_default_context
    from tfloom.node.context.utilities import get_rmw_implementation_identifier as get_rmw_implementation_identifier
    from tfloom.node.context.utilities import ok as ok
    from tfloom.node.context.utilities import try_shutdown as try_shutdown
    from tfloom.node.executing.signals import SignalHandlerOptions as SignalHandlerOptions
    from tfloom.node.executing.signals import install_signal_handlers as install_signal_handlers
    from tfloom.node.executing.signals import uninstall_signal_handlers as uninstall_signal_handlers
    from tfloom.node.executing.task import Future as Future
    from tfloom.node.parameters.parameter import Parameter as Parameter
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Context="tfloom.node.context.context",
        Future="tfloom.node.executing.task",
        InitContextManager="tfloom.node.client_library",
        Parameter="tfloom.node.parameters.parameter",
        SignalHandlerOptions="tfloom.node.executing.signals",
        action="rclpy",
        callback_groups="rclpy",
        client="rclpy",
        clock="rclpy",
        clock_type="rclpy",
        constants="rclpy",
        context="rclpy",
        destroyable="rclpy",
        duration="rclpy",
        event_handler="rclpy",
        exceptions="rclpy",
        executors="rclpy",
        expand_topic_name="rclpy",
        experimental="rclpy",
        get_default_context="tfloom.node.context.utilities",
        get_rmw_implementation_identifier="tfloom.node.context.utilities",
        guard_condition="rclpy",
        impl="rclpy",
        install_signal_handlers="tfloom.node.executing.signals",
        lifecycle="rclpy",
        logging="rclpy",
        logging_service="rclpy",
        node="rclpy",
        ok="tfloom.node.context.utilities",
        parameter="rclpy",
        parameter_client="rclpy",
        parameter_event_handler="rclpy",
        parameter_service="rclpy",
        publisher="rclpy",
        qos="rclpy",
        qos_event="rclpy",
        qos_overriding_options="rclpy",
        serialization="rclpy",
        service="rclpy",
        service_introspection="rclpy",
        signals="rclpy",
        subscription="rclpy",
        task="rclpy",
        time="rclpy",
        time_source="rclpy",
        timer="rclpy",
        topic_endpoint_info="rclpy",
        topic_or_service_is_hidden="rclpy",
        try_shutdown="tfloom.node.context.utilities",
        type_description_service="rclpy",
        type_hash="rclpy",
        type_support="rclpy",
        uninstall_signal_handlers="tfloom.node.executing.signals",
        utilities="rclpy",
        validate_full_topic_name="rclpy",
        validate_namespace="rclpy",
        validate_node_name="rclpy",
        validate_parameter_name="rclpy",
        validate_topic_name="rclpy",
        wait_for_message="rclpy",
        waitable="rclpy",
    )
