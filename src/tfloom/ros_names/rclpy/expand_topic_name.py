"""Expansion of relative names to full names."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.names import expand_topic_name as expand_topic_name
