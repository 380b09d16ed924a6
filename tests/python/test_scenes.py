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


def test_animations_are_read_where_they_are_asked_for():
    assert graze.load(SCENES / "moving.gltf").animations == []
    scene = graze.load(SCENES / "moving.gltf", animations=True)
    [(name, seconds), *_] = scene.animations
    assert isinstance(name, str) and seconds > 0
    moved = graze.animated_colliders(scene)
    assert moved and all(0 <= i < len(scene.colliders) for i in moved)
    events = graze.collide_frames(scene, fps=60)
    assert events == graze.collide_frames(scene, animation=name or 0, fps=60)
    assert all(0 <= time <= seconds and kind in ("begin", "end") and a < b for time, kind, a, b, _, _ in events)
    assert any(kind == "begin" for _, kind, *_ in events)
    assert [time for time, *_ in events] == sorted(time for time, *_ in events)
    assert all(time <= 0.5 for time, *_ in graze.collide_frames(scene, duration=0.5))


def test_animations_that_are_none_are_refused():
    scene = graze.load(SCENES / "moving.gltf", animations=True)
    for animation in (99, "no such", -1):
        for ask in (graze.animated_colliders, graze.collide_frames):
            with pytest.raises(ValueError):
                ask(scene, animation=animation)
    for wrong in ({"fps": 0}, {"fps": float("nan")}, {"duration": -1}, {"margin": -1}):
        with pytest.raises(ValueError):
            graze.collide_frames(scene, **wrong)
    with pytest.raises(ValueError):
        graze.collide_frames(graze.load(SCENES / "demo.gltf"))


def frames_of(kit, scene, **how):
    frames = []
    summary = kit.simulate(scene, frames.append, **how)
    return frames, summary


@pytest.mark.parametrize("threads", [None, 3])
@pytest.mark.parametrize("kit", [graze, plane], ids=["space", "plane"])
def test_scenes_are_played(kit, threads, tmp_path):
    scene = kit.load(SCENES / ("demo.gltf" if kit is graze else "plane.svg"))
    count, place = len(scene.moving_bodies), 7 if kit is graze else 3
    frames, summary = frames_of(
        kit, scene, seconds=0.5, rate=60, threads=threads, out=tmp_path / "moved.jsonl", capture=tmp_path / "moved.capture"
    )
    assert count > 0 and len(frames) == 31 and summary["steps"] == 30 and summary["bodies"] == count
    assert [frame["time"] for frame in frames] == [i / 60 for i in range(31)]
    for frame in frames:
        assert frame["poses"].shape == (count, place) and frame["asleep"].shape == (count,)
        assert len(frame["linear"]) == len(frame["angular"]) == count
    assert not np.array_equal(frames[0]["poses"], frames[-1]["poses"])
    lower, upper = scene.colliders[0].shape.bounds(frames[-1]["poses"][0])  # a row is a pose
    assert (lower <= upper).all()
    assert (tmp_path / "moved.jsonl").read_text().count("\n") >= 31
    assert graze.replay(tmp_path / "moved.capture")["difference"] is None
    again, _ = frames_of(kit, scene, seconds=0.5, rate=60)
    assert all(np.array_equal(a["poses"], b["poses"]) for a, b in zip(frames, again))


def test_a_played_scene_is_that_of_a_simulation(tmp_path):
    """A scene of free bodies, played and simulated by hand."""
    file = tmp_path / "fall.json"
    file.write_text(
        '{"dimension": 2, "bodies": ['
        '{"name": "ground", "translation": [0, -0.5], "shape": {"type": "box", "box": {"size": [9, 1]}}},'
        '{"name": "wheel", "motion": "dynamic", "translation": [0, 2], "shape": {"type": "circle", "circle": {"radius": 1}}}]}'
    )
    scene = plane.load(file)
    frames, _ = frames_of(plane, scene, seconds=1)
    simulation = plane.Simulation()
    ground, wheel = scene.colliders
    simulation.add(ground.shape, ground.pose, fixed=True)
    body = simulation.add(wheel.shape, wheel.pose, material=plane.Material(static_friction=0.6, dynamic_friction=0.6))
    for _ in range(60):
        simulation.step(1 / 60)
    assert frames[-1]["poses"][0, :2].tolist() == simulation.pose(body).translation.tolist()


def test_an_animated_scene_follows_its_keyframes(tmp_path):
    file = SCENES / "moving.gltf"
    still, _ = frames_of(graze, graze.load(file), seconds=0.5)
    moved, _ = frames_of(graze, graze.load(file, animations=True), seconds=0.5)
    assert len(still) == len(moved) == 31
    # The pendulum hangs, or swings from 60 degrees on one side to the middle in half a second.
    assert all(frame["poses"].tolist() == [[3, 3, 0, 0, 0, 0, 1]] for frame in still)
    angles = np.array([2 * np.arctan2(*frame["poses"][0, 5:]) for frame in moved])
    assert angles[[0, -1]] == pytest.approx([-np.pi / 3, 0], abs=1e-6) and (np.diff(angles) > 0).all()
    graze.simulate(graze.load(file), seconds=0.2, out=tmp_path / "moved.gltf", source=file)
    assert "simulation" in [name for name, _ in graze.load(tmp_path / "moved.gltf", animations=True).animations]


def test_what_playing_refuses(tmp_path):
    scene = graze.load(SCENES / "demo.gltf")
    for wrong in (
        {"seconds": -1}, {"rate": 0}, {"gravity": (0, float("nan"), 0)}, {"sub_steps": 3}, {"threads": 0},
        {"out": tmp_path / "moved.txt"}, {"capture": tmp_path / "no" / "where"},
    ):
        with pytest.raises(ValueError):
            graze.simulate(scene, **wrong)

    def refuse(frame):
        if frame["time"] > 0.05:
            raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        graze.simulate(scene, refuse)
    with pytest.raises(ValueError):
        plane.simulate(plane.load(SCENES / "plane.svg"), rate=0)
