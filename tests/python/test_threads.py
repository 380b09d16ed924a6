"""Worlds, simulations and batches on several threads: the same bits, and the same errors."""

import os
import threading

import numpy as np
import pytest

import graze
from graze import plane

COUNT = 3000


def poses(seed, reach=12.0):
    random = np.random.default_rng(seed)
    rows = random.normal(size=(COUNT, 7))
    rows[:, :3] *= reach / 3
    rows[:, 3:] /= np.linalg.norm(rows[:, 3:], axis=1, keepdims=True)
    return rows


def rows_of_plane(seed):
    random = np.random.default_rng(seed)
    angle = random.uniform(-3, 3, COUNT)
    return np.stack([*random.uniform(-4, 4, (2, COUNT)), np.cos(angle), np.sin(angle)], axis=1)


SHAPES = [graze.Box((1, 2, 3)), graze.Sphere(1.5), graze.Capsule(2, 0.5), graze.Cylinder(1, 1),
          graze.ConvexHull(np.random.default_rng(5).normal(size=(20, 3))),
          graze.Compound([(graze.Box((1, 1, 1)), None), (graze.Sphere(1), (2, 0, 0))])]
SHAPES_2D = [plane.Box((1, 2)), plane.Circle(1), plane.Capsule(2, 0.5), plane.Polygon([(0, 0), (3, 0), (3, 1), (1, 2)])]


def cases(kit, shapes, place, zero):
    """Batches of one box and many shapes, of boxes alone, and of pairs by index."""
    many = (shapes * COUNT)[:COUNT]
    boxes = [shapes[0]] * COUNT
    index = np.random.default_rng(9).integers(0, COUNT, (2 * COUNT + 7, 2))
    return {
        "one and many": (shapes[0], None, many, place(1), {}),
        "boxes": (boxes, place(1), boxes, place(2), {}),
        "by index": (many, place(1), many, place(2), {"pairs": index}),
    }


def same(a, b):
    if isinstance(a, tuple):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    if a.dtype.names is None:
        return np.array_equal(a, b)
    # Bytes between fields mean nothing.
    return a.shape == b.shape and all(a[name].tobytes() == b[name].tobytes() for name in a.dtype.names)


def pair_by_pair(found):
    """Contacts in the order of pairs: manifolds of different pairs may stand in any."""
    pairs, manifolds, points = found
    out = [pairs["overlap"].tobytes()]
    for pair in pairs:
        for m in manifolds[pair["first_manifold"] : pair["first_manifold"] + pair["manifold_count"]]:
            of_it = points[m["first_point"] : m["first_point"] + m["point_count"]]
            out.append([m[name].tobytes() for name in ("normal", "piece_a", "piece_b")])
            out.append([of_it[name].tobytes() for name in of_it.dtype.names])
    return out


@pytest.mark.parametrize("case", ["one and many", "boxes", "by index"])
@pytest.mark.parametrize("kit", [graze, plane], ids=["space", "plane"])
def test_batches_have_the_same_bits(kit, case):
    in_plane = kit is plane
    a, at, b, there, more = cases(kit, SHAPES_2D if in_plane else SHAPES, rows_of_plane if in_plane else poses, 0)[case]
    zero, way = ((0, 0), (1, -2)) if in_plane else ((0, 0, 0), (1, -2, 0.5))
    ask = kit.batch
    threads = graze.Threads(3)
    for question in (
        lambda **how: ask.overlap(a, at, b, there, **more, **how),
        lambda **how: ask.distance(a, at, b, there, **more, **how),
        lambda **how: ask.near_pieces(a, at, b, there, 0.5, **more, **how),
        lambda **how: ask.cast(a, at, zero, b, there, way, duration=2, **more, **how),
    ):
        alone = question()
        assert same(alone, question(threads=threads)) and same(alone, question(threads=2))
    for most in ({}, {"most": 2}):
        question = lambda **how: pair_by_pair(ask.contacts(a, at, b, there, margin=0.1, **most, **more, **how))  # noqa: E731, B023
        alone = question()
        assert len(alone) > 100 and alone == question(threads=threads) == question(threads=2)
    origins = np.random.default_rng(3).normal(size=(COUNT, len(zero))) * 5
    for question in (
        lambda **how: ask.raycast(b[0], None, origins, way, **how),
        lambda **how: ask.raycast_any(b[0], None, origins, way, **how),
        lambda **how: ask.closest(b[0], None, origins, **how),
    ):
        alone = question()
        assert same(alone, question(threads=threads)) and same(alone, question(threads=1))


