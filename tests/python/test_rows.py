"""Batches of points, casts, near pieces and the plane's rays are each alone; all hits; corners of features."""

import math

import numpy as np
import pytest

import graze
from graze import plane

CUBE_CORNERS = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
SPACE = [
    graze.Box((1, 2, 3)), graze.Cylinder(2, 0.5), graze.ConvexHull(CUBE_CORNERS),
    graze.Compound([(graze.Sphere(0.5), (1, 0, 0)), (graze.Box((1, 1, 1)), (-1, 0, 0))])]
PLANE = [
    plane.Box((1, 2)), plane.Circle(0.7), plane.Polygon([(0, 0), (2, 0), (2, 2), (1, 0.5), (0, 2)]),
    plane.Ellipse((1.0, 0.5))]


def same(row, answer, *names):
    for name in names:
        assert np.array_equal(row[name], getattr(answer, name)), name


@pytest.mark.parametrize("words,shapes,size,pose", [
    (graze, SPACE, 3, ((0.1, 0.2, 0.3), (0, 0.6, 0, 0.8))), (plane, PLANE, 2, ((0.1, 0.2), 0.4))])
def test_points_are_each_alone(words, shapes, size, pose):
    points = np.random.default_rng(1).uniform(-1.2, 1.2, (50, size))
    for shape in shapes:
        found = words.batch.closest(shape, pose, points)
        assert len(found) == 50 and (found["distance"] < 0).any()
        for point, row in zip(points, found):
            same(row, words.closest(shape, pose, point), "distance", "point", "normal", "error")
    assert words.batch.closest(shapes[0], None, np.zeros(size)).shape == (1,)
    assert words.batch.closest(shapes[0], None, np.zeros((0, size))).shape == (0,)
    with pytest.raises(ValueError, match=r"points\[1\]"):
        words.batch.closest(shapes[0], None, [[0] * size, [math.inf] * size])
    with pytest.raises(ValueError, match="points"):
        words.batch.closest(shapes[0], None, np.zeros((2, 5)))


def test_rays_of_the_plane_are_each_alone():
    rng = np.random.default_rng(2)
    origins, directions = rng.uniform(-3, 3, (200, 2)), rng.uniform(-1, 1, (200, 2))
    pose = ((0.1, 0.2), 0.4)
    for shape in PLANE:
        found = plane.batch.raycast(shape, pose, origins, directions, 5)
        some = plane.batch.raycast_any(shape, pose, origins, directions, 5)
        assert 0 < found["hit"].sum() < 200
        for ray, row, hit in zip(zip(origins, directions), found, some):
            alone = plane.raycast(shape, pose, *ray, 5)
            assert bool(row["hit"]) == bool(hit) == (alone is not None) == plane.raycast_any(shape, pose, *ray, 5)
            every = plane.raycast_all(shape, pose, *ray, 5)
            assert bool(every) == bool(hit) and [h.t for h in every] == sorted(h.t for h in every)
            if alone is None:
                assert np.isinf(row["t"])
            else:
                same(row, alone, "t", "point", "normal", "piece")
                assert every[0].t == alone.t
    comb = plane.Polygon([(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)])
    assert len(plane.raycast_all(comb, None, (-1, 1.5), (1, 0))) == 2


def test_casts_are_each_alone():
    rng = np.random.default_rng(3)
    linear, angular = rng.uniform(-4, 4, (40, 3)), rng.uniform(-2, 2, (40, 3))
    poses = [tuple(p) for p in rng.uniform(-4, 4, (40, 3))]
    for shape in SPACE[:2]:
        found = graze.batch.cast(shape, None, (0, 0, 0), SPACE[0], poses, linear, 1.5, angular_b=angular)
        assert 0 < found["hit"].sum() < 40
        for i, row in enumerate(found):
            alone = graze.cast(shape, None, (0, 0, 0), SPACE[0], poses[i], linear[i], 1.5, angular_b=angular[i])
            assert bool(row["hit"]) == (alone is not None)
            if alone is not None:
                same(row, alone, "t", "point", "normal", "depth", "piece_a", "piece_b")
            else:
                assert np.isinf(row["t"])


def test_casts_of_the_plane_are_each_alone():
    rng = np.random.default_rng(4)
    linear, angular = rng.uniform(-4, 4, (40, 2)), rng.uniform(-2, 2, 40)
    poses = [tuple(p) for p in rng.uniform(-4, 4, (40, 2))]
    found = plane.batch.cast(PLANE[2], None, (0, 0), PLANE[0], poses, linear, 1.5, angular_b=angular)
    assert 0 < found["hit"].sum() < 40
    for i, row in enumerate(found):
        alone = plane.cast(PLANE[2], None, (0, 0), PLANE[0], poses[i], linear[i], 1.5, angular_b=angular[i])
        assert bool(row["hit"]) == (alone is not None)
        if alone is not None:
            same(row, alone, "t", "point", "normal", "depth", "piece_a", "piece_b")
    # Velocities go by bodies, not by pairs.
    bodies = [(9, 0), (0, 9)]
    pairs = [(0, 1), (0, 0)]
    ball = plane.Circle(0.5)
    found = plane.batch.cast(ball, None, (0, 0), ball, bodies, [(-16, 0), (0, -8)], 2, angular_b=1.0, pairs=pairs)
    assert found["t"].round(9).tolist() == [1.0, 0.5]
    for wrong in (dict(linear_b=[(1, 0)] * 3), dict(linear_b=(0, math.nan)), dict(linear_b=(0, 0), duration=-1),
                  dict(linear_b=(0, 0), angular_b=[1, 2, 3])):
        with pytest.raises(ValueError):
            plane.batch.cast(ball, None, (0, 0), ball, bodies, **wrong)


