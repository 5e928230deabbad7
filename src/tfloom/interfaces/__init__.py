"""The interfaces that come with tfloom, generated from `tfloom/rosidl/definitions`: one file a package and kind."""
