"""Tasks that watch frequencies and ages."""

from tfloom.sensing.update_functions import *
from tfloom.sensing.update_functions import __all__
