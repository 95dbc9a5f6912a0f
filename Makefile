# `make` sets up .venv, derives everything and audits the papers; `make test` sets up what it needs and runs the tests.
# CONTRIBUTING.md explains the other goals. Another Python: make PYTHON=python3.12

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
INSTALL := $(BIN)/python -m pip install -qq --constraint constraints.txt --no-build-isolation
VERSION = $$($(PYTHON) -c 'import platform; print(platform.python_version())' 2>/dev/null || echo not there)
export PIP_DISABLE_PIP_VERSION_CHECK := 1
export PYTHONDONTWRITEBYTECODE :=  # what one process has compiled, the hundreds that tests start need not compile again

.PHONY: all test lint format types layers drift notebooks bench scoreboard verify mutants matrix seeds site site-release site-test dist installed clean
.NOTPARALLEL:

all: $(VENV)/.package
	$(BIN)/radartrack regenerate
	$(BIN)/radartrack audit

test: $(VENV)/.group-test
	$(BIN)/python -m pytest -n auto --dist worksteal

lint: $(VENV)/.group-lint
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: $(VENV)/.group-lint
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

types: $(VENV)/.group-types installed
	@cp -R tests build/installed
	cd build/installed && ../../$(BIN)/mypy --config-file ../../pyproject.toml --package radartrack --package tests

layers: $(VENV)/.group-layers installed
	cd build/installed && ../../$(BIN)/lint-imports --config ../../pyproject.toml --no-cache --no-logo

# In another order of hashes and with other integers than `make` itself: both must give the same bytes.
drift: $(VENV)/.package
	PYTHONHASHSEED=4242 SYMPY_GROUND_TYPES=python $(BIN)/radartrack regenerate --check

notebooks: $(VENV)/.group-notebooks $(VENV)/.extra-plots
	$(BIN)/python -m pytest -n auto --nbmake --overwrite notebooks

bench: $(VENV)/.extra-peers
	@mkdir -p build
	$(BIN)/python -m pytest benchmarks --benchmark-json build/benchmarks.json --benchmark-columns min --override-ini filterwarnings=default
	$(BIN)/python benchmarks/table.py build/benchmarks.json >build/benchmarks.md
	$(BIN)/python benchmarks/growth.py >>build/benchmarks.md
	mv build/benchmarks.md docs/benchmarks.md

# The page of all audits of literature and libraries; on a busy machine claims need more than their usual time.
scoreboard: $(VENV)/.package
	$(BIN)/radartrack audit literature libraries --timeout 600 --html docs/scoreboard.html

verify: $(VENV)/.group-test
	$(BIN)/radartrack verify

# Mutants of the derivations' own code, in a copy; Cosmic Ray has an environment of its own. All of them take days;
# `make mutants SAMPLE=120` takes an hour.
mutants: $(VENV)/.group-test
	rm -rf build/mutants
	mkdir -p build/mutants
	cp -R derive generated radartrack tests pyproject.toml mutation.toml build/mutants
	ln -s ../derive ../generated build/mutants/radartrack
	$(PYTHON) -m venv build/mutants/tool
	build/mutants/tool/bin/python -m pip install -qq cosmic-ray==8.7.0
	cd build/mutants && tool/bin/cosmic-ray init mutation.toml session.sqlite
	cd build/mutants && tool/bin/cr-filter-operators session.sqlite mutation.toml
	$(if $(SAMPLE),$(BIN)/python tests/mutants_of_the_tool.py sample build/mutants/session.sqlite $(SAMPLE))
	cd build/mutants && PYTHONPATH="$$PWD" PATH="$$PWD/../../$(BIN):$$PATH" tool/bin/cosmic-ray exec mutation.toml session.sqlite
	build/mutants/tool/bin/cr-report build/mutants/session.sqlite

# The tests with the oldest and the newest of what is allowed, and without what is optional.
# `make matrix ENVIRONMENTS="oldest bare"` takes some of tests/version_matrix.py.
matrix: $(VENV)/.package
	$(BIN)/python tests/version_matrix.py $(ENVIRONMENTS)

# The property tests with a hundred seeds, or with those of `make seeds SEEDS="7 8"`; the first that fails ends it.
SEEDS ?= $(shell seq 100)
seeds: $(VENV)/.group-test
	@for seed in $(SEEDS); do echo "seed $$seed"; \
		RADARTRACK_HYPOTHESIS=dev $(BIN)/python -m pytest -n auto --dist worksteal -q -m hypothesis --hypothesis-seed $$seed || exit 1; done

