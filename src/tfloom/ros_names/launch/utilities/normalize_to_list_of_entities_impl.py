"""Entities in every form as a list."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.utilities.normalize_to_list_of_entities import normalize_to_list_of_entities as normalize_to_list_of_entities
