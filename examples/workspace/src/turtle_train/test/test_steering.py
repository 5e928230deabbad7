"""A wagon's speed and turning rate."""

import math

from turtle_train.steering import follow


def test_wagon_drives_to_the_gap():
    assert follow(1.5, 0.0, 0.5, 2.0, 4.0) == (2.0, 0.0)


def test_wagon_stops_within_the_gap():
    speed, turn = follow(0.0, 0.3, 0.5, 2.0, 4.0)
    assert speed == 0.0
    assert turn == 4.0 * math.pi / 2
