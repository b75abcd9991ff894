"""Workers that are jobs of Slurm."""

import dask_jobqueue
import pytest

from orthocut import sweep


class Unsubmitted(dask_jobqueue.SLURMCluster):
    """Writes the script of its jobs but submits none."""

    def scale(self, n):
        self.asked = n


def test_jobs_of_workers_ask_for_the_time_and_their_share_of_the_memory_of_the_batch(monkeypatch, tmp_path):
    monkeypatch.setattr(dask_jobqueue, "SLURMCluster", Unsubmitted)
    with sweep._cluster("slurm", workers=4, memory_mb=4000, minutes=135, logs=tmp_path / "batch") as cluster:
        script = cluster.job_script()
        assert cluster.asked == 4
    assert "#SBATCH -t 135\n" in script
    assert f"#SBATCH -o {tmp_path}/batch/" in script
    memory = next(line for line in script.splitlines() if "--mem=" in line).partition("--mem=")[2]
    assert memory.endswith("M")
    assert float(memory[:-1]) == pytest.approx(1000 / 1.048576, abs=1)
