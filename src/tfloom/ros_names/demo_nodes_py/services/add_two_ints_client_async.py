"""Call add_two_ints with 2 and 3, and check after each spin whether the response has arrived."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.add_two_ints_client_async import main as main
