"""Digests of sources: what reruns what."""

import pytest

from orthocut.params import identity


@pytest.fixture
def package(tmp_path, monkeypatch):
    """Return a package of empty files under which digests are taken."""
    names = (
        "kernels/jit.py", "kernels/laws/law.py", "kernels/mpm/grid.py", "kernels/dem/bonds.py", "mpm/solver.py",
        "dem/solver.py", "experiments/mpm_cutting.py", "experiments/dem_cutting.py", "experiments/speed_mpm.py",
        "measure/steady.py", "params/tool.py", "params/mpm.py", "params/study.py", "figures/show.py",
        "figures/style.mplstyle", "theory/beam.py", "variables.py", "cli/__init__.py",
    )  # fmt: skip
    for name in names:
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("")
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
        ("kernels/laws/law.py", {"mpm", "dem"}),
        ("kernels/jit.py", {"mpm", "dem"}),
        ("measure/steady.py", {"mpm", "dem"}),
        ("params/tool.py", {"mpm", "dem", "pictures"}),
        ("kernels/mpm/grid.py", {"mpm"}),
        ("mpm/solver.py", {"mpm"}),
        ("params/mpm.py", {"mpm", "pictures"}),
        ("experiments/mpm_cutting.py", {"mpm"}),
        ("dem/solver.py", {"dem"}),
        ("experiments/dem_cutting.py", {"dem"}),
        ("figures/show.py", {"pictures"}),
        ("figures/style.mplstyle", {"pictures"}),
        ("theory/beam.py", {"pictures"}),
        ("variables.py", {"pictures"}),
        ("experiments/speed_mpm.py", set()),
        ("params/study.py", set()),
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
            "pictures": identity.digest_pictures(),
        }

    before = digests()
    (package / name).write_text("edited = True\n")
    after = digests()
    assert {key for key in before if before[key] != after[key]} == changes


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
