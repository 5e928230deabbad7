"""The interfaces of object_recognition_msgs."""
