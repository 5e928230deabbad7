"""The interfaces of controller_manager_msgs."""
