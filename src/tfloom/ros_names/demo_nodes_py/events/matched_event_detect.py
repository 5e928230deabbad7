"""Log how a publisher and a subscription get company, and lose it again."""

from tfloom.demos.demo_nodes_py.matched_event_detect import *
from tfloom.demos.demo_nodes_py.matched_event_detect import __all__
