"""Recordings: rosbag2 of MCAP and sqlite3, and ROS 1 bags for their transforms.

    from tfloom.bag import frames, open_bag

    buffer = frames("my_bag")
    with open_bag("my_bag") as bag:
        for message in bag.messages("/scan"): …

- opening: `open_bag`
- bag, values, metadata: files in order, topics, messages as bytes, and what a bag says of itself
- tf_frames, stamps, moved_clouds: frames of a recording, and what needs them
- message_classes: also of types that only the recording knows
- reading/, writing/: one form in each file; the numbers of topics, the folder
- recording/, playing/, node_running: the nodes
- qos_profiles, topic_choice, key_presses, info_text, reindexing, converting: what the verbs of `bag` need
- html: what notebooks show
- rosbag2_names/: rosbag2_py
"""

from __future__ import annotations

__all__ = [
    "Bag",
    "BagError",
    "BagWarning",
    "Definition",
    "RawMessage",
    "Topic",
    "clouds",
    "frames",
    "open_bag",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.bag.bag import Bag as Bag
    from tfloom.bag.errors import BagError as BagError
    from tfloom.bag.errors import BagWarning as BagWarning
    from tfloom.bag.moved_clouds import clouds as clouds
    from tfloom.bag.opening import open_bag as open_bag
    from tfloom.bag.tf_frames import frames as frames
    from tfloom.bag.values import Definition as Definition
    from tfloom.bag.values import RawMessage as RawMessage
    from tfloom.bag.values import Topic as Topic
else:
    from tfloom.ros_imports.modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Bag="tfloom.bag.bag",
        BagError="tfloom.bag.errors",
        BagWarning="tfloom.bag.errors",
        Definition="tfloom.bag.values",
        RawMessage="tfloom.bag.values",
        Topic="tfloom.bag.values",
        clouds="tfloom.bag.moved_clouds",
        frames="tfloom.bag.tf_frames",
        open_bag="tfloom.bag.opening",
    )
