"""The mark of tests that run after the launch."""

from tfloom.launch.testing.decorator import post_shutdown_test as post_shutdown_test
