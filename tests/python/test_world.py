"""Worlds, simulations and scenes against brute force, closed forms and themselves."""

import gc
import json
import pathlib
import pickle
import subprocess
import sys
import threading
import weakref

import numpy as np
import pytest

import graze
from graze import plane

SCENES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "scenes"


def boxes(count=60, seed=1):
    rng = np.random.default_rng(seed)
    rows = np.column_stack([rng.uniform(-2, 2, (count, 3)), rng.normal(size=(count, 4))])
    rows[:, 3:] /= np.linalg.norm(rows[:, 3:], axis=1)[:, None]
    return graze.Box((1, 0.7, 0.4)), rows


def test_events_begin_stay_and_end():
    world = graze.World()
    floor = world.add(graze.HalfSpace(), fixed=True)
    ball = world.add(graze.Sphere(0.5), (0, 0.49, 0))
    kinds = []
    for height in (0.49, 0.48, 3.0):
        world.move(ball, (0, height, 0))
        world.update()
        kinds += [kind for kind, a, b, _ in world.events if {a, b} == {floor, ball}]
    assert kinds == ["begin", "stay", "end"]


def test_a_world_finds_what_touches_and_where():
    box, rows = boxes()
    world = graze.World(margin=0.05)
    ids = [world.add(box) for _ in rows]
    world.move_all(ids, rows)
    world.update()
    expected = [
        (i, j)
        for i in range(len(rows))
        for j in range(i + 1, len(rows))
        if graze.distance(box, rows[i], box, rows[j]).distance <= 0.05
    ]
    assert len(expected) > 50
    assert [tuple(p) for p in world.touching.tolist()] == expected
    pairs, manifolds, points = world.pairs, world.manifolds, world.points
    for pair in pairs:
        [alone] = graze.contacts(box, rows[pair["a"]], box, rows[pair["b"]], margin=0.05)
        assert pair["manifold_count"] == 1
        m = manifolds[pair["first_manifold"]]
        np.testing.assert_allclose(m["normal"], alone.normal, atol=1e-12)
        found = points[m["first_point"] : m["first_point"] + m["point_count"]]
        assert sorted(found["feature"].tolist()) == sorted(p.feature for p in alone.points)
        gap = found["b"] - found["a"] - found["distance"][:, None] * m["normal"]
        np.testing.assert_allclose(gap, 0, atol=1e-12)
    assert not points["impulse"].any()


def test_impulses_are_carried_on():
    world = graze.World()
    world.add(graze.HalfSpace(), fixed=True)
    box = world.add(graze.Box((1, 1, 1)), (0, 0.499, 0))
    world.update()
    given = np.arange(12.0).reshape(4, 3)
    world.set_impulses(given)
    world.move(box, (0.001, 0.499, 0))
    world.update()
    np.testing.assert_array_equal(np.sort(world.points["impulse"], axis=0), given)
    with pytest.raises(ValueError, match=r"impulses: expected 4 rows"):
        world.set_impulses(given[:2])


def test_questions_to_a_world_are_those_to_each_body():
    shape, rows = boxes(40, 2)
    world = graze.World()
    ids = [world.add(shape, row) for row in rows]
    probe, place = graze.Capsule(0.5, 0.3), (0.2, 0.1, -0.3)
    each = [graze.distance(probe, place, shape, row).distance for row in rows]
    assert world.overlapping(probe, place) == [i for i, d in zip(ids, each) if d <= 0]
    nearest = world.nearest(probe, place, count=7)
    assert [d.distance for _, d in nearest] == pytest.approx(sorted(each)[:7], abs=1e-9)
    rng = np.random.default_rng(3)
    for direction in rng.normal(size=(20, 3)):
        origin = -5 * direction / np.linalg.norm(direction)
        hits = [(h.t, i) for i, h in zip(ids, (graze.raycast(shape, r, origin, direction) for r in rows)) if h]
        found = world.raycast(origin, direction)
        assert (found is None) == (not hits) == (not world.raycast_any(origin, direction))
        if hits:
            assert found[1].t == pytest.approx(min(t for t, _ in hits), abs=1e-9)
            assert sorted(h.t for _, h in world.raycast_all(origin, direction)) == pytest.approx(
                sorted(t for t, _ in hits), abs=1e-9
            )
    body, hit = world.cast(graze.Sphere(0.1), (-9, 0, 0), (10, 0, 0))
    first = min(
        h.t
        for h in (graze.cast(graze.Sphere(0.1), (-9, 0, 0), (10, 0, 0), shape, r, (0, 0, 0)) for r in rows)
        if h
    )
    assert hit.t == pytest.approx(first, abs=1e-6) and body in world
    met = world.cast_all(graze.Sphere(0.1), (-9, 0, 0), (10, 0, 0))
    assert [(i, h.t) for i, h in met][0] == (body, hit.t) and [h.t for _, h in met] == sorted(h.t for _, h in met)
    alone = [graze.cast(graze.Sphere(0.1), (-9, 0, 0), (10, 0, 0), shape, r, (0, 0, 0)) for r in rows]
    assert sorted(i.index for i, _ in met) == [i.index for i, h in zip(ids, alone) if h]
    assert world.overlaps_any(probe, place) and not world.overlaps_any(probe, (9, 9, 9))


