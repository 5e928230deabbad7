"""Names of rclpy's compiled module that programs import: errors, and entities for wait sets."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.implementation import Client as Client
from tfloom.node.implementation import ClockType as ClockType
from tfloom.node.implementation import GuardCondition as GuardCondition
from tfloom.node.implementation import InvalidHandle as InvalidHandle
from tfloom.node.implementation import NodeNameNonExistentError as NodeNameNonExistentError
from tfloom.node.implementation import QoSCompatibility as QoSCompatibility
from tfloom.node.implementation import RCLError as RCLError
from tfloom.node.implementation import RCLInvalidROSArgsError as RCLInvalidROSArgsError
from tfloom.node.implementation import Service as Service
from tfloom.node.implementation import SignalHandlerOptions as SignalHandlerOptions
from tfloom.node.implementation import Subscription as Subscription
from tfloom.node.implementation import Timer as Timer
from tfloom.node.implementation import TimerCancelledError as TimerCancelledError
from tfloom.node.implementation import UnknownROSArgsError as UnknownROSArgsError
from tfloom.node.implementation import UnsupportedEventTypeError as UnsupportedEventTypeError
from tfloom.node.implementation import WaitSet as WaitSet
