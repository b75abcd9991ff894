"""Generated files are in step with the models."""

from pathlib import Path

import jsonschema
import pytest

from orthocut.params.case import KINDS, load, validate
from orthocut.params.schema import files, study_schema
from orthocut.params.text import parse_yaml, read_yaml

CONFIG = Path(__file__).resolve().parents[3] / "workflow" / "config"
STUDIES = sorted(path for path in CONFIG.glob("*.yaml") if path.name != "default.yaml")


@pytest.mark.parametrize("name", files())
def test_generated_file_is_current(name):
    assert (CONFIG / name).read_text(encoding="utf-8") == files()[name], (
        "run: python -m orthocut.params.schema workflow/config"
    )


@pytest.mark.parametrize("kind", KINDS)
def test_default_yaml_gives_the_default_case(kind):
    assert validate(parse_yaml(files()["default.yaml"], "default.yaml")[kind]) == load(kind)


def test_schema_is_a_schema_and_refuses():
    schema = study_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    good = {"title": "t", "sweeps": {"a": {"base": {"kind": "mpm_cutting", "cut_depth": "1 mm"}}}, "figures": {}}
    jsonschema.validate(good, schema)
    bad = {**good, "sweeps": {"a": {"base": {"kind": "mpm_cutting", "cut_dept": "1 mm"}}}}
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(bad, schema)


@pytest.mark.parametrize("path", STUDIES, ids=lambda path: path.name)
def test_studies_of_the_project_fit_the_schema(path):
    jsonschema.validate(read_yaml(path), study_schema())
