"""Importing extension modules."""

from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
from tfloom.c_libraries import import_c_library as import_c_library
