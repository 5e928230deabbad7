"""Hidden topics and services: names with a part that begins with `_`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.names import HIDDEN_TOPIC_PREFIX as HIDDEN_TOPIC_PREFIX
from tfloom.node.values.names import topic_or_service_is_hidden as topic_or_service_is_hidden
