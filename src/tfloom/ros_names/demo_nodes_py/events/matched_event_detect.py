"""Log each change of the number of matched subscriptions and publishers."""

from tfloom.demos.demo_nodes_py.matched_event_detect import *
from tfloom.demos.demo_nodes_py.matched_event_detect import __all__
