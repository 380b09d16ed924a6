"""Blows, blows that are passed on, and free motion, in space and in the plane."""

import math

import numpy as np
import pytest

import graze
from graze import plane


def test_a_ball_is_thrown_back_by_a_wall():
    ball = graze.StruckBody.of_shape(graze.Sphere(1), 2.0, None, linear=(3, 0, 1))
    wall = graze.StruckBody(math.inf)
    assert ball.movable and not wall.movable
    found = graze.response(ball, wall, (1, 0, 0), (1, 0, 0), restitution=0.5, friction=0)
    np.testing.assert_allclose(found["a"].linear, (-1.5, 0, 1), atol=1e-12)
    assert found["at_fault"] == "a" and found["normal_impulse"] == pytest.approx(9)
    assert found["b"].linear.tolist() == [0, 0, 0]
    rough = graze.response(ball, wall, (1, 0, 0), (1, 0, 0), friction=10)
    # Rolls on: friction ends the sliding, and the ball turns with two sevenths of what it slid at.
    np.testing.assert_allclose(rough["a"].linear, (0, 0, 5 / 7), atol=1e-12)
    np.testing.assert_allclose(rough["a"].angular, (0, 5 / 7, 0), atol=1e-12)


def test_an_impulse_moves_and_turns():
    body = graze.StruckBody(2.0, (2, 2, 4), ((1, 0, 0), (0, 0, 0, 1)))
    after = body.apply_impulse((0, 4, 0), (2, 0, 0))
    np.testing.assert_allclose(after.linear, (0, 2, 0))
    np.testing.assert_allclose(after.angular, (0, 0, 1))
    tensor = graze.StruckBody(2.0, np.diag([2.0, 2, 4]), (1, 0, 0))
    np.testing.assert_allclose(tensor.apply_impulse((0, 4, 0), (2, 0, 0)).angular, (0, 0, 1))
    flat = plane.StruckBody(2.0, 4.0, (1, 0)).apply_impulse((0, 4), (2, 0))
    assert flat.linear.tolist() == [0, 2] and flat.angular == 1
    assert graze.StruckBody(2.0).apply_impulse((0, 4, 0), (2, 0, 0)).angular.tolist() == [0, 0, 0]


@pytest.mark.parametrize("words,axis", [(graze, (1, 0, 0)), (plane, (1, 0))])
def test_of_a_cradle_only_the_last_ball_leaves(words, axis):
    axis = np.array(axis, dtype=float)
    ball = words.Sphere(0.5) if words is graze else words.Circle(0.5)
    bodies = [words.StruckBody.of_shape(ball, 1.0, i * axis, linear=axis * (5 if i == 0 else 0)) for i in range(5)]
    blows = [words.Blow(i, i + 1, axis, (i + 0.5) * axis, 1.0) for i in range(4)]
    passed = words.pass_on(bodies, blows, 0.01)
    assert passed["struck"] == 4 and passed["approach"] <= 0.01
    speeds = [body.linear[0] for body in passed["bodies"]]
    np.testing.assert_allclose(speeds, [0, 0, 0, 0, 5], atol=1e-12)
    np.testing.assert_allclose(np.concatenate(passed["impulses"]), [5] * 4)
    assert bodies[0].linear[0] == 5  # what was given stays
    assert words.pass_on(bodies, blows, 0.01, most=2)["struck"] == 2


def test_a_book_that_tumbles_keeps_its_momentum_and_energy():
    book = graze.FreeBody((1, 2, 3), linear=(1, 0, 0), angular=(0.01, 5, 0))
    momentum, energy = book.angular_momentum.tolist(), book.rotational_energy
    for _ in range(240):
        book.advance(1 / 60, (0, -10, 0))
    assert book.angular_momentum.tolist() == momentum
    assert book.rotational_energy == pytest.approx(energy, rel=1e-7)
    np.testing.assert_allclose(book.pose.translation, (4, -80, 0), rtol=1e-9)
    wheel = plane.FreeBody(2.0, linear=(1, 0), angular=3.0)
    wheel.advance(0.5, (0, -10))
    assert wheel.angular == 3 and wheel.rotational_energy == 9 and wheel.angular_momentum == 6
    np.testing.assert_allclose(wheel.pose.translation, (0.5, -1.25))
    assert wheel.pose.angle == pytest.approx(1.5)
    assert plane.FreeBody(math.inf, angular=3.0).angular == 0


@pytest.mark.parametrize("wrong,named", [
    (lambda: graze.StruckBody(0), "mass"), (lambda: graze.StruckBody(1, (1, -1, 1)), "inertia"),
    (lambda: graze.StruckBody(1, np.zeros((2, 3))), "inertia"), (lambda: graze.StruckBody(1, (1, 1, 3)), r"inertia\[2\]"),
    (lambda: graze.StruckBody(1, linear=(math.nan, 0, 0)), "linear"), (lambda: plane.StruckBody(-1), "mass"),
    (lambda: plane.StruckBody(1, 0.0), "inertia"), (lambda: plane.StruckBody.of_shape(plane.HalfPlane(), 1.0), "shape"),
    (lambda: graze.Blow(0, 1, (1, 1, 0), (0, 0, 0)), "normal"), (lambda: graze.Blow(0, 1, (1, 0, 0), (0, 0, 0), 2), "restitution"),
    (lambda: graze.pass_on([graze.StruckBody(1)], [graze.Blow(0, 1, (1, 0, 0), (0, 0, 0))]), r"blows\[0\].b"),
    (lambda: graze.pass_on([graze.StruckBody(1)], [graze.Blow(0, 0, (1, 0, 0), (0, 0, 0))]), r"blows\[0\].b"),
    (lambda: plane.pass_on([], [], -1), "resting_speed"), (lambda: graze.FreeBody((1, 0, 1)), r"inertia\[1\]"),
    (lambda: graze.FreeBody((1, 1, 1)).advance(math.inf), "duration"),
    (lambda: graze.response(graze.StruckBody(1), graze.StruckBody(1), (0, 0, 0), (1, 0, 0), friction=-1), "friction"),
])
def test_wrong_values_are_named(wrong, named):
    with pytest.raises(ValueError, match=named):
        wrong()
