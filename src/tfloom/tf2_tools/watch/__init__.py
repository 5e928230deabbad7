"""Transforms as they are published: by which node, how often, how late, and what is wrong with them."""
