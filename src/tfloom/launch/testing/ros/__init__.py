"""What launch_testing_ros has: tests of launch descriptions with nodes and topics."""
