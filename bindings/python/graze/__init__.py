"""Collision detection: do these things touch, where, how deep, how far apart, and when.

Lengths, times and masses are in whatever units you use; everything is in double precision. A pose
is a `Pose`, a pair (translation, quaternion x y z w), seven numbers, a 4x4 matrix, a translation
alone, or None for the origin. Normals point from a to b; distances are negative where shapes
overlap. Bad values raise ValueError, which names them.

>>> import graze
>>> graze.distance(graze.Box((2, 2, 2)), None, graze.Sphere(0.5), (3, 0, 0)).distance
1.5
"""

from . import _graze
from ._graze import *  # noqa: F401,F403
from ._graze import __version__, batch  # noqa: F401
from . import plane  # noqa: F401

__all__ = [name for name in dir(_graze) if not name.startswith("_")]

for _name in __all__:
    _thing = getattr(_graze, _name)
    if isinstance(_thing, type):
        _thing.__module__ = "graze"
del _name, _thing


def _make_shape(name, arguments):
    """The shape of a pickle: its class and the arguments that make it anew."""
    return getattr(_graze, name)(**arguments)
