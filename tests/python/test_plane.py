"""The plane: answers against closed forms and each other, batches, poses, errors, pickles."""

import itertools
import math
import pickle
import threading

import numpy as np
import pytest

from graze import plane

SHAPES = {
    "circle": plane.Circle(0.5),
    "capsule": plane.Capsule(1.0, 0.4),
    "tapered": plane.Capsule(1.0, 0.4, 0.1),
    "box": plane.Box((2, 1), rounding=0.1),
    "segment": plane.Segment((-1, 0), (1, 0.5), rounding=0.2),
    "convex": plane.ConvexPolygon([(0, 0), (2, 0), (1, 1), (1, 0.2)]),
    "ellipse": plane.Ellipse((1.0, 0.5)),
    "user": plane.UserConvex(lambda d: (math.copysign(1, d[0]), math.copysign(0.5, d[1]))),
    "half_plane": plane.HalfPlane(),
    "polygon": plane.Polygon([(0, 0), (2, 0), (2, 2), (1, 0.5), (0, 2)]),
    "chain": plane.Chain([(-2, 0), (0, 0.5), (2, 0)]),
    "compound": plane.Compound([(plane.Circle(0.5), (1, 0)), (plane.Box((1, 1)), ((-1, 0), 0.3))]),
    "rounded compound": plane.Compound([(plane.Circle(0.5), (1, 0)), (plane.Box((1, 1)), None)], rounding=0.25),
}
PAIRS = list(itertools.product(SHAPES, SHAPES))


def random_rows(rng, count, reach):
    """Poses with the rotations that are left of these when they are brought to unit length: a batch takes rows as they
    are, a call for one pair brings them there."""
    angle = rng.uniform(-math.pi, math.pi, count)
    rows = np.column_stack([rng.uniform(-reach, reach, (count, 2)), np.cos(angle), np.sin(angle)])
    for row in rows:
        while (unit := plane.Pose.from_matrix(matrix_of(row)).rotation).tolist() != row[2:].tolist():
            row[2:] = unit
    return rows


def test_distance_of_circles_is_the_closed_form():
    rng = np.random.default_rng(1)
    for x, y, r, s in rng.uniform(0.1, 3, (200, 4)):
        d = plane.distance(plane.Circle(r), None, plane.Circle(s), (x, y))
        assert d.distance == pytest.approx(math.hypot(x, y) - r - s, abs=1e-12)
        np.testing.assert_allclose(d.normal, np.array([x, y]) / math.hypot(x, y), atol=1e-12)


def test_distance_of_circle_and_box_is_the_closed_form():
    rng = np.random.default_rng(2)
    box = plane.Box((2, 1))
    for x, y, angle in rng.uniform(-3, 3, (200, 3)):
        local = np.array([math.cos(angle) * x + math.sin(angle) * y, math.cos(angle) * y - math.sin(angle) * x])
        gap = np.abs(local) - (1, 0.5)
        truth = np.linalg.norm(np.maximum(gap, 0)) + min(gap.max(), 0) - 0.25
        d = plane.distance(box, ((0, 0), angle), plane.Circle(0.25), (x, y))
        assert d.distance == pytest.approx(truth, abs=1e-12)
        c = plane.closest(box, (0, 0, angle), (x, y))
        assert c.distance == pytest.approx(truth + 0.25, abs=1e-12)


@pytest.mark.parametrize("a,b", PAIRS)
def test_questions_agree(a, b):
    rng = np.random.default_rng(PAIRS.index((a, b)))
    for row in random_rows(rng, 8, 3.0):
        here, there = ((0.3, -0.2), 0.4), row
        d = plane.distance(SHAPES[a], here, SHAPES[b], there)
        if d.status == "unbounded":
            assert plane.overlap(SHAPES[a], here, SHAPES[b], there)
            continue
        assert plane.overlap(SHAPES[a], here, SHAPES[b], there) == (d.distance <= 0)
        np.testing.assert_allclose(d.b - d.a, d.distance * d.normal, atol=1e-9)
        swapped = plane.distance(SHAPES[b], there, SHAPES[a], here)
        assert swapped.distance == pytest.approx(d.distance, abs=1e-8)
        explained, trace = plane.distance(SHAPES[a], here, SHAPES[b], there, trace=True)
        assert explained.distance == d.distance and isinstance(trace["method"], str)
        if d.distance > 0:  # what is a gap is closed after that way
            hit = plane.cast(SHAPES[a], here, (0, 0), SHAPES[b], there, -2 * d.distance * d.normal)
            assert hit is not None and hit.t <= 0.5 + 1e-6
            assert plane.contacts(SHAPES[a], here, SHAPES[b], there) == []


