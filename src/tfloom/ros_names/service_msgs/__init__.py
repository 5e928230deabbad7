"""The interfaces of service_msgs."""
