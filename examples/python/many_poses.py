"""A robot's poses, spread over ranks by mpi4py: which of many configurations of an arm are free?

    mpirun -n 4 python3 -m mpi4py examples/python/many_poses.py [poses.npy]

Rank 0 hands out blocks of configurations and the others answer them: who is done takes the next block, so that a slow
one holds up nobody, and the answers come back in the order of the poses. Without mpirun one process answers all. A block
is asked in one call a link, `graze.batch.distance`: every pose of the link against every body of the room.

`poses.npy` is an array of N x links x 7 numbers, translations and rotations (x, y, z, w); without it random ones. Needs
Debian's python3-mpi4py.
"""
import sys

import numpy as np
from mpi4py import MPI
from mpi4py.futures import MPICommExecutor

import graze

LINK = graze.Capsule(0.5, 0.06)
LINKS = 5
BLOCK = 256  # configurations a message: some milliseconds of work


def room():
    """Posts around the arm: shapes, and where they stand."""
    angles, away = 0.7 * np.arange(24), 0.6 + 0.07 * np.arange(24)
    shapes = [graze.Box((0.1, 0.4 + 0.1 * (i % 7), 0.1)) for i in range(24)]
    poses = np.zeros((24, 7))
    poses[:, 0], poses[:, 1], poses[:, 2], poses[:, 6] = away * np.cos(angles), 0.3, away * np.sin(angles), 1
    return shapes, poses


def random_poses(count):
    """Links one behind the other, each turned by random angles against the one before."""
    dice = np.random.default_rng(1)
    poses = np.empty((count, LINKS, 7))
    for pose in poses:
        start, turn = np.zeros(3), np.array([0.0, 0, 0, 1])
        for link in pose:
            bend = np.append(np.sin(dice.uniform(-0.7, 0.7, 3)) * 0.6, 1)
            turn = product(turn, bend / np.linalg.norm(bend))
            along = 0.5 * turned(turn, np.array([0.0, 1, 0]))
            link[:3], link[3:] = start + along / 2, turn
            start = start + along
    return poses


def product(p, q):
    xyz = p[3] * q[:3] + q[3] * p[:3] + np.cross(p[:3], q[:3])
    return np.append(xyz, p[3] * q[3] - p[:3] @ q[:3])


def turned(q, v):
    return v + 2 * np.cross(q[:3], np.cross(q[:3], v) + q[3] * v)


def clearances(block):
    """The least distance from any link to any post, of each configuration; negative where they overlap."""
    shapes, stands = room()
    links, posts = len(block) * LINKS, len(shapes)
    which = np.stack(np.meshgrid(np.arange(links), np.arange(posts), indexing="ij"), -1).reshape(-1, 2)
    found = graze.batch.distance([LINK] * links, block.reshape(-1, 7), shapes, stands, pairs=which)
    return found["distance"].reshape(len(block), -1).min(axis=1)


def all_clearances(poses, comm=MPI.COMM_WORLD):
    """Those of all configurations in their order, on rank 0; None on the others."""
    with MPICommExecutor(comm, root=0) as ranks:
        if ranks is None:
            return None
        blocks = [poses[i : i + BLOCK] for i in range(0, len(poses), BLOCK)]
        return np.concatenate(list(ranks.map(clearances, blocks)))


if __name__ == "__main__":
    asked = None
    if MPI.COMM_WORLD.rank == 0:
        asked = np.load(sys.argv[1]) if len(sys.argv) > 1 else random_poses(2000)
    nearest = all_clearances(asked)
    if nearest is not None:
        print(f"{np.count_nonzero(nearest > 0)} of {len(nearest)} poses are free; the nearest miss is "
              f"{nearest[nearest > 0].min():.6f}")
