"""Space: answers against closed forms and each other, batches, poses, errors, pickles."""

import itertools
import math
import pickle
import threading

import numpy as np
import pytest

import graze

CUBE = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))
FACES = np.array(
    [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
)
SHAPES = {
    "sphere": graze.Sphere(0.5),
    "capsule": graze.Capsule(1.0, 0.4),
    "tapered": graze.Capsule(1.0, 0.4, 0.1),
    "box": graze.Box((2, 1, 1), rounding=0.1),
    "cylinder": graze.Cylinder(1.0, 0.5),
    "ellipsoid": graze.Ellipsoid((1.0, 0.5, 0.75)),
    "hull": graze.ConvexHull(CUBE),
    "mesh": graze.Mesh(CUBE, FACES, solid=True),
    "field": graze.HeightField([[0, 0.5, 0], [0.25, 0, 0], [0, 0, 1]]),
    "half_space": graze.HalfSpace(),
    "compound": graze.Compound([(graze.Sphere(0.5), (1, 0, 0)), (graze.Box((1, 1, 1)), (-1, 0, 0))]),
}
PAIRS = [(a, b) for a, b in itertools.product(SHAPES, SHAPES) if (a, b) != ("half_space", "half_space")]


def random_rows(rng, count, reach):
    q = rng.normal(size=(count, 4))
    return np.column_stack([rng.uniform(-reach, reach, (count, 3)), q / np.linalg.norm(q, axis=1, keepdims=True)])


def test_distance_of_spheres_is_the_closed_form():
    rng = np.random.default_rng(1)
    for x, y, z, r, s in rng.uniform(0.1, 3, (200, 5)):
        d = graze.distance(graze.Sphere(r), None, graze.Sphere(s), (x, y, z))
        assert d.distance == pytest.approx(math.sqrt(x * x + y * y + z * z) - r - s, abs=1e-12)
        np.testing.assert_allclose(d.b - d.a, d.normal * d.distance, atol=1e-12)


def test_distance_of_ball_and_box_is_the_closed_form():
    rng = np.random.default_rng(2)
    box = graze.Box((2, 1, 3))
    for row in random_rows(rng, 200, 3.0):
        pose = graze.Pose(row[:3], row[3:])
        local = pose.inverse() @ (0, 0, 0)
        gap = np.abs(local) - (1, 0.5, 1.5)
        truth = np.linalg.norm(np.maximum(gap, 0)) + min(gap.max(), 0) - 0.25
        assert graze.distance(box, row, graze.Sphere(0.25), None).distance == pytest.approx(truth, abs=1e-12)
        assert graze.closest(box, pose, (0, 0, 0)).distance == pytest.approx(truth + 0.25, abs=1e-12)


@pytest.mark.parametrize("a,b", PAIRS)
def test_questions_agree(a, b):
    rng = np.random.default_rng(PAIRS.index((a, b)))
    for row in random_rows(rng, 4, 2.5):
        here = ((0.3, -0.2, 0.1), (0, 0, 0.6, 0.8))
        d = graze.distance(SHAPES[a], here, SHAPES[b], row)
        assert graze.overlap(SHAPES[a], here, SHAPES[b], row) == (d.distance <= 0)
        assert graze.within(SHAPES[a], here, SHAPES[b], row, max(d.distance, 0) + 1e-6)
        manifolds = graze.contacts(SHAPES[a], here, SHAPES[b], row, margin=0.1)
        assert bool(manifolds) == (d.distance <= 0.1) or abs(d.distance - 0.1) < 1e-9
        for m in manifolds:
            for p in m.points:
                np.testing.assert_allclose(p.b - p.a, m.normal * p.distance, atol=1e-9)


def test_a_batch_has_the_bits_of_each_pair():
    rng = np.random.default_rng(3)
    poses_a, poses_b = random_rows(rng, 500, 1.5), random_rows(rng, 500, 1.5)
    shapes = [list(SHAPES.values())[i % 6] for i in range(500)]
    distances = graze.batch.distance(graze.Box((1, 1, 1)), poses_a, shapes, poses_b)
    touch = graze.batch.overlap(graze.Box((1, 1, 1)), poses_a, shapes, poses_b)
    for i in range(500):
        alone = graze.distance(graze.Box((1, 1, 1)), poses_a[i], shapes[i], poses_b[i])
        assert distances["distance"][i] == alone.distance
        assert touch[i] == (alone.distance <= 0)


def test_compact_contacts_are_those_of_the_pairs():
    rng = np.random.default_rng(13)
    rows, box = random_rows(rng, 300, 1.0), graze.Box((1, 2, 1))
    manifolds, points = graze.batch.compact_contacts(box, None, box, rows, margin=0.1)
    groups = {}
    for manifold in manifolds:
        groups.setdefault(int(manifold["pair"]), []).append(manifold)
    assert len(groups) > 100
    for i, row in enumerate(rows):
        alone = graze.contacts(box, None, box, row, margin=0.1)
        assert len(alone) == len(groups.get(i, []))
        for m, group in zip(alone, groups.get(i, [])):
            np.testing.assert_array_equal(group["normal"], m.normal)
            mine = points[group["first_point"] :][: group["point_count"]]
            assert mine["distance"].tolist() == [p.distance for p in m.points]
            np.testing.assert_array_equal(mine["position"], [p.position for p in m.points])


def test_batches_from_several_threads_are_the_same():
    rng = np.random.default_rng(4)
    poses = random_rows(rng, 20000, 3.0)
    expected = graze.batch.distance(graze.Box((1, 2, 1)), None, graze.Sphere(0.5), poses)["distance"]
    results = [None] * 4

    def work(i):
        results[i] = graze.batch.distance(graze.Box((1, 2, 1)), None, graze.Sphere(0.5), poses)["distance"]

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    for r in results:
        np.testing.assert_array_equal(r, expected)


def test_rays_and_casts():
    hit = graze.raycast(graze.Sphere(1.0), None, (-5, 0, 0), (2, 0, 0))
    assert hit.t == pytest.approx(4, abs=1e-12)
    np.testing.assert_allclose(hit.normal, (-1, 0, 0), atol=1e-12)
    assert graze.raycast(graze.Sphere(1.0), None, (-5, 2, 0), (1, 0, 0)) is None
    blow = graze.cast(graze.Box((2, 2, 2)), None, (0, 0, 0), graze.Sphere(0.5), (9, 0, 0), (-15, 0, 0), 1.0)
    assert blow.t == pytest.approx(0.5, abs=1e-6)


@pytest.mark.parametrize("name", ["sphere", "capsule", "tapered", "box", "cylinder", "ellipsoid", "hull"])
def test_a_swept_shape_is_the_shape_at_every_time(name):
    shape, probe, steps = SHAPES[name], graze.Sphere(0.1), 400
    rng = np.random.default_rng(12)
    for row, there, motion in zip(random_rows(rng, 5, 1.0), rng.uniform(-4, 4, (5, 3)), rng.uniform(-3, 3, (5, 3))):
        path = shape.swept(row, motion)
        times = np.arange(steps + 1) / steps
        least = min(graze.distance(shape, row + [*(t * motion), 0, 0, 0, 0], probe, there).distance for t in times)
        if least > 0:  # between two times the distance changes by no more than the way between them
            found = graze.distance(path, row, probe, there).distance
            assert least - np.linalg.norm(motion) / steps <= found <= least + 1e-9
    with pytest.raises(TypeError, match="a swept shape is not pickled"):
        pickle.dumps(path)


def test_an_explanation_changes_no_bit():
    a, b = SHAPES["box"], SHAPES["ellipsoid"]
    for row in random_rows(np.random.default_rng(5), 20, 1.5):
        answer, trace = graze.distance(a, None, b, row, trace=True)
        assert answer.distance == graze.distance(a, None, b, row).distance
        assert trace["method"]


def test_an_explanation_of_contacts_tells_the_faces_and_the_cuts():
    box = graze.Box((1, 1, 1))
    [manifold], trace = graze.contacts(box, None, box, (0.25, 0.99, 0), trace=True)
    assert len(trace["face_a"]) == len(trace["face_b"]) == len(trace["cuts"]) == 4
    left = {tuple(np.round(corner, 9)) for corner in trace["cuts"][-1]["left"]}
    assert left == {tuple(np.round(p.a, 9)) for p in manifold.points}
    assert left == {(x, 0.5, z) for x in (-0.25, 0.5) for z in (-0.5, 0.5)}


@pytest.mark.parametrize("name", SHAPES)
def test_pickle_and_repr(name):
    shape = SHAPES[name]
    again = pickle.loads(pickle.dumps(shape))
    assert type(again) is type(shape)
    row = (0.3, 1.2, 0.4)
    assert graze.distance(again, row, graze.Sphere(0.2), None).distance == graze.distance(shape, row, graze.Sphere(0.2), None).distance
    assert type(shape).__name__ in repr(shape)


@pytest.mark.parametrize(
    "call,message",
    [
        (lambda: graze.Sphere(-1), "radius"),
        (lambda: graze.Box((1, float("nan"), 1)), r"size\[1\]"),
        (lambda: graze.Pose((0, 0, 0), (0, 0, 0, 0)), "quaternion"),
        (lambda: graze.Mesh(CUBE, [(0, 1, 8)]), r"faces\[0\]"),
        (lambda: graze.overlap(graze.Sphere(1), (float("inf"), 0, 0), graze.Sphere(1), None), "translation"),
        (lambda: graze.contacts(graze.Sphere(1), None, graze.Sphere(1), None, margin=-1), "margin"),
        (lambda: SHAPES["mesh"].swept(None, (1, 0, 0)), "shape: expected a bounded convex shape"),
        (lambda: graze.Sphere(1).swept(None, (math.nan, 0, 0)), r"motion\[0\]"),
        (lambda: graze.raycast(graze.Sphere(1), None, (0, math.nan, 0), (1, 0, 0)), r"origin\[1\]: expected a finite"),
        (lambda: graze.raycast_any(graze.Sphere(1), None, (0, 0, 0), (1, 0, math.inf)), r"direction\[2\]"),
        (lambda: graze.raycast_all(graze.Sphere(1), None, (0, math.nan, 0), (1, 0, 0)), r"origin\[1\]"),
        (lambda: graze.World().raycast((0, 0, 0), (math.nan, 0, 0)), r"direction\[0\]"),
        (lambda: graze.feature_corners(graze.Box((1, 1, 1)), -1), "feature: expected an integer from 0 to 65535, got -1"),
        (lambda: graze.feature_corners(graze.Box((1, 1, 1)), 0, 1 << 32), "piece: expected an integer from 0 to"),
        (lambda: graze.Simulation(sub_steps=1 << 40), "sub_steps: expected an integer from"),
        (lambda: graze.Simulation(most_sub_steps=1 << 40), "most_sub_steps: expected an integer from"),
    ],
)
def test_errors_name_the_value(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_wrong_types_are_type_errors():
    with pytest.raises(TypeError):
        graze.overlap("box", None, graze.Sphere(1), None)
    with pytest.raises(TypeError, match=r"poses_a\[0\]: expected a pose"):
        graze.batch.overlap(graze.Sphere(1), np.zeros((3, 5)), graze.Sphere(1), None)


def test_a_batch_of_rays_is_each_alone():
    rng = np.random.default_rng(3)
    shapes = [graze.Box((1, 2, 3)), graze.Sphere(1), graze.Cylinder(2, 0.5),
              graze.Mesh(np.array([[-1, 0, -1], [1, 0, -1], [0, 0, 2.0]]), np.array([[0, 1, 2]]))]
    pose = ((0.1, 0.2, 0.3), (0, 0.6, 0, 0.8))
    origins, directions = rng.uniform(-3, 3, (200, 3)), rng.uniform(-1, 1, (200, 3))
    for shape in shapes:
        for back_faces in (True, False):
            found = graze.batch.raycast(shape, pose, origins, directions, 5, back_faces)
            some = graze.batch.raycast_any(shape, pose, origins, directions, 5, back_faces)
            assert some.dtype == bool and 0 < found["hit"].sum() < 200
            for ray, answer, hit in zip(zip(origins, directions), found, some):
                alone = graze.raycast(shape, pose, *ray, 5, back_faces)
                assert bool(answer["hit"]) == bool(hit) == (alone is not None)
                if alone is None:
                    assert np.isinf(answer["t"])
                else:
                    assert answer["t"] == alone.t and answer["piece"] == alone.piece
                    assert answer["point"].tolist() == alone.point.tolist()
                    assert answer["normal"].tolist() == alone.normal.tolist()
    one = graze.batch.raycast(graze.Sphere(1), None, (-5, 0, 0), [[1, 0, 0], [0, 1, 0]])
    assert one["hit"].tolist() == [True, False] and one["t"][0] == 4
    with pytest.raises(ValueError, match=r"origins\[1\]"):
        graze.batch.raycast(graze.Sphere(1), None, [[0, 0, 0], [0, float("nan"), 0]], (1, 0, 0))
    with pytest.raises(ValueError, match="directions"):
        graze.batch.raycast(graze.Sphere(1), None, [[0, 0, 0]] * 3, [[1, 0, 0]] * 2)