def test_a_shape_slides_along_what_is_in_its_way():
    world = graze.World()
    floor = world.add(graze.HalfSpace(), fixed=True)
    wall = world.add(graze.Box((1, 4, 8)), (3, 0, 0), fixed=True)
    ball = graze.Sphere(0.5)
    end, left, touched = world.slide(ball, (0, 2, 0), (4, -4, 1))
    np.testing.assert_allclose(end.translation, (2, 0.5, 1), atol=1e-5)
    np.testing.assert_allclose(left, 0, atol=1e-5)
    # Onto the floor, along it to the wall, and along both: the wall takes the motion that the floor had left.
    assert [body for body, _ in touched] == [floor, wall, floor]
    end, left, touched = world.slide(ball, (0, 2, 0), (4, -4, 1), casts=1)
    assert len(touched) == 1 and np.linalg.norm(left) > 1
    end, left, touched = world.slide(ball, (0, 2, 0), (1, 0, 0))
    np.testing.assert_array_equal(end.translation, (1, 2, 0))
    assert touched == []
    np.testing.assert_allclose(graze.along_planes((1, -1, -1), [(0, 1, 0), (0, 0, 1)]), (1, 0, 0), atol=1e-15)
    np.testing.assert_array_equal(graze.along_planes((1, 1, 0), [(0, 1, 0)]), (1, 1, 0))
    with pytest.raises(ValueError, match=r"normals\[1\]\[2\]"):
        graze.along_planes((1, 0, 0), [(0, 1, 0), (0, 1, np.inf)])
    for motion, casts, what in [((np.nan, 0, 0), 6, "motion"), ((1, 0, 0), 0, "casts: expected a number >= 1, got 0")]:
        with pytest.raises(ValueError, match=what):
            world.slide(ball, (0, 2, 0), motion, casts=casts)


def test_pairs_are_reduced_and_impacts_found_without_an_update():
    world = graze.World()
    wall = world.add(graze.Box((0.1, 5, 5)), fixed=True)
    world.add(graze.Box((1, 1, 1)), (0.5, 0, 0))
    bullet = world.add(graze.Sphere(0.05), (-3, 0, 0), linear=(100, 0, 0))
    world.update(0.1)
    assert len(world.points) == 4 and world.impacts == []
    world.reduce(2)
    [manifold] = world.manifolds
    assert len(world.points) == 2 and manifold["point_count"] == 2
    with pytest.raises(ValueError, match="count: expected a number >= 1, got 0"):
        world.reduce(0)
    world.set_fast(bullet, True)
    world.find_impacts(0.1)
    assert {wall, bullet} in [{a, b} for a, b, _, _ in world.impacts]
    with pytest.raises(ValueError, match="duration: expected a finite number >= 0, got -1"):
        world.find_impacts(-1)


