"""Folders of DLLs, on Windows."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
