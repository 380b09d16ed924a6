"""Worlds of the plane against brute force over each body, and what they refuse."""

import math
import pathlib

import numpy as np
import pytest

import graze
from graze import plane

SHAPES = [
    plane.Circle(0.4),
    plane.Capsule(0.5, 0.2, 0.3),
    plane.Box((0.8, 0.5), rounding=0.05),
    plane.Ellipse((0.5, 0.3)),
    plane.Polygon([(0, 0), (0.9, 0.1), (0.8, 0.7), (0.3, 0.2), (-0.4, 0.6)]),
    plane.Chain([(-0.5, 0), (0, 0.3), (0.5, 0)]),
    plane.Compound([(plane.Circle(0.2), (0.3, 0)), (plane.Box((0.4, 0.2)), ((-0.3, 0), 0.3))]),
]


def crowd(count=80, seed=1, reach=3.0):
    """A world of many bodies, and of each its handle, its shape and its pose as a row."""
    rng = np.random.default_rng(seed)
    angle = rng.uniform(-math.pi, math.pi, count)
    rows = np.column_stack([rng.uniform(-reach, reach, (count, 2)), np.cos(angle), np.sin(angle)])
    world = plane.World(margin=0.05)
    shapes = [SHAPES[i % len(SHAPES)] for i in range(count)]
    ids = [world.add(shape) for shape in shapes]
    world.move_all(ids, rows)
    return world, ids, shapes, rows


def test_a_world_finds_what_touches_and_where():
    world, ids, shapes, rows = crowd()
    world.update()
    poses = [world.pose(body) for body in ids]  # rotations of unit length to the last bit
    np.testing.assert_allclose([p.rotation for p in poses], rows[:, 2:], atol=1e-15)
    alone = {
        (i, j): plane.contacts(shapes[i], poses[i], shapes[j], poses[j], margin=0.05)
        for i in range(len(shapes))
        for j in range(i + 1, len(shapes))
    }
    expected = [
        (i, j) for i, j in alone if plane.distance(shapes[i], poses[i], shapes[j], poses[j]).distance <= 0.05
    ]
    assert len(expected) > 100
    assert [tuple(p) for p in world.touching.tolist()] == expected
    manifolds, points = world.manifolds, world.points
    for pair in world.pairs:
        first = pair["first_manifold"]
        found = manifolds[first : first + pair["manifold_count"]]
        assert len(found) == len(alone[pair["a"], pair["b"]])
        for m, manifold in zip(found, alone[pair["a"], pair["b"]]):
            np.testing.assert_array_equal(m["normal"], manifold.normal)
            row = points[m["first_point"] : m["first_point"] + m["point_count"]]
            assert row["distance"].tolist() == [p.distance for p in manifold.points]
            np.testing.assert_array_equal(row["a"], [p.a for p in manifold.points])
    assert points["impulse"].shape == (len(points), 2) and not points["impulse"].any()


def test_questions_to_a_world_are_those_to_each_body():
    world, ids, shapes, rows = crowd(seed=2)
    rng = np.random.default_rng(3)
    probe = plane.Capsule(0.5, 0.3)
    for place in rng.uniform(-3, 3, (10, 2)):
        each = [plane.distance(probe, place, s, r).distance for s, r in zip(shapes, rows)]
        assert world.overlapping(probe, place) == [i for i, d in zip(ids, each) if d <= 0]
        assert [d.distance for _, d in world.nearest(probe, place, count=7)] == pytest.approx(
            sorted(each)[:7], abs=1e-9
        )
        assert len(world.nearest(probe, place, count=99, limit=0.5)) == sum(d <= 0.5 for d in each)
    for direction in rng.normal(size=(20, 2)):
        origin = -6 * direction / np.linalg.norm(direction)
        hits = [h.t for s, r in zip(shapes, rows) if (h := plane.raycast(s, r, origin, direction))]
        found = world.raycast(origin, direction)
        assert (found is None) == (not hits) == (not world.raycast_any(origin, direction))
        assert [h.t for _, h in world.raycast_all(origin, direction)] == pytest.approx(sorted(hits), abs=1e-9)
        if hits:
            assert found[1].t == pytest.approx(min(hits), abs=1e-9) and found[0] in world
    met = world.cast(plane.Circle(0.1), (-9, 0.3), (20, 0), angular=1.0)
    probe = plane.Circle(0.1)
    alone = [plane.cast(probe, (-9, 0.3), (20, 0), s, r, (0, 0), angular_a=1.0) for s, r in zip(shapes, rows)]
    assert met[1].t == pytest.approx(min(h.t for h in alone if h), abs=1e-6)
    all_met = world.cast_all(plane.Circle(0.1), (-9, 0.3), (20, 0), angular=1.0)
    assert all_met[0][0] == met[0] and sorted(i.index for i, _ in all_met) == [i.index for i, h in zip(ids, alone) if h]
    assert world.overlaps_any(probe, rows[0][:2]) and not world.overlaps_any(probe, (99, 0))


