"""Many configurations of a chain of bodies, spread over the ranks of MPI, with a journal.

Needs mpi4py, and a graze that was built where MPI and Zoltan are (`scripts/setup.sh mpi` installs Debian's). All ranks
call the same with the same arguments, of a program that `mpirun` starts:

    mpirun -n 8 python3 -m mpi4py examples/python/many_poses.py poses.bin nearest.bin
"""

import math
import os

import numpy as np
from mpi4py import MPI

from . import _graze  # noqa: F401  its shapes and worlds are the arguments' types

try:
    from ._graze_mpi import CommonError
    from ._graze_mpi import sweep_configurations as _sweep
except ImportError as error:
    raise ImportError("this graze was built without MPI and Zoltan, so it has no graze.mpi") from error

__all__ = ["CommonError", "nearest", "sweep_configurations"]
nearest = np.dtype([("distance", "f8"), ("link", "u4"), ("other", "u4")])
CommonError.__module__ = "graze.mpi"
CommonError.__doc__ = """A fault that all ranks are told of, so that each can end in order; the message names the rank."""


def sweep_configurations(poses, out, links, scene, *, pairs=(), limit=math.inf, journal=None, name="", comm=None):
    """What is nearest in each of N configurations: of all links against all bodies of a scene, and of pairs of links.

    poses: a file that every rank can read, of N x links x 7 numbers: translation and quaternion (x, y, z, w) of each
    link in the world, as `numpy.ndarray.tofile` writes them of doubles.
    out: the file for the answers, written by all ranks: `numpy.fromfile(out, graze.mpi.nearest)` has for each
    configuration the signed distance, the link, and the other: a link, or behind all links the index of a body of the
    scene. inf where nothing is within the limit, nan where a pose is none.
    links: shapes, one for each pose of a configuration. scene: a `graze.World`, the same on every rank.
    pairs: links, by number, that must not touch each other either. limit: what is further is not looked at.
    journal: a directory that every rank can write, for what is done so far (default: `out` with ".journal" behind it).
    A sweep that was killed, by rank or as a whole, and is started again goes on where it was; the answers are those of
    one that was never killed. name: what the answers depend on besides, as the robot and the scene: a journal of
    another name is refused. comm: of mpi4py, by default all ranks.

    Returns a dict: configurations, errors (poses that are none), and on rank 0 chunks, those that the journal had
    (remembered), and the chunks and seconds of each rank (by_rank, busy). Raises `CommonError` on every rank for what
    is wrong from the start, and RuntimeError on the one that cannot read or write later on: `python3 -m mpi4py` then
    ends the others. Answers are byte for byte the same for any number of ranks. Cost: a query of the scene for each
    link and a distance for each pair, handed out in chunks to whoever is done.
    """
    comm = MPI.COMM_WORLD if comm is None else comm
    return _sweep(comm.py2f(), os.fspath(poses), os.fspath(out), os.fspath(journal or ""), name, list(links),
                  [tuple(pair) for pair in pairs], scene, limit)
