"""Parsing of .idl files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.rosidl.definition import ACTION_FEEDBACK_SUFFIX as ACTION_FEEDBACK_SUFFIX
from tfloom.rosidl.definition import ACTION_GOAL_SUFFIX as ACTION_GOAL_SUFFIX
from tfloom.rosidl.definition import ACTION_RESULT_SUFFIX as ACTION_RESULT_SUFFIX
from tfloom.rosidl.definition import AbstractNestedType as AbstractNestedType
from tfloom.rosidl.definition import AbstractType as AbstractType
from tfloom.rosidl.definition import Action as Action
from tfloom.rosidl.definition import Annotation as Annotation
from tfloom.rosidl.definition import Array as Array
from tfloom.rosidl.definition import BasicType as BasicType
from tfloom.rosidl.definition import BoundedSequence as BoundedSequence
from tfloom.rosidl.definition import BoundedString as BoundedString
from tfloom.rosidl.definition import BoundedWString as BoundedWString
from tfloom.rosidl.definition import CONSTANT_MODULE_SUFFIX as CONSTANT_MODULE_SUFFIX
from tfloom.rosidl.definition import Constant as Constant
from tfloom.rosidl.definition import IdlContent as IdlContent
from tfloom.rosidl.definition import IdlFile as IdlFile
from tfloom.rosidl.definition import Include as Include
from tfloom.rosidl.definition import Member as Member
from tfloom.rosidl.definition import Message as Message
from tfloom.rosidl.definition import NamedType as NamedType
from tfloom.rosidl.definition import NamespacedType as NamespacedType
from tfloom.rosidl.definition import SERVICE_REQUEST_MESSAGE_SUFFIX as SERVICE_REQUEST_MESSAGE_SUFFIX
from tfloom.rosidl.definition import SERVICE_RESPONSE_MESSAGE_SUFFIX as SERVICE_RESPONSE_MESSAGE_SUFFIX
from tfloom.rosidl.definition import Service as Service
from tfloom.rosidl.definition import Structure as Structure
from tfloom.rosidl.definition import UnboundedSequence as UnboundedSequence
from tfloom.rosidl.definition import UnboundedString as UnboundedString
from tfloom.rosidl.definition import UnboundedWString as UnboundedWString
from tfloom.rosidl.idl_parser import parse_idl_file as parse_idl_file
from tfloom.rosidl.idl_parser import parse_idl_string as parse_idl_string
