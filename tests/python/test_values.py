"""Plain values: what they show, pickles of them, and numbers and arrays that are refused."""

import pickle

import numpy as np
import pytest

import graze
from graze import plane


def values():
    box, ball = graze.Box((2, 2, 2)), graze.Sphere(0.5)
    world = graze.World()
    body = world.add(box)
    simulation = graze.Simulation()
    floor, crate = simulation.add(graze.HalfSpace(), fixed=True), simulation.add(box, (0, 1, 0))
    joint = simulation.join_ball(floor, None, crate, None)
    [manifold] = graze.contacts(box, None, ball, (1.4, 0, 0))
    square, disk = plane.Box((2, 2)), plane.Circle(0.5)
    [flat] = plane.contacts(square, None, disk, (1.4, 0))
    return [
        graze.Filter(3, 5, -1), graze.Material(0.1, restitution=0.5, friction_combine="maximum", surface_velocity=(1, 2, 3)),
        plane.Material(0.1, surface_velocity=(1, 2)), body, joint, graze.JointLimit("linear", "xy", -1, 1, 5, 0.25),
        graze.JointLimit("angular", "z"), graze.JointDrive("angular", "y", velocity_target=2, acceleration=True),
        graze.distance(box, None, ball, (3, 0, 0)), graze.closest(box, None, (3, 0, 0)),
        graze.raycast(box, None, (5, 0, 0), (-1, 0, 0)), graze.cast(box, None, (0, 0, 0), ball, (5, 0, 0), (-5, 0, 0)),
        manifold, manifold.points[0], plane.distance(square, None, disk, (3, 0)), plane.closest(square, None, (3, 0)),
        plane.raycast(square, None, (5, 0), (-1, 0)), plane.cast(square, None, (0, 0), disk, (5, 0), (-5, 0)), flat,
        flat.points[0], graze.ShapeArray([box, ball]), graze.StruckBody.of_shape(ball, 2, linear=(1, 2, 3)),
        plane.StruckBody.of_shape(disk, 2, linear=(1, 2)), graze.Blow(0, 1, (1, 0, 0), [(0, 0, 0), (0, 1, 0)], 0.5),
        plane.Blow(0, 1, (1, 0), [(0, 0)]), graze.FreeBody((1, 2, 3), (1, 0, 0), angular=(1, 2, 3)),
        plane.FreeBody(2.0, (1, 0), angular=3.0),
    ]  # fmt: skip


def public(value):
    """All that a value tells, in a form that is compared."""
    told = {}
    for name in dir(type(value)):
        if isinstance(getattr(type(value), name), property):
            member = getattr(value, name)
            told[name] = [public(point) for point in member] if name == "points" else repr(member)
    return told


@pytest.mark.parametrize("value", values(), ids=lambda value: type(value).__module__ + "." + type(value).__name__)
def test_a_pickle_is_the_value_again(value):
    again = pickle.loads(pickle.dumps(value))
    assert type(again) is type(value)
    assert repr(again) == repr(value) and public(again) == public(value)
    assert " object at 0x" not in repr(value)


def test_what_values_show():
    assert repr(graze.Material(restitution=0.5)) == (
        "graze.Material(static_friction=0.6, dynamic_friction=0.6, restitution=0.5, rolling_friction=0.0, "
        "friction_combine='unset', restitution_combine='unset', surface_velocity=(0.0, 0.0, 0.0))")
    assert eval(repr(plane.Material(0.25)), {"graze": graze}).static_friction == 0.25
    limit = graze.JointLimit("linear", "xy", -1, 1)
    assert repr(limit) == (
        "graze.JointLimit(space='linear', axes='xy', min=-1.0, max=1.0, stiffness=None, damping=0.0)")
    world = plane.World()
    world.add(plane.Circle(1))
    world.add(plane.Circle(1), (1, 0))
    world.update()
    assert repr(world) == "graze.plane.World(bodies=2, pairs=1)"
    simulation = graze.Simulation()
    simulation.add(graze.Sphere(1))
    assert repr(simulation) == "graze.Simulation(bodies=1, joints=0)"
    assert repr(simulation.world) == "graze.WorldView(bodies=1, pairs=0)"
    assert repr(graze.ShapeArray.boxes([(1, 2, 3)])) == "<graze.ShapeArray of 1 shapes>"
    assert repr(graze.BroadPhase()).startswith("graze.BroadPhase(tests=0, memory=")
    for name in ("StruckBody", "FreeBody", "Blow", "Material"):
        assert getattr(plane, name).__module__ == "graze.plane"


