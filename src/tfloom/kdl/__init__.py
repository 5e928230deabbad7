"""KDL's vectors, rotations, frames, twists and wrenches, as PyKDL has them; compiled in `native/kdl/`.

- frames: what PyKDL exports
- absent: an error for each name that it has beyond geometry
"""