def test_near_pieces_are_each_alone():
    poses = [(1.2, 0, 0), (0, 1.5, 0), (9, 0, 0)]
    pieces, ends = graze.batch.near_pieces(SPACE[3], None, SPACE[3], poses, 0.6)
    begin = 0
    for pose, end in zip(poses, ends):
        alone = graze.near_pieces(SPACE[3], None, SPACE[3], pose, 0.6)
        assert end - begin == len(alone)
        for row, (a, b, d) in zip(pieces[begin:end], alone):
            assert (row["piece_a"], row["piece_b"]) == (a, b)
            same(row, d, "distance", "normal", "a", "b")
        begin = end
    assert ends[0] > 0 and ends[1] == ends[2]


def test_all_hits_of_casts():
    two = graze.Compound([(graze.Sphere(0.5), (4, 0, 0)), (graze.Sphere(0.5), (2, 0, 0))])
    hits = graze.cast_all(graze.Sphere(0.5), None, (5, 0, 0), two, None, (0, 0, 0))
    assert [(round(h.t, 9), h.piece_b) for h in hits] == [(0.2, 1), (0.6, 0)]
    both = plane.Compound([(plane.Circle(0.5), (4, 0)), (plane.Circle(0.5), (2, 0))])
    hits = plane.cast_all(plane.Circle(0.5), None, (5, 0), both, None, (0, 0))
    assert [(round(h.t, 9), h.piece_b) for h in hits] == [(0.2, 1), (0.6, 0)]
    assert graze.cast_all(graze.Sphere(0.5), None, (-5, 0, 0), two, None, (0, 0, 0)) == []


def test_corners_of_features_lie_where_points_of_contact_are():
    box = graze.Box((2, 2, 2))
    [manifold] = graze.contacts(graze.HalfSpace(), None, box, (0, 0.99, 0))
    corners = {tuple(graze.feature_corners(box, p.feature & 0xFFFF)[0]) for p in manifold.points}
    assert corners == {(x, -1.0, z) for x in (-1, 1) for z in (-1, 1)}
    square = plane.Box((2, 2))
    [manifold] = plane.contacts(plane.HalfPlane(), None, square, (0, 0.99))
    corners = {tuple(plane.feature_corners(square, p.feature & 0xFFFF)[0]) for p in manifold.points}
    assert corners == {(-1.0, -1.0), (1.0, -1.0)}
    manifold.reduce(1)
    assert len(manifold) == 1
    assert graze.feature_corners(graze.Sphere(1), 0).shape == (0, 3)


def test_small_questions():
    box = graze.Box((1, 1, 1))
    assert graze.may_overlap(box, None, box, (0.9, 0, 0)) and not graze.may_overlap(box, None, box, (5, 0, 0))
    pose = graze.pose_at((1, 0, 0), (0, 2, 0), (0, 0, math.pi), 0.5)
    np.testing.assert_allclose(pose @ (1, 0, 0), (1, 2, 0), atol=1e-12)
    turned = plane.pose_at((1, 0), (0, 2), math.pi, 0.5)
    np.testing.assert_allclose(turned @ (1, 0), (1, 2), atol=1e-12)
    with pytest.raises(ValueError, match="t: "):
        graze.pose_at(None, (0, 0, 0), (0, 0, 0), math.inf)
    found = graze.Mesh(np.array([[0, 0, 0], [2, 0, 0], [0, 0, 2.0]]), np.array([[0, 1, 2]])).findings()
    assert (found["triangles"], found["open_edges"], found["flat_edges"], found["t_junctions"]) == (1, 3, 0, 0)


@pytest.mark.parametrize("words,row", [(graze, (0, 0, 0, 0, 0, 0, 1.0)), (plane, (0, 0, 1.0, 0))])
def test_rows_that_are_no_numbers_are_refused(words, row):
    ball = words.Sphere(1) if words is graze else words.Circle(1)
    for column in range(len(row)):
        rows = np.array([row, row])
        rows[1, column] = math.nan
        with pytest.raises(ValueError, match=r"poses_b\[1\]"):
            words.batch.overlap(ball, None, ball, rows)


