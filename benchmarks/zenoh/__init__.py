"""The wire on Zenoh beside the one on DDS."""
