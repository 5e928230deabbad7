"""The ROS 2 client library for Python, implemented by tfloom."""

from typing import TYPE_CHECKING

from tfloom.node.client_library import *

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
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rclpy")
