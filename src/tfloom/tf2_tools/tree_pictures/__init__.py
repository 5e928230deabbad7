"""A tree of frames as pictures and texts: what `view_frames` writes."""
