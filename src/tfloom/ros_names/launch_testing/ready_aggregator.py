"""One report that several processes are ready."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.ready_aggregator import ReadyAggregator as ReadyAggregator