def test_filters_triggers_and_fast_bodies():
    world = graze.World()
    wall = world.add(graze.Box((0.1, 5, 5)), fixed=True, filter=graze.Filter(category=2))
    bullet = world.add(graze.Sphere(0.05), (-3, 0, 0), linear=(100, 0, 0), fast=True)
    ghost = world.add(graze.Sphere(0.05), (-3, 1, 0), linear=(100, 0, 0), fast=True, filter=graze.Filter(mask=1))
    zone = world.add(graze.Sphere(1), (-3, 0, 0), trigger=True, fixed=True)
    world.update(0.1)
    [(a, b, hit, trigger)] = [i for i in world.impacts if not i[3]]
    assert {a, b} == {wall, bullet} and hit.t == pytest.approx(0.029, abs=1e-6) and not trigger
    assert [e[0] for e in world.events if e[3] and {e[1], e[2]} == {zone, bullet}] == ["begin"]
    assert ghost in world and len(world) == 4


def test_a_body_that_is_gone_is_named():
    world = graze.World()
    ball = world.add(graze.Sphere(1))
    world.remove(ball)
    assert ball not in world and len(world) == 0
    again = world.add(graze.Sphere(1))
    assert again.index == ball.index and again != ball
    for ask in (world.pose, world.shape, world.velocity, world.remove, lambda b: world.move(b, None)):
        with pytest.raises(ValueError, match="body"):
            ask(ball)
    before = world.pose(again)
    with pytest.raises(ValueError, match="body"):
        world.move_all([again, ball], [[1, 0, 0, 0, 0, 0, 1]] * 2)
    with pytest.raises(ValueError, match=r"poses\[0\]\.rotation"):
        world.move_all([again], [[1, 0, 0, 0, 0, 0, 0]])
    assert world.pose(again) == before
    with pytest.raises(ValueError, match="margin"):
        graze.World(margin=-1)


def test_a_body_falls_as_the_closed_form_says():
    simulation = graze.Simulation(gravity=(0, -10, 0))
    ball = simulation.add(graze.Sphere(0.5), (0, 100, 0))
    for _ in range(60):
        simulation.step(1 / 60)
    assert simulation.pose(ball).translation[1] == pytest.approx(95, abs=1e-9)
    assert simulation.velocity(ball)[0][1] == pytest.approx(-10, abs=1e-9)
    assert simulation.mass(ball) == pytest.approx(1000 * np.pi / 6)
    with pytest.raises(ValueError, match="mass"):
        simulation.add(graze.Sphere(1), mass=-1)
    with pytest.raises(ValueError):
        simulation.step(0)


def test_restitution_and_friction_are_the_materials():
    simulation = graze.Simulation(gravity=(0, -10, 0))
    rough = graze.Material(static_friction=0.5, dynamic_friction=0.5, friction_combine="multiply")
    smooth = graze.Material(static_friction=0, dynamic_friction=0, friction_combine="multiply")
    simulation.add(graze.HalfSpace(), fixed=True, material=graze.Material(static_friction=1, dynamic_friction=1))
    slides = simulation.add(graze.Box((1, 1, 1)), (0, 0.5, 0), linear=(1, 0, 0), material=smooth)
    stops = simulation.add(graze.Box((1, 1, 1)), (0, 0.5, 5), linear=(1, 0, 0), material=rough)
    for _ in range(60):
        simulation.step(1 / 60)
    assert simulation.velocity(slides)[0][0] == pytest.approx(1, abs=1e-6)
    # Coulomb: v^2 / (2 mu g) = 0.1
    assert simulation.pose(stops).translation[0] == pytest.approx(0.1, abs=0.02)
    assert {0, 1} in [set(pair) for pair in simulation.world.touching.tolist()]
    with pytest.raises(ValueError, match="friction_combine"):
        graze.Material(friction_combine="sum")


def test_a_box_comes_to_rest_and_a_state_comes_back():
    simulation = graze.Simulation()
    simulation.add(graze.HalfSpace(), fixed=True)
    box = simulation.add(graze.Box((1, 1, 1)), ((0, 2, 0), (0, 0, 0.1, 1)))
    saved, runs = simulation.save(), []
    for state in (saved, pickle.loads(pickle.dumps(saved))):
        simulation.restore(state)
        for _ in range(240):
            simulation.step(1 / 60)
        runs.append(simulation.poses)
    np.testing.assert_array_equal(runs[0], runs[1])
    assert simulation.pose(box).translation[1] == pytest.approx(0.5, abs=5e-3)
    assert simulation.asleep(box) and simulation.report["deepest"] < 5e-3
    simulation.add(graze.Sphere(1), (9, 9, 9))
    with pytest.raises(ValueError):
        simulation.restore(saved)


