"""Record what Orocos' PyKDL answers, in `tests/golden/pykdl.jsonl`: run this beside it, as Debian's python3-pykdl.

Each line has an expression and its answer: numbers, a text (with "text"), or an error (with "error").
"""

from __future__ import annotations

import json
import math
import pickle
import random
import sys
from copy import copy, deepcopy

import PyKDL

RIGHT = "math.pi/2"
AXES = [
    "1,0,0",
    "0,1,0",
    "0,0,1",
    "1,1,0",
    "0,1,1",
    "1,0,1",
    "-1,1,0",
    "1,-1,1",
    "-1,-2,-3",
    "-3,1,1",
    "1,2,-3",
]
ANGLES = [
    "0",
    "4e-7",
    "6e-7",
    "1e-3",
    "1",
    "3",
    "math.pi-1e-7",
    "math.pi-1e-5",
    "math.pi",
    "math.pi+1e-8",
    "-math.pi",
    "4",
    "-1",
]


def number() -> str:
    return f"{random.uniform(-3, 3):.3f}"


def numbers(count: int) -> str:
    return ",".join(number() for _ in range(count))


def vector() -> str:
    return f"Vector({numbers(3)})"


def rotation() -> str:
    return f"Rotation.RPY({numbers(3)})"


def value(kind: str) -> str:
    return {
        "Vector": vector,
        "Rotation": rotation,
        "Frame": lambda: f"Frame({rotation()},{vector()})",
        "Twist": lambda: f"Twist({vector()},{vector()})",
        "Wrench": lambda: f"Wrench({vector()},{vector()})",
    }[kind]()


def of_rotations() -> list[str]:
    rotations = [f"Rotation.Rot(Vector({axis}),{angle})" for axis in AXES for angle in ANGLES]
    rotations += [rotation() for _ in range(20)]
    rotations += [
        f"Rotation.RPY({roll},{pitch},{yaw})"
        for pitch in (RIGHT, f"-{RIGHT}", f"{RIGHT}-1e-9", f"{RIGHT}+1e-4", "2")
        for roll, yaw in (("1", ".3"), ("-2", "2.5"), ("0", "0"))
    ]
    rotations += [
        f"Rotation.EulerZYZ(1,{beta},.3)" for beta in ("0", "1e-7", "1e-3", "1", "-1", "math.pi", "4")
    ]
    gets = ["GetRPY()", "GetEulerZYX()", "GetEulerZYZ()", "GetQuaternion()", "GetRot()", "GetRotAngle()"]
    found = [f"{rotation}.{get}" for rotation in rotations for get in gets]
    for _ in range(3):
        found += [f"Rotation.{make}({numbers(3)})" for make in ("RPY", "EulerZYX", "EulerZYZ")]
        found.append(f"Rotation.Quaternion({numbers(4)})")
        found.append(f"Rotation.Rot2({vector()},{number()})")
        found += [f"Rotation.Rot{axis}({number()})" for axis in "XYZ"]
        found += [f"{rotation()}.Unit{axis}()" for axis in "XYZ"]
        found += [f"changed({rotation()}, 'DoRot{axis}', {number()})" for axis in "XYZ"]
        found += [f"changed({rotation()}, 'Unit{axis}', {vector()})" for axis in "XYZ"]
    found.append(f"changed({rotation()}, 'SetInverse')")
    found += [
        "Rotation(1,2,3,4,5,6,7,8,9)",
        "Rotation(Vector(1,2,3),Vector(4,5,6),Vector(7,8,9))",
        "Rotation.Identity()",
    ]
    found += ["Rotation.Quaternion(0,0,0,0)", "Rotation.Rot(Vector(),1)", "Rotation.Rot2(Vector(),1)"]
    return found


