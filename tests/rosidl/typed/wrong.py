"""Each line with `# error: CODE` must be an error for a type checker, and no other line."""

from geometry_msgs.msg import Twist, Vector3
from std_msgs.msg import String
from turtlesim.srv import Spawn

twist = Twist(linear=3)  # error: arg-type
twist.linear.q = 1.0  # error: attr-defined
twist.linear.x = "abc"  # error: assignment
vector = Vector3(1.0, 2.0, 3.0)  # error: call-arg
string = String(dta="x")  # error: call-arg
number: int = String().data  # error: assignment
request = Spawn.Request(x="1")  # error: arg-type
