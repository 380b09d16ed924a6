"""Exceptions of support functions in Python: raised by the call that asked them, in place of its answer."""

import threading

import numpy as np
import pytest

import graze
from graze import plane


def breakable(of):
    """A cube or a square whose support function raises `broken[0]`, or returns it where it is no exception."""
    broken = [None]

    def support(direction):
        calls.append(1)
        if isinstance(broken[0], BaseException):
            raise broken[0]
        return np.sign(direction) if broken[0] is None else broken[0]

    calls = []
    return of.UserConvex(support), broken, calls


SPACES = [(graze, graze.Sphere(0.5), (3, 0, 0), 7), (plane, plane.Circle(0.5), (3, 0), 4)]


@pytest.mark.parametrize("of, ball, at, columns", SPACES)
def test_the_first_exception_is_raised_in_place_of_the_answer(of, ball, at, columns):
    cube, broken, calls = breakable(of)
    poses = np.zeros((20, columns))
    poses[:, 0], poses[:, 6 if columns == 7 else 2] = 3, 1
    ray = ((-5,) + at[1:], (1,) + (0,) * (len(at) - 1))
    questions = [
        lambda: of.distance(cube, None, ball, at),
        lambda: of.overlap(cube, None, ball, tuple(0.4 * x for x in at)),  # nearer than bounds can tell
        lambda: of.contacts(cube, None, ball, at, 5),
        lambda: of.raycast(cube, None, *ray),
        lambda: of.batch.distance(cube, None, ball, poses),
        lambda: of.batch.contacts(cube, None, ball, poses, 5),
        lambda: of.batch.closest(cube, None, [at]),
        lambda: cube.bounds(),
        lambda: cube.support(at),
    ]
    for question in questions:
        broken[0] = None
        before = question()
        broken[0] = error = KeyError("mine")
        calls.clear()
        with pytest.raises(KeyError) as raised:
            question()
        assert raised.value is error and calls == [1]  # nobody is asked any more
        broken[0] = None
        assert repr(question()) == repr(before)
    world = of.World()
    world.add(ball, at)
    world.add(cube, at)
    broken[0] = ValueError("mine, too")
    with pytest.raises(ValueError, match="^mine, too$"):
        world.update()
    with pytest.raises(ValueError, match="^mine, too$"):
        world.nearest(cube)
    broken[0] = None
    world.update()
    assert len(world) == 2 and len(world.events) >= 1


@pytest.mark.parametrize("of, ball, at, columns", SPACES)
def test_what_is_no_point_is_a_type_error(of, ball, at, columns):
    number = "three" if of is graze else "two"
    for answer in ("x", 1.0, (1,)):
        cube, broken, _ = breakable(of)
        broken[0] = answer
        with pytest.raises(TypeError, match=f"^support: expected {number} numbers, got "):
            of.distance(cube, None, ball, at)
        with pytest.raises(TypeError, match=f"^support: expected {number} numbers, got "):
            of.UserConvex(lambda direction: answer)
    with pytest.raises(TypeError, match=f"^support: expected {number} numbers, got None$"):
        of.UserConvex(lambda direction: None)
    with pytest.raises(ZeroDivisionError):
        of.UserConvex(lambda direction: 1 / 0)


def test_an_exception_is_that_of_the_innermost_call():
    cube, broken, _ = breakable(graze)
    ball = graze.Sphere(0.5)
    caught = []

    def support(direction):
        broken[0] = KeyError("inner")
        try:
            graze.distance(cube, None, ball, (3, 0, 0))
        except KeyError as error:
            caught.append(error)
        broken[0] = None
        return np.sign(direction)

    outer = graze.UserConvex(support)
    assert graze.distance(outer, None, ball, (3, 0, 0)).distance == pytest.approx(1.5)
    assert caught


def test_threads_have_their_own():
    cube, broken, _ = breakable(graze)
    ball, raised = graze.Sphere(0.5), []
    broken[0] = KeyError("mine")

    def ask():
        try:
            graze.distance(cube, None, ball, (3, 0, 0))
        except KeyError:
            raised.append(1)

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for _ in range(100):
        assert graze.distance(ball, None, ball, (3, 0, 0)).distance == 2
    for thread in threads:
        thread.join()
    assert len(raised) == 4
