"""Publish a given number of messages, with a chosen reliability."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.talker_qos import TalkerQos as TalkerQos
from tfloom.demos.demo_nodes_py.talker_qos import main as main
