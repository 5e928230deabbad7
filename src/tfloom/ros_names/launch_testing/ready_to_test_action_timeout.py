"""The time until tests can begin."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.ready_to_test_action_timeout import ready_to_test_action_timeout as ready_to_test_action_timeout
