"""KDL's vectors, rotations, frames, twists and wrenches, as PyKDL has them; compiled in `native/kdl/`."""
