"""One report that several processes are ready."""

from tfloom.launch.testing.ready_aggregator import ReadyAggregator as ReadyAggregator
