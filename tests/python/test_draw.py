"""Debug draw: what is known, through an object with as many of a renderer's methods as it likes."""

import numpy as np
import pytest

import graze
from graze import plane


class Everything:
    """Writes down all calls."""

    center, size = (0, 0, 0), 4

    def __init__(self, layers=None):
        self.calls = []
        if layers is not None:
            self.layers = layers

    def _note(kind):
        def method(self, *given):
            *places, layer, meaning = given
            self.calls.append((kind, places, layer, meaning))

        return method

    point, line, triangle, text = _note("point"), _note("line"), _note("triangle"), _note("text")

    def of(self, kind):
        return [places for k, places, _, _ in self.calls if k == kind]


class Faces(Everything):
    polygon, arrow = Everything._note("polygon"), Everything._note("arrow")


def world_with_a_box():
    world = graze.World()
    world.add(graze.HalfSpace(), fixed=True)
    world.add(graze.Box((1, 1, 1)), (0, 0.49, 0))
    world.update()
    return world


def test_a_box_is_twelve_triangles_seen_from_outside():
    on = Everything()
    graze.draw(on, graze.Box((2, 2, 2)), (5, 0, 0), "touching")
    assert {(layer, meaning) for _, _, layer, meaning in on.calls} == {("shapes", "touching")}
    triangles = on.of("triangle")
    assert len(triangles) == 12
    for a, b, c in triangles:
        assert np.all(np.abs(a - (5, 0, 0)) == 1)
        assert np.dot(np.cross(b - a, c - a), a - (5, 0, 0)) > 0


def test_a_renderer_that_knows_polygons_gets_faces_and_arrows():
    on = Faces()
    graze.draw(on, graze.Box((2, 2, 2)))
    assert [corners.shape for (corners,) in on.of("polygon")] == [(4, 3)] * 6 and not on.of("triangle")
    [manifold] = graze.contacts(graze.Box((1, 1, 1)), None, graze.Box((1, 1, 1)), (0, 0.9, 0))
    graze.draw(on, manifold)
    assert len(on.of("point")) == 4
    [(_, direction)] = on.of("arrow")
    assert np.all(direction == manifold.normal)


def test_a_world_is_drawn_by_its_layers():
    everything, contacts = Everything(), Everything(["contacts"])
    graze.draw(everything, world_with_a_box())
    graze.draw(contacts, world_with_a_box())
    assert {"shapes", "bounds", "contacts"} <= {layer for _, _, layer, _ in everything.calls}
    assert {layer for _, _, layer, _ in contacts.calls} == {"contacts"}
    assert len(contacts.of("point")) == 4
    center, size = graze.draw_area(world_with_a_box())
    assert center.shape == (3,) and size > 0


def test_a_simulation_shows_its_joints():
    simulation = graze.Simulation()
    box = graze.Box((1, 1, 1))
    a, b = simulation.add(box), simulation.add(box, (3, 0, 0))
    simulation.join_ball(a, (1.5, 0, 0), b, (-1.5, 0, 0))
    on = Everything(["joints"])
    graze.draw(on, simulation)
    assert on.of("line")


def test_a_simulation_of_the_plane_shows_its_joints():
    simulation = plane.Simulation()
    a, b = simulation.add(plane.Box((1, 1))), simulation.add(plane.Box((1, 1)), (3, 0))
    simulation.join_hinge(a, (1.5, 0), b, (-1.5, 0))
    on = Everything(["joints"])
    plane.draw(on, simulation)
    assert on.of("line")


