"""A status that is easy to fill."""

from tfloom.sensing.diagnostic_status_wrapper import *
from tfloom.sensing.diagnostic_status_wrapper import __all__
