"""The words of graze in two dimensions: shapes, poses and questions of the plane.

A pose is a `Pose`, a pair (translation, angle), two numbers (a translation), three (x, y, angle),
four (x, y, cosine, sine), a 3x3 matrix, or None for the origin. Angles are in radians,
counter-clockwise. Normals point from a to b; distances are negative where shapes overlap.

>>> from graze import plane
>>> plane.distance(plane.Box((2, 2)), None, plane.Circle(0.5), (3, 0)).distance
1.5
"""

import sys as _sys

from .._graze import _plane
from .._graze._plane import *  # noqa: F401,F403
from .._graze._plane import batch  # noqa: F401

__all__ = [name for name in dir(_plane) if not name.startswith("_")]
_sys.modules[__name__ + ".batch"] = batch