def test_compact_contacts_are_the_same_pair_by_pair():
    def sorted_by_pair(found):
        manifolds, points = found
        assert (np.diff(manifolds["first_point"].astype(int)) >= 0).all()
        out = []
        for m in manifolds[np.argsort(manifolds["pair"], kind="stable")]:
            of_it = points[m["first_point"] : m["first_point"] + m["point_count"]]
            out.append((int(m["pair"]), m["normal"].tobytes(), of_it["position"].tobytes(), of_it["distance"].tobytes()))
        return out

    boxes = graze.ShapeArray.boxes(np.full((COUNT, 3), 3.0))
    ask = lambda **how: graze.batch.compact_contacts(boxes, poses(1), boxes, poses(2), **how)  # noqa: E731
    alone = sorted_by_pair(ask())
    assert len(alone) > 100 and alone == sorted_by_pair(ask(threads=3))


def test_no_pairs_and_one():
    nothing = np.zeros((0, 7))
    assert len(graze.batch.overlap(SHAPES[0], None, [], nothing, threads=4)) == 0
    assert graze.batch.overlap(SHAPES[0], None, SHAPES[1], None, threads=4).tolist() == [True]


def pile(simulation, kit):
    """Bodies that fall onto each other."""
    random = np.random.default_rng(2)
    if kit is plane:
        simulation.add(plane.HalfPlane(), fixed=True)
        for i in range(60):
            simulation.add(SHAPES_2D[i % 3], (random.uniform(-3, 3), 1 + 0.7 * i), mass=1)
    else:
        simulation.add(graze.HalfSpace(), fixed=True)
        for i in range(60):
            simulation.add(SHAPES[i % 3], (random.uniform(-2, 2), 1 + 0.7 * i, random.uniform(-2, 2)), mass=1)
    return simulation


@pytest.mark.parametrize("kit", [graze, plane], ids=["space", "plane"])
def test_simulations_have_the_same_bits(kit, tmp_path):
    threads = graze.Threads(2)
    all_of_them = [
        pile(made, kit)
        for made in (kit.Simulation(), kit.Simulation(threads=4), kit.Simulation(threads=threads),
                     kit.CapturedSimulation(tmp_path / "pile.capture", threads=threads))
    ]
    for _ in range(90):
        for simulation in all_of_them:
            simulation.step(1 / 60)
    assert len({simulation.state_hash() for simulation in all_of_them}) == 1
    del all_of_them
    assert graze.replay(tmp_path / "pile.capture")["difference"] is None


@pytest.mark.parametrize("kit", [graze, plane], ids=["space", "plane"])
def test_worlds_have_the_same_bits(kit, tmp_path):
    shapes, place = (SHAPES_2D, rows_of_plane) if kit is plane else (SHAPES[:4], poses)
    worlds = [kit.World(), kit.World(threads=3), kit.CapturedWorld(tmp_path / "world.capture", threads=2)]
    for world in worlds:
        for i, pose in enumerate(place(4)[:300]):
            world.add(shapes[i % len(shapes)], pose)
        world.update()
    first, *others = worlds
    assert len(first.touching) > 50
    for world in others:
        assert np.array_equal(first.touching, world.touching) and same(first.points, world.points)


