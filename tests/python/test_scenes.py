"""Scenes from files, of space and of the plane."""

import json
import os
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


def test_a_file_whose_name_is_no_text_is_named_in_the_error():
    for load in (graze.load, graze.plane.load):
        with pytest.raises(ValueError, match=r"^no-scene-\\xff"):
            load(os.fsdecode(b"no-scene-\xff." + (b"obj" if load is graze.load else b"svg")))


def test_a_scene_of_a_file_whose_name_is_no_text_has_that_name(tmp_path):
    file = os.path.join(os.fsencode(tmp_path), b"three \xc3\xa9 \xff.obj")
    with open(file, "w") as out:
        out.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    scene = graze.load(os.fsdecode(file))
    [collider], [(name, _, _)] = scene.colliders, scene.bodies
    assert scene.source == os.fsdecode(b"three \xc3\xa9 \xff.obj")
    assert collider.name == name == os.fsdecode(b"three \xc3\xa9 \xff")
    assert repr(scene).startswith(r"<graze.Scene 'three é \udcff.obj': 1 bodies")
    assert repr(collider) == r"<graze.Collider 'three é \udcff'>"


def test_a_scene_tells_what_moves_and_what_joins():
    folder = SCENES / "conformance"
    for file in sorted(folder.glob("joint-*.gltf")) + [folder / "sample-motion-properties.gltf"]:
        scene, physics = graze.load(file), json.loads(file.read_text())
        described = physics.get("extensions", {}).get("KHR_physics_rigid_bodies", {})
        wanted = {
            node["name"]: node["extensions"]["KHR_physics_rigid_bodies"]["motion"]
            for node in physics["nodes"]
            if "motion" in node.get("extensions", {}).get("KHR_physics_rigid_bodies", {})
        }
        assert len(scene.motions) == len(scene.bodies)
        seen = 0
        for (name, kind, _), motion in zip(scene.bodies, scene.motions):
            assert (motion is None) == (kind == "static")
            if motion is None:
                continue
            seen += 1
            said = wanted[name]
            assert motion["kinematic"] == said.get("isKinematic", False)
            assert motion["mass"] == (said["mass"] or np.inf if "mass" in said else None)
            assert motion["gravity_factor"] == said.get("gravityFactor", 1)
            assert np.allclose(np.linalg.norm(motion["linear_velocity"]), np.linalg.norm(said.get("linearVelocity", [0])))
        assert seen == len(wanted)
        for joint in scene.joints:
            assert joint["a"] is None or 0 <= joint["a"] < len(scene.bodies)
            texts = [repr(limit) for limit in joint["limits"]] + [repr(drive) for drive in joint["drives"]]
            assert all(text.startswith("graze.Joint") for text in texts)
        of_file = described.get("physicsJoints", [])
        assert sorted(len(j["limits"]) for j in scene.joints if len(of_file) == len(scene.joints)) == sorted(
            len(j.get("limits", [])) for j in of_file if len(of_file) == len(scene.joints)
        )


def test_a_scene_is_simulated_by_what_it_tells():
    scene = graze.load(SCENES / "conformance" / "joint-10-linear-drive.gltf")
    simulation, ids = graze.Simulation(), {}
    for collider in scene.colliders:
        motion = scene.motions[collider.body]
        assert collider.body not in ids, "one collider a body"
        more = {} if motion is None else {"mass": motion["mass"], "gravity_factor": motion["gravity_factor"]}
        ids[collider.body] = simulation.add(
            collider.shape, collider.pose, fixed=motion is None, filter=collider.filter,
            material=collider.material or graze.Material(), **more)  # fmt: skip
    assert scene.joints and all(joint["drives"] for joint in scene.joints)
    for joint in scene.joints:
        arguments = {key: value for key, value in joint.items() if key != "name"}
        simulation.join(**{**arguments, "a": ids[joint["a"]], "b": ids[joint["b"]]})
    before = simulation.poses.copy()
    for _ in range(60):
        simulation.step(1 / 60)
    assert np.isfinite(simulation.poses).all() and not np.array_equal(simulation.poses, before)
