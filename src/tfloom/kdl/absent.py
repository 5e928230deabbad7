"""What PyKDL has beyond geometry, and tfloom has not: an error for each name that says so."""

from __future__ import annotations

__all__ = ["__getattr__"]

_VELOCITIES = {"FrameVel", "RotationVel", "TwistVel", "VectorVel", "doubleVel"}
_CHAINS = {
    "Add",
    "Chain",
    "ChainDynParam",
    "ChainFkSolverPos",
    "ChainFkSolverPos_recursive",
    "ChainFkSolverVel",
    "ChainFkSolverVel_recursive",
    "ChainIdSolver",
    "ChainIdSolver_RNE",
    "ChainIkSolverPos",
    "ChainIkSolverPos_LMA",
    "ChainIkSolverPos_NR",
    "ChainIkSolverPos_NR_JL",
    "ChainIkSolverVel",
    "ChainIkSolverVel_pinv",
    "ChainIkSolverVel_pinv_givens",
    "ChainIkSolverVel_pinv_nso",
    "ChainIkSolverVel_wdls",
    "ChainJntToJacDotSolver",
    "ChainJntToJacSolver",
    "Divide",
    "Jacobian",
    "JntArray",
    "JntArrayVel",
    "JntSpaceInertiaMatrix",
    "Joint",
    "Multiply",
    "MultiplyJacobian",
    "RigidBodyInertia",
    "RotationalInertia",
    "Segment",
    "SolverI",
    "Subtract",
    "Tree",
    "changeBase",
    "changeRefPoint",
}
_HERE = "it has Vector, Rotation, Frame, Twist, Wrench, and their functions"


def __getattr__(name: str) -> object:
    """Raise AttributeError, with what to use instead of a name of the original PyKDL."""
    if name in _CHAINS:
        raise AttributeError(
            f"tfloom's PyKDL has no {name}: {_HERE}. "
            "For the forward kinematics of a URDF, use tfloom.robot; for solvers and dynamics, install Orocos' PyKDL"
        )
    if name in _VELOCITIES:
        raise AttributeError(
            f"tfloom's PyKDL has no {name}: {_HERE}. Keep a value and its Twist, and use diff and addDelta"
        )
    raise AttributeError(f"module 'PyKDL' has no attribute {name!r}")
