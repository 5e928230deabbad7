"""The type of paths."""

from tfloom.launch.utilities.typing_file_path import FilePath as FilePath
