"""Validation of topic names that are not expanded yet."""

from tfloom.node.values.names import TOPIC_SEPARATOR_STRING as TOPIC_SEPARATOR_STRING
from tfloom.node.values.names import InvalidServiceNameException as InvalidServiceNameException
from tfloom.node.values.names import InvalidTopicNameException as InvalidTopicNameException
from tfloom.node.values.names import validate_topic_name as validate_topic_name
