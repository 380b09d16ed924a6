"""Worlds, simulations and scenes: what a program does with bodies."""

import json
import pathlib

import numpy as np
import pytest

import graze

SCENES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "scenes"


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


def test_contacts_are_those_of_each_pair():
    rng = np.random.default_rng(1)
    world = graze.World(margin=0.05)
    box = graze.Box((1, 1, 1))
    places = rng.uniform(-2, 2, (60, 3))
    for place in places:
        world.add(box, place)
    world.update()
    touching = {tuple(sorted(p)) for p in world.touching.tolist()}
    expected = {
        (i, j)
        for i in range(60)
        for j in range(i + 1, 60)
        if graze.distance(box, places[i], box, places[j]).distance <= 0.05
    }
    assert touching == expected
    points, manifolds = world.points, world.manifolds
    for m in manifolds:
        for p in points[m["first_point"] : m["first_point"] + m["point_count"]]:
            np.testing.assert_allclose(p["b"] - p["a"], m["normal"] * p["distance"], atol=1e-12)


def test_a_world_answers_questions():
    world = graze.World()
    near, far = world.add(graze.Sphere(1), (3, 0, 0)), world.add(graze.Sphere(1), (9, 0, 0))
    world.update()
    body, hit = world.raycast((0, 0, 0), (1, 0, 0))
    assert body == near and hit.t == pytest.approx(2)
    assert [b for b, _ in world.nearest(graze.Sphere(0.5), None, count=2)] == [near, far]
    assert world.overlapping(graze.Box((4, 1, 1)), None) == [near]
    body, cast = world.cast(graze.Sphere(0.5), None, (4, 0, 0))
    assert body == near and cast.t == pytest.approx(1.5 / 4, abs=1e-6)


def test_a_body_that_is_gone_is_named():
    world = graze.World()
    ball = world.add(graze.Sphere(1))
    world.remove(ball)
    assert ball not in world
    for ask in (lambda: world.pose(ball), lambda: world.move(ball, None), lambda: world.remove(ball)):
        with pytest.raises(ValueError, match="body"):
            ask()


def test_a_body_falls_as_the_closed_form_says():
    simulation = graze.Simulation(gravity=(0, -10, 0))
    ball = simulation.add(graze.Sphere(0.5), (0, 100, 0))
    for _ in range(60):
        simulation.step(1 / 60)
    assert simulation.pose(ball).translation[1] == pytest.approx(95, abs=1e-9)
    assert simulation.velocity(ball)[0][1] == pytest.approx(-10, abs=1e-9)


def test_a_box_comes_to_rest_and_a_state_comes_back():
    simulation = graze.Simulation()
    simulation.add(graze.HalfSpace(), fixed=True, material=graze.Material(dynamic_friction=0.6))
    box = simulation.add(graze.Box((1, 1, 1)), ((0, 2, 0), (0, 0, 0.1, 1)))
    saved = simulation.save()
    runs = []
    for _ in range(2):
        simulation.restore(saved)
        for _ in range(240):
            simulation.step(1 / 60)
        runs.append(simulation.poses.copy())
    np.testing.assert_array_equal(runs[0], runs[1])
    assert simulation.pose(box).translation[1] == pytest.approx(0.5, abs=5e-3)
    assert simulation.report["deepest"] < 5e-3


def test_a_pendulum_keeps_its_length():
    simulation = graze.Simulation(sleep=False)
    anchor = simulation.add(graze.Sphere(0.1), fixed=True)
    bob = simulation.add(graze.Sphere(0.1), (1, 0, 0), mass=1.0)
    simulation.join_ball(anchor, None, bob, (-1, 0, 0))
    for _ in range(120):
        simulation.step(1 / 60)
        assert np.linalg.norm(simulation.pose(bob).translation) == pytest.approx(1, abs=1e-2)


def test_scenes_are_loaded_and_collided():
    scene = graze.load(SCENES / "demo.gltf")
    assert len(scene.colliders) > 3
    pairs = graze.collide(scene)
    for a, b, manifolds in pairs:
        first, second = scene.colliders[a], scene.colliders[b]
        assert graze.overlap(first.shape, first.pose, second.shape, second.pose)
        assert manifolds
    with pytest.raises(ValueError, match="nowhere.gltf"):
        graze.load("nowhere.gltf")


def test_the_protocol_answers():
    answer = json.loads(graze.answer('{"query": "closest", "a": {"shape": {"type": "box"}}, "point": [2, 0, 0]}'))
    assert answer["distance"] == 1.5
    assert "error" in json.loads(graze.answer("{}"))
