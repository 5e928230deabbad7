"""The actions of launch_testing."""
