"""Keep messages until they can be transformed."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.message_filter import FilterFailureReason as FilterFailureReason
from tfloom.tf2_ros.message_filter import MessageFilter as MessageFilter
from tfloom.tf2_ros.message_filter import get_filter_failure_reason_string as get_filter_failure_reason_string
