"""The action that sets whether the launch's own node uses simulated time."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.set_use_sim_time import SetUseSimTime as SetUseSimTime