def of_products() -> list[str]:
    found = []
    for _ in range(3):
        for by in ("Rotation", "Frame"):
            found += [f"{value(by)}*{value(kind)}" for kind in ("Vector", "Twist", "Wrench", by)]
            found += [f"{value(by)}.Inverse({value(kind)})" for kind in ("Vector", "Twist", "Wrench")]
            found.append(f"{value(by)}.Inverse()")
        found += [f"Frame.{make}({numbers(4)})" for make in ("DH", "DH_Craig1989")]
        found += [
            f"changed({value('Frame')}, 'Integrate', {value('Twist')}, {rate})" for rate in (1, 10, 1000)
        ]
        found.append(f"changed({value('Frame')}, 'Integrate', Twist({vector()},Vector(0,9e-6,0)), 10)")
        for kind in ("Twist", "Wrench"):
            found.append(f"{value(kind)}.RefPoint({vector()})")
        found += [f"dot({value('Twist')},{value('Wrench')})", f"dot({value('Wrench')},{value('Twist')})"]
        found += [f"dot({vector()},{vector()})", f"{vector()}*{vector()}"]
        for kind in ("Vector", "Twist", "Wrench"):
            found += [f"{value(kind)}{sign}{value(kind)}" for sign in "+-"]
            found += [f"{value(kind)}*{number()}", f"{number()}*{value(kind)}", f"{value(kind)}/{number()}"]
            found += [
                f"-{value(kind)}",
                f"changed({value(kind)}, 'ReverseSign')",
                f"{kind}.Zero()",
                f"zeroed({value(kind)})",
            ]
        for kind, velocity in (
            ("Vector", "Vector"),
            ("Rotation", "Vector"),
            ("Frame", "Twist"),
            ("Twist", "Twist"),
            ("Wrench", "Wrench"),
        ):
            found += [f"diff({value(kind)},{value(kind)}{dt})" for dt in ("", ",0.3", ",dt=2")]
            found += [f"addDelta({value(kind)},{value(velocity)}{dt})" for dt in ("", ",0.3", ",dt=2")]
    found += ["diff(Rotation(),Rotation.RotX(math.pi))", "diff(Rotation.RotZ(1),Rotation.RotZ(1))"]
    found += ["addDelta(Rotation(),Vector())", "diff(Vector(1,2,3),Vector(2,4,6),0)"]
    return found


def of_vectors() -> list[str]:
    found = ["Vector(1e-7,0,0).Norm()", "Vector(9e-7,9e-7,9e-7).Norm()", "Vector(1e-6,0,0).Norm()"]
    found += ["Vector(1e-7,0,0).Norm(0)", "Vector(1e-7,0,0).Norm(eps=1e-9)", "Vector(1e200,1e200,0).Norm()"]
    found += [f"{vector()}.Norm()" for _ in range(5)]
    for given in ("3,4,0", "0,0,0", "1e-7,0,0", "0,0,-2e-6", "1,2,3"):
        found += [f"Vector({given}).Normalize()", f"changed(Vector({given}), 'Normalize')"]
    found += [f"Vector(1,2,3).{axis}()" for axis in "xyz"] + [
        f"changed(Vector(1,2,3), '{axis}', 9)" for axis in "xyz"
    ]
    found += [
        "Vector(1,2,3)/0",
        "Vector(True,1,2)",
        "Vector(x=1,y=2,z=3)",
        "Vector(Vector(1,2,3))",
        "Vector(1,2,3)[2]",
    ]
    return found


def of_comparisons() -> list[str]:
    found = []
    for kind, parts in (("Vector", 3), ("Twist", 6), ("Wrench", 6)):
        for near in ("0.999e-6", "1e-6", "-0.999e-6", "float('nan')"):
            for index in range(parts):
                found.append(f"{kind}()==set_at({kind}(),{index},{near})")
                found.append(f"{kind}()!=set_at({kind}(),{index},{near})")
                found.append(f"Equal({kind}(),set_at({kind}(),{index},{near}))")
        found.append(f"Equal({value(kind)},{value(kind)},10)")
        found.append(f"Equal({value(kind)},{value(kind)},eps=.1)")
    for kind, columns in (("Rotation", 3), ("Frame", 4)):
        for near in ("0.999e-6", "1.001e-6"):
            for cell in ((i, j) for i in range(3) for j in range(columns)):
                changed = f"set_at({kind}(),{cell},{kind}()[{cell}]+{near})"
                found += [f"{kind}()=={changed}", f"{kind}()!={changed}", f"Equal({kind}(),{changed})"]
        found.append(f"Equal({value(kind)},{value(kind)},10)")
    found += ["Vector()==1", "Vector()!=None", "Twist()==Wrench()", "Rotation()==Frame()", "bool(Vector())"]
    return found


def of_texts() -> list[str]:
    found = [
        "repr(Vector(1e-7,123456.789,1e10))",
        "str(Vector(1,2,3))",
        "repr(Vector(float('nan'),-float('inf'),-0.0))",
    ]
    found += [f"repr({value(kind)})" for kind in ("Vector", "Rotation", "Frame", "Twist", "Wrench")]
    return [*found, "repr(type(Vector()))", "repr(Rotation()[1,1])", "repr(list(Twist()))"]