def test_a_shape_slides_along_what_is_in_its_way():
    world = plane.World()
    floor = world.add(plane.HalfPlane(), fixed=True)
    wall = world.add(plane.Box((1, 4)), (4, 0), fixed=True)
    ball = plane.Circle(0.5)
    end, left, touched = world.slide(ball, (0, 2), (2, -4))
    np.testing.assert_allclose(end.translation, (2, 0.5), atol=1e-5)
    assert [body for body, _ in touched] == [floor]
    end, left, touched = world.slide(ball, (0, 2), (9, -4))  # along the wall into the corner
    np.testing.assert_allclose(end.translation, (3, 0.5), atol=1e-5)
    assert [body for body, _ in touched][:2] == [wall, floor]
    end, left, touched = world.slide(ball, (0, 2), (9, -4), casts=1)
    assert len(touched) == 1 and np.linalg.norm(left) > 1
    np.testing.assert_array_equal(plane.along_lines((1, -1), [(0, 1), (-1, 0)]), (0, 0))
    slope = np.array([-0.6, 0.8])  # the motion without its part along the normal
    np.testing.assert_allclose(plane.along_lines((1, -1), [slope]), (1, -1) + 1.4 * slope, atol=1e-15)
    for motion, casts, what in [((np.nan, 0), 6, "motion"), ((1, 0), 0, "casts: expected a number >= 1, got 0")]:
        with pytest.raises(ValueError, match=what):
            world.slide(ball, (0, 2), motion, casts=casts)


def test_events_impacts_filters_and_triggers():
    world = plane.World()
    wall = world.add(plane.Box((0.1, 5)), fixed=True, filter=graze.Filter(category=2))
    bullet = world.add(plane.Circle(0.05), (-3, 0), linear=(100, 0), angular=2.0, fast=True)
    world.add(plane.Circle(0.05), (-3, 1), linear=(100, 0), fast=True, filter=graze.Filter(mask=1))
    zone = world.add(plane.Circle(1), (-3, 0), trigger=True, fixed=True)
    world.update(0.1)
    [(a, b, hit, trigger)] = [i for i in world.impacts if not i[3]]
    assert {a, b} == {wall, bullet} and hit.t == pytest.approx(0.029, abs=1e-6) and not trigger
    assert [e[0] for e in world.events if e[3] and {e[1], e[2]} == {zone, bullet}] == ["begin"]
    linear, angular = world.velocity(bullet)
    assert linear.tolist() == [100, 0] and angular == 2.0
    world.set_velocity(bullet, (0, 1), -1.0)
    assert world.velocity(bullet)[0].tolist() == [0, 1] and world.velocity(bullet)[1] == -1.0
    world.move(bullet, (9, 9))
    world.update()
    assert [e[0] for e in world.events if {e[1], e[2]} == {zone, bullet}] == ["end"]


def test_impulses_are_carried_on():
    world = plane.World()
    world.add(plane.HalfPlane(), fixed=True)
    box = world.add(plane.Box((1, 1)), (0, 0.499))
    world.update()
    given = np.array([[1.0, 2.0], [3.0, 4.0]])
    world.set_impulses(given)
    world.move(box, (0.001, 0.499))
    world.update()
    np.testing.assert_array_equal(np.sort(world.points["impulse"], axis=0), given)
    with pytest.raises(ValueError, match=r"impulses: expected 2 rows"):
        world.set_impulses(given[:1])
    with pytest.raises(ValueError, match=r"impulses\[1\]"):
        world.set_impulses([[0, 0], [0, math.nan]])


def test_a_body_has_the_shape_that_was_given():
    world, ids, shapes, rows = crowd(10)
    for body, shape, row in zip(ids, shapes, rows):
        assert world.shape(body) is shape
        np.testing.assert_allclose(world.pose(body).translation, row[:2])
    world.set_shape(ids[0], shapes[4])
    assert world.shape(ids[0]) is shapes[4]
    world.remove(ids[0])
    again = world.add(plane.Circle(2))
    assert again.index == ids[0].index and again != ids[0] and world.shape(again).radius == 2


def test_what_is_refused_changes_nothing():
    world = plane.World()
    ball, gone = world.add(plane.Circle(1), (1, 2)), world.add(plane.Circle(1))
    world.remove(gone)
    assert gone not in world and len(world) == 1
    for ask in (world.pose, world.shape, world.velocity, world.remove, lambda b: world.move(b, None)):
        with pytest.raises(ValueError, match="body"):
            ask(gone)
    with pytest.raises(ValueError, match="body"):
        world.move_all([ball, gone], [[5, 5, 1, 0]] * 2)
    with pytest.raises(ValueError, match=r"poses\[0\]\.rotation"):
        world.move_all([ball], [[5, 5, 0, 0]])
    with pytest.raises(ValueError, match="poses: expected 1 rows"):
        world.move_all([ball], [[5, 5, 1, 0]] * 2)
    with pytest.raises(ValueError, match="angular"):
        world.cast(plane.Circle(1), None, (1, 0), angular=math.inf)
    with pytest.raises(ValueError, match="duration"):
        world.update(-1)
    with pytest.raises(ValueError, match="margin"):
        plane.World(margin=-1)
    with pytest.raises(TypeError):
        world.add(graze.Sphere(1))
    assert world.pose(ball).translation.tolist() == [1, 2]


def test_a_world_is_not_changed_while_it_is_asked():
    told = []

    def support(direction):
        if asked:
            try:
                world.remove(ball)
            except RuntimeError as error:
                told.append(str(error))
        return math.copysign(1, direction[0]), math.copysign(1, direction[1])

    asked = False
    world = plane.World()
    ball = world.add(plane.Circle(1), (3, 0))
    probe = plane.UserConvex(support)
    asked = True
    [(body, d)] = world.nearest(probe)
    assert body == ball and d.distance == pytest.approx(1) and len(world) == 1
    assert told and set(told) == {"in use: another call reads it at this moment"}


def test_the_stub_has_every_name():
    root = pathlib.Path(__file__).resolve().parents[2]
    text = (root / "bindings/python/graze/plane/__init__.pyi").read_text(encoding="utf-8")
    for name in plane.__all__:
        thing = getattr(plane, name)
        if name == "batch":
            continue
        assert (f"\nclass {name}" if isinstance(thing, type) else f"\ndef {name}(") in text, name
