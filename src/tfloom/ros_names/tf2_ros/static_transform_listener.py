"""Fill a buffer from /tf_static."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.transform_listener import StaticTransformListener as StaticTransformListener
