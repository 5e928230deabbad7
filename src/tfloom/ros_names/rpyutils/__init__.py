"""Importing extension modules."""

# Imported before the function of the same name, which it would take the place of whenever somebody imports it.
import rpyutils.import_c_library
from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
from tfloom.c_libraries import import_c_library as import_c_library
