"""The mark of tests that run after the launch."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.decorator import post_shutdown_test as post_shutdown_test
