"""Simulations of the plane against closed forms, space and themselves."""

import math
import pickle

import numpy as np
import pytest

import graze
from graze import plane

STEP = 1 / 60


def run(simulation, steps):
    for _ in range(steps):
        simulation.step(STEP)


def test_a_thrown_body_flies_its_parabola_and_turns_evenly():
    simulation = plane.Simulation(gravity=(0, -10))
    box = simulation.add(plane.Box((1, 2)), (0, 100), linear=(3, 4), angular=0.5, density=7)
    run(simulation, 60)
    assert simulation.pose(box).translation == pytest.approx((3, 99), abs=1e-9)
    assert simulation.pose(box).angle == pytest.approx(0.5, abs=1e-9)
    linear, angular = simulation.velocity(box)
    assert linear == pytest.approx((3, -6), abs=1e-9) and angular == 0.5
    assert simulation.mass(box) == pytest.approx(14)
    assert simulation.angular_momentum(box) == pytest.approx(14 * (1 + 4) / 12 * 0.5)
    assert simulation.center_of_mass(box) == pytest.approx((3, 99), abs=1e-9)


def test_a_stack_comes_to_rest_sleeps_and_wakes():
    simulation = plane.Simulation()
    simulation.add(plane.HalfPlane(), fixed=True)
    boxes = [simulation.add(plane.Box((1, 1)), (0, 0.5 + i)) for i in range(5)]
    run(simulation, 240)
    assert all(simulation.asleep(box) for box in boxes)
    assert simulation.poses.shape == (6, 4)
    np.testing.assert_allclose(simulation.poses[1:, 1], 0.5 + np.arange(5), atol=5e-3)
    assert simulation.report["awake"] == 0
    assert len(simulation.world.touching) == 5
    simulation.apply_impulse(boxes[4], (500, 0), (0, 5))
    assert not simulation.asleep(boxes[4])


def test_friction_stops_what_slides_after_its_way():
    simulation = plane.Simulation(gravity=(0, -10))
    rough = plane.Material(static_friction=0.5, dynamic_friction=0.5)
    simulation.add(plane.HalfPlane(), fixed=True, material=rough)
    slider = simulation.add(plane.Box((1, 0.2)), (0, 0.1), linear=(2, 0), material=rough)
    run(simulation, 60)
    # v² / (2 μ g) within the way of one step
    assert simulation.pose(slider).translation[0] == pytest.approx(0.4, abs=2 * STEP)
    assert simulation.velocity(slider)[0][0] == pytest.approx(0, abs=1e-3)


def test_a_joint_is_read_back_and_the_bits_have_a_hash():
    simulation = plane.Simulation()
    a, b = [simulation.add(plane.Box((1, 1)), (2 * i, 0)) for i in range(2)]
    hinge = simulation.join_hinge(a, (1, 0), b, ((-1, 0), 0.5))
    read = simulation.joint(hinge)
    assert read["a"] == a and read["frame_b"] == plane.Pose((-1, 0), 0.5) and read["drives"] == []
    assert [(limit.space, limit.axes) for limit in read["limits"]] == [("linear", "xy")]
    before = simulation.state_hash()
    simulation.step(STEP)
    assert simulation.state_hash() != before and simulation.sub_steps(a) >= 4


def test_a_belt_carries_what_lies_on_it():
    simulation = plane.Simulation()
    simulation.add(plane.Box((20, 1)), (0, -0.5), fixed=True, material=plane.Material(surface_velocity=(1, 0)))
    crate = simulation.add(plane.Box((1, 1)), (0, 0.5))
    run(simulation, 120)
    assert simulation.velocity(crate)[0][0] == pytest.approx(1, abs=1e-3)


def test_joints_hold_what_they_say():
    simulation = plane.Simulation()
    post = simulation.add(plane.Circle(0.1), (0, 5), fixed=True)
    bob = plane.Circle(0.2)
    hinged = simulation.add(bob, (2, 5))
    tied = simulation.add(bob, (0, 8))
    welded = simulation.add(plane.Box((1, 1)), (-3, 5))
    sliding = simulation.add(bob, (0, 2))
    joints = [
        simulation.join_hinge(post, None, hinged, (-2, 0)),
        simulation.join_distance(post, None, tied, None, 0, 3),
        simulation.fix(post, (-3, 0), welded, None),
        simulation.join_slider(post, (0, -3), sliding, None, -1, 1),
    ]
    assert simulation.joints() == joints
    for _ in range(120):
        simulation.step(STEP)
        for body in (hinged, tied):
            assert np.linalg.norm(simulation.pose(body).translation - (0, 5)) < (2 if body == hinged else 3) + 1e-2
        assert simulation.pose(welded).translation == pytest.approx((-3, 5), abs=1e-2)
        assert simulation.pose(sliding).translation == pytest.approx((0, 2), abs=1e-2)
    assert simulation.joint_impulses(joints[2])[1] != 0  # it bears the weight
    simulation.remove_joint(joints[2])
    run(simulation, 30)
    assert simulation.pose(welded).translation[1] < 4.5


