"""How a tag gets its action, and a name after `$(` its substitution."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.frontend.expose import action_parse_methods as action_parse_methods
from tfloom.launch.frontend.expose import expose_action as expose_action
from tfloom.launch.frontend.expose import expose_substitution as expose_substitution
from tfloom.launch.frontend.expose import instantiate_action as instantiate_action
from tfloom.launch.frontend.expose import instantiate_substitution as instantiate_substitution
from tfloom.launch.frontend.expose import substitution_parse_methods as substitution_parse_methods
