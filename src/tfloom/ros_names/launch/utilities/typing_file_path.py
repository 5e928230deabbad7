"""The type of paths."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.utilities.typing_file_path import FilePath as FilePath
