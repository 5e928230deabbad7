"""The names available after `import tf2_ros` alone."""

from __future__ import annotations

import tf2_py
import tf2_ros

from tfloom.tf2_ros import buffer, transform_listener


def test_submodules_are_imported_with_the_package() -> None:
    assert tf2_ros.buffer.Buffer is tf2_ros.Buffer is buffer.Buffer
    assert tf2_ros.transform_listener.TransformListener is transform_listener.TransformListener
    assert tf2_ros.static_transform_listener.StaticTransformListener is tf2_ros.StaticTransformListener
    assert (tf2_ros.transform_listener.DEFAULT_TF_TOPIC, tf2_ros.DEFAULT_STATIC_TF_TOPIC) == (
        "/tf",
        "/tf_static",
    )


def test_exceptions_have_a_common_base() -> None:
    assert tf2_ros.LookupException is tf2_py.LookupException
    assert tf2_py.LookupException.__module__ == "tf2"
    assert issubclass(tf2_ros.ExtrapolationException, tf2_ros.TransformException)
    assert issubclass(tf2_ros.Buffer, tf2_py.BufferCore)


def test_names_leaked_by_the_reference_exist() -> None:
    assert all(hasattr(tf2_ros, name) for name in ("Time", "Duration", "TransformStamped", "Header"))
