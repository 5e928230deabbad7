"""The transform between two frames over time, as a picture."""
