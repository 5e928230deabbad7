"""How a wagon follows: from where the one before it is, to speed and turning rate."""

import math


def follow(x, y, gap, speed_gain, turn_gain):
    """
    Return the speed [m/s] and the turning rate [rad/s] of a wagon.

    The one before it is at x, y [m] in the wagon's frame. The wagon drives towards it while it is
    farther away than the gap [m].
    """
    distance = math.hypot(x, y)
    speed = speed_gain * max(0.0, distance - gap)
    return speed, turn_gain * math.atan2(y, x)
