"""Set one parameter when another is set, by the pre-set, on-set and post-set callbacks."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.set_parameters_callback import SetParametersCallback as SetParametersCallback
from tfloom.demos.demo_nodes_py.set_parameters_callback import main as main
