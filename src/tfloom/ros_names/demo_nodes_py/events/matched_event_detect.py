"""Log each change of the number of matched subscriptions and publishers."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.matched_event_detect import MatchedEventDetectNode as MatchedEventDetectNode
from tfloom.demos.demo_nodes_py.matched_event_detect import MultiPubNode as MultiPubNode
from tfloom.demos.demo_nodes_py.matched_event_detect import MultiSubNode as MultiSubNode
from tfloom.demos.demo_nodes_py.matched_event_detect import main as main