# Tests that may be made as long as one likes, each with a size of its own: `make campaign-formulas SIZE=1000`.
TESTS_OF_arguments := tests/generated/test_elementary.py
SIZE_OF_arguments := 12500000
TESTS_OF_faults := tests/radartrack/verification/test_generated_code.py
SIZE_OF_faults := 200
TESTS_OF_formulas := tests/derive/checking/test_verdicts.py
SIZE_OF_formulas := 100000
TESTS_OF_functions := tests/radartrack/testing/test_diagnosing.py
SIZE_OF_functions := 20
TESTS_OF_mutants := tests/derive/checking
SIZE_OF_mutants := 100
TESTS_OF_strangers := tests/derive/checking/test_strangers.py
SIZE_OF_strangers := 1000
# A number without its digits is nothing.
digits_off = $(if $(2),$(call digits_off,$(subst $(firstword $(2)),,$(1)),$(wordlist 2,10,$(2))),$(1))
is_number = $(if $(1),$(if $(call digits_off,$(1),0 1 2 3 4 5 6 7 8 9),,$(filter-out 0%,$(1))))
campaign-%: $(VENV)/.group-test
	$(if $(TESTS_OF_$*),,$(error there is no campaign of $*))
	$(if $(call is_number,$(or $(SIZE),$(SIZE_OF_$*))),,$(error SIZE must be a whole number from 1; got "$(SIZE)"))
	RADARTRACK_$(shell echo $* | tr a-z A-Z)=$(or $(SIZE),$(SIZE_OF_$*)) \
		$(BIN)/python -m pytest -n auto --dist worksteal -q --override-ini faulthandler_timeout=0 $(TESTS_OF_$*)

# The documents and the checker's page, which runs the library in the browser: build/site. Needs Node 20 or newer and npm.
SITE := build/site-source
CHECKER := $(SITE)/docs/check
site: $(VENV)/.group-site web/node_modules/.installed
	rm -rf $(SITE) build/site
	mkdir -p $(CHECKER)/python
	$(BIN)/python web/build/python_sources.py $(SITE)/sources.zip
	node web/build/compile_modules.mjs $(SITE)/sources.zip $(CHECKER)/python/modules.bin
	$(BIN)/python web/build/catalogue.py $(CHECKER)/catalogue.json
	cp derive/claims/gao.toml $(CHECKER)/example.toml
	node web/build/checker.mjs $(CHECKER)
	$(BIN)/python web/build/documents.py $(SITE)
	NO_MKDOCS_2_WARNING=1 $(BIN)/python -m mkdocs build --quiet --strict --config-file $(SITE)/mkdocs.yml --site-dir $(CURDIR)/build/site

# The site of a release beside those of earlier ones, as a commit in the branch `site`, which is for a host of files. The
# address without a release leads to the latest.
site-release: export PATH := $(CURDIR)/$(BIN):$(PATH)
site-release: export NO_MKDOCS_2_WARNING := 1
site-release: site
	mike --quiet deploy --config-file $(SITE)/release.yml --branch site --update-aliases --alias-type copy \
		$$(python -c 'from importlib.metadata import version; print(version("radartrack"))') latest
	mike --quiet set-default --config-file $(SITE)/release.yml --branch site latest

# The site in Chromium; what is missing for that is said, and skipped. CHROMIUM=… names another browser.
site-test: web/node_modules/.installed
	cd web && npx tsc --project .
	cd web && node --test tests/

# What is uploaded at a release: dist/
dist: $(VENV)/.group-build
	rm -rf dist
	$(BIN)/python -m build --quiet

clean:
	rm -rf web/node_modules dist
	rm -rf $(VENV) build *.egg-info .hypothesis .mypy_cache .pytest_cache .ruff_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# Type checkers and import-linter do not follow the mapping of folders to packages in an editable
# installation, so they read an ordinary one, built from a copy that leaves nothing behind in the tree.
installed: $(VENV)/.package
	@rm -rf build/source build/installed
	@mkdir -p build/source
	@cp -R LICENSE README.md pyproject.toml derive generated radartrack build/source
	@$(INSTALL) --no-deps --target build/installed ./build/source

web/node_modules/.installed: web/package.json web/package-lock.json
	@node -e 'process.exit(+(parseInt(process.versions.node) < 20))' 2>/dev/null || { \
		echo "The site is built with Node 20 or newer and npm; https://nodejs.org has them." >&2; exit 1; }
	cd web && npm ci --no-audit --no-fund
	@touch $@

# The package is installed editable: a change of its code needs no second installation.
$(VENV)/.package: pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { \
		echo "radartrack needs Python 3.11 or newer; $(PYTHON) is $(VERSION)." >&2; \
		echo "Name another one: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { \
		echo "$(PYTHON) cannot make a virtual environment: it lacks ensurepip or venv." >&2; \
		echo "On Debian and Ubuntu the package python3-venv has them." >&2; exit 1; }
	@echo "Setting up $(VENV) with $(PYTHON), which is $(VERSION)"
	@$(PYTHON) -m venv $(VENV)
	@$(BIN)/python -m pip install -qq --upgrade --constraint constraints.txt pip setuptools
	@$(INSTALL) --editable .
	@touch $@

$(VENV)/.group-%: $(VENV)/.package
	@echo "Installing the dependency group $*"
	@$(INSTALL) --group $*
	@touch $@

$(VENV)/.extra-%: $(VENV)/.package
	@echo "Installing the extra $*"
	@$(INSTALL) --editable ".[$*]"
	@touch $@