def test_equal_runs_have_equal_hashes_and_sub_steps():
    def pile():
        simulation = graze.Simulation()
        simulation.add(graze.HalfSpace(), fixed=True)
        return simulation, [simulation.add(graze.Box((1, 1, 1)), (0.1 * i, 0.5 + i, 0)) for i in range(4)]

    (a, boxes), (b, _) = pile(), pile()
    assert a.sub_steps(boxes[0]) == 0 and a.state_hash() == b.state_hash()
    for _ in range(20):
        a.step(1 / 60)
        b.step(1 / 60)
    assert a.state_hash() == b.state_hash()
    assert max(a.sub_steps(box) for box in boxes) == a.report["most_sub_steps"] >= 4
    b.apply_impulse(boxes[3], (1e-9, 0, 0), (0, 4, 0))
    assert a.state_hash() != b.state_hash()


def test_a_joint_is_read_back_and_joins_another_pair():
    simulation = graze.Simulation()
    a, b, c = [simulation.add(graze.Box((1, 1, 1)), (2 * i, 0, 0)) for i in range(3)]
    limits = [graze.JointLimit("linear", "yz"), graze.JointLimit("angular", "x", -0.5, 0.25, stiffness=30, damping=2)]
    drives = [graze.JointDrive("linear", "x", velocity_target=2, damping=7, max_force=5, acceleration=True)]
    first = simulation.join(a, (1, 0, 0), b, ((-1, 0, 0), (0, 0, 0.6, 0.8)), limits, drives, enable_collision=True)
    read = simulation.joint(first)
    assert (read["a"], read["b"], read["enable_collision"]) == (a, b, True)
    assert read["frame_b"] == graze.Pose((-1, 0, 0), (0, 0, 0.6, 0.8))
    tube, soft = read["limits"]
    assert (tube.space, tube.axes, tube.min, tube.max, tube.stiffness) == ("linear", "yz", 0, 0, None)
    assert (soft.space, soft.axes, soft.min, soft.max, soft.stiffness, soft.damping) == ("angular", "x", -0.5, 0.25, 30, 2)
    [motor] = read["drives"]
    assert (motor.space, motor.axis, motor.velocity_target, motor.damping) == ("linear", "x", 2, 7)
    assert (motor.position_target, motor.stiffness, motor.max_force, motor.acceleration) == (0, 0, 5, True)
    second = simulation.join(**{**read, "a": b, "b": c})
    assert simulation.joints() == [first, second] and simulation.joint(second)["b"] == c
    simulation.remove_joint(first)
    with pytest.raises(ValueError):
        simulation.joint(first)


@pytest.mark.parametrize(
    "join, keeps",
    [("fix", "all"), ("join_ball", "length"), ("join_hinge", "length"), ("join_distance", "length")],
)
def test_joints_hold(join, keeps):
    simulation = graze.Simulation(sleep=False)
    anchor = simulation.add(graze.Sphere(0.1), fixed=True)
    bob = simulation.add(graze.Sphere(0.1), (1, 0, 0), mass=1.0)
    if join == "join_distance":
        joint = simulation.join_distance(anchor, None, bob, None, 1.0, 1.0)
    else:
        # A turn about the frames' x axis is free: it lies along z.
        frame = (0, -np.sqrt(0.5), 0, np.sqrt(0.5))
        joint = getattr(simulation, join)(anchor, ((0, 0, 0), frame), bob, ((-1, 0, 0), frame))
    lowest = 0.0
    for _ in range(120):
        simulation.step(1 / 60)
        assert np.linalg.norm(simulation.pose(bob).translation) == pytest.approx(1, abs=1e-2)
        lowest = min(lowest, simulation.pose(bob).translation[1])
    assert lowest == pytest.approx(0 if keeps == "all" else -1, abs=2e-2)
    simulation.remove_joint(joint)
    with pytest.raises(ValueError):
        simulation.remove_joint(joint)


