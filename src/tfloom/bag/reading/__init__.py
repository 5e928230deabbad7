"""Reading of bags: their files in MCAP, sqlite3 and ROS 1's format, and decompression.

- bag_file: which form a file has
- mcap_*, sqlite_reader, ros1_*: one form each
- message_order: the order of chunks that overlap in time
- compression, file_bytes: bytes, limited by declared sizes
"""
