"""Digests of sources: what reruns what."""

import pytest

from orthocut.params import identity

FILES = {
    "kernels/jit.py": "",
    "kernels/laws/law.py": "from orthocut.kernels.jit import part\n",
    "kernels/laws/joint.py": "from orthocut.kernels.jit import part\n",
    "kernels/mpm/grid.py": "from orthocut.kernels.laws.law import law\nfrom orthocut.kernels.jit import jit\n",
    "kernels/dem/bonds.py": "from orthocut.kernels.laws import joint, law\n",
    "mpm/solver.py": "from orthocut.kernels.mpm import grid\n",
    "dem/solver.py": "from orthocut.kernels.dem import bonds\n",
    "experiments/mpm_cutting.py": "from orthocut.measure import steady\nfrom orthocut.mpm.solver import Solver\n"
    "from orthocut.params.mpm import Case\nfrom orthocut.io.files import write\n",
    "experiments/dem_cutting.py": "from orthocut.experiments.dem_run import run\nfrom orthocut.measure import steady\n",
    "experiments/dem_tension.py": "from orthocut.experiments.dem_run import run\n",
    "experiments/dem_run.py": "from orthocut.dem.solver import Solver\nfrom orthocut.params.tool import Tool\n",
    "experiments/speed_mpm.py": "from orthocut.mpm.solver import Solver\n",
    "measure/steady.py": "",
    "params/tool.py": "from orthocut.params.block import Block\n",
    "params/mpm.py": "from orthocut.params.tool import Tool\n",
    "params/block.py": "",
    "params/study.py": "",
    "params/accuracy.py": "",
    "params/accuracy.yaml": "",
    "params/accuracy_ductile.py": "",
    "params/size.py": "",
    "cost.py": "",
    "figures/show.py": "",
    "figures/style.mplstyle": "",
    "theory/beam.py": "",
    "io/files.py": "",
    "variables.py": "",
    "cli/__init__.py": "",
}
"""A small package: files and what they import."""


@pytest.fixture
def package(tmp_path, monkeypatch):
    """Return a package under which digests are taken."""
    for name, text in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    monkeypatch.setattr(identity, "_PACKAGE", tmp_path)
    digests = (identity.digest_numbers, identity.digest_pictures)
    for digest in digests:
        digest.cache_clear()
    yield tmp_path
    for digest in digests:
        digest.cache_clear()


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("kernels/laws/law.py", {"mpm", "dem", "tension"}),
        ("kernels/laws/joint.py", {"dem", "tension"}),
        ("kernels/jit.py", {"mpm", "dem", "tension"}),
        ("measure/steady.py", {"mpm", "dem"}),
        ("params/tool.py", {"mpm", "dem", "tension", "pictures"}),
        ("kernels/mpm/grid.py", {"mpm"}),
        ("mpm/solver.py", {"mpm"}),
        ("params/mpm.py", {"mpm", "pictures"}),
        ("experiments/mpm_cutting.py", {"mpm"}),
        ("dem/solver.py", {"dem", "tension"}),
        ("experiments/dem_run.py", {"dem", "tension"}),
        ("experiments/dem_tension.py", {"tension"}),
        ("params/block.py", set()),
        ("io/files.py", set()),
        ("experiments/dem_cutting.py", {"dem"}),
        ("figures/show.py", {"pictures"}),
        ("figures/style.mplstyle", {"pictures"}),
        ("theory/beam.py", {"pictures"}),
        ("variables.py", {"pictures"}),
        ("experiments/speed_mpm.py", set()),
        ("params/study.py", set()),
        ("params/accuracy.yaml", {"pictures"}),
        ("cost.py", {"pictures"}),
        ("cli/__init__.py", set()),
    ],
)
def test_an_edit_changes_the_digests_it_should(package, name, changes):
    def digests():
        identity.digest_numbers.cache_clear()
        identity.digest_pictures.cache_clear()
        return {
            "mpm": identity.digest_numbers("mpm_cutting"),
            "dem": identity.digest_numbers("dem_cutting"),
            "tension": identity.digest_numbers("dem_tension"),
            "pictures": identity.digest_pictures(),
        }

    before = digests()
    (package / name).write_text(FILES[name] + "edited = True\n")
    after = digests()
    assert {key for key in before if before[key] != after[key]} == changes


def test_a_method_is_all_of_its_kinds(package):
    both = {*identity.sources("dem_cutting"), *identity.sources("dem_tension")}
    assert set(identity.sources("dem")) == both
    assert {file.name for file in identity.sources("mpm_cutting")} >= {"solver.py", "grid.py", "law.py", "jit.py"}


def test_kernels_that_only_one_method_uses_count_for_it_alone():
    names = {kind: {file.name for file in identity.sources(kind)} for kind in ("mpm_cutting", "dem_cutting")}
    assert {"step.py", "rest.py", "cohesive_cubic.py", "hardening_voce.py", "jit.py"} <= names["mpm_cutting"]
    assert {"joints.py", "flat_joint.py", "packing.py", "jit.py"} <= names["dem_cutting"]
    assert "flat_joint.py" not in names["mpm_cutting"]
    assert "step.py" not in names["dem_cutting"]


def test_libraries_count(package, monkeypatch):
    before = identity.digest_numbers("mpm_cutting")
    identity.digest_numbers.cache_clear()
    monkeypatch.setattr(identity, "version", lambda name: "0.0")
    assert identity.digest_numbers("mpm_cutting") != before


@pytest.mark.parametrize(
    ("edited", "same"),
    [
        ('"""New words."""\n\nEDGE = 1  # other words\n', True),
        ('"""Words."""\n\n\n# a line of its own\nEDGE = 1\n\n"""Edge."""\n', True),
        ('"""Words."""\nEDGE = 2\n', False),
        ('"""Words."""\nEDGE = "# 1"\n', False),
        ('"""Words."""\nif True:\n    EDGE = 1\n', False),
    ],
)
def test_words_about_the_code_are_no_part_of_a_digest(package, edited, same):
    def digest():
        identity.digest_numbers.cache_clear()
        return identity.digest_numbers("mpm_cutting")

    (package / "kernels/mpm/grid.py").write_text('"""Words."""\nEDGE = 1\n')
    before = digest()
    (package / "kernels/mpm/grid.py").write_text(edited)
    assert (digest() == before) is same
