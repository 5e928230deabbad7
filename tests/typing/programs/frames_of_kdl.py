"""Geometry of PyKDL: each product and part has its type."""

import PyKDL
import tf2_kdl
from geometry_msgs.msg import TransformStamped

frame = PyKDL.Frame(PyKDL.Rotation.RPY(0.1, 0.2, 0.3), PyKDL.Vector(1, 2, 3))
x: float = frame.p.x() + frame.p[0] + frame.M[0, 1]
roll, pitch, yaw = frame.M.GetRPY()
angle, axis = frame.M.GetRotAngle()
v: PyKDL.Vector = frame * PyKDL.Vector() + axis * angle + 2 * axis
t: PyKDL.Twist = frame * PyKDL.Twist()
f: PyKDL.Frame = frame * frame.Inverse()
f.p = v
moved = tf2_kdl.do_transform_vector(v, TransformStamped())
print(moved.header.frame_id, PyKDL.diff(frame, f).vel, PyKDL.dot(v, v) + 1.0, list(v), PyKDL.Equal(v, v))
for n in v:
    x += n
v += v
v.z(3.0)
PyKDL.SetToZero(v)
