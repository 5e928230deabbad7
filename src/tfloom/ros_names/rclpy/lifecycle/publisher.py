"""Publishers that publish while their lifecycle node is active."""

from tfloom.node.endpoints.publisher import MsgType as MsgType
from tfloom.node.endpoints.publisher import Publisher as Publisher
from tfloom.node.lifecycle.managed_entity import SimpleManagedEntity as SimpleManagedEntity
from tfloom.node.lifecycle.publisher import *
