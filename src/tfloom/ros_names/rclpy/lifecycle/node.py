"""Lifecycle nodes."""

from tfloom.node.endpoints.service import Service as Service
from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
from tfloom.node.lifecycle.managed_entity import ManagedEntity as ManagedEntity
from tfloom.node.lifecycle.managed_entity import TransitionCallbackReturn as TransitionCallbackReturn
from tfloom.node.lifecycle.node import *
from tfloom.node.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher
from tfloom.node.node import Node as Node
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.node.values.type_support import check_is_valid_srv_type as check_is_valid_srv_type