def test_distances_and_the_plane():
    on = Everything()
    graze.draw(on, graze.distance(graze.Sphere(1), None, graze.Sphere(1), (4, 0, 0)))
    assert "gap" in {meaning for _, _, _, meaning in on.calls}
    flat = Faces()
    world = plane.World()
    world.add(plane.HalfPlane(), fixed=True)
    world.add(plane.Circle(1), (0, 0.9))
    world.update()
    plane.draw(flat, world)
    plane.draw(flat, plane.Box((1, 1)), (2, 2), "b")
    plane.draw(flat, plane.distance(plane.Circle(1), None, plane.Circle(1), (4, 0)))
    assert all(place[..., 2] == 0 for (place,) in flat.of("point"))
    assert flat.of("polygon")[-1][0].shape == (4, 3)
    assert plane.draw_area(world)[1] > 0


def test_a_renderer_without_methods_draws_nothing():
    graze.draw(object(), world_with_a_box())


def test_what_is_wrong_is_said():
    class Broken:
        size = 0

    class Lost:
        layers = ["everything"]

    class Throws:
        def triangle(self, *_):
            raise RuntimeError("out of ink")

    box = graze.Box((1, 1, 1))
    with pytest.raises(ValueError, match="size: expected a size > 0, got 0"):
        graze.draw(Broken(), box)
    with pytest.raises(ValueError, match="layers: expected one of shapes, bounds"):
        graze.draw(Lost(), box)
    with pytest.raises(ValueError, match="meaning: expected one of a, b"):
        graze.draw(Everything(), box, None, "pretty")
    with pytest.raises(RuntimeError, match="out of ink"):
        graze.draw(Throws(), box)
    assert graze.suggested_color("contact") == (193, 18, 31)


