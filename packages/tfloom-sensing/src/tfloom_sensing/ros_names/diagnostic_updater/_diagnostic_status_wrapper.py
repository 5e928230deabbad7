"""A status that is easy to fill."""

from tfloom_sensing.diagnostic_status_wrapper import *
from tfloom_sensing.diagnostic_status_wrapper import __all__