def of_mistakes() -> list[str]:
    found = ["Vector()[3]", "Vector()[-1]", "Vector()['a']", "Vector()[1.5]", "Twist()[6]", "Wrench()[-1]"]
    found += [
        "Rotation()[0]",
        "Rotation()[3,0]",
        "Rotation()[0,-1]",
        "Rotation()[0,3]",
        "Frame()[0,4]",
        "Frame()[3,3]",
    ]
    found += [
        "set_at(Vector(),3,1)",
        "set_at(Frame(),(3,0),1)",
        "set_at(Twist(),6,1)",
        "set_at(Rotation(),(0,3),1)",
    ]
    found += [
        "Vector(1,2)",
        "Vector('a',1,2)",
        "Vector([1,2,3])",
        "Vector(None)",
        "Twist(Vector())",
        "Frame(1)",
    ]
    found += [
        "hash(Vector())",
        "hash(Frame())",
        "len(Vector())",
        "len(Rotation())",
        "Vector()*'a'",
        "Frame()*'a'",
    ]
    found += [
        "Rotation()*2",
        "2*Rotation()",
        "Frame()+Frame()",
        "-Frame()",
        "Frame()@Frame()",
        "Vector()*Rotation()",
    ]
    found += [
        "Twist()*Wrench()",
        "Twist()*Vector()",
        "Vector()+1",
        "2/Vector(1,2,3)",
        "Vector()/Vector()",
        "[1]*Vector()",
    ]
    found += [
        "dot(Twist(),Twist())",
        "Equal(Rotation(),Vector())",
        "diff(Vector(),Twist())",
        "addDelta(Frame(),Vector())",
    ]
    found += [
        "SetToZero(Frame())",
        "SetToZero(Rotation())",
        "setattr(Frame(),'M',1)",
        "setattr(Frame(),'p',None)",
    ]
    found += ["PyKDL.epsilon", "list(Frame())", "Rotation.RotX()", "Rotation.RotX('a')", "Vector.Norm(1)"]
    return found


def of_copies() -> list[str]:
    found = []
    for kind in ("Vector", "Rotation", "Frame", "Twist", "Wrench"):
        found += [f"{copied}({value(kind)})" for copied in ("copy", "deepcopy", kind)]
        found.append(f"pickle.loads(pickle.dumps({value(kind)}))")
    found += [f"pickle.dumps({value(kind)},2)" for kind in ("Vector", "Twist", "Wrench")]
    found += [
        "written_to_parts()",
        "Frame(Vector(1,2,3))",
        "Frame(Rotation.RotX(1))",
        "Frame(Frame(Vector(1,2,3)))",
    ]
    return found


def changed(thing, method, *words):
    """Return a value after a method has changed it."""
    getattr(thing, method)(*words)
    return thing


def set_at(thing, index, number):
    """Return a value after one number is set."""
    thing[index] = number
    return thing


def zeroed(thing):
    """Return a value after SetToZero."""
    PyKDL.SetToZero(thing)
    return thing


def written_to_parts():
    """Write to parts of a frame, before and after the parts are replaced."""
    frame = PyKDL.Frame()
    frame.p[0] = 5
    frame.M.DoRotX(1)
    turn, place = frame.M, frame.p
    turn[0, 0] = 7
    frame.p = PyKDL.Vector(1, 1, 1)
    place[1] = 9
    frame.p += PyKDL.Vector(0, 0, 3)
    return frame


NAMES = {
    **{name: getattr(PyKDL, name) for name in ("Vector", "Rotation", "Frame", "Twist", "Wrench")},
    **{name: getattr(PyKDL, name) for name in ("SetToZero", "dot", "Equal", "diff", "addDelta")},
    **{
        function.__name__: function
        for function in (changed, set_at, zeroed, written_to_parts, math, pickle, copy, deepcopy, PyKDL)
    },
}


def flat(answer):
    """Return the numbers of an answer in order; None, if it has none."""
    if isinstance(answer, (int, float)):
        return [float(answer)]
    if isinstance(answer, (PyKDL.Rotation, PyKDL.Frame)):
        columns = 3 if isinstance(answer, PyKDL.Rotation) else 4
        return [answer[i, j] for i in range(3) for j in range(columns)]
    if isinstance(answer, (tuple, PyKDL.Vector, PyKDL.Twist, PyKDL.Wrench)):
        return [number for part in answer for number in flat(part)]
    return None


def answer_to(expression: str) -> dict:
    """Evaluate an expression, and return what a line of the file says of it."""
    try:
        answer = eval(expression, dict(NAMES))
    except Exception as error:  # noqa: BLE001, each is an answer
        text = str(error) if isinstance(error, IndexError) else ""
        return {"error": type(error).__name__, **({"says": text} if text else {})}
    kind = type(answer).__name__
    found = flat(answer)
    return {"text": str(answer)} if found is None else {"kind": kind, "numbers": found}


def main() -> None:
    """Write all lines to stdout."""
    random.seed(7)
    for group in (of_vectors, of_rotations, of_products, of_comparisons, of_texts, of_mistakes, of_copies):
        for expression in group():
            line = json.dumps({"expression": expression, **answer_to(expression)}, separators=(",", ":"))
            sys.stdout.write(line + "\n")


if __name__ == "__main__":
    main()
