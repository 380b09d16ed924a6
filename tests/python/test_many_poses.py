"""The example of many poses: in order and the same whatever the number of ranks."""

import os
import pathlib
import runpy
import shutil
import subprocess
import sys

import numpy as np
import pytest

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python" / "many_poses.py"
CHECK = """
import sys
import numpy as np
from mpi4py import MPI
sys.path.insert(0, sys.argv[1])
import many_poses
poses = many_poses.random_poses(700) if MPI.COMM_WORLD.rank == 0 else None
nearest = many_poses.all_clearances(poses)
if nearest is not None:
    np.save(sys.argv[2], nearest)
    np.save(sys.argv[2] + ".poses", poses)
"""


def test_the_answers_are_in_order_at_any_number_of_ranks(tmp_path):
    pytest.importorskip("mpi4py")
    if not shutil.which("mpirun"):
        pytest.skip("no mpirun")
    check = tmp_path / "check.py"
    check.write_text(CHECK)
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    for ranks in (1, 3):
        subprocess.run(["mpirun", "--oversubscribe", "-n", str(ranks), sys.executable, "-m", "mpi4py", check,
                        EXAMPLE.parent, tmp_path / f"nearest{ranks}.npy"], check=True, timeout=120, env=environment)
    one, three = (np.load(tmp_path / f"nearest{ranks}.npy") for ranks in (1, 3))
    assert len(one) == 700 and (one < 0).any() and (one > 0).any()
    assert one.tobytes() == three.tobytes()
    # In the order of the poses: some asked alone.
    poses = np.load(tmp_path / "nearest1.npy.poses.npy")
    clearances = runpy.run_path(str(EXAMPLE))["clearances"]
    for i in (0, 255, 256, 699):
        assert clearances(poses[i : i + 1])[0] == one[i]