def test_other_values_are_refused():
    for make in (graze.Threads, lambda n: graze.World(threads=n), lambda n: plane.Simulation(threads=n)):
        for count in (0, -1, 1025, 2**70):
            with pytest.raises(ValueError, match=f"^threads: expected a number from 1 to 1024, got {count}$"):
                make(count)
        with pytest.raises(TypeError):
            make("two")
    with pytest.raises(ValueError, match="threads"):
        graze.batch.overlap(SHAPES[0], None, SHAPES[1], None, threads=0)
    assert repr(graze.Threads(2)) == "graze.Threads(2)" and graze.Threads(2).count == 2
    with pytest.raises(ValueError, match=r"poses_b\[2999\]\.rotation"):
        rows = poses(1)
        rows[-1, 3:] = 3
        graze.batch.overlap(SHAPES[0], None, SHAPES[1], rows, threads=2)


class Refusal(Exception):
    pass


def refusing(*_):
    raise Refusal("no")


def test_what_functions_raise_on_threads_is_raised_by_the_call():
    refuses = []
    shape = graze.UserConvex(lambda direction: refusing() if refuses else np.sign(direction))
    refuses.append(True)
    for _ in range(3):
        with pytest.raises(Refusal):
            graze.batch.overlap(shape, None, [SHAPES[0]] * COUNT, poses(1, 1.0), threads=3)
    world = graze.World(allow=refusing, threads=3)
    for pose in poses(1, 1.0)[:200]:
        world.add(SHAPES[0], pose)
    with pytest.raises(Refusal):
        world.update()
    refuses.clear()
    simulation = graze.Simulation(threads=3)
    for i in range(20):
        simulation.add(shape if i % 2 else SHAPES[0], (0, 0.5 * i, 0), mass=1, inertia=(1, 1, 1), center_of_mass=(0, 0, 0))
    refuses.append(True)
    with pytest.raises(Refusal):
        simulation.step(1 / 60)


def test_functions_are_called_on_threads():
    ball = graze.UserConvex(lambda d: np.asarray(d) / np.linalg.norm(d))
    at = poses(1, 6.0)[:200]
    alone = graze.batch.overlap(ball, None, [SHAPES[0]] * 200, at)
    assert 0 < alone.sum() < 200
    assert np.array_equal(alone, graze.batch.overlap(ball, None, [SHAPES[0]] * 200, at, threads=3))


def test_calls_that_meet_share_threads():
    """From two threads of Python, and from within a task: whoever finds the threads at work does without."""
    threads = graze.Threads(2)
    expected = graze.batch.overlap(SHAPES[0], None, SHAPES[1], poses(1))
    wrong = []

    def ask():
        for _ in range(50):
            if not np.array_equal(expected, graze.batch.overlap(SHAPES[0], None, SHAPES[1], poses_once, threads=threads)):
                wrong.append(True)

    poses_once = poses(1)
    askers = [threading.Thread(target=ask) for _ in range(4)]
    for asker in askers:
        asker.start()
    for asker in askers:
        asker.join()
    assert not wrong

    def support(direction):
        graze.batch.overlap(SHAPES[0], None, SHAPES[1], poses_once[:50], threads=threads)
        return np.sign(direction)

    cube = graze.UserConvex(support)
    graze.batch.overlap(cube, None, SHAPES[0], poses_once[:20], threads=threads)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_process_does_without_its_parents_threads():
    threads = graze.Threads(3)
    ask = lambda: graze.batch.overlap(SHAPES[0], None, SHAPES[1], poses(1), threads=threads)  # noqa: E731
    expected = ask()
    child = os.fork()
    if child == 0:
        status = 1
        try:
            status = 0 if np.array_equal(expected, ask()) else 1
            del threads, ask
        finally:
            os._exit(status)
    assert os.waitpid(child, 0)[1] == 0 and np.array_equal(expected, ask())