def test_a_limit_bounds_and_a_drive_turns_a_hinge():
    simulation = plane.Simulation(gravity=(0, 0))
    post = simulation.add(plane.Box((1, 1)), fixed=True)
    arm = simulation.add(plane.Box((2, 0.2)), (1, 0))
    held = graze.JointLimit("linear", "xy")
    motor = graze.JointDrive("angular", "z", velocity_target=1.5, damping=1e7)
    simulation.join(post, None, arm, (-1, 0), [held, graze.JointLimit("angular", "z", -1, 1)], [motor])
    run(simulation, 20)
    assert simulation.velocity(arm)[1] == pytest.approx(1.5, abs=1e-3)
    run(simulation, 100)
    assert simulation.pose(arm).angle == pytest.approx(1, abs=2e-2)


def test_a_kinematic_body_carries_and_is_not_pushed():
    simulation = plane.Simulation()
    lift = simulation.add(plane.Box((3, 0.5)), kinematic=True)
    crate = simulation.add(plane.Box((1, 1)), (0, 0.75))
    for i in range(60):
        simulation.move_to(lift, (0, (i + 1) * STEP), STEP)
        simulation.step(STEP)
    assert simulation.pose(lift).translation[1] == pytest.approx(1, abs=1e-12)
    assert simulation.pose(crate).translation[1] == pytest.approx(1.75, abs=1e-2)
    assert simulation.mass(lift) == math.inf


def test_a_saved_state_brings_back_the_same_bits():
    simulation = plane.Simulation()
    simulation.add(plane.HalfPlane(), fixed=True)
    for i in range(10):
        simulation.add(plane.Polygon([(0, 0), (1, 0), (0.5, 1)]), (0.1 * i, 1 + 1.2 * i))
    run(simulation, 30)
    state = pickle.loads(pickle.dumps(simulation.save()))
    run(simulation, 30)
    once = simulation.poses
    simulation.restore(state)
    run(simulation, 30)
    assert np.array_equal(simulation.poses, once)
    simulation.add(plane.Circle(1), (50, 1))
    with pytest.raises(ValueError):
        simulation.restore(state)


def test_bodies_keep_their_shapes_and_places():
    simulation = plane.Simulation(gravity=(0, 0))
    compound = plane.Compound([(plane.Circle(0.2), (0.3, 0)), (plane.Box((0.4, 0.2)), (-0.3, 0))])
    first = simulation.add(compound)
    assert simulation.world.shape(first) is compound
    simulation.remove(first)
    with pytest.raises(ValueError, match="body"):
        simulation.pose(first)
    circle = plane.Circle(1)
    second = simulation.add(circle, (3, 0))
    assert second.index == first.index and second != first
    assert simulation.world.shape(second) is circle
    simulation.set_pose(second, (4, 0, 0.5))
    assert simulation.pose(second).translation == pytest.approx((4, 0))


@pytest.mark.parametrize(
    ("what", "named"),
    [
        (lambda s, a, b: s.add(plane.Circle(1), mass=-1), "mass"),
        (lambda s, a, b: s.add(plane.Circle(1), linear=(math.nan, 0)), "linear"),
        (lambda s, a, b: s.add(plane.HalfPlane()), "shape"),
        (lambda s, a, b: s.step(0), "dt"),
        (lambda s, a, b: s.step(math.inf), "dt"),
        (lambda s, a, b: s.fix(a, None, a, None), "^b: expected another body than a"),
        (lambda s, a, b: s.join_slider(a, None, b, None, 2, 1), "min"),
        (lambda s, a, b: s.join(a, None, b, None, [graze.JointLimit("linear", "z")]), r"limits\[0\]\.axes"),
        (lambda s, a, b: s.join(a, None, b, None, [], [graze.JointDrive("angular", "x")]), r"drives\[0\]"),
        (lambda s, a, b: graze.JointLimit("round", "x"), "space"),
        (lambda s, a, b: graze.JointLimit("linear", "xx"), "axes"),
        (lambda s, a, b: graze.JointDrive("linear", "w"), "axis"),
        (lambda s, a, b: plane.Material(friction_combine="often"), "friction_combine"),
        (lambda s, a, b: plane.Simulation(sub_steps=3), "sub_steps"),
    ],
)
def test_what_is_none_is_named_and_nothing_changes(what, named):
    simulation = plane.Simulation(gravity=(0, 0))
    a, b = simulation.add(plane.Circle(1)), simulation.add(plane.Circle(1), (5, 0))
    before = simulation.poses
    with pytest.raises(ValueError, match=named):
        what(simulation, a, b)
    assert np.array_equal(simulation.poses, before) and simulation.joints() == []
