"""Captures: what is recorded is the ordinary run, and plays again to the same bits."""

import numpy as np
import pytest

import graze
from graze import plane

STEP = 1 / 60


def drop(simulation):
    """A few bodies of space that fall on each other."""
    simulation.add(graze.HalfSpace(), fixed=True)
    return [simulation.add(graze.Box((1, 1, 1)), (0.2 * i, 1 + 1.3 * i, 0)) for i in range(5)]


def drop_in_the_plane(simulation):
    simulation.add(plane.HalfPlane(), fixed=True)
    return [simulation.add(plane.Box((1, 1)), (0.2 * i, 1 + 1.3 * i)) for i in range(5)]


@pytest.mark.parametrize(("words", "begin"), [(graze, drop), (plane, drop_in_the_plane)])
def test_a_captured_simulation_is_the_same_and_plays_again(tmp_path, words, begin):
    file = tmp_path / "drop.capture"
    captured, ordinary = words.CapturedSimulation(file), words.Simulation()
    bodies = begin(captured)
    begin(ordinary)
    captured.set_name(bodies[1], "the second \u2014 of five")
    frames = []
    for _ in range(60):
        captured.step(STEP)
        ordinary.step(STEP)
        frames.append(captured.poses)
    assert np.array_equal(captured.poses, ordinary.poses)
    assert len(captured.world.touching) == len(ordinary.world.touching)

    played = []
    report = graze.replay(file, lambda frame, poses: played.append((frame, poses)))
    assert [frame for frame, _ in played] == list(range(1, 61))
    assert all(np.array_equal(poses, frame) for (_, poses), frame in zip(played, frames))
    # The calls: two shapes, each written once, six bodies, a name and the steps.
    assert report == {
        "simulation": True, "plane": words is plane, "single": False,
        "frames": 60, "calls": 2 + 6 + 1 + 60, "cut": False, "names": {2: "the second \u2014 of five"}, "difference": None,
    }  # fmt: skip


@pytest.mark.parametrize("words", [graze, plane])
def test_states_are_kept_in_the_file(words, tmp_path):
    file = tmp_path / "back.capture"
    simulation = words.CapturedSimulation(file)
    drop(simulation) if words is graze else simulation.add(plane.Circle(0.5), (0, 3))
    for _ in range(10):
        simulation.step(STEP)
    state = simulation.save()
    simulation.step(STEP)
    once = simulation.poses
    simulation.restore(state)
    simulation.step(STEP)
    assert np.array_equal(simulation.poses, once)
    other = words.CapturedSimulation(tmp_path / "other.capture")
    with pytest.raises(ValueError, match="state: expected one of this simulation"):
        other.restore(state)
    # Sixteen at a time: one that is gone makes room for another.
    more = [simulation.save() for _ in range(15)]
    with pytest.raises(ValueError, match="at most 16 states"):
        simulation.save()
    more.pop()
    more.append(simulation.save())
    assert graze.replay(file)["difference"] is None


@pytest.mark.parametrize(
    ("words", "big", "small"),
    [(graze, graze.Box((9, 1, 9)), graze.Sphere(0.5)), (plane, plane.Box((9, 1)), plane.Circle(0.5))],
)
def test_a_captured_world_is_a_world(tmp_path, words, big, small):
    file = tmp_path / "world.capture"
    world = words.CapturedWorld(file, margin=0.01)
    assert isinstance(world, words.WorldView)
    at = (lambda x, y: (x, y)) if words is plane else (lambda x, y: (x, y, 0))
    floor, ball = world.add(big, fixed=True), world.add(small, at(0, 0.99), fast=True)
    world.update()
    assert [kind for kind, *_ in world.events] == ["begin"]
    world.move(ball, at(0, 9))
    world.set_velocity(ball, at(0, -600))
    world.update(STEP)
    assert [kind for kind, *_ in world.events] == ["end"] and len(world.impacts) == 1
    world.remove(floor)
    world.update()
    report = graze.replay(file)
    assert report["frames"] == 3 and not report["simulation"] and report["difference"] is None


def test_a_file_that_was_cut_plays_up_to_there_and_a_damaged_one_is_refused(tmp_path):
    file = tmp_path / "whole.capture"
    simulation = graze.CapturedSimulation(file)
    drop(simulation)
    for _ in range(5):
        simulation.step(STEP)
    whole = file.read_bytes()  # every frame is there as soon as its step returns
    cut = tmp_path / "cut.capture"
    cut.write_bytes(whole[:-3])
    report = graze.replay(cut)
    assert report["cut"] and report["frames"] == 4 and report["difference"] is None
    damaged = bytearray(whole)
    damaged[len(whole) // 2] ^= 0x40
    cut.write_bytes(damaged)
    with pytest.raises(ValueError, match="cut.capture"):
        graze.replay(cut)
    cut.write_bytes(b"graze")
    with pytest.raises(ValueError, match="cut.capture"):
        graze.replay(cut)


def test_what_is_raised_while_it_plays_comes_out(tmp_path):
    file = tmp_path / "one.capture"
    simulation = graze.CapturedSimulation(file)
    drop(simulation)
    simulation.step(STEP)
    with pytest.raises(ZeroDivisionError):
        graze.replay(file, lambda frame, poses: 1 / 0)


def test_what_no_file_holds_is_refused(tmp_path):
    world = graze.CapturedWorld(tmp_path / "own.capture")
    with pytest.raises(ValueError, match="shape"):
        world.add(graze.UserConvex(lambda direction: tuple(np.sign(direction))))
    assert len(world) == 0
    gone = world.add(graze.Sphere(1))
    world.set_name(gone, "gone")
    world.remove(gone)
    with pytest.raises(ValueError, match="body"):
        world.set_name(gone, "back")
    with pytest.raises(ValueError, match="file"):
        graze.CapturedWorld(tmp_path / "no such folder" / "a.capture")
    with pytest.raises(ValueError, match="file"):
        graze.replay(tmp_path / "none.capture")


def test_a_full_disk_is_told():
    with pytest.raises(ValueError, match="takes no more bytes"):
        graze.CapturedSimulation("/dev/full")
