"""Tests of launch descriptions: launch_testing's room; `fixtures/` is launch_pytest's, `ros/` launch_testing_ros's."""
