"""A tree of frames as pictures: a graph if it is small enough to be read as one, else an indented table."""

from __future__ import annotations

from tfloom.tf2_tools.drawing.shapes import Picture
from tfloom.tf2_tools.tree_pictures.graph import Graph
from tfloom.tf2_tools.tree_pictures.table import one_page, pages
from tfloom.tf2_tools.tree_pictures.tree import FrameTree

GRAPH_SIZE = (1130.0, 780.0)
"""The longer and the shorter side of the largest graph that can be read at once: an A3 page, in points."""
GRAPH_FRAMES = 60
"""A larger tree is not tried as a graph."""
A4 = (595.3, 841.9)
"""Points."""


def draw_page(tree: FrameTree) -> Picture:
    """Return the tree on one page."""
    return _graph(tree) or one_page(tree)


def draw_pages(tree: FrameTree) -> list[Picture]:
    """Return the tree for printing: one page for a graph, or a table on pages of A4."""
    graph = _graph(tree)
    return [graph] if graph else pages(tree, A4)


def _graph(tree: FrameTree) -> Picture | None:
    """Return a small tree as a graph; None if it is larger than `GRAPH_SIZE`."""
    if len(tree.frames) > GRAPH_FRAMES:
        return None
    graph = min((Graph(tree, sideways=sideways) for sideways in (False, True)), key=Graph.unwieldiness)
    longer, shorter = max(graph.width, graph.height), min(graph.width, graph.height)
    return graph.picture() if longer <= GRAPH_SIZE[0] and shorter <= GRAPH_SIZE[1] else None
