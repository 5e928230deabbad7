"""Measure lookups and inserts with Debian's python3-tf2, the core of ROS 1 Noetic; run by Debian's Python, prints JSON.

Standard input has a line of JSON with the number of stamps, the edges and the frames to look up. Then, for each tree,
follow the stamps (int64) and, edge by edge, rows of x y z and x y z w (float64).
"""

import json
import random
import sys
from array import array
from time import process_time

TURNS = 5


def read(kind, count):
    numbers = array(kind)
    numbers.frombytes(sys.stdin.buffer.read(count * numbers.itemsize))
    return numbers


def best_us(count, call, *args):
    times = []
    for _ in range(TURNS):
        start = process_time()
        for _ in range(count):
            call(*args)
        times.append((process_time() - start) / count)
    return 1e6 * min(times)


def message(parent, child, stamp, row):
    result = TransformStamped()
    result.header.frame_id, result.child_frame_id = parent, child
    result.header.stamp = Time(*divmod(stamp, 1_000_000_000))
    p, q = result.transform.translation, result.transform.rotation
    p.x, p.y, p.z, q.x, q.y, q.z, q.w = row
    return result


def measure(tree):
    buffer = BufferCore(Duration(1000))
    stamps = read("q", tree["count"])
    seconds = []
    for parent, child in tree["edges"]:
        rows = read("d", 7 * len(stamps))
        messages = [message(parent, child, stamp, rows[7 * i : 7 * i + 7]) for i, stamp in enumerate(stamps)]
        start = process_time()
        for stamped in messages:
            buffer.set_transform(stamped, "bench")
        seconds.append((process_time() - start) / len(messages))
    names = tree["target"], tree["source"]
    middle = Time(*divmod(tree["middle"], 1_000_000_000))
    found = buffer.lookup_transform_core(*names, middle).transform.translation
    return {
        "latest_us": best_us(2000, buffer.lookup_transform_core, *names, Time()),
        "middle_us": best_us(200, buffer.lookup_transform_core, *names, middle),
        "set_us": 1e6 * min(seconds),
        "position": [found.x, found.y, found.z],
    }


def insert_shuffled():
    stamps = [100_000_000_000 + index * 1_000_000 for index in range(10_000)]
    random.Random(2).shuffle(stamps)
    messages = [message("a", "b", stamp, (1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0)) for stamp in stamps]
    buffer = BufferCore(Duration(1000))
    start = process_time()
    for stamped in messages:
        buffer.set_transform(stamped, "bench")
    return 1e6 * (process_time() - start) / len(messages)


try:
    from genpy import Duration, Time
    from geometry_msgs.msg import TransformStamped
    from tf2_py import BufferCore
except ImportError as error:
    print(json.dumps({"absent": str(error)}))
else:
    trees = json.loads(sys.stdin.buffer.readline())
    results = {name: measure(tree) for name, tree in trees.items()}
    print(json.dumps({"trees": results, "shuffled_us": insert_shuffled()}))
