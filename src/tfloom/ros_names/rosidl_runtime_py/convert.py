"""Convert messages to YAML, CSV and dicts."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.rosidl.runtime import get_message_slot_types as get_message_slot_types
from tfloom.rosidl.yaml_text import message_to_csv as message_to_csv
from tfloom.rosidl.yaml_text import message_to_ordereddict as message_to_ordereddict
from tfloom.rosidl.yaml_text import message_to_yaml as message_to_yaml
