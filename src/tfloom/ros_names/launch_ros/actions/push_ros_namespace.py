"""The action that puts later nodes into a namespace."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.push_ros_namespace import PushROSNamespace as PushROSNamespace
