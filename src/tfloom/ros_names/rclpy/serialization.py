"""Serialization of messages to bytes and back."""

from tfloom.node.values.serialization import *
from tfloom.node.values.type_support import check_for_type_support as check_for_type_support
