"""Types of attributes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.frontend.type_utils import check_is_list_entity as check_is_list_entity
from tfloom.launch.frontend.type_utils import get_data_type_from_identifier as get_data_type_from_identifier
