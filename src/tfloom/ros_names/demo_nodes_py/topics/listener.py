"""Log each message on chatter."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.listener import Listener as Listener
from tfloom.demos.demo_nodes_py.listener import main as main