@pytest.mark.parametrize("of", [graze, plane])
def test_a_material_is_checked_when_it_is_made(of):
    for arguments, message in [
        ({"restitution": 2}, "restitution: expected a number from 0 to 1, got 2"),
        ({"restitution": float("nan")}, "restitution: expected a number from 0 to 1, got nan"),
        ({"static_friction": -1}, "static_friction: expected a finite number >= 0, got -1"),
        ({"dynamic_friction": float("inf")}, "dynamic_friction: expected a finite number >= 0, got inf"),
        ({"rolling_friction": -0.5}, "rolling_friction: expected a finite number >= 0, got -0.5"),
    ]:
        with pytest.raises(ValueError) as refused:
            of.Material(**arguments)
        assert str(refused.value) == message
    with pytest.raises(ValueError, match="^surface_velocity"):
        of.Material(surface_velocity=(float("nan"),) * (3 if of is graze else 2))


def test_whole_numbers_out_of_range_are_named():
    broad = graze.BroadPhase()
    most = 2**32 - 1
    for ask, path, greatest, got in [
        (lambda: graze.Filter(-1), "category", 2**64 - 1, -1),
        (lambda: graze.Filter(mask=2**64), "mask", 2**64 - 1, 2**64),
        (lambda: broad.insert(-1, (0, 0, 0), (1, 1, 1)), "id", most, -1),
        (lambda: broad.move(2**32, (0, 0, 0), (1, 1, 1)), "id", most, 2**32),
        (lambda: broad.remove(2**70), "id", most, 2**70),
    ]:
        with pytest.raises(ValueError) as refused:
            ask()
        assert str(refused.value) == f"{path}: expected an integer from 0 to {greatest}, got {got}"
    with pytest.raises(TypeError):
        broad.insert(1.5, (0, 0, 0), (1, 1, 1))
    with pytest.raises(TypeError):
        graze.Filter("1")
    assert graze.Filter(np.uint8(3)).category == 3


def test_complex_numbers_and_masks_are_refused():
    poses = np.zeros((3, 7))
    poses[:, 6] = 1
    ball = graze.Sphere(1)
    for give in (lambda a: a + 0j, lambda a: np.ma.masked_array(a, mask=True), lambda a: np.ma.masked_array(a)):
        for ask in [
            lambda: graze.batch.overlap(ball, None, ball, give(poses)),
            lambda: graze.Box(give(np.ones(3))),
            lambda: graze.distance(ball, give(poses[0]), ball, None),
            lambda: graze.ConvexHull(give(np.eye(3))),
            lambda: graze.HeightField(give(np.zeros((3, 3)))),
            lambda: graze.ShapeArray.spheres(give(np.ones(3))),
            lambda: plane.overlap(plane.Circle(1), give(np.zeros(2)), plane.Circle(1), None),
        ]:
            with pytest.raises(TypeError, match="expected (real numbers, got complex ones|an array without a mask)"):
                ask()


def test_counts_are_refused_by_name():
    ball = graze.Sphere(1)
    world = graze.World()
    body = world.add(ball)
    [manifold] = graze.contacts(ball, None, ball, (1, 0, 0))
    cases = [
        (lambda: world.nearest(ball, count=-1), "count: expected an integer from 0 to 18446744073709551615, got -1"),
        (lambda: world.slide(ball, None, (1, 0, 0), casts=0), "casts: expected a number >= 1, got 0"),
        (lambda: world.slide(ball, None, (1, 0, 0), casts=2**40), "casts: expected an integer from"),
        (lambda: world.reduce(0), "count: expected a number >= 1, got 0"),
        (lambda: world.overlapping(ball, mask=-1), "mask: expected an integer from 0 to"),
        (lambda: world.overlapping(ball, group=2**31), "group: expected an integer from"),
        (lambda: manifold.reduce(-2), "count: expected an integer from 0 to"),
        (lambda: graze.Blow(-1, 0, (1, 0, 0), []), "a: expected an integer from 0 to 4294967295, got -1"),
        (lambda: graze.pass_on([], [], most=-1), "most: expected an integer from 0 to"),
        (lambda: graze.World(points_per_pair=-1), "points_per_pair: expected an integer from 0 to"),
    ]
    for question, message in cases:
        with pytest.raises(ValueError, match=message):
            question()
    assert body in world


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_every_protocol_of_pickle_makes_the_value_or_an_error(protocol):
    world = graze.World()
    body = world.add(graze.Box((2, 2, 2)))
    for value in [body, graze.Pose((1, 2, 3)), plane.Pose((1, 2), 0.5)]:
        assert pickle.loads(pickle.dumps(value, protocol)) == value
    state = graze.Simulation().save()
    graze.Simulation().restore(pickle.loads(pickle.dumps(state, protocol)))
    for value in [world, graze.Simulation(), plane.World(), graze.BroadPhase(), graze.PairChanges()]:
        with pytest.raises(TypeError, match="cannot pickle"):
            pickle.dumps(value, protocol)


