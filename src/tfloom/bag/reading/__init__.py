"""Reading of bags: their files in MCAP, sqlite3 and ROS 1's format, and decompression."""
