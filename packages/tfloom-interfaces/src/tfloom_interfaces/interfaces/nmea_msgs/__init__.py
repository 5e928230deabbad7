"""The interfaces of nmea_msgs."""
