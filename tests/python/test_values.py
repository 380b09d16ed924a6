"""Plain values: what they show, pickles of them, and numbers and arrays that are refused."""

import pickle

import numpy as np
import pytest

import graze
from graze import plane


def values():
    box, ball = graze.Box((2, 2, 2)), graze.Sphere(0.5)
    world = graze.World()
    body = world.add(box)
    simulation = graze.Simulation()
    floor, crate = simulation.add(graze.HalfSpace(), fixed=True), simulation.add(box, (0, 1, 0))
    joint = simulation.join_ball(floor, None, crate, None)
    [manifold] = graze.contacts(box, None, ball, (1.4, 0, 0))
    square, disk = plane.Box((2, 2)), plane.Circle(0.5)
    [flat] = plane.contacts(square, None, disk, (1.4, 0))
    return [
        graze.Filter(3, 5, -1), graze.Material(0.1, restitution=0.5, friction_combine="maximum", surface_velocity=(1, 2, 3)),
        plane.Material(0.1, surface_velocity=(1, 2)), body, joint, graze.JointLimit("linear", "xy", -1, 1, 5, 0.25),
        graze.JointLimit("angular", "z"), graze.JointDrive("angular", "y", velocity_target=2, acceleration=True),
        graze.distance(box, None, ball, (3, 0, 0)), graze.closest(box, None, (3, 0, 0)),
        graze.raycast(box, None, (5, 0, 0), (-1, 0, 0)), graze.cast(box, None, (0, 0, 0), ball, (5, 0, 0), (-5, 0, 0)),
        manifold, manifold.points[0], plane.distance(square, None, disk, (3, 0)), plane.closest(square, None, (3, 0)),
        plane.raycast(square, None, (5, 0), (-1, 0)), plane.cast(square, None, (0, 0), disk, (5, 0), (-5, 0)), flat,
        flat.points[0], graze.ShapeArray([box, ball]), graze.StruckBody.of_shape(ball, 2, linear=(1, 2, 3)),
        plane.StruckBody.of_shape(disk, 2, linear=(1, 2)), graze.Blow(0, 1, (1, 0, 0), [(0, 0, 0), (0, 1, 0)], 0.5),
        plane.Blow(0, 1, (1, 0), [(0, 0)]), graze.FreeBody((1, 2, 3), (1, 0, 0), angular=(1, 2, 3)),
        plane.FreeBody(2.0, (1, 0), angular=3.0),
    ]  # fmt: skip


def public(value):
    """All that a value tells, in a form that is compared."""
    told = {}
    for name in dir(type(value)):
        if isinstance(getattr(type(value), name), property):
            member = getattr(value, name)
            told[name] = [public(point) for point in member] if name == "points" else repr(member)
    return told


@pytest.mark.parametrize("value", values(), ids=lambda value: type(value).__module__ + "." + type(value).__name__)
def test_a_pickle_is_the_value_again(value):
    again = pickle.loads(pickle.dumps(value))
    assert type(again) is type(value)
    assert repr(again) == repr(value) and public(again) == public(value)
    assert " object at 0x" not in repr(value)


def test_what_values_show():
    assert repr(graze.Material(restitution=0.5)) == (
        "graze.Material(static_friction=0.6, dynamic_friction=0.6, restitution=0.5, rolling_friction=0.0, "
        "friction_combine='unset', restitution_combine='unset', surface_velocity=(0.0, 0.0, 0.0))")
    assert eval(repr(plane.Material(0.25)), {"graze": graze}).static_friction == 0.25
    limit = graze.JointLimit("linear", "xy", -1, 1)
    assert repr(limit) == (
        "graze.JointLimit(space='linear', axes='xy', min=-1.0, max=1.0, stiffness=None, damping=0.0)")
    world = plane.World()
    world.add(plane.Circle(1))
    world.add(plane.Circle(1), (1, 0))
    world.update()
    assert repr(world) == "graze.plane.World(bodies=2, pairs=1)"
    simulation = graze.Simulation()
    simulation.add(graze.Sphere(1))
    assert repr(simulation) == "graze.Simulation(bodies=1, joints=0)"
    assert repr(simulation.world) == "graze.WorldView(bodies=1, pairs=0)"
    assert repr(graze.ShapeArray.boxes([(1, 2, 3)])) == "<graze.ShapeArray of 1 shapes>"
    assert repr(graze.BroadPhase()).startswith("graze.BroadPhase(tests=0, memory=")
    for name in ("StruckBody", "FreeBody", "Blow", "Material"):
        assert getattr(plane, name).__module__ == "graze.plane"


