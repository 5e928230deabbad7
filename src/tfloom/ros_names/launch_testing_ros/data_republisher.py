"""Messages that are changed and published again."""

from tfloom.launch.testing.ros.data_republisher import DataRepublisher as DataRepublisher
