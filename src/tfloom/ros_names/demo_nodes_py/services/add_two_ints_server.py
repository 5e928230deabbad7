"""Serve add_two_ints: respond with the sum of two integers."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.add_two_ints_server import AddTwoIntsServer as AddTwoIntsServer
from tfloom.demos.demo_nodes_py.add_two_ints_server import main as main
