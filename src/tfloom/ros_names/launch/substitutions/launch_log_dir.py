"""The folder of the launch's log."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.launch_log_dir import LaunchLogDir as LaunchLogDir
