"""The kinematics of a robot: from the positions of its joints to the poses of its links, many at once."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeAlias

from tfloom._native import JointChain
from tfloom.robot.description import Description, Joint, variables_of
from tfloom.robot.joint_tree import from_root
from tfloom.robot.mimicry import Dependence, followers
from tfloom.robot.urdf import parse_urdf

if TYPE_CHECKING:
    from os import PathLike

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from tfloom.tf2.buffer import Buffer

__all__ = ["RobotModel", "joint_form"]

JointForm: TypeAlias = "tuple[str, tuple[float, ...], tuple[float, float, float]]"
"""Type, origin (7 numbers) and axis of a joint, for native code."""


def joint_form(joint: Joint) -> JointForm:
    """Return what native code takes of a joint."""
    return joint.type, (*joint.origin.translation, *joint.origin.rotation_xyzw), joint.axis


class RobotModel:
    """A robot whose links' poses are computed from positions of its joints.

    A pose is a row of seven numbers: translation x, y, z [m], rotation x, y, z, w (unit quaternion).

    Attributes:
        description: What the URDF says.
        joints: The joints in order from the root; parents come before children.
        links: Names of the links: the root, then the child of each of `joints`.
        variables: Names of the position variables, in the order of the columns of arrays. A joint has one of its own
            name: [rad], or [m] for prismatic joints. Planar joints have `name/x`, `name/y`, `name/theta`; floating ones
            `name/trans_x`, `…_y`, `…_z`, `name/rot_x`, `…_y`, `…_z`, `…_w`. Fixed joints have none, and mimic joints
            use the one of the joint that they follow.

    All methods may be called from any thread.
    """

    def __init__(self, description: Description) -> None:
        self.description = description
        self.joints: tuple[Joint, ...] = tuple(from_root(description))
        self.links: tuple[str, ...] = (description.root, *(joint.child for joint in self.joints))
        self._followers = followers(description.joints)
        self._columns: dict[str, int] = {}
        names: list[str] = []
        for joint in self.joints:
            if joint.name not in self._followers:
                self._columns[joint.name] = len(names)
                names += variables_of(joint)
        self.variables: tuple[str, ...] = tuple(names)

    @classmethod
    def from_urdf(cls, urdf: str | bytes | PathLike[str]) -> RobotModel:
        """Return the model of a URDF.

        Args:
            urdf: The description as a str or bytes, if it begins with `<` after blanks; else the path of its file.

        Raises:
            UrdfError: it is not a valid description; the message has the line.
            OSError: the file can't be read.

        Warns:
            UserWarning: it can be read, but is not as it should be.
        """
        if not isinstance(urdf, (str, bytes)) or urdf.lstrip()[:1] not in {"<", b"<", "\ufeff", b"\xef"}:
            from pathlib import Path

            urdf = Path(urdf.decode() if isinstance(urdf, bytes) else urdf).read_bytes()
        description = parse_urdf(urdf)
        for remark in description.remarks:
            warnings.warn(str(remark), stacklevel=2)
        return cls(description)

    def forward(self, positions: ArrayLike | Mapping[str, ArrayLike]) -> NDArray[np.float64]:
        """Return the pose of each link in the root link, root_from_link, at many positions.

        Args:
            positions: (N, J), a column for each of `variables`; or (J,). Or a mapping from names of variables to
                arrays (N,) or numbers; those that are not named are at 0, a floating joint at the identity.

        Returns:
            (N, L, 7), in the order of `links`; (L, 7) for positions of shape (J,), or of numbers alone.

        Raises:
            TypeError, ValueError: the positions have the wrong type or shape.
            KeyError: a name is none of `variables`.
        """
        return self._fill(self._chain.fill_links, len(self.links), positions)

    def joint_transforms(self, positions: ArrayLike | Mapping[str, ArrayLike]) -> NDArray[np.float64]:
        """Return parent_from_child of each of `joints` at many positions.

        Args:
            positions: As for `forward`.

        Returns:
            (N, K, 7), in the order of `joints`; (K, 7) as for `forward`.

        Raises:
            TypeError, ValueError, KeyError: as `forward`.
        """
        return self._fill(self._chain.fill_joints, len(self.joints), positions)

    def matrices(self, positions: ArrayLike | Mapping[str, ArrayLike]) -> NDArray[np.float64]:
        """Return what `forward` does as matrices: (N, L, 4, 4), or (L, 4, 4)."""
        import numpy as np

        from tfloom import _native

        poses = self.forward(positions)
        out = np.empty((*poses.shape[:-1], 4, 4))
        _native.matrices(poses.reshape(-1, 7), out.reshape(-1, 4, 4))
        return out

    def store(
        self,
        buffer: Buffer,
        stamps_ns: ArrayLike,
        positions: ArrayLike | Mapping[str, ArrayLike],
        *,
        frame_prefix: str = "",
        authority: str = "",
    ) -> int:
        """Store the transforms of all joints at many times in a buffer; those of fixed joints as static ones.

        Args:
            buffer: Where they are stored.
            stamps_ns: (N,) integers or datetime64 [ns since epoch].
            positions: (N, J), or a mapping, as for `forward`.
            frame_prefix: Text before each link's name in the names of frames.
            authority: Name of the publisher.

        Returns:
            Number of stored transforms; the others were rejected, for the reasons of `Buffer.set`.

        Raises:
            TypeError, ValueError, KeyError: as `forward` and `Buffer.set_many`; nothing is stored.
        """
        import numpy as np

        stamps = np.asarray(stamps_ns)
        transforms = self.joint_transforms(positions)
        if transforms.ndim == 2:
            transforms = np.broadcast_to(transforms, (len(np.atleast_1d(stamps)), *transforms.shape))
        if stamps.shape != transforms.shape[:1]:
            raise ValueError(f"stamps_ns must be of shape ({len(transforms)},), not {stamps.shape}")
        stored = 0
        for index, joint in enumerate(self.joints):
            frames = frame_prefix + joint.parent, frame_prefix + joint.child
            if joint.type == "fixed":
                stored += buffer.set(
                    *frames, 0, joint.origin.translation, joint.origin.rotation_xyzw, authority, True
                )
            else:
                rows = transforms[:, index]
                stored += buffer.set_many(*frames, stamps, rows[:, :3], rows[:, 3:], authority)
        return stored

    def columns_of(self, names: Sequence[str]) -> list[int]:
        """Return the column of each named variable.

        Raises:
            KeyError: a name is none of `variables`; the text has those that there are.
        """
        columns = {name: index for index, name in enumerate(self.variables)}
        if unknown := [name for name in names if name not in columns]:
            raise KeyError(
                f"no such position variable: {', '.join(unknown)}; there are: {', '.join(columns)}"
            )
        return [columns[name] for name in names]

    @cached_property
    def _chain(self) -> JointChain:
        links = {link: index for index, link in enumerate(self.links)}
        rows = []
        for joint in self.joints:
            source, factor, offset = self._followers.get(joint.name, Dependence(joint.name))
            rows.append((joint_form(joint), links[joint.parent], self._columns[source], factor, offset))
        return JointChain(rows, len(self.variables))

    def _fill(
        self, fill: Any, poses: int, positions: ArrayLike | Mapping[str, ArrayLike]
    ) -> NDArray[np.float64]:
        import numpy as np

        array = self._from_names(positions) if isinstance(positions, Mapping) else _numbers(positions)
        if array.ndim not in {1, 2} or array.shape[-1] != len(self.variables):
            wanted = f"(N, {len(self.variables)}) or ({len(self.variables)},)"
            raise ValueError(f"positions must be of shape {wanted}, not {array.shape}; see `variables`")
        rows = np.ascontiguousarray(np.atleast_2d(array))
        out = np.empty((len(rows), poses, 7))
        fill(rows, out)
        return out if array.ndim == 2 else out[0]

    def _from_names(self, positions: Mapping[str, ArrayLike]) -> NDArray[np.float64]:
        import numpy as np

        columns = self.columns_of(list(positions))
        values = [_numbers(value) for value in positions.values()]
        shape = np.broadcast_shapes(*(value.shape for value in values))
        array = np.zeros((*shape, len(self.variables)))
        for index, name in enumerate(self.variables):
            if name.endswith("/rot_w"):
                array[..., index] = 1.0
        for column, value in zip(columns, values, strict=True):
            array[..., column] = value
        return array


def _numbers(values: ArrayLike) -> NDArray[np.float64]:
    import numpy as np

    array = np.asarray(values)
    if array.size and array.dtype.kind not in "fiu":
        raise TypeError(f"positions must be numbers, not {array.dtype}")
    return array.astype(np.float64, copy=False)