def test_arrays_of_texts_and_times_are_refused():
    ball = graze.Sphere(1)
    poses = np.zeros((2, 7), int)
    poses[:, 6] = 1
    for kind in ("U8", "S8", "m8[s]", "M8[s]"):
        for ask in [
            lambda: graze.batch.overlap(ball, None, ball, poses.astype(kind)),
            lambda: graze.distance(ball, poses[0].astype(kind), ball, None),
            lambda: graze.Box(np.ones(3, int).astype(kind)),
            lambda: graze.Mesh(np.eye(3, dtype=int).astype(kind), [(0, 1, 2)]),
            lambda: plane.Polygon(np.array([(0, 0), (2, 0), (0, 2)]).astype(kind)),
        ]:
            with pytest.raises(TypeError, match="expected an array of numbers, got one of "):
                ask()
    with pytest.raises(TypeError, match="vertices: expected an array of numbers"):
        graze.Mesh([("0", "0", "0"), ("1", "0", "0"), ("0", "1", "0")], [(0, 1, 2)])


def test_an_empty_list_is_an_array_of_no_rows():
    ball, disk = graze.Sphere(1), plane.Circle(1)
    assert graze.batch.overlap(ball, [None] * 3, ball, [None] * 3, pairs=[]).shape == (0,)
    assert graze.batch.closest(ball, None, []).shape == (0,)
    assert graze.batch.raycast(ball, None, [], (1, 0, 0)).shape == (0,)
    assert plane.batch.closest(disk, None, []).shape == (0,)
    assert len(graze.ShapeArray.boxes([])) == 0
    assert graze.along_planes((1, 2, 3), []).tolist() == [1, 2, 3]
    assert plane.along_lines((1, 2), []).tolist() == [1, 2]
    with pytest.raises(ValueError, match="points: expected"):
        graze.ConvexHull([])
    with pytest.raises(ValueError, match="faces: expected at least one triangle"):
        graze.Mesh([], [])


def test_normals_of_obstacles_have_unit_length():
    for normals, got in [([(0, 1, 0), (0, 2, 0)], "2"), ([(1, 0, 0), (0, 0, 0)], "0")]:
        with pytest.raises(ValueError, match=rf"normals\[1\]: expected a vector of unit length, got {got}$"):
            graze.along_planes((1, -1, 0), normals)
        with pytest.raises(ValueError, match=rf"normals\[1\]: expected a vector of unit length, got {got}$"):
            plane.along_lines((1, -1), [normal[:2] for normal in normals])


def test_an_index_that_no_32_bits_hold_is_named_as_it_was_given():
    ball = graze.Sphere(1)
    for index in (2**32, 2**63, 2**64 - 1):
        with pytest.raises(ValueError, match=rf"pairs\[1\]\[0\]: expected an index from 0 to 4294967295, got {index}$"):
            graze.batch.overlap(ball, [None], ball, [None], pairs=np.array([[0, 0], [index, 0]], np.uint64))


def test_numbers_of_another_form_are_named():
    for wrong in ("x", (1, 2), None):
        with pytest.raises(TypeError, match="size: expected a number, got"):
            graze.draw(type("Renderer", (), {"size": wrong, "line": print})(), graze.Sphere(1))
    with pytest.raises(TypeError, match="inertia: expected a number, got 'x'"):
        plane.Simulation().add(plane.Circle(1), inertia="x")
    with pytest.raises(TypeError, match=r"inertia: expected a number, got \(1, 2\)"):
        plane.StruckBody(1, (1, 2))
    with pytest.raises(TypeError, match="layers: expected a list of words, got one word"):
        graze.draw(type("Renderer", (), {"layers": "contacts"})(), graze.Sphere(1))
    with pytest.raises(TypeError, match="line: expected a method, got 3"):
        graze.draw(type("Renderer", (), {"line": 3})(), graze.Sphere(1))


