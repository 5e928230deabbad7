"""Validation of full topic names."""

from tfloom.node.values.names import InvalidServiceNameException as InvalidServiceNameException
from tfloom.node.values.names import InvalidTopicNameException as InvalidTopicNameException
from tfloom.node.values.names import validate_full_topic_name as validate_full_topic_name
