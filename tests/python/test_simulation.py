"""Masses and joints of simulations, in space and in the plane, as they are given."""

import numpy as np
import pytest

import graze
from graze import plane


def test_a_simulation_takes_masses_as_they_are():
    simulation = graze.Simulation(gravity=(0, 0, 0), most_sub_steps=8, longest_step=0.1)
    body = simulation.add(
        graze.Box((1, 1, 1)), mass=2, center_of_mass=(0.25, 0, 0), inertia=((1, 2, 3), (0, 0, np.sqrt(0.5), np.sqrt(0.5)))
    )
    assert simulation.center_of_mass(body).tolist() == [0.25, 0, 0]
    # A quarter turn about z: what turns about x has the moment that is given for y.
    simulation.apply_angular_impulse(body, (2, 0, 0))
    np.testing.assert_allclose(simulation.velocity(body)[1], (1, 0, 0), atol=1e-12)
    simulation.apply_impulse(body, (0, 2, 0), (0.25, 0, 0))
    np.testing.assert_allclose(simulation.velocity(body)[0], (0, 1, 0), atol=1e-12)
    plain = simulation.add(graze.Box((1, 1, 1)), (5, 0, 0), mass=2, inertia=(1, 2, np.inf))
    simulation.apply_angular_impulse(plain, (0, 2, 2))
    assert simulation.velocity(plain)[1].tolist() == [0, 1, 0]
    flat = plane.Simulation(gravity=(0, 0))
    disk = flat.add(plane.Circle(1), mass=1, center_of_mass=(0, 0.5), inertia=4)
    flat.apply_angular_impulse(disk, 2)
    assert flat.velocity(disk)[1] == 0.5 and flat.center_of_mass(disk).tolist() == [0, 0.5]
    with pytest.raises(ValueError, match="dt: expected a number > 0 and at most longest_step, got 0.2"):
        simulation.step(0.2)
    with pytest.raises(ValueError, match="most_sub_steps"):
        graze.Simulation(most_sub_steps=3)
    with pytest.raises(ValueError, match="inertia"):
        simulation.add(graze.Sphere(1), inertia=(1, 1, 5))
    for given in (1, 2), "x", ((1, 2, 3), (0, 1)):
        with pytest.raises(TypeError, match="inertia: expected"):
            simulation.add(graze.Sphere(1), inertia=given)


def test_joints_let_their_bodies_touch():
    for of, box, aside in (graze, graze.Box((1, 1, 1)), (0.5, 0, 0)), (plane, plane.Box((1, 1)), (0.5, 0)):
        for touch in False, True:
            simulation = of.Simulation()
            a, b = simulation.add(box), simulation.add(box, aside)
            joint = simulation.join_slider(a, None, b, None, enable_collision=touch)
            assert simulation.joint(joint)["enable_collision"] is touch
            joint = simulation.join_distance(a, None, b, None, 0, 1, enable_collision=touch)
            assert simulation.joint(joint)["enable_collision"] is touch


def test_pieces_have_materials_of_their_own():
    ice, felt = (dict(static_friction=f, dynamic_friction=f, friction_combine="minimum") for f in (0, 0.3))
    for of, slab, slider, at in (
        (graze, graze.Box((80, 1, 40)), graze.Box((2, 1, 1)), lambda z: (0, -0.5, z)),
        (plane, plane.Box((80, 1)), plane.Box((2, 1)), lambda z: (0, 10 * z - 0.5)),
    ):
        simulation = of.Simulation(gravity=(0, -10, 0)[: len(at(0))])
        floor = simulation.add(of.Compound([(slab, at(-20)), (slab, at(20))]), fixed=True)
        materials = [of.Material(**ice), of.Material(**felt)]
        simulation.set_materials(floor, materials, [0, 1])
        up = np.array((0, 1, 0)[: len(at(0))])
        rough = of.Material(static_friction=1, dynamic_friction=1, friction_combine="minimum")
        boxes = [simulation.add(slider, np.add(at(z), up), linear=6 * np.eye(len(up))[0], material=rough) for z in (-20, 20)]
        for _ in range(60):
            simulation.step(1 / 60)
        on_ice, on_felt = (simulation.velocity(box)[0][0] for box in boxes)
        assert on_ice == pytest.approx(6, abs=1e-3)
        assert on_felt == pytest.approx(3, abs=0.1)
        simulation.set_materials(floor, materials, np.array([1, 0], dtype=np.uint32))
        for body, of_piece, message in [
            (floor, [0], "of_piece: expected a number for each of the 2 pieces"),
            (floor, [0, 2], r"of_piece\[1\]: expected the place of one of the 2 materials"),
            (floor, [0, -1], r"of_piece\[1\]: expected an integer from 0"),
            (boxes[0], [0, 1], "body: expected one whose shape has pieces"),
        ]:
            with pytest.raises(ValueError, match=message):
                simulation.set_materials(body, materials, of_piece)