def test_an_array_of_shapes_is_a_sequence():
    shapes = graze.ShapeArray.spheres([1, 2, 3, 4])
    radii = [shape.radius for shape in shapes]
    for i in range(-4, 4):
        assert shapes[i].radius == radii[i]
    for i in (-5, 4):
        with pytest.raises(IndexError, match=f"index {i} of 4 shapes"):
            shapes[i]
    for part in (slice(None), slice(1, 3), slice(None, None, -1), slice(-2, None), slice(3, 1), slice(0, 9, 3)):
        found = shapes[part]
        assert isinstance(found, graze.ShapeArray)
        assert [shape.radius for shape in found] == radii[part]
    with pytest.raises(ValueError, match=r"sizes\[1\].size\[2\]: expected a finite number >= 0, got -3"):
        graze.ShapeArray.boxes([(1, 2, 3), (1, 2, -3)])
    with pytest.raises(ValueError, match=r"radii\[2\].radius: expected a finite number >= 0, got -1"):
        graze.ShapeArray.spheres([1, 2, -1])


def test_shapes_tell_what_they_were_made_of():
    rectangle, segment = graze.Rectangle(1, 2), graze.Segment((0, 1, 2), (3, 4, 5))
    assert (rectangle.size_x, rectangle.size_z) == (1, 2)
    assert segment.a.tolist() == [0, 1, 2] and segment.b.tolist() == [3, 4, 5]
    corners = np.arange(9.0).reshape(3, 3) ** 2
    triangle = graze.Triangle(*corners)
    assert np.array_equal([triangle.a, triangle.b, triangle.c], corners)
    heights = np.arange(6.0).reshape(2, 3)
    heights[0, 0] = np.nan
    field = graze.HeightField(heights, 0.5, 2, front_only=True)
    assert np.array_equal(field.heights, heights, equal_nan=True)
    assert (field.spacing_x, field.spacing_z, field.front_only) == (0.5, 2, True)
    assert not graze.Mesh(corners, [(0, 1, 2)]).front_only


def test_errors_of_shapes_have_the_names_of_their_arguments():
    nan = float("nan")
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    for make, name in [
        (lambda: graze.Capsule(1, -1), "radius:"),
        (lambda: graze.Cylinder(1, 1, -1), "radius_top:"),
        (lambda: graze.Capsule(-1, 1), "height:"),
        (lambda: plane.Capsule(1, -1), "radius:"),
        (lambda: plane.Capsule(1, 1, -1), "radius_top:"),
        (lambda: graze.Rectangle(1, -1), "size_z:"),
        (lambda: graze.Segment((0, 0, 0), (0, nan, 0)), r"b\[1\]:"),
        (lambda: plane.Segment((nan, 0), (1, 0)), r"a\[0\]:"),
        (lambda: graze.Triangle((0, 0, 0), (1, 0, 0), (0, 0, nan)), r"c\[2\]:"),
        (lambda: graze.Mesh(corners, [(0, 1, 3)]), r"faces\[0\]\[2\]: expected an index below 3, got 3"),
        (lambda: graze.Mesh(corners, []), "faces: expected at least one triangle"),
        (lambda: graze.Mesh([(nan, 0, 0), *corners], [(0, 1, 2)]), r"vertices\[0\]\[0\]:"),
        (lambda: graze.HeightField(np.zeros((2, 2)), 1, -1), "spacing_z:"),
    ]:
        with pytest.raises(ValueError, match="^" + name):
            make()


@pytest.mark.parametrize("of, size", [(graze, 3), (plane, 2)])
def test_a_pose_moves_many_points(of, size):
    rng = np.random.default_rng(5)
    points = rng.normal(size=(20, size))
    pose = of.Pose(rng.normal(size=size), rng.normal(size=4) if size == 3 else 0.7)
    for given in (points, np.asfortranarray(points), np.vstack([points, points])[::2], points.astype(">f8")):
        assert np.array_equal(pose @ given, [pose @ point for point in given])
    assert (pose @ np.zeros((0, size))).shape == (0, size)
    with pytest.raises(ValueError, match=rf"points: expected an array of shape \(n, {size}\), got shape \(4, 5\)"):
        pose @ np.ones((4, 5))
    with pytest.raises(TypeError):
        pose @ "abc"


def test_a_matrix_of_a_pose_is_one():
    matrix = graze.Pose((1, 2, 3), (0, 0, 0.6, 0.8)).matrix
    assert np.array_equal(graze.Pose.from_matrix(matrix.tolist()).translation, (1, 2, 3))
    for wrong in (np.ones(3), np.ones(7), np.eye(3), np.eye(4)[:3], [1, 2, 3]):
        with pytest.raises(ValueError, match="matrix: expected an array of shape"):
            graze.Pose.from_matrix(wrong)
    with pytest.raises(TypeError, match="matrix: expected real numbers, got complex ones"):
        graze.Pose.from_matrix(matrix + 0j)
    with pytest.raises(TypeError, match="matrix: expected an array without a mask"):
        graze.Pose.from_matrix(np.ma.masked_array(matrix, mask=True))
