"""The action that sets the folder of later nodes' logs."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.set_ros_log_dir import SetROSLogDir as SetROSLogDir
