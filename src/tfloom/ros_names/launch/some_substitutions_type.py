"""What an argument accepts where it takes substitutions: a text, a substitution, or a list of both, concatenated."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
