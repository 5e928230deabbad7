"""The interfaces of geographic_msgs."""
