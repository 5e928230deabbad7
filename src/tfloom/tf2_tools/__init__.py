"""The programs of tf2: printing, monitoring, drawing, serving and publishing transforms.

- echo, monitor, static_publisher, view_frames, buffer_server: the programs

- text: counts, times and transforms in words
- static_transform, static_file: static transforms as a command line, as a YAML file
- watch/: transforms as they are published, live or recorded; the tools below read these observations
- tree_pictures/: of view_frames: records, the tree with the health of its edges, graph or table, web page
- drawing/: shapes, fonts, layout of trees, as PDF, SVG and PNG
- lookups/: why one succeeds or fails: chain, time-line, advice
- diagnosis/: checks, and the catalogue of what they find
- top/: the tree in a terminal
- motion, chart: the transform between two frames over time, as a picture
"""
