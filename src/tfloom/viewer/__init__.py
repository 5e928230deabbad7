"""Frames, robots and sensors in a browser: `tfloom view`, by viser, which the extra `view` installs.

- frames, camera, playback, shapes: what is shown, without viser
- displays/: from a message to shapes, a file for each kind
- topic_log: the messages of one topic, from which displays, plots and the slider read
- topics, topic_reader, recorded: those of a graph, or of a recording
- feed, replay: what a display shows of them
- obstacles: why it shows nothing, as a sentence
- shared_state: what all pages share, and what follows of it
- drawing, scene, scene_server, viser_private: viser's scene and server
- page_scenes, page_camera, labels, picking, measuring: what of the scene is each page's own: how its camera moves,
  which names it shows, what its pointer is at, and what it measures
- mesh_files, textures, mesh_places: files of meshes and of what is on them, and where they are
- extents: how far shapes reach, for cameras
- joints, published_joints: joints that pages move, those of a file or those that this process publishes
- described: a robot of a file, without a graph
- page_server, page_command: the server of our page, and what it is asked for
- interactive/: interactive markers, dragged and clicked
- forms/: what pages publish, call and send as goals, by forms made from any type
- driving/: velocities, by a separate process, which stops robots whose page or viewer is gone
- plots/: numeric fields of topics over time
- layout/: what is shown from the start, of our files or RViz's
- tools, log_lines, parameters, node_graph, pictures: what is beside the scene
- inline, inline_page, extra: the page in a notebook; whether the extra is installed
- program, live, live_only: the loop, and what it needs of a graph
"""