def test_what_a_question_did_is_drawn_before_it_answers():
    shapes = graze.Box((2, 2, 2)), None, graze.ConvexHull([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), (1.4, 0.2, 0.1)
    for question in graze.overlap, graze.distance, graze.contacts:
        on = Everything()
        drawn, plain = question(*shapes, trace=on), question(*shapes)
        assert type(drawn) is type(plain)
        assert {layer for _, _, layer, _ in on.calls} >= {"trace"}
    on = Everything()
    answer, trace = graze.distance(*shapes, trace=True)
    assert graze.distance(*shapes, trace=on).distance == answer.distance == graze.distance(*shapes).distance
    assert trace["gjk"] and on.of("line")
    # What moves: the ray and the cast.
    on = Everything()
    assert graze.raycast(graze.Sphere(1), None, (-3, 0, 0), (1, 0, 0), trace=on).t == 2
    assert graze.cast(graze.Sphere(1), None, (0, 0, 0), graze.Sphere(1), (4, 0, 0), (-2, 0, 0), trace=on).t == pytest.approx(1)
    assert graze.closest(graze.Sphere(1), None, (3, 0, 0), trace=on).distance == 2


def test_in_the_plane_too():
    on = Everything()
    shapes = plane.Box((2, 2)), None, plane.ConvexPolygon([(0, 0), (1, 0), (0, 1)]), (1.4, 0.2)
    assert plane.distance(*shapes, trace=on).distance == plane.distance(*shapes).distance
    assert on.of("line") and all(len(p) == 3 and p[2] == 0 for _, places, _, _ in on.calls for p in places if not isinstance(p, str))
    hit, trace = plane.raycast(plane.Circle(1), None, (-3, 0), (1, 0), trace=True)
    assert hit.t == 2 and trace["method"]
    moving = plane.Circle(1), None, (0, 0), plane.Circle(1), (1, 0), (1, 0)
    assert plane.cast(*moving).t == 0 and plane.cast(*moving, ignore_separating=True) is None
    assert plane.cast(*moving, trace=on).t == 0


def test_flags_of_all_kinds_ask_for_a_trace():
    shapes = graze.Sphere(1), None, graze.Sphere(1), (3, 0, 0)
    for no in False, None, 0, np.bool_(False):
        assert graze.distance(*shapes, trace=no).distance == 1
    for yes in True, 1, np.bool_(True):
        assert graze.distance(*shapes, trace=yes)[0].distance == 1
    with pytest.raises(ValueError, match="size"):
        graze.distance(*shapes, trace=type("Flat", (), {"size": 0}))


def test_a_tessellation_is_the_shape():
    ball = graze.tessellate(graze.Sphere(2), (5, 0, 0))
    assert ball["smooth"] and ball["closed"]
    np.testing.assert_allclose(np.linalg.norm(ball["points"] - (5, 0, 0), axis=1), 2, rtol=1e-12)
    volume = 0.0
    for loop in ball["loops"]:  # counter-clockwise seen from outside: cones to the origin with a sign
        corners = ball["points"][loop]
        for i in range(1, len(loop) - 1):
            volume += np.linalg.det([corners[0], corners[i], corners[i + 1]]) / 6
    assert volume == pytest.approx(4 / 3 * np.pi * 8, rel=0.05) and volume < 4 / 3 * np.pi * 8
    [loop] = plane.tessellate(plane.Box((2, 4)), (0, 0, np.pi / 2))["loops"]
    flat = plane.tessellate(plane.Box((2, 4)), (0, 0, np.pi / 2))["points"]
    np.testing.assert_allclose(flat.min(axis=0), (-2, -1, 0), atol=1e-12)
    assert len(loop) == 4 and not flat[:, 2].any()
    floor = graze.tessellate(graze.HalfSpace(), (0, 1, 0), center=(3, 9, 0), half_space_size=5)["points"]
    np.testing.assert_allclose([floor.min(axis=0), floor.max(axis=0)], [(-2, 1, -5), (8, 1, 5)], atol=1e-12)
    with pytest.raises(ValueError, match="half_space_size"):
        graze.tessellate(graze.HalfSpace(), half_space_size=-1)


def test_rays_casts_joints_and_boxes():
    on = Faces()
    graze.draw_ray(on, (-3, 0, 0), (1, 0, 0), hit=graze.raycast(graze.Sphere(1), None, (-3, 0, 0), (1, 0, 0)))
    [(start, end)] = on.of("line")
    assert start.tolist() == [-3, 0, 0] and end.tolist() == [-1, 0, 0]
    assert [direction.tolist() for _, direction in on.of("arrow")] == [[-1, 0, 0]]
    assert {layer for _, _, layer, _ in on.calls} == {"rays"}
    on = Faces()
    moving = graze.Sphere(1), (0, 0, 0), (2, 0, 0)
    hit = graze.cast(*moving, graze.Sphere(1), (4, 0, 0), (0, 0, 0), 5)
    graze.draw_cast(on, *moving, 5, hit=hit)
    far = max(corners[:, 0].max() for (corners,) in on.of("polygon"))
    assert far == pytest.approx(3, abs=0.01) and {layer for _, _, layer, _ in on.calls} == {"casts"}
    on = Everything()
    graze.draw_bounds(on, (0, 0, 0), (1, 2, 3), "tree")
    assert len(on.of("line")) == 12 and {layer for _, _, layer, _ in on.calls} == {"tree"}
    on = Everything()
    graze.draw_joint(on, (1, 0, 0), None, (-1, 0, 0), (3, 0, 0))
    assert any(np.array_equal(places, [(1, 0, 0), (2, 0, 0)]) for places in on.of("line"))
    flat = Everything()
    plane.draw_ray(flat, (-3, 0), (1, 0), 2)
    plane.draw_cast(flat, plane.Box((1, 1)), None, (2, 0), angular=1)
    plane.draw_joint(flat, (1, 0), None, (-1, 0), (3, 0))
    assert {layer for _, _, layer, _ in flat.calls} == {"rays", "casts", "joints"}
    with pytest.raises(ValueError, match="length: expected a number >= 0, got -1"):
        graze.draw_ray(on, (0, 0, 0), (1, 0, 0), -1)
    with pytest.raises(ValueError, match="layer: expected one of shapes"):
        graze.draw_bounds(on, (0, 0, 0), (1, 1, 1), "boxes")