@pytest.mark.parametrize("of", [graze, plane])
def test_a_material_is_checked_when_it_is_made(of):
    for arguments, message in [
        ({"restitution": 2}, "restitution: expected a number from 0 to 1, got 2"),
        ({"restitution": float("nan")}, "restitution: expected a number from 0 to 1, got nan"),
        ({"static_friction": -1}, "static_friction: expected a finite number >= 0, got -1"),
        ({"dynamic_friction": float("inf")}, "dynamic_friction: expected a finite number >= 0, got inf"),
        ({"rolling_friction": -0.5}, "rolling_friction: expected a finite number >= 0, got -0.5"),
    ]:
        with pytest.raises(ValueError) as refused:
            of.Material(**arguments)
        assert str(refused.value) == message
    with pytest.raises(ValueError, match="^surface_velocity"):
        of.Material(surface_velocity=(float("nan"),) * (3 if of is graze else 2))


def test_whole_numbers_out_of_range_are_named():
    broad = graze.BroadPhase()
    most = 2**32 - 1
    for ask, path, greatest, got in [
        (lambda: graze.Filter(-1), "category", 2**64 - 1, -1),
        (lambda: graze.Filter(mask=2**64), "mask", 2**64 - 1, 2**64),
        (lambda: broad.insert(-1, (0, 0, 0), (1, 1, 1)), "id", most, -1),
        (lambda: broad.move(2**32, (0, 0, 0), (1, 1, 1)), "id", most, 2**32),
        (lambda: broad.remove(2**70), "id", most, 2**70),
    ]:
        with pytest.raises(ValueError) as refused:
            ask()
        assert str(refused.value) == f"{path}: expected an integer from 0 to {greatest}, got {got}"
    with pytest.raises(TypeError):
        broad.insert(1.5, (0, 0, 0), (1, 1, 1))
    with pytest.raises(TypeError):
        graze.Filter("1")
    assert graze.Filter(np.uint8(3)).category == 3


def test_complex_numbers_and_masks_are_refused():
    poses = np.zeros((3, 7))
    poses[:, 6] = 1
    ball = graze.Sphere(1)
    for give in (lambda a: a + 0j, lambda a: np.ma.masked_array(a, mask=True), lambda a: np.ma.masked_array(a)):
        for ask in [
            lambda: graze.batch.overlap(ball, None, ball, give(poses)),
            lambda: graze.Box(give(np.ones(3))),
            lambda: graze.distance(ball, give(poses[0]), ball, None),
            lambda: graze.ConvexHull(give(np.eye(3))),
            lambda: graze.HeightField(give(np.zeros((3, 3)))),
            lambda: graze.ShapeArray.spheres(give(np.ones(3))),
            lambda: plane.overlap(plane.Circle(1), give(np.zeros(2)), plane.Circle(1), None),
        ]:
            with pytest.raises(TypeError, match="expected (real numbers, got complex ones|an array without a mask)"):
                ask()


def test_counts_are_refused_by_name():
    ball = graze.Sphere(1)
    world = graze.World()
    body = world.add(ball)
    [manifold] = graze.contacts(ball, None, ball, (1, 0, 0))
    cases = [
        (lambda: world.nearest(ball, count=-1), "count: expected an integer from 0 to 18446744073709551615, got -1"),
        (lambda: world.slide(ball, None, (1, 0, 0), casts=0), "casts: expected a number >= 1, got 0"),
        (lambda: world.slide(ball, None, (1, 0, 0), casts=2**40), "casts: expected an integer from"),
        (lambda: world.reduce(0), "count: expected a number >= 1, got 0"),
        (lambda: world.overlapping(ball, mask=-1), "mask: expected an integer from 0 to"),
        (lambda: world.overlapping(ball, group=2**31), "group: expected an integer from"),
        (lambda: manifold.reduce(-2), "count: expected an integer from 0 to"),
        (lambda: graze.Blow(-1, 0, (1, 0, 0), []), "a: expected an integer from 0 to 4294967295, got -1"),
        (lambda: graze.pass_on([], [], most=-1), "most: expected an integer from 0 to"),
        (lambda: graze.World(points_per_pair=-1), "points_per_pair: expected an integer from 0 to"),
    ]
    for question, message in cases:
        with pytest.raises(ValueError, match=message):
            question()
    assert body in world
