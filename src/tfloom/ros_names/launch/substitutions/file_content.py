"""The content of a file."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.file_content import FileContent as FileContent
