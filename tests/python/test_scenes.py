"""Scenes from files, of space and of the plane."""

import pathlib
import pickle

import numpy as np
import pytest

import graze
from graze import plane

SCENES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "scenes"


def test_a_drawing_is_a_scene_of_the_plane():
    scene = plane.load(SCENES / "plane.svg")
    assert scene.colliders and len(scene.bodies) <= len(scene.colliders)
    assert repr(scene).startswith("<graze.plane.Scene 'plane.svg'") and f"{len(scene.colliders)} colliders" in repr(scene)
    for collider in scene.colliders:
        assert 0 <= collider.body < len(scene.bodies)
        assert isinstance(collider.shape, plane.Shape) and type(collider.shape) is not plane.Shape
        lower, upper = collider.shape.bounds(collider.pose)
        assert (lower <= upper).all()
        again = pickle.loads(pickle.dumps(collider.shape))
        assert repr(again) == repr(collider.shape)
        assert plane.distance(again, collider.pose, collider.shape, collider.pose).distance <= 0


def test_json_keeps_corners_and_children(tmp_path):
    corners = [[0, 0], [4, 0], [4, 4], [2, 1]]
    file = tmp_path / "scene.json"
    file.write_text(
        '{"dimension": 2, "bodies": ['
        '{"name": "wedge", "shape": {"type": "polygon", "polygon": {"points": [[0, 0], [4, 0], [4, 4], [2, 1]]}}},'
        '{"name": "steps", "shape": {"type": "chain", "chain": {"points": [[0, 0], [1, 0], [1, 1]], "sides": "one"}}},'
        '{"name": "pair", "motion": "dynamic", "translation": [0, 5], "shape": {"type": "compound", "compound":'
        ' {"children": [{"shape": {"type": "circle", "circle": {"radius": 1}}, "translation": [2, 0]}]}}}]}'
    )
    scene = plane.load(file)
    wedge, steps, pair = (collider.shape for collider in scene.colliders)
    np.testing.assert_array_equal(wedge.points, corners)
    np.testing.assert_array_equal(steps.points, [[0, 0], [1, 0], [1, 1]])
    [(ball, pose)] = pair.children
    assert ball.radius == 1 and pose.translation.tolist() == [2, 0]
    assert [kind for _, kind in scene.bodies] == ["static", "static", "dynamic"]
    assert scene.gravity is None
    world = plane.World()
    for collider in scene.colliders:
        world.add(collider.shape, collider.pose)
    world.update()
    assert world.touching.tolist() == [[0, 1]]


def test_space_and_plane_point_to_each_other():
    with pytest.raises(ValueError, match="graze.plane.load"):
        graze.load(SCENES / "plane.svg")
    with pytest.raises(ValueError):
        plane.load(SCENES / "demo.gltf")
    scene = graze.load(SCENES / "demo.gltf")
    assert repr(scene).startswith("<graze.Scene 'demo.gltf'") and f"{len(scene.bodies)} bodies" in repr(scene)
    with pytest.raises(TypeError):
        pickle.dumps(scene)
