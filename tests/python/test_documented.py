"""Every name that users find says what it is."""

import inspect

import pytest

import graze
import graze._graze


def text_of(thing):
    """What a docstring says beyond the signatures that pybind11 puts there."""
    lines = (thing.__doc__ or "").splitlines()
    if not isinstance(thing, (property, type)):
        lines = [line for line in lines if "(" not in line or "->" not in line]
        lines = [line for line in lines if line.strip() not in ("", "Overloaded function.")]
    return "\n".join(lines).strip()


def names():
    for module in (graze._graze, graze._graze.batch, graze._graze._plane, graze._graze._plane.batch):
        for name, thing in vars(module).items():
            if name.startswith("_") or not callable(thing):
                continue
            yield pytest.param(thing, id=f"{module.__name__}.{name}")
            if inspect.isclass(thing):
                for attribute, member in vars(thing).items():
                    if not attribute.startswith("_"):
                        yield pytest.param(member, id=f"{module.__name__}.{name}.{attribute}")


def test_batches_are_modules_to_import():
    from graze.batch import overlap
    from graze.plane.batch import overlap as in_the_plane

    assert overlap is graze.batch.overlap and in_the_plane is graze.plane.batch.overlap


@pytest.mark.parametrize("thing", names())
def test_it_says_what_it_is(thing):
    assert text_of(thing)


@pytest.mark.parametrize(
    "name", ["distance", "contacts", "cast", "closest", "raycast", "overlap", "batch.contacts", "batch.cast", "batch.distance"]
)
def test_questions_say_what_they_raise(name):
    for module in (graze, graze.plane):
        thing = module
        for part in name.split("."):
            thing = getattr(thing, part)
        assert "ValueError" in thing.__doc__, f"{module.__name__}.{name}"
