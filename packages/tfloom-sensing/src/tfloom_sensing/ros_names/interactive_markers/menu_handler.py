"""Menus of markers."""

from tfloom_sensing.menu_handler import *
from tfloom_sensing.menu_handler import __all__
