"""Interactive markers on pages: dragged, clicked, and asked for their menus.

- gizmos: what pages drag, as nodes of viser's scene
- grabs: where a marker goes when a page drags a shape of its own
- markers_feed: the display of a namespace of markers, with its ends on the graph
- dragging: who drags which marker, and what its server is told of it
"""