def test_warm_starting_is_a_setting():
    def sunk(of, **settings):
        """How far ten boxes sink into each other and the floor in two seconds."""
        simulation = of.Simulation(sleep=False, sub_steps=4, most_sub_steps=4, **settings)
        space = of is graze
        simulation.add(of.HalfSpace() if space else of.HalfPlane(), fixed=True)
        box = of.Box((1, 1, 1) if space else (1, 1))
        boxes = [simulation.add(box, (0, 0.5 + i, 0)[: 3 if space else 2]) for i in range(10)]
        for _ in range(120):
            simulation.step(1 / 60)
        return 9.5 - simulation.pose(boxes[-1]).translation[1]

    for of in graze, plane:
        warm, cold = sunk(of), sunk(of, warm_start=False)
        assert sunk(of, warm_start=True) == warm
        assert 0 < warm < 0.05 and cold > 4 * warm


def test_an_inertia_may_be_a_matrix():
    rng = np.random.default_rng(4)
    hull = graze.ConvexHull(rng.normal(size=(30, 3)))
    volume, center, inertia = hull.mass_properties()
    for tensor in (inertia, inertia.tolist(), np.asfortranarray(inertia), inertia.astype(np.float32)):
        simulation = graze.Simulation(gravity=(0, 0, 0))
        spin = (1.0, 2.0, -3.0)
        own = simulation.add(hull, angular=spin, mass=5)
        given = simulation.add(hull, (9, 0, 0), angular=spin, mass=5, inertia=np.asarray(tensor) * 5 / volume)
        close = 1e-5 if np.asarray(tensor).dtype == np.float32 else 1e-12
        assert np.allclose(simulation.angular_momentum(given), simulation.angular_momentum(own), rtol=close)
        assert np.allclose(simulation.angular_momentum(given), inertia * 5 / volume @ spin, rtol=close)
    for moments in [(1, 2, 2.5), (3, 3, 3), (2.5, 1, 2)]:
        body = simulation.add(hull, (0, 9, 0), angular=spin, mass=1, inertia=np.diag(moments))
        assert np.allclose(simulation.angular_momentum(body), np.multiply(moments, spin), rtol=1e-12)
    for wrong, message in [
        ([[1, 0.5, 0], [0, 1, 0], [0, 0, 1]], r"inertia\[1\]\[0\]: expected a symmetric matrix"),
        (np.full((3, 3), np.nan), "inertia: expected a finite number"),
        (-np.eye(3), "inertia"),
        (np.diag([1, 1, 5]), "inertia_diagonal"),
        (np.eye(4), r"inertia: expected an array of shape \(n, 3\)"),
        (np.ones((2, 3)), "inertia"),
    ]:
        with pytest.raises((ValueError, TypeError), match=message):
            simulation.add(hull, mass=1, inertia=wrong)


def test_a_motor_gets_another_target():
    s = graze.Simulation(gravity=(0, 0, 0))
    post = s.add(graze.Box((1, 1, 1)), (-2, 0, 0), fixed=True)
    wheel = s.add(graze.Cylinder(0.2, 0.5))

    def drives(speed):
        return [graze.JointDrive("angular", "x", velocity_target=speed, damping=50, acceleration=True)]

    limits = [graze.JointLimit("linear", "xyz"), graze.JointLimit("angular", "yz")]
    hinge = s.join(post, (2, 0, 0), wheel, None, limits=limits, drives=drives(1))
    for target in (1, -2):
        s.set_joint(hinge, drives=drives(target))
        for _ in range(60):
            s.step(1 / 60)
        assert s.velocity(wheel)[1][0] == pytest.approx(target, abs=1e-3)
    assert len(s.joint(hinge)["limits"]) == 2
    s.set_filter(wheel, graze.Filter(category=2, mask=2))
