"""A robot's poses, answered by all ranks: which of many configurations of an arm are free?

    mpirun -n 4 python3 -m mpi4py examples/python/many_poses.py poses.bin nearest.bin [COUNT]

writes COUNT random poses (20,000) if poses.bin is not there, and what is nearest in each to nearest.bin. Ranks that are
done take the next chunk, so that a slow one holds up nobody. Killed and started again, the sweep goes on where it was,
by as many ranks as one likes: what is done stands in nearest.bin.journal until all is. Needs python3-mpi4py and a graze
that was built with MPI.
"""
import os
import sys

import numpy as np
from mpi4py import MPI

import graze
import graze.mpi

LENGTH, LINKS = 0.5, 5


def arm():
    """Capsules along Y, each from its joint on, and the pairs of them that are no neighbours."""
    pairs = [(k, i) for i in range(LINKS) for k in range(i - 1)]
    return [graze.Capsule(LENGTH, 0.06)] * LINKS, pairs


def room():
    """A floor, and posts around the arm."""
    world = graze.World()
    world.add(graze.HalfSpace(), (0, -0.1, 0), fixed=True)
    for i in range(24):
        angle, away = 0.7 * i, 0.6 + 0.07 * i
        world.add(graze.Box((0.1, 0.4 + 0.1 * (i % 7), 0.1)), (away * np.cos(angle), 0.3, away * np.sin(angle)), fixed=True)
    world.update()
    return world


def random_poses(count):
    """Of each link the middle and the rotation, in the world; each link turns about X and Y of the one before."""
    half = np.random.default_rng(1).uniform(-0.75, 0.75, (count, LINKS, 2))
    sine, cosine = np.sin(half), np.cos(half)
    poses, joint, turn = np.empty((count, LINKS, 7)), np.zeros((count, 3)), np.tile([0.0, 0, 0, 1], (count, 1))
    nothing = np.zeros(count)
    for i in range(LINKS):
        for axis, parts in enumerate(((sine[:, i, 0], nothing, nothing), (nothing, sine[:, i, 1], nothing))):
            turn = product(turn, np.stack((*parts, cosine[:, i, axis]), -1))
        along = LENGTH * turned(turn, np.array([0.0, 1, 0]))
        poses[:, i, :3], poses[:, i, 3:] = joint + along / 2, turn
        joint = joint + along
    return poses


def product(p, q):
    xyz = p[:, 3:] * q[:, :3] + q[:, 3:] * p[:, :3] + np.cross(p[:, :3], q[:, :3])
    return np.column_stack((xyz, p[:, 3] * q[:, 3] - np.sum(p[:, :3] * q[:, :3], axis=1)))


def turned(q, v):
    return v + 2 * np.cross(q[:, :3], np.cross(q[:, :3], v) + q[:, 3:] * v)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit("many_poses.py POSES NEAREST [COUNT]")
    if MPI.COMM_WORLD.rank == 0 and not os.path.exists(sys.argv[1]):
        random_poses(int(sys.argv[3]) if len(sys.argv) > 3 else 20000).tofile(sys.argv[1])
    MPI.COMM_WORLD.Barrier()
    links, pairs = arm()
    report = graze.mpi.sweep_configurations(sys.argv[1], sys.argv[2], links, room(), pairs=pairs, name="arm 1")
    if MPI.COMM_WORLD.rank == 0:
        nearest = np.fromfile(sys.argv[2], graze.mpi.nearest)
        print(f"{np.count_nonzero(nearest['distance'] > 0)} of {len(nearest)} poses are free; "
              f"{report['remembered']} of {report['chunks']} chunks were in the journal")
