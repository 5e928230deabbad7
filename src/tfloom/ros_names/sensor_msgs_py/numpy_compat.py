"""Convert structured arrays to plain ones and back."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.numpy_compat import structured_to_unstructured as structured_to_unstructured
from tfloom.tf2_ros.numpy_compat import unstructured_to_structured as unstructured_to_structured
