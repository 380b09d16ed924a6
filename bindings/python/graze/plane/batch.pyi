from collections.abc import Iterable
from typing import Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import Threads
from . import PoseLike, Shape

Shapes = Union[Shape, Iterable[Shape]]
Poses = Union[PoseLike, Iterable[PoseLike]]

def overlap(
    a: Shapes, poses_a: Poses, b: Shapes, poses_b: Poses,
    pairs: ArrayLike | None = None, threads: Threads | int | None = None
) -> NDArray[np.bool_]: ...
def distance(
    a: Shapes, poses_a: Poses, b: Shapes, poses_b: Poses,
    pairs: ArrayLike | None = None, threads: Threads | int | None = None
) -> NDArray[np.void]: ...
def contacts(
    a: Shapes,
    poses_a: Poses,
    b: Shapes,
    poses_b: Poses,
    margin: float = 0.0,
    pairs: ArrayLike | None = None,
    most: int | None = None,
    threads: Threads | int | None = None,
) -> tuple[NDArray[np.void], NDArray[np.void], NDArray[np.void]]: ...
def near_pieces(
    a: Shapes, poses_a: Poses, b: Shapes, poses_b: Poses, margin: float,
    pairs: ArrayLike | None = None, threads: Threads | int | None = None
) -> tuple[NDArray[np.void], NDArray[np.uint64]]: ...
def closest(
    shape: Shape, pose: PoseLike, points: ArrayLike, threads: Threads | int | None = None
) -> NDArray[np.void]: ...
def raycast(
    shape: Shape, pose: PoseLike, origins: ArrayLike, directions: ArrayLike, length: float = ...,
    threads: Threads | int | None = None,
) -> NDArray[np.void]: ...
def raycast_any(
    shape: Shape, pose: PoseLike, origins: ArrayLike, directions: ArrayLike, length: float = ...,
    threads: Threads | int | None = None,
) -> NDArray[np.bool_]: ...
def cast(
    a: Shapes,
    poses_a: Poses,
    linear_a: ArrayLike,
    b: Shapes,
    poses_b: Poses,
    linear_b: ArrayLike,
    duration: float = 1.0,
    angular_a: ArrayLike = 0.0,
    angular_b: ArrayLike = 0.0,
    ignore_separating: bool = False,
    pairs: ArrayLike | None = None,
    threads: Threads | int | None = None,
) -> NDArray[np.void]: ...