@pytest.mark.parametrize("a,b", PAIRS)
def test_questions_up_to_a_limit_agree_with_the_distance(a, b):
    for row in random_rows(np.random.default_rng(PAIRS.index((a, b))), 8, 3.0):
        d = plane.distance(SHAPES[a], None, SHAPES[b], row)
        near = plane.distance_up_to(SHAPES[a], None, SHAPES[b], row, 0.75)
        assert plane.within(SHAPES[a], None, SHAPES[b], row, 0.75) == (d.distance <= 0.75) == (near is not None)
        assert near is None or near.distance == d.distance and near.normal.tolist() == d.normal.tolist()


def test_near_pieces_are_the_children_that_are_near():
    children = [(plane.Circle(0.5), (i % 4, i // 4)) for i in range(12)]
    probe = plane.Capsule(1.0, 0.3)
    for row in random_rows(np.random.default_rng(11), 20, 3.0):
        alone = {i: plane.distance(c, at, probe, row).distance for i, (c, at) in enumerate(children)}
        found = plane.near_pieces(plane.Compound(children), None, probe, row, 0.25)
        assert [(i, 0) for i, d in alone.items() if d <= 0.25] == [(i, j) for i, j, _ in found]
        assert [d.distance for _, _, d in found] == pytest.approx([alone[i] for i, _, _ in found], abs=1e-12)


@pytest.mark.parametrize("name", ["circle", "capsule", "tapered", "box", "segment", "convex", "ellipse", "user"])
def test_a_swept_shape_is_the_shape_at_every_time(name):
    shape, probe, steps = SHAPES[name], plane.Circle(0.1), 400
    rng = np.random.default_rng(12)
    for row, there, motion in zip(random_rows(rng, 5, 1.0), rng.uniform(-4, 4, (5, 2)), rng.uniform(-3, 3, (5, 2))):
        path = shape.swept(row, motion)
        times = np.arange(steps + 1) / steps
        least = min(plane.distance(shape, row + [*(t * motion), 0, 0], probe, there).distance for t in times)
        if least > 0:  # between two times the distance changes by no more than the way between them
            found = plane.distance(path, row, probe, there).distance
            assert least - np.linalg.norm(motion) / steps <= found <= least + 1e-9
        direction = rng.normal(size=2)
        local = plane.Pose.from_matrix(matrix_of(row)).inverse() @ (row[:2] + motion)
        furthest = max(shape.support(direction) @ direction, (shape.support(direction) + local) @ direction)
        assert path.support(direction) @ direction == pytest.approx(furthest, abs=1e-12)
        assert np.all(np.array(path.bounds(row)[0]) <= np.minimum(shape.bounds(row)[0], shape.bounds(row)[0] + motion) + 1e-9)


def test_a_swept_shape_without_a_support_function_in_python_is_not_pickled():
    with pytest.raises(TypeError, match="a swept shape is not pickled"):
        pickle.dumps(SHAPES["ellipse"].swept(None, (1, 0)))
    path = pickle.loads(pickle.dumps(SHAPES["circle"].swept(None, (1, 0))))
    assert path.b.tolist() == [1, 0] and path.rounding == 0.5


@pytest.mark.parametrize("a,b", PAIRS)
def test_batch_is_each_alone(a, b):
    rows = random_rows(np.random.default_rng(PAIRS.index((a, b))), 20, 2.0)
    here = plane.Pose((0.1, 0.2), 0.3)
    touch = plane.batch.overlap(SHAPES[a], here, SHAPES[b], rows)
    found = plane.batch.distance(SHAPES[a], here, SHAPES[b], rows)
    pairs, manifolds, points = plane.batch.contacts(SHAPES[a], here, SHAPES[b], rows, margin=0.1)
    poses = [pickle.loads(pickle.dumps(plane.Pose.from_matrix(matrix_of(row)))) for row in rows]
    assert touch.dtype == bool and len(found) == len(pairs) == 20
    for i in range(20):
        d = plane.distance(SHAPES[a], here, SHAPES[b], poses[i])
        assert found["distance"][i] == pytest.approx(d.distance, abs=1e-9)
        assert bool(touch[i]) == (found["distance"][i] <= 0) or found["status"][i] == 2
        alone = plane.contacts(SHAPES[a], here, SHAPES[b], rows[i], margin=0.1)
        assert pairs["manifold_count"][i] == len(alone)
        groups = manifolds[pairs["first_manifold"][i] :][: len(alone)]
        for group, manifold in zip(groups, alone):
            np.testing.assert_allclose(group["normal"], manifold.normal, atol=1e-9)
            mine = points[group["first_point"] :][: group["point_count"]]
            assert [p.feature for p in manifold.points] == list(mine["feature"])
            np.testing.assert_allclose(mine["a"], [p.a for p in manifold.points], atol=1e-9)


def matrix_of(row):
    x, y, c, s = row
    return np.array([[c, -s, x], [s, c, y], [0, 0, 1]])


def test_batch_takes_pairs_and_shares_memory_of_answers():
    boxes = [plane.Box((1, 1)), plane.Box((3, 3))]
    rows = np.array([[0, 0, 1, 0], [1.5, 0, 1, 0]], dtype=float)
    touch = plane.batch.overlap(boxes, rows, boxes, rows, pairs=[(0, 1), (1, 1), (0, 0)])
    assert touch.tolist() == [True, True, True]
    assert not touch.flags.owndata  # the library's own vector, not a copy
    far = rows.copy()
    far[1, 0] = 2.5
    assert plane.batch.distance(boxes, far, boxes, far, pairs=[(0, 1)])["distance"][0] == 0.5


def test_pose_forms_are_the_same():
    c, s = math.cos(0.7), math.sin(0.7)
    forms = [plane.Pose((1, 2), 0.7), ((1, 2), 0.7), (1, 2, 0.7), (1, 2, c, s), np.array([1, 2, c, s])]
    forms += [matrix_of((1, 2, c, s)), np.float32([1, 2, c, s])]
    boxes = plane.Box((2, 1)), plane.Box((1, 3))
    answers = [plane.distance(boxes[0], None, boxes[1], form).distance for form in forms]
    assert answers[:5] == [answers[0]] * 5
    np.testing.assert_allclose(answers, answers[0], atol=1e-6)
    pose = forms[0]
    np.testing.assert_allclose((pose @ pose.inverse()).matrix, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(pose @ (1, 0), [1 + c, 2 + s])
    assert pose == plane.Pose((1, 2), 0.7) and hash(pose) == hash(plane.Pose((1, 2), 0.7))


@pytest.mark.parametrize("name", [n for n in SHAPES if n != "user"])
def test_pickle_and_repr(name):
    shape = SHAPES[name]
    again = pickle.loads(pickle.dumps(shape))
    assert type(again) is type(shape) and repr(again) == repr(shape)
    assert repr(shape).startswith("graze.plane.")
    for row in random_rows(np.random.default_rng(3), 5, 2.0):
        one = plane.distance(shape, None, plane.Circle(0.3), row)
        assert plane.distance(again, None, plane.Circle(0.3), row).distance == one.distance
    pose = plane.Pose((1, 2), 0.3)
    assert pickle.loads(pickle.dumps(pose)) == pose


@pytest.mark.parametrize(
    "make,named",
    [
        (lambda: plane.Circle(-1), "radius: expected a finite number >= 0, got -1"),
        (lambda: plane.Box((1, float("nan"))), "size[1]"),
        (lambda: plane.Polygon([(0, 0), (1, 1), (1, 0), (0, 1)]), "points"),
        (lambda: plane.Chain([(0, 0), (0, 0)]), "points"),
        (lambda: plane.ConvexPolygon([(0, 0, 0)]), "shape (n, 2)"),
        (lambda: plane.Compound([]), "children"),
        (lambda: plane.Pose((0, float("inf"))), "translation[1]"),
        (lambda: plane.overlap(plane.Circle(1), np.diag([2.0, 2.0, 1.0]), plane.Circle(1), None), "pose"),
        (lambda: plane.contacts(plane.Circle(1), None, plane.Circle(1), None, margin=-1), "margin"),
        (lambda: plane.within(plane.Circle(1), None, plane.Circle(1), None, -1), "limit: expected a number >= 0, got -1"),
        (lambda: SHAPES["chain"].support((1, 0)), "shape: expected a bounded convex shape"),
        (lambda: SHAPES["half_plane"].swept(None, (1, 0)), "shape: expected a bounded convex shape"),
        (lambda: plane.Circle(1).swept(None, (float("nan"), 0)), "motion[0]"),
        (lambda: plane.raycast(plane.Circle(1), None, (0, float("nan")), (1, 0)), "origin[1]: expected a finite number"),
        (lambda: plane.raycast_any(plane.Circle(1), None, (0, 0), (float("inf"), 0)), "direction[0]"),
        (lambda: plane.raycast_all(plane.Circle(1), None, (0, float("nan")), (1, 0)), "origin[1]"),
        (lambda: plane.World().raycast((0, 0), (float("nan"), 0)), "direction[0]"),
        (lambda: plane.feature_corners(plane.Box((1, 1)), 1 << 16), "feature: expected an integer from 0 to 65535"),
        (lambda: plane.batch.overlap(plane.Circle(1), None, plane.Circle(1), np.ones((2, 4))), "poses_b[0].rotation"),
        (lambda: plane.batch.overlap(plane.Circle(1), None, plane.Circle(1), None, pairs=[(0, 7)]), "pairs"),
    ],
)
def test_errors_name_the_value(make, named):
    with pytest.raises(ValueError) as caught:
        make()
    assert named in str(caught.value)


def test_what_is_no_pose_is_a_type_error():
    with pytest.raises(TypeError):
        plane.overlap(plane.Circle(1), "here", plane.Circle(1), None)
    with pytest.raises(TypeError):
        plane.Compound([plane.Circle(1)])


def test_ray_and_cast():
    hit = plane.raycast(plane.Box((2, 2)), None, (-4, 0.5), (2, 0))
    assert hit.t == pytest.approx(3) and hit.normal.tolist() == [-1, 0]
    assert plane.raycast(plane.Box((2, 2)), None, (-4, 0.5), (2, 0), length=2.9) is None
    # A bar of half length 2 that turns at pi a unit of time reaches a ball of radius 1/2 at (0, 1.5) after nearly 1/2.
    hit = plane.cast(plane.Segment((-2, 0), (2, 0)), None, (0, 0), plane.Circle(0.5), (0, 1.5), (0, 0), angular_a=math.pi)
    assert hit.t == pytest.approx(0.5 - math.asin(0.5 / 1.5) / math.pi, abs=1e-4)


def test_shapes_outlive_what_they_were_made_of():
    points = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)])
    polygon = plane.Polygon(points)
    points[:] = 99
    assert plane.closest(polygon, None, (1.9, 1.0)).distance < 0
    compound = plane.Compound([(plane.Polygon(polygon.points), None)])
    del polygon
    assert plane.closest(compound, None, (1.9, 1.0)).distance < 0


def test_batches_run_beside_other_threads():
    rng = np.random.default_rng(5)
    rows = random_rows(rng, 20000, 20.0)
    shape = plane.Polygon([(0, 0), (2, 0), (2, 2), (1, 0.5), (0, 2)])
    expected = plane.batch.distance(shape, None, shape, rows)["distance"]
    answers = [None] * 4

    def ask(i):
        answers[i] = plane.batch.distance(shape, None, shape, rows)["distance"]

    threads = [threading.Thread(target=ask, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    ticks = 0
    while any(thread.is_alive() for thread in threads):
        ticks += 1
    for thread in threads:
        thread.join()
    assert ticks > 100 and all(np.array_equal(a, expected) for a in answers)


def test_near_pieces_of_many_pairs_are_those_of_each():
    row = plane.Compound([(plane.Circle(0.5), (3 * i, 0)) for i in range(4)])
    steps = plane.Chain([(0, 0), (1, 0), (1, 1), (2, 1)])
    probe, places = plane.Box((1, 1)), [(0, 0.75), (3, 0.75), (50, 0)]
    pieces, ends = plane.batch.near_pieces([row, steps, row], None, probe, places, 0.4)
    begin = 0
    for shape, place, end in zip([row, steps, row], places, ends):
        alone = plane.near_pieces(shape, None, probe, place, 0.4)
        assert [(a, b, d.distance) for a, b, d in alone] == [
            (p["piece_a"], p["piece_b"], p["distance"]) for p in pieces[begin:end]
        ]
        begin = end
    assert ends.tolist()[-1] == len(pieces) > 0
    with pytest.raises(ValueError, match="margin"):
        plane.batch.near_pieces(row, None, probe, places, -1)


def test_mass_properties_are_the_closed_forms():
    area, center, inertia = plane.Box((2, 1)).mass_properties()
    assert area == 2 and center.tolist() == [0, 0]
    assert inertia == pytest.approx(2 * (2**2 + 1) / 12, rel=1e-14)
    area, _, inertia = plane.Circle(3).mass_properties()
    assert area == pytest.approx(9 * np.pi, rel=1e-14) and inertia == pytest.approx(area * 9 / 2, rel=1e-14)
    assert plane.HalfPlane().mass_properties()[0] == 0


def test_convex_is_what_no_line_leaves_twice():
    corners = [(0, 0), (1, 0), (0, 1)]
    convex = [plane.Circle(1), plane.HalfPlane(), plane.ConvexPolygon(corners), plane.Segment((0, 0), (1, 0))]
    assert all(shape.convex for shape in convex)
    assert not any(s.convex for s in (plane.Polygon(corners), plane.Chain(corners), plane.Compound([(convex[0], None)])))
