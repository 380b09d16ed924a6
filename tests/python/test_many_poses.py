"""Sweeps of configurations over ranks: the same bytes at any number of them, and after a kill; errors on every rank."""

import os
import pathlib
import runpy
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import graze

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python" / "many_poses.py"
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


@pytest.fixture(scope="module")
def example():
    pytest.importorskip("mpi4py")
    pytest.importorskip("graze.mpi")
    if not shutil.which("mpirun"):
        pytest.skip("no mpirun")
    return runpy.run_path(str(EXAMPLE))


def command(ranks, *arguments):
    return ["mpirun", "--oversubscribe", "-n", str(ranks), sys.executable, "-m", "mpi4py", str(EXAMPLE), *map(str, arguments)]


def run(ranks, *arguments):
    return subprocess.run(command(ranks, *arguments), check=True, timeout=120, env=ENVIRONMENT, text=True,
                          stdout=subprocess.PIPE).stdout


def test_answers_are_those_of_the_world_at_any_number_of_ranks(example, tmp_path):
    for ranks in (1, 3):
        assert "of 700 poses are free" in run(ranks, tmp_path / "poses", tmp_path / f"nearest{ranks}", 700)
    assert (tmp_path / "nearest1").read_bytes() == (tmp_path / "nearest3").read_bytes()
    nearest = np.fromfile(tmp_path / "nearest3", graze.mpi.nearest)
    poses = np.fromfile(tmp_path / "poses").reshape(-1, 5, 7)
    assert len(nearest) == 700 and (nearest["distance"] < 0).any() and (nearest["distance"] > 0).any()
    links, pairs = example["arm"]()
    room = example["room"]()
    # In the order of the poses: each as asked alone.
    for pose, answer in zip(poses[::23], nearest[::23]):
        of_scene = min(room.nearest(link, at)[0][1].distance for link, at in zip(links, pose))
        of_arm = min(graze.distance(links[a], pose[a], links[b], pose[b]).distance for a, b in pairs)
        assert answer["distance"] == min(of_scene, of_arm)
        assert answer["link"] < 5 and (answer["other"] >= 5) == (of_scene <= of_arm)


def test_a_sweep_that_was_killed_goes_on(example, tmp_path):
    poses, out, journal = tmp_path / "poses", tmp_path / "nearest", tmp_path / "nearest.journal"
    example["random_poses"](60000).tofile(poses)
    started = subprocess.Popen(command(2, poses, out), env=ENVIRONMENT, start_new_session=True)
    until = time.monotonic() + 60
    while sum(part.stat().st_size for part in journal.glob("part-*")) == 0:
        assert started.poll() is None and time.monotonic() < until, "nothing in the journal"
        time.sleep(0.002)
    os.killpg(started.pid, signal.SIGKILL)
    started.wait(60)
    # mpirun gives each rank a group of its own.
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if str(out).encode() in (process / "cmdline").read_bytes():
                os.kill(int(process.name), signal.SIGKILL)
        except (FileNotFoundError, ProcessLookupError):
            pass
    assert not out.exists()
    assert int(run(3, poses, out).split("; ")[1].split()[0]) > 0
    assert not journal.exists()
    run(1, poses, tmp_path / "whole")
    assert out.read_bytes() == (tmp_path / "whole").read_bytes()


FAULT = """
import sys
import graze, graze.mpi
try:
    graze.mpi.sweep_configurations(sys.argv[1], sys.argv[2], [graze.Sphere(1)] * 3, graze.World(),
                                     limit=float(sys.argv[3]))
except graze.mpi.CommonError as error:
    sys.stdout.write(f"told: {error}\\n")
"""


def test_a_fault_is_told_on_every_rank(example, tmp_path):
    (tmp_path / "fault.py").write_text(FAULT)
    (tmp_path / "torn").write_bytes(bytes(100))
    for poses, limit, words in (("none", "1", "cannot be opened"), ("torn", "1", "records of 168 bytes"),
                                ("torn", "nan", "limit: expected a number >= 0, got nan")):
        told = subprocess.run(
            ["mpirun", "--oversubscribe", "-n", "3", sys.executable, "-m", "mpi4py", str(tmp_path / "fault.py"),
             str(tmp_path / poses), str(tmp_path / "out"), limit], check=True, timeout=60, env=ENVIRONMENT, text=True, stdout=subprocess.PIPE).stdout
        assert told.count("told: ") == 3 and told.count(words) == 3, told
    assert not (tmp_path / "out").exists()


LIMIT = """
import sys
import graze, graze.mpi
from mpi4py import MPI
try:
    limit = (1e-7, 4e-7)[MPI.COMM_WORLD.rank]
    graze.mpi.sweep_configurations(sys.argv[1], sys.argv[2], [graze.Sphere(1)], graze.World(), limit=limit)
except graze.mpi.CommonError as error:
    sys.stdout.write(f"told: {error}\\n")  # at once, since all ranks write to one pipe
"""


def test_small_limits_are_told_from_each_other(example, tmp_path):
    # The same words stand at the head of the journal, which is refused where they are others.
    (tmp_path / "limit.py").write_text(LIMIT)
    (tmp_path / "poses").write_bytes(bytes(56))
    told = subprocess.run(
        ["mpirun", "--oversubscribe", "-n", "2", sys.executable, "-m", "mpi4py", str(tmp_path / "limit.py"),
         str(tmp_path / "poses"), str(tmp_path / "out")], check=True, timeout=60, env=ENVIRONMENT, text=True,
        stdout=subprocess.PIPE).stdout
    assert told.count("limit 1e-07") == 2 and told.count("limit 4e-07") == 2, told
