"""Replace the variables of a template."""

from tfloom.workspace.templates import *
from tfloom.workspace.templates import __all__
