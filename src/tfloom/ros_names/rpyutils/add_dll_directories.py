"""Folders of DLLs, on Windows."""

from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
