"""Logic on substitutions whose texts are true or false."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.boolean_substitution import AllSubstitution as AllSubstitution
from tfloom.launch.substitutions.boolean_substitution import AndSubstitution as AndSubstitution
from tfloom.launch.substitutions.boolean_substitution import AnySubstitution as AnySubstitution
from tfloom.launch.substitutions.boolean_substitution import NotSubstitution as NotSubstitution
from tfloom.launch.substitutions.boolean_substitution import OrSubstitution as OrSubstitution
from tfloom.launch.substitutions.boolean_substitution import perform_boolean as perform_boolean