def test_a_view_keeps_its_simulation():
    view = graze.Simulation().world
    assert len(view) == 0 and view.events == []
    assert not hasattr(view, "add") and not hasattr(view, "update")


def test_another_thread_is_refused_while_a_step_runs():
    simulation = graze.Simulation(sleep=False)
    simulation.add(graze.HalfSpace(), fixed=True)
    bodies = [simulation.add(graze.Box((1, 1, 1)), (x, y + 0.5, 0)) for x in range(0, 60, 2) for y in range(20)]
    refused, answered = [], []

    def ask():
        while not done.is_set():
            try:
                answered.append(simulation.pose(bodies[0]))
            except RuntimeError as error:
                refused.append(str(error))

    done = threading.Event()
    other = threading.Thread(target=ask)
    other.start()
    steps = 0
    while steps < 20 and not refused:
        simulation.step(1 / 60)
        steps += 1
    done.set()
    other.join()
    assert set(refused) == {"in use: another call changes it at this moment"}
    simulation.step(1 / 60)


def meddling_shape(meddle):
    """A cube whose support function, once `armed`, calls `meddle` in the middle of whatever asks the shape."""

    def support(direction):
        if support.armed:
            meddle()
        return np.sign(direction)

    support.armed = False
    return support, graze.UserConvex(support)


@pytest.mark.parametrize("change", ["update", "move", "add", "remove", "set_shape"])
def test_a_world_is_not_changed_while_it_is_asked(change):
    world, told = graze.World(), []
    ball = world.add(graze.Sphere(1), (3, 0, 0))
    arguments = {"update": (), "move": (ball, None), "add": (ball_shape := graze.Sphere(1),), "remove": (ball,)}

    def meddle():
        try:
            getattr(world, change)(*arguments.get(change, (ball, ball_shape)))
        except RuntimeError as error:
            told.append((str(error), world.pose(ball).translation[0]))  # which may be read meanwhile

    support, probe = meddling_shape(meddle)
    support.armed = True
    [(body, d)] = world.nearest(probe)
    assert body == ball and d.distance == pytest.approx(1) and len(world) == 1
    assert told and set(told) == {("in use: another call reads it at this moment", 3.0)}


def test_a_world_is_not_used_while_it_is_updated():
    world, told = graze.World(), []
    ball = world.add(graze.Sphere(1), (1.5, 0, 0))

    def meddle():
        for use in (lambda: world.pose(ball), lambda: len(world), lambda: world.remove(ball), world.update):
            try:
                use()
            except RuntimeError as error:
                told.append(str(error))

    support, shape = meddling_shape(meddle)
    world.add(shape)
    support.armed = True
    world.update()
    support.armed = False
    assert world.touching.tolist() == [[0, 1]] and len(told) >= 4
    assert set(told) == {"in use: another call changes it at this moment"}
    assert len(world) == 2


def test_scenes_are_loaded_and_collided():
    scene = graze.load(SCENES / "demo.gltf")
    assert len(scene.colliders) > 3 and scene.bodies
    pairs = graze.collide(scene)
    assert pairs
    for a, b, manifolds in pairs:
        first, second = scene.colliders[a], scene.colliders[b]
        assert graze.overlap(first.shape, first.pose, second.shape, second.pose)
        d = graze.distance(first.shape, first.pose, second.shape, second.pose)
        assert min(p.distance for m in manifolds for p in m.points) <= d.distance + 1e-6
    with pytest.raises(ValueError, match="nowhere.gltf"):
        graze.load("nowhere.gltf")
    with pytest.raises(ValueError, match="colliders"):
        graze.load(SCENES / "demo.gltf", colliders="torus")
    with pytest.raises(ValueError, match="margin"):
        graze.collide(scene, margin=-1)


def test_the_protocol_answers():
    answer = json.loads(graze.answer('{"query": "closest", "a": {"shape": {"type": "box"}}, "point": [2, 0, 0]}'))
    assert answer["distance"] == 1.5
    assert "error" in json.loads(graze.answer("{}"))


