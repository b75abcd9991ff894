"""Options behind ``snakemake --config``."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from orthocut.params.block import ConfigError
from orthocut.params.workflow import WorkflowOptions


@pytest.fixture
def project(tmp_path):
    """Return the folder of a project beside somebody else's files."""
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "thesis.tex").write_text("")
    root = tmp_path / "project"
    (root / "src").mkdir(parents=True)
    (root / "src" / "code.py").write_text("")
    return root


def check(project, **config):
    options = WorkflowOptions.read(config)
    options.check_folders(project)
    return options


def test_defaults(project):
    options = check(project)
    assert (options.results, options.store_path, options.cluster) == ("results", "results/store", "local")
    assert options.study_path(project) == project / "workflow/config/quick.yaml"


def test_a_file_instead_of_a_name_and_a_store_elsewhere(project):
    options = check(project, study_file="mine/s.yaml", results="results//a/", store=str(project.parent / "shared"))
    assert options.study_path(project) == Path("mine/s.yaml")
    assert (options.results, options.store_path) == ("results/a", str(project.parent / "shared"))


@pytest.mark.parametrize(
    ("config", "words"),
    [
        ({"study": "../../x"}, r"study = '../../x': must be a name \(allowed: a letter"),
        ({"study": "a\nb"}, r"study = 'a\\nb': must be a name"),
        ({"study": "-x"}, "must be a name"),
        ({"study": "é"}, "must be a name"),
        ({"study": "x" * 65}, "must be a name"),
        ({"study": "quick\n"}, "must be a name"),
        ({"study": 3}, "study = 3: must be words"),
        ({"study": None}, "study = None: must be words"),
        ({"study": True}, "study = True: must be words"),
        ({"study": ["quick"]}, "must be words"),
        ({"study": "a", "study_file": "b.yaml"}, r"study and study_file are both given \(allowed: one"),
        ({"studdy": "quick"}, "studdy = 'quick': no such field; did you mean study"),
        ({"study_file": "a\0b"}, r"must be a path"),
        ({"results": ""}, "must be a path"),
        ({"results": "-x"}, "must be a path"),
        ({"results": "r{x}"}, r"without any of \{\}"),
        ({"results": "r;rm x"}, "without any of ;"),
        ({"results": "x" * 1001}, "must be a path"),
        ({"cluster": "pbs"}, "cluster = 'pbs': .*'local' or 'slurm'"),
        ({"batch_cores": 0}, r"batch_cores = 0: is out of range \(allowed: 1 to 4096\)"),
        ({"batch_cores": 1.5}, "must be a whole number"),
        ({"batch_minutes": float("nan")}, "batch_minutes = nan: is out of range"),
        ({"batch_minutes": "10 min"}, "must be a number without unit"),
    ],
)
def test_options_that_are_refused(config, words):
    with pytest.raises(ConfigError, match=rf"^--config: .*{words}"):
        WorkflowOptions.read(config)


@pytest.mark.parametrize(
    ("results", "words"),
    [
        ("..", "leads out of the folder of the project"),
        ("results/../../other", "leads out of"),
        (".", "holds other things"),
        ("src", "holds other things"),
        ("src/code.py", "code.py is not a folder"),
        ("src/code.py/results", "code.py is not a folder"),
        ("{other}", "holds other things"),
        ("x" * 300, "File name too long"),
    ],
)
def test_folders_that_are_refused(project, results, words):
    with pytest.raises(ConfigError, match=words):
        check(project, results=results.replace("{other}", str(project.parent / "other")))


def test_a_store_holds_nothing_else(project):
    with pytest.raises(ConfigError, match=r"store = .*: holds other things"):
        check(project, store=str(project.parent / "other"))
    (project.parent / "other" / "dem-cutting-0.nc").write_text("")
    check(project, store=str(project.parent / "other"))


def test_folders_that_hold_results_are_taken(project):
    for name in ("results", "elsewhere"):
        (project / name / "logs").mkdir(parents=True)
        (project / name / "notes.txt").write_text("")
        check(project, results=name)
    (project / "results" / "logs").rmdir()
    check(project, results="results")


def test_a_folder_that_cannot_be_written_to(project, monkeypatch):
    monkeypatch.setattr("orthocut.params.workflow.os.access", lambda path, mode: False)
    with pytest.raises(ConfigError, match="results = results: cannot be written to"):
        check(project)


SCALARS = st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20)
LISTS = st.lists(SCALARS, max_size=3) | st.dictionaries(st.text(), SCALARS, max_size=2)
NAMES = st.sampled_from(list(WorkflowOptions.model_fields)) | st.text(max_size=8)


@given(st.dictionaries(NAMES, SCALARS | LISTS, max_size=4))
def test_any_config_is_read_or_refused(config):
    message = "--config: "
    try:
        options = WorkflowOptions.read(config)
        assert set(config) <= set(WorkflowOptions.model_fields)
        assert not {"/", "\0", "\n", "."} & set(options.study)
    except ConfigError as refused:
        message = str(refused)
    assert message.startswith("--config: ")
