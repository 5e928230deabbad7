"""Set, list, get, load and delete parameters of another node, parameter_blackboard."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.async_param_client import main as main