def test_a_batch_takes_quaternions_of_single_precision_as_the_plane_does():
    _, rows = boxes(500, 4)
    single = rows.astype(np.float32).astype(np.float64)
    box = graze.Box((1, 1, 1))
    found = graze.batch.distance(box, single, graze.Sphere(0.5), None)["distance"]
    exact = [graze.distance(box, row, graze.Sphere(0.5), None).distance for row in rows]
    np.testing.assert_allclose(found, exact, atol=1e-5)
    single[3, 3:] *= 1.00001
    with pytest.raises(ValueError, match=r"poses_a\[3\]\.rotation: expected a quaternion of unit length"):
        graze.batch.distance(box, single, graze.Sphere(0.5), None)


SPACES = [(graze, graze.Sphere(0.5), 3), (plane, plane.Circle(0.5), 2)]


@pytest.mark.parametrize("of, ball, numbers", SPACES)
def test_the_last_word_on_pairs_and_bodies_is_a_function(of, ball, numbers):
    asked = []

    def allow(a, b):
        asked.append((a.index, b.index))
        return 2 not in (a.index, b.index)

    world = of.World(allow=allow)
    ids = [world.add(ball, (0.6 * i,) + (0,) * (numbers - 1)) for i in range(4)]
    world.update()
    assert sorted(asked) == [(0, 1), (1, 2), (2, 3)]
    assert world.touching.tolist() == [[0, 1]]
    world.set_allow(None)
    world.update()
    assert world.touching.tolist() == [[0, 1], [1, 2], [2, 3]]
    assert world.overlapping(ball, accept=lambda body: body != ids[0]) == [ids[1]]
    assert world.overlapping(ball, group=0) == ids[:2]
    origin, direction = (-9,) + (0,) * (numbers - 1), (1,) + (0,) * (numbers - 1)
    assert world.raycast(origin, direction, accept=lambda body: body.index >= 2)[0] == ids[2]
    assert [body for body, _ in world.nearest(ball, count=2, accept=lambda body: body.index != 1)] == [ids[0], ids[2]]
    assert world.cast(ball, origin, direction, 20, accept=lambda body: body.index == 3)[0] == ids[3]
    with pytest.raises(TypeError, match="allow: expected a function or None"):
        of.World(allow=3)
    with pytest.raises(TypeError, match="accept: expected a function or None"):
        world.overlapping(ball, accept="all")

    def broken(*_):
        raise KeyError("mine")

    for question in lambda: world.overlapping(ball, accept=broken), lambda: world.raycast_all(origin, direction, accept=broken):
        with pytest.raises(KeyError, match="mine"):
            question()
    world.set_allow(lambda a, b: world.remove(a))
    with pytest.raises(RuntimeError, match="in use"):
        world.update()
    world.set_allow(broken)
    with pytest.raises(KeyError, match="mine"):
        world.update()


def test_groups_of_questions():
    world = graze.World()
    own = world.add(graze.Sphere(0.5), filter=graze.Filter(group=-7))
    other = world.add(graze.Sphere(0.5), (0.5, 0, 0))
    assert world.overlapping(graze.Sphere(0.5)) == [own, other]
    assert world.overlapping(graze.Sphere(0.5), group=-7) == [other]
    assert world.overlapping(graze.Sphere(0.5), mask=0) == []


@pytest.mark.parametrize("of, ball", [(graze, graze.Sphere(1)), (plane, plane.Circle(1))])
def test_a_world_and_the_object_whose_method_decides_are_collected(of, ball):
    class Game:
        def __init__(self, later):
            self.world = of.World() if later else of.World(allow=self.allow)
            if later:
                self.world.set_allow(self.allow)
            self.world.add(ball), self.world.add(ball)
            self.world.update()

        def allow(self, a, b):
            gc.collect()  # the world is held by the call that asks
            return True

    class Own(of.World):
        pass

    def held_by_its_function():
        world = Own(allow=lambda a, b: world is not None)
        return weakref.ref(world)

    for later in (False, True):
        kept = Game(later)
        gone, lost = weakref.ref(Game(later)), held_by_its_function()
        gc.collect()
        assert gone() is None and lost() is None
        kept.world.update()
        assert kept.world.touching.tolist() == [[0, 1]]


