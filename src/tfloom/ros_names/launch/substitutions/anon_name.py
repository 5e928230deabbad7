"""A name that no other launch uses."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.anon_name import AnonName as AnonName