@pytest.mark.parametrize("of", [graze, plane])
def test_contacts_of_a_batch_with_at_most_so_many_points(of):
    box = of.Box((1, 1, 1) if of is graze else (1, 1))
    places = [(0.1 * i, 0.9) + ((0,) if of is graze else ()) for i in range(8)]
    all_pairs, _, all_points = of.batch.contacts(box, None, box, places)
    pairs, manifolds, points = of.batch.contacts(box, None, box, places, most=1)
    assert len(all_points) > len(points) == len(pairs) == len(all_pairs) == 8
    for i, place in enumerate(places):
        [alone] = of.contacts(box, None, box, place)
        alone.reduce(1)
        m = manifolds[pairs[i]["first_manifold"]]
        assert m["point_count"] == 1 and points[m["first_point"]]["a"].tolist() == alone.points[0].a.tolist()
    with pytest.raises(ValueError, match="most: expected a number >= 1, got 0"):
        of.batch.contacts(box, None, box, places, most=0)


@pytest.mark.parametrize("count", [1, 3, 64, 256, 259])
@pytest.mark.parametrize("kit", [graze, plane], ids=["space", "plane"])
def test_every_number_of_every_row_is_looked_at(kit, count):
    """Poses are looked at many at a time: a fault is found wherever it is, and none where there is none."""
    in_space = kit is graze
    shape = graze.Sphere(1) if in_space else plane.Circle(1)
    rows = np.zeros((count, 7 if in_space else 4))
    rows[:, 6 if in_space else 2] = 1
    coordinates = 3 if in_space else 2
    kit.batch.overlap(shape, None, shape, rows)
    for row in {0, count // 2, count - 1}:
        for column in range(rows.shape[1]):
            for wrong in (np.nan, np.inf, -np.inf, 2e48, -2e48, 1e200):
                bad = rows.copy()
                bad[row, column] = wrong
                part = "translation" if column < coordinates else "rotation"
                with pytest.raises(ValueError, match=rf"poses_b\[{row}\]\.{part}"):
                    kit.batch.overlap(shape, None, shape, bad)
        far = rows.copy()
        far[row, :coordinates] = 9e47  # allowed, and more than the quick look is sure of
        kit.batch.overlap(shape, None, shape, far)
        off = rows.copy()
        off[row, coordinates:] *= 1 + 1e-6  # its square is off by twice that
        with pytest.raises(ValueError, match=rf"poses_b\[{row}\]\.rotation"):
            kit.batch.overlap(shape, None, shape, off)


def test_rotations_of_single_precision_are_of_unit_length():
    random = np.random.default_rng(4)
    rows = np.zeros((5000, 7))
    rotations = random.normal(size=(5000, 4))
    rows[:, 3:] = (rotations / np.linalg.norm(rotations, axis=1, keepdims=True)).astype(np.float32)
    assert graze.batch.overlap(graze.Sphere(1), None, graze.Sphere(1), rows).all()


def test_answers_that_are_held_stay():
    """Memory of answers is used again, but not of those that somebody has."""
    box, ball = graze.Box((2, 2, 2)), graze.Sphere(1)
    near, far = np.zeros((500, 7)), np.zeros((500, 7))
    near[:, 6] = far[:, 6] = 1
    far[:, 0] = 9
    kept = graze.batch.distance(box, None, ball, near)
    view, copy = kept["distance"][10:20], kept.copy()
    for _ in range(3):
        assert (graze.batch.distance(box, None, ball, far)["distance"] == 7).all()
    assert (kept == copy).all()
    del kept
    for _ in range(3):
        graze.batch.distance(box, None, ball, far)
    assert (view == copy["distance"][10:20]).all()
    fewer = graze.batch.distance(box, None, ball, far[:7])
    assert len(fewer) == 7 and (fewer["distance"] == 7).all()


def test_arrays_of_shapes_of_one_kind_and_of_many_answer_alike():
    random = np.random.default_rng(6)
    poses = np.zeros((200, 7))
    poses[:, :3], poses[:, 6] = random.uniform(-2, 2, (200, 3)), 1
    kinds = [graze.Box((1, 2, 1)), graze.Sphere(0.7), graze.Capsule(1, 0.4), graze.Cylinder(1, 0.5), graze.HalfSpace(),
             graze.Triangle((0, 0, 0), (1, 0, 0), (0, 1, 0)), graze.Box((1, 1, 1), rounding=0.2)]
    for shape in kinds:
        alone = [graze.distance(shape, None, graze.Sphere(0.5), pose).distance for pose in poses]
        array = graze.ShapeArray([shape] * 200)
        mixed = graze.ShapeArray([shape] * 199 + [graze.ConvexHull(random.normal(size=(9, 3)))])
        for shapes in (shape, array, array[:]):
            assert graze.batch.distance(shapes, None, graze.Sphere(0.5), poses)["distance"].tolist() == alone
        assert graze.batch.distance(mixed, None, graze.Sphere(0.5), poses)["distance"][:199].tolist() == alone[:199]
        assert repr(array[3]) == repr(mixed[3]) == repr(shape)
