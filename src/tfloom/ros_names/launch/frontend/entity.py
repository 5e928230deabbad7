"""An element of a launch file, and the parser as actions need it."""

from tfloom.launch.frontend.entity import *
