"""Log the serialized bytes of each message on chatter."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.listener_serialized import SerializedSubscriber as SerializedSubscriber
from tfloom.demos.demo_nodes_py.listener_serialized import main as main
