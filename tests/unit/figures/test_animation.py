"""Animations of cuts: a frame a snapshot, readable, small."""

import itertools

import numpy as np
import pytest
from PIL import Image
from synthetic import dem_cut_run, dem_test_run, make_case, mpm_run

from orthocut.figures.cut_animation import WIDTH, animate
from orthocut.io.collect import collect
from orthocut.io.datasets import failed


@pytest.mark.parametrize("make", [mpm_run, dem_cut_run])
def test_a_frame_a_snapshot(make, tmp_path):
    run = make(snapshots=3)
    animate(collect([run]), tmp_path / "cut.gif")
    with Image.open(tmp_path / "cut.gif") as picture:
        assert picture.n_frames == run.sizes["snapshot"]
        assert picture.size[0] == WIDTH
        frames = []
        for index in range(picture.n_frames):
            picture.seek(index)
            frames.append(np.asarray(picture.convert("L")))
    assert all((a != b).any() for a, b in itertools.pairwise(frames))
    assert [path.name for path in tmp_path.iterdir()] == ["cut.gif"]


@pytest.mark.parametrize("runs", [[dem_test_run("dem_tension")], [failed(make_case("mpm_cutting"), "why", 1.0)]])
def test_without_a_cut_there_is_one_picture_that_says_so(runs, tmp_path):
    animate(collect(runs), tmp_path / "cut.gif")
    with Image.open(tmp_path / "cut.gif") as picture:
        assert picture.n_frames == 1