@pytest.mark.parametrize("of, size", [(graze, 3), (plane, 2)])
def test_many_bodies_move_to_poses_of_any_form(of, size):
    ball = graze.Sphere(1) if of is graze else plane.Circle(1)
    world = of.World()
    bodies = [world.add(ball) for _ in range(3)]
    places = np.arange(3.0 * size).reshape(3, size)
    turned = of.Pose(places[1], (0, 0, 0.6, 0.8) if of is graze else 0.5)
    whole = np.array([of.Pose(place).matrix for place in places])
    for poses in (places, list(places), [tuple(place) for place in places], whole, [of.Pose(place) for place in places]):
        world.move_all(bodies, np.zeros((3, size)))
        world.move_all(bodies, poses)
        assert [world.pose(body).translation.tolist() for body in bodies] == places.tolist()
    world.move_all(bodies, [None, turned, places[2]])
    assert world.pose(bodies[0]) == of.Pose() and world.pose(bodies[1]) == turned
    for poses, error, message in [
        ([None, None, (float("nan"),) + (0,) * (size - 1)], ValueError, r"poses\[2\].translation\[0\]: expected a finite"),
        ([None, "x", None], TypeError, r"poses\[1\]: expected a pose"),
        ([None, None], ValueError, "poses: expected 3 rows, one for each body, got 2"),
        (5, TypeError, "poses: expected an array or a sequence of poses"),
    ]:
        with pytest.raises(error, match=message):
            world.move_all(bodies, poses)
    assert world.pose(bodies[1]) == turned


def test_pairs_that_another_thread_changes_meanwhile_were_read_before():
    """In a process of its own, which places far beyond the bodies ended."""
    program = """
import threading, time
import numpy as np, graze
ball, poses, pairs = graze.Sphere(1), np.zeros((10, 7)), np.zeros((500_000, 2), np.uint32)
poses[:, 6] = 1
done = []
def change():
    while not done:
        pairs[:] = 2**31
        pairs[:] = 3
thread = threading.Thread(target=change)
thread.start()
end = time.monotonic() + 1.5
while time.monotonic() < end:
    try:
        assert len(graze.batch.distance(ball, poses, ball, poses, pairs=pairs)) == len(pairs)
    except ValueError as error:
        assert "expected a place below 10" in str(error), error
done.append(True)
thread.join()
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


@pytest.mark.parametrize("of, ball, size", [(graze, graze.Sphere(1), 7), (plane, plane.Circle(1), 4)])
def test_a_world_tells_its_bodies_by_index(of, ball, size):
    world, filter = of.World(), graze.Filter(2, 5, -1)
    bodies = [world.add(ball, (3 * i,) + (0,) * (2 if of is graze else 1), filter=filter) for i in range(3)]
    world.remove(bodies[1])
    assert [world.body_at(i) for i in range(4)] == [bodies[0], None, bodies[2], None]
    assert world.body_at(2**32 - 1) is None
    assert world.bodies == [bodies[0], bodies[2]]
    with pytest.raises(ValueError, match="index: expected an integer from 0 to 4294967295, got -1"):
        world.body_at(-1)
    assert world.poses.shape == (3, size)
    assert world.poses[[0, 2], 0].tolist() == [0, 6]
    assert repr(world.filter(bodies[0])) == repr(filter)
    with pytest.raises(ValueError, match="body: expected a body of the world"):
        world.filter(bodies[1])
    empty = of.World().memory
    assert 0 <= empty < world.memory
    again = world.add(ball)
    assert (again.index, world.body_at(1)) == (1, again)
    assert world.bodies == [bodies[0], again, bodies[2]] and of.World().bodies == []
    world.update()
    assert [tuple(world.body_at(i) for i in pair) for pair in world.touching] == [(bodies[0], again)]


def test_filters_say_whether_two_bodies_may_collide():
    masks = [graze.Filter(category, mask, group) for category in (1, 2) for mask in (1, 2, 3) for group in (0, 1, -1)]
    for a in masks:
        for b in masks:
            meet = bool(a.category & b.mask and b.category & a.mask)
            expected = a.group > 0 if a.group == b.group != 0 else meet
            assert a.may_collide(b) == b.may_collide(a) == expected
