"""Messages that are changed and published again."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.ros.data_republisher import DataRepublisher as DataRepublisher
