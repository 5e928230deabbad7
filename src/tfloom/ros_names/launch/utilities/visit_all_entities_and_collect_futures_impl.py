"""The visit of a tree of entities."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.utilities.visit_all_entities_and_collect_futures import visit_all_entities_and_collect_futures as visit_all_entities_and_collect_futures
