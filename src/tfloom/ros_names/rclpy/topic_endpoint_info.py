"""Description of a publisher or subscription on the graph."""

from tfloom.node.qos.qos import QoSHistoryPolicy as QoSHistoryPolicy
from tfloom.node.qos.qos import QoSPresetProfiles as QoSPresetProfiles
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.node.qos.topic_endpoint_info import *
from tfloom.node.values.type_hash import TypeHash as TypeHash
