"""Broad phases beside brute force, and a hull's support query layer by layer."""

import numpy as np
import pytest

import graze

KINDS = ["dynamic_tree", "sort_and_sweep", "sweep_and_prune", "hashed_grid", "loose_octree", "bsp"]


def touching(boxes, lower, upper):
    return np.flatnonzero(np.all((boxes[:, 0] <= upper) & (lower <= boxes[:, 1]), axis=1))


@pytest.mark.parametrize("kind", KINDS)
def test_a_broad_phase_finds_what_brute_force_finds(kind):
    rng = np.random.default_rng(8)
    lower = rng.uniform(-4, 4, (120, 3))
    boxes = np.stack([lower, lower + rng.uniform(0, 2, (120, 3))], axis=1)
    broad = graze.BroadPhase(kind)
    for i, box in enumerate(boxes):
        broad.insert(i, *box)
    expected = [(i, j) for i in range(120) for j in touching(boxes, *boxes[i]) if i < j]
    assert broad.pairs().tolist() == [list(pair) for pair in expected] and len(expected) > 50
    assert broad.tests >= len(expected) and broad.memory > 0
    boxes[5] = (-1, -1, -1), (1, 1, 1)
    broad.move(5, *boxes[5])
    others = [int(i) for i in touching(boxes, *boxes[5]) if i != 5]
    assert broad.moved_pairs().tolist() == [sorted((5, i)) for i in others]
    assert broad.query(*boxes[5]).tolist() == sorted([5, *others])
    assert set(broad.query(*boxes[5])) <= set(broad.sweep(*boxes[5], (3, 0, 0)))
    parts = broad.parts()
    assert (len(parts) > 0) == (kind not in ("sort_and_sweep", "sweep_and_prune"))
    if parts:
        assert parts[0][2] == 0
    broad.remove(5)
    assert 5 not in broad.query(*boxes[5])


def test_what_a_broad_phase_refuses():
    broad = graze.BroadPhase()
    broad.insert(1, (0, 0, 0), (1, 1, 1))
    with pytest.raises(ValueError, match="id: expected an id that is not in use, got 1"):
        broad.insert(1, (0, 0, 0), (1, 1, 1))
    with pytest.raises(ValueError, match="box: expected lower <= upper on every axis, got 2 and 1"):
        broad.query((2, 0, 0), (1, 1, 1))
    with pytest.raises(ValueError, match="box: expected lower <= upper"):
        broad.query((float("nan"), 0, 0), (1, 1, 1))
    with pytest.raises(ValueError, match="kind: expected dynamic_tree, .* got tree"):
        graze.BroadPhase("tree")


def test_a_support_query_layer_by_layer():
    rng = np.random.default_rng(2)
    points = rng.normal(size=(500, 3))
    hull = graze.ConvexHull(points / np.linalg.norm(points, axis=1, keepdims=True))
    vertices, layers = graze.hull_vertices(hull), graze.hull_layers(hull)
    assert len(layers) > 1 and len(layers[-1][0]) == len(vertices)
    for (coarse, _), (fine, edges) in zip(layers, layers[1:]):
        assert set(coarse) <= set(fine) and set(edges.ravel()) <= set(fine)
    for direction in rng.normal(size=(20, 3)):
        steps = graze.explain_support(hull, direction)
        np.testing.assert_array_equal(vertices[steps["vertex"]], hull.support(direction))
        assert steps["layers"][-1]["winner"] == steps["vertex"] and not steps["scanned"]
        assert sum(len(layer["looked_at"]) for layer in steps["layers"]) == steps["products"]
    with pytest.raises(ValueError, match="shape: expected a convex hull, got sphere"):
        graze.hull_layers(graze.Sphere(1))


def test_changes_are_the_differences_of_all_pairs():
    rng = np.random.default_rng(4)
    changes, broad = graze.PairChanges("loose_octree"), graze.BroadPhase()
    before, seen = set(), 0
    for frame in range(5):
        for i in range(80) if frame == 0 else rng.choice(80, 15, replace=False):
            lower = rng.uniform(-3, 3, 3)
            for boxes in changes, broad:
                (boxes.insert if frame == 0 else boxes.move)(int(i), lower, lower + 1)
        if frame == 3:
            for boxes in changes, broad:
                boxes.remove(5)
                boxes.insert(5, (0, 0, 0), (1, 1, 1))
        now = {tuple(pair) for pair in broad.pairs().tolist()}
        begun, ended = changes.find()
        assert {tuple(pair) for pair in begun.tolist()} == now - before
        assert {tuple(pair) for pair in ended.tolist()} == before - now
        seen += len(begun) + len(ended)
        before = now
    assert seen > 50 and changes.memory > 1000
    assert all(len(pairs) == 0 for pairs in changes.find())
    with pytest.raises(ValueError, match="id: expected an id that was inserted, got 99"):
        changes.remove(99)
    with pytest.raises(ValueError, match="kind"):
        graze.PairChanges("tree")
