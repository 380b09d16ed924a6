"""Collision detection: do these things touch, where, how deep, how far apart, and when.

Lengths, times and masses are in whatever units you use; everything is in double precision. A pose
is a `Pose`, a pair (translation, quaternion x y z w), seven numbers, a 4x4 matrix, a translation
alone, or None for the origin. Normals point from a to b; distances are negative where shapes
overlap. Bad values raise ValueError, which names them.

>>> import graze
>>> graze.distance(graze.Box((2, 2, 2)), None, graze.Sphere(0.5), (3, 0, 0)).distance
1.5
"""

import sys as _sys

from . import _graze
from ._graze import *  # noqa: F401,F403
from ._graze import __version__, batch  # noqa: F401
from . import plane  # noqa: F401

_sys.modules[__name__ + ".batch"] = batch  # a module of its own for `import graze.batch`

__all__ = [name for name in dir(_graze) if not name.startswith("_")]


def _reduce(self, protocol):
    """A pickle by protocol 2 at least. The older ones make a bare object of pybind11's base class, which ends Python."""
    return object.__reduce_ex__(self, max(protocol, 2))


for _module in (_graze, _graze._plane):
    for _thing in vars(_module).values():
        if isinstance(_thing, type):
            _thing.__reduce_ex__ = _reduce
            if _module is _graze:
                _thing.__module__ = "graze"
del _module, _thing


def _make_shape(name, arguments):
    """The shape of a pickle: its class and the arguments that make it anew."""
    return getattr(_graze, name)(**arguments)
