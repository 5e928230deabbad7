"""Menus of markers."""

from tfloom.sensing.menu_handler import *
from tfloom.sensing.menu_handler import __all__
