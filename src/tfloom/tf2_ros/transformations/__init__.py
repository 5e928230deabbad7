"""The functions of tf_transformations: matrices, quaternions, projections, and the arcball."""
