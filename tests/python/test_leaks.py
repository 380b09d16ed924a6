"""What is made and dropped leaves nothing behind.

Counted is what is in use, the allocator's bytes and the interpreter's blocks, and not resident memory, in whose holes a
leak may hide for long. Something that leaks grows in every round of equal work, what caches and lists keep only in some:
of several rounds the one that grew least has to have grown by less than a small part of any object.
"""

import ctypes
import gc
import pathlib
import sys

import numpy as np
import pytest

import graze
from graze import plane

ROUNDS = 6
BYTES = 16  # that a repetition may leave behind: less than any object of the library takes


class Mallinfo(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in
                ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")]


try:
    mallinfo = ctypes.CDLL(None).mallinfo2
    mallinfo.restype = Mallinfo
except (AttributeError, OSError, TypeError):
    pytestmark = pytest.mark.skip(reason="the C library does not tell what is in use")


def in_use():
    """Bytes of the C library's allocator, and of the interpreter's own: a block has at least 16."""
    gc.collect()
    info = mallinfo()
    return info.uordblks + info.hblkhd + 16 * sys.getallocatedblocks()


def least_growth(make, times):
    """The growth of the round that grew least, in bytes a repetition. Two rounds before fill caches."""
    grown = []
    for i in range(ROUNDS + 2):
        before = in_use()
        for _ in range(times):
            make()
        if i >= 2:
            grown.append((in_use() - before) / times)
    return min(grown)


POINTS = np.random.default_rng(1).normal(size=(30, 3))
GRID = np.random.default_rng(2).normal(size=(8, 8))
ROWS = np.array([[0, 0, 0, 0, 0, 0, 1.0], [1, 0, 0, 0, 0, 0, 1.0]])
ROWS_2D = np.array([[0, 0, 1.0, 0], [1, 0, 1.0, 0]])
BALL, BOX = graze.Sphere(1), graze.Box((1, 1, 1))
DISC, SQUARE = plane.Circle(1), plane.Box((1, 1))


def support(direction):
    return np.sign(direction)


def shapes():
    graze.Box((1, 2, 3)), graze.Sphere(1), graze.Capsule(2, 1), graze.Cylinder(2, 1), graze.Triangle((0, 0, 0), (1, 0, 0), (0, 1, 0))
    graze.ConvexHull(POINTS), graze.HeightField(GRID)
    graze.Mesh(POINTS[:4], [(0, 1, 2), (0, 2, 3)])
    graze.Compound([(graze.Box((1, 1, 1)), None), (graze.Sphere(1), (2, 0, 0))])
    graze.UserConvex(support)
    graze.ShapeArray.boxes(np.ones((4, 3)))[1]


def shapes_of_the_plane():
    plane.Box((1, 2)), plane.Circle(1), plane.Capsule(2, 1), plane.Polygon([(0, 0), (2, 0), (1, 2)])
    plane.Compound([(plane.Box((1, 1)), None)]), plane.Chain([(0, 0), (1, 0), (2, 1)])


def questions():
    graze.overlap(BALL, None, BOX, (1, 0, 0), trace=True)
    graze.distance(BALL, None, BOX, (3, 0, 0)), graze.contacts(BALL, None, BOX, (1, 0, 0))
    graze.raycast(BALL, None, (-3, 0, 0), (1, 0, 0)), graze.closest(BALL, None, (3, 0, 0))
    graze.cast(BALL, None, (1, 0, 0), BOX, (4, 0, 0), (0, 0, 0))
    plane.distance(DISC, None, SQUARE, (3, 0)), plane.contacts(DISC, None, SQUARE, (1, 0))


def batches():
    graze.batch.overlap(BALL, None, BOX, ROWS), graze.batch.distance([BALL, BOX], ROWS, BOX, ROWS)
    graze.batch.contacts(BALL, None, BOX, ROWS), graze.batch.compact_contacts(BALL, None, BOX, ROWS)
    graze.batch.raycast(BALL, None, POINTS, (1, 0, 0)), graze.batch.near_pieces(BALL, None, BOX, ROWS, 1)
    plane.batch.distance(DISC, None, SQUARE, ROWS_2D, threads=2)


def worlds():
    world = graze.World(allow=lambda a, b: True)
    bodies = [world.add(BALL, (0.5 * i, 0, 0)) for i in range(4)]
    world.update(), world.events, world.points, world.pose(bodies[0])
    world.raycast((-9, 0, 0), (1, 0, 0), accept=lambda body: True)


def worlds_of_the_plane():
    world = plane.World(points_per_pair=2)
    for i in range(4):
        world.add(plane.Polygon([(0, 0), (2, 0), (1, 2)]), (0.5 * i, 0))
    world.update(), world.points, world.events


def simulations():
    for kit, floor, shape, at in (
        (graze, graze.HalfSpace(), BOX, (0, 0.4, 0)), (plane, plane.HalfPlane(), SQUARE, (0, 0.4))
    ):
        simulation = kit.Simulation()
        ground = simulation.add(floor, fixed=True)
        body = simulation.add(shape, at)
        simulation.join(ground, None, body, None, [graze.JointLimit("linear", "x")])
        simulation.step(1 / 60)
        kept = simulation.save()
        simulation.restore(kept)
        simulation.world.touching, simulation.report


def threads():
    simulation = graze.Simulation(threads=2)
    simulation.step(1 / 60)
    graze.World(threads=graze.Threads(2)).update()


def errors():
    for ask in (
        lambda: graze.Box((1, -2, 1)), lambda: graze.Box("box"), lambda: graze.overlap(BALL, None, BOX, (np.nan, 0, 0)),
        lambda: graze.Mesh(POINTS[:3], [(0, 1, 9)]), lambda: plane.Circle(-1), lambda: graze.load("nowhere.glb"),
        lambda: graze.batch.overlap(BALL, None, BOX, np.full((2, 7), 5.0)), lambda: graze.Threads(0),
        lambda: graze.UserConvex(raising),
    ):
        with pytest.raises((ValueError, TypeError, ArithmeticError)):
            ask()


def raising(_):
    raise ArithmeticError("of a support function")


class HoldsWorld:
    """A cycle through a world: the function that decides is a method of the object that has the world."""

    def __init__(self):
        self.world = graze.World(allow=self.allow)
        self.weight = bytearray(1000)

    def allow(self, a, b):
        return a.index < b.index


class HoldsShape:
    """A cycle through a shape whose support function is a method of the object that has the shape."""

    def __init__(self):
        self.shape = graze.UserConvex(self.support)
        self.weight = bytearray(1000)

    def support(self, direction):
        return np.sign(direction)


def drawings():
    class Lines:
        def line(self, a, b, layer, meaning):
            pass

    graze.draw(Lines(), BOX, None), graze.tessellate(BOX), plane.tessellate(DISC)


def scenes():
    scene = graze.load(SCENES / "demo.gltf", animations=True)
    graze.simulate(scene, lambda frame: None, seconds=0.1), graze.collide(scene)


SCENES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "scenes"


@pytest.mark.parametrize(
    ("make", "times"),
    [(shapes, 400), (shapes_of_the_plane, 1500), (questions, 400), (batches, 800), (worlds, 500), (worlds_of_the_plane, 500),
     (simulations, 300), (threads, 200), (errors, 400), (HoldsWorld, 2000), (HoldsShape, 2000), (drawings, 500), (scenes, 10)],
    ids=lambda value: getattr(value, "__name__", None),
)
def test_memory_stays_flat(make, times):
    assert least_growth(make, times) < BYTES


def test_small_answers_do_not_keep_the_memory_of_large_ones():
    large = np.repeat(ROWS[:1], 20000, axis=0)
    held = []

    def ask():
        graze.batch.distance(BALL, None, BOX, large)
        held.append(graze.batch.distance(BALL, None, BOX, ROWS))

    assert least_growth(ask, 20) < 2000


def test_captures_leave_nothing(tmp_path):
    def capture():
        file = tmp_path / "fall.capture"
        simulation = graze.CapturedSimulation(file)
        simulation.add(BALL, (0, 9, 0))
        simulation.step(1 / 60)
        simulation.restore(simulation.save())
        del simulation
        graze.replay(file, lambda frame, poses: None)

    assert least_growth(capture, 200) < BYTES


def test_a_leak_is_seen():
    kept = []
    assert least_growth(lambda: kept.append(graze.Box((1, 2, 3))), 3000) >= BYTES
