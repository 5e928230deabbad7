"""Publish "Hello World" and a count on chatter, once a second."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.talker import Talker as Talker
from tfloom.demos.demo_nodes_py.talker import main as main
