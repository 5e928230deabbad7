"""Call add_two_ints with 2 and 3, and wait for the response."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.add_two_ints_client import main as main
from tfloom.demos.demo_nodes_py.add_two_ints_client import wait_for_server as wait_for_server
