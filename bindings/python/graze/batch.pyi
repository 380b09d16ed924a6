"""Written by scripts/write_python_stubs.py from the module: do not edit."""

import os
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import BodyId, Box, BroadPhase, Capsule, CapturedSimulation, CapturedState, CapturedWorld, CastHit, Closest, Collider, Compound, ContactPoint, ConvexHull, Cylinder, Distance, Ellipsoid, Filter, HalfSpace, HeightField, JointDrive, JointId, JointLimit, Manifold, Material, Mesh, Pose, RayHit, Rectangle, Scene, Segment, Shape, ShapeArray, Simulation, Sphere, State, Triangle, UserConvex, World, WorldView, PoseLike

def contacts(a: Any, poses_a: Any, b: Any, poses_b: Any, margin: float = 0.0, pairs: Any = None) -> tuple: ...
def distance(a: Any, poses_a: Any, b: Any, poses_b: Any, pairs: Any = None) -> NDArray[Any]: ...
def overlap(a: Any, poses_a: Any, b: Any, poses_b: Any, pairs: Any = None) -> NDArray[Any]: ...
