"""The substitutions in a text: `$(name argument 'quoted argument' $(nested argument))`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.frontend.parse_substitution import SubstitutionSyntaxError as SubstitutionSyntaxError
from tfloom.launch.frontend.parse_substitution import parse_if_substitutions as parse_if_substitutions
from tfloom.launch.frontend.parse_substitution import parse_substitution as parse_substitution
from tfloom.launch.frontend.parse_substitution import replace_escaped_characters as replace_escaped_characters
