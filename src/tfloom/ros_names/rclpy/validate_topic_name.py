"""What is valid as a name that a program gives."""

from tfloom.node.values.names import TOPIC_SEPARATOR_STRING as TOPIC_SEPARATOR_STRING
from tfloom.node.values.names import InvalidServiceNameException as InvalidServiceNameException
from tfloom.node.values.names import InvalidTopicNameException as InvalidTopicNameException
from tfloom.node.values.names import validate_topic_name as validate_topic_name
