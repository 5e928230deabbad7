"""A client and a server of add_two_ints that publish their service events."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.introspection import IntrospectionClientNode as IntrospectionClientNode
from tfloom.demos.demo_nodes_py.introspection import IntrospectionServiceNode as IntrospectionServiceNode
from tfloom.demos.demo_nodes_py.introspection import check_parameter as check_parameter
from tfloom.demos.demo_nodes_py.introspection import main as main
