"""Parameters in every form, normalized: files, and mappings of names to values without mappings in them."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameter_dict as normalize_parameter_dict
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters as normalize_parameters
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
