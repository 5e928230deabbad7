"""Checks that a class is a message or service class."""

from tfloom.node.values.exceptions import NoTypeSupportImportedException as NoTypeSupportImportedException
from tfloom.node.values.type_support import *
