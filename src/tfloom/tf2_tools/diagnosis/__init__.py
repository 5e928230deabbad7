"""Checks of the transforms on a graph or in a bag: `tfloom tf doctor`."""
