"""Log messages, with a chosen reliability, until a given number has arrived."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.listener_qos import ListenerQos as ListenerQos
from tfloom.demos.demo_nodes_py.listener_qos import main as main
