"""Tasks that watch frequencies and ages."""

from tfloom_sensing.update_functions import *
from tfloom_sensing.update_functions import __all__
