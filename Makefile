# Two commands are all a new machine needs: make demo, make test. Each sets up .venv/ by itself.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.ready
export PIP_DISABLE_PIP_VERSION_CHECK := 1

.PHONY: help demo bundle test format bench footage ablation results results-parts results-stereo results-spheroid results-flow results-doctor detector kills batch-kills batch-cost power-cuts failed-calls two-programs mutants networks containers hostile soak long memory model peers scorers interchange pictures snapshots messages lock clean
.DEFAULT_GOAL := help

help: ## what can be made
	@grep -E '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 12

$(STAMP): pyproject.toml requirements.lock
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "trackwright needs Python 3.11 or newer: make PYTHON=python3.12 ..." >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || \
	  { echo "Python's venv module is missing: apt-get install python3-venv" >&2; exit 1; }
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --require-hashes -r requirements.lock
	$(BIN)/pip install --quiet --no-deps --no-build-isolation --editable .
	@touch $@

demo: $(STAMP) ## the built-in recording: made, tracked, opened
	@$(BIN)/python -m app.cli.system_libraries
	$(BIN)/trackwright demo --out demo

test: $(STAMP) ## formatter, linter, types, import layers and tests
	@$(BIN)/python -m app.cli.system_libraries
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	QT_QPA_PLATFORM=offscreen $(BIN)/pytest -n auto --dist loadfile

bundle: $(STAMP) ## dist/: a folder that needs no Python, as an archive and a Debian package (ten minutes)
	$(BIN)/python -m tests.bundle

format: $(STAMP) ## put the code into the house's form
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

bench: $(STAMP) ## measure speed (not part of make test)
	$(BIN)/python -m tests.benchmarks

footage: $(STAMP) ## all trackers over real recordings, rendered ones of others and our own scenes (half an hour)
	$(BIN)/python -m tests.benchmarks.footage --others

ablation: $(STAMP) ## docs/results/ablation.md: what each mechanism of a tracker is worth (hours)
	for tracker in spheroid flow three-part stereo-joint; do \
	  $(BIN)/python -m tests.benchmarks.footage.ablation --tracker $$tracker --report || exit 1; done

results: results-parts results-stereo results-spheroid results-flow results-doctor ## docs/results/: the papers' figures beside ours (six and a half hours)

results-doctor: $(STAMP) ## docs/results/doctor.md: faults put into recordings and found (a quarter of an hour)
	$(BIN)/python -m tests.benchmarks.doctor --report

results-parts: $(STAMP) ## docs/results/parts.md: body parts on scenes no setting was chosen on (half an hour)
	$(BIN)/python -m tests.benchmarks.parts --report

results-stereo: $(STAMP) ## docs/results/stereo.md: both papers' tables, goals, other trackers (five hours; after make peers)
	$(BIN)/python -m tests.benchmarks.stereo --report

results-spheroid: $(STAMP) ## docs/results/spheroid.md: marks, hard situations, disturbances (half an hour)
	$(BIN)/python -m tests.benchmarks.spheroid --report

results-flow: $(STAMP) ## docs/results/flow.md: counted passages and sums (half an hour)
	$(BIN)/python -m tests.benchmarks.flow --report

detector: $(STAMP) ## the built-in failure detector: rendered, tracked, labelled from truth, trained (ten minutes; the one by the paper: tests.benchmarks.parts.detector --paper)
	$(BIN)/python -m tests.benchmarks.parts.detector

kills: $(STAMP) ## kill programs that correct a session 2,000 times: nothing may be lost (half an hour)
	$(BIN)/python -m tests.sweeps.kills

batch-kills: $(STAMP) ## kill a batch and its workers 200 times: equal to one worker that nobody kills (three quarters of an hour)
	$(BIN)/python -m tests.sweeps.batches

batch-cost: $(STAMP) ## what batches cost: beginning again, two workers, 64 workers and 100,000 recordings (ten minutes)
	$(BIN)/python -m tests.benchmarks.batch resume
	$(BIN)/python -m tests.benchmarks.batch speed-up
	$(BIN)/python -m tests.benchmarks.batch simulate

power-cuts: $(STAMP) ## 500 power cuts replayed from recorded writes: nothing may be lost (ten minutes, needs strace)
	$(BIN)/python -m tests.sweeps.power_cuts

failed-calls: $(STAMP) ## each system call of saving, importing and exporting fails once (hours, needs strace)
	$(BIN)/python -m tests.sweeps.failed_calls

two-programs: $(STAMP) ## two programs on one session whose lock is removed by hand, 500 times (fifteen minutes)
	$(BIN)/python -m tests.sweeps.two_programs

mutants: $(STAMP) ## damaged files of each kind through the real command, 10,000 of each (days)
	$(BIN)/python -m tests.sweeps.mutants

networks: $(STAMP) ## 1,000 damaged networks, run by either engine (ten minutes)
	$(BIN)/python -m tests.sweeps.networks

containers: $(STAMP) ## 10,000 damaged bags and folders of stereo cameras, opened and read (half an hour)
	$(BIN)/python -m tests.sweeps.containers

hostile: $(STAMP) ## 300 files and folders made to harm, each through the real command (five minutes)
	$(BIN)/python -m tests.sweeps.hostile

soak: $(STAMP) ## 10,000 steps of correcting in the real window (an hour)
	$(BIN)/python -m tests.sweeps.soak

long: $(STAMP) ## track 100,000 frames and watch the memory: below 1 GiB (half an hour to an hour)
	$(BIN)/python -m tests.sweeps.long_run

memory: $(STAMP) ## open and close a session 200 times in the window: memory must not grow (20 minutes)
	QT_QPA_PLATFORM=offscreen $(BIN)/python -m tests.sweeps.open_close

model: $(STAMP) ## sessions against a plain list of states, 10,000 runs of 50 steps (two hours)
	$(BIN)/python -m tests.sweeps.model

peers: $(STAMP) ## the programs we compare with, each in an environment of its own under build/peers
	$(BIN)/python -m tests.peers

scorers: $(STAMP) ## scores against TrackEval's and py-motmetrics' on 480 random sequences (five minutes; after make peers)
	$(BIN)/python -m tests.sweeps.scorers

interchange: $(STAMP) ## other tools read what is written, and the other way round (after make peers)
	$(BIN)/python -m tests.sweeps.formats

pictures: $(STAMP) ## make the pictures in docs/ through a virtual screen
	@$(BIN)/python -m app.cli.system_libraries
	@command -v xvfb-run >/dev/null || { echo "xvfb-run is missing: apt-get install xvfb" >&2; exit 1; }
	xvfb-run -a -s "-screen 0 1920x1200x24" $(BIN)/python -m tests.pictures

snapshots: $(STAMP) ## build/snapshots: every panel, dialog and page in both looks, 100 and 200 %, English and Japanese (half an hour)
	@$(BIN)/python -m app.cli.system_libraries
	$(BIN)/python -m tests.pictures.snapshots build/snapshots

messages: $(STAMP) ## texts to translate: resources/translations/trackwright.pot
	$(BIN)/python -m tests.catalogue

lock: $(STAMP) ## pin the newest allowed versions of all dependencies, with hashes
	$(BIN)/pip install --quiet uv
	$(BIN)/uv pip compile pyproject.toml --extra dev --universal --python-version 3.11 \
	  --generate-hashes --no-emit-index-url --no-annotate --no-header --upgrade -o requirements.lock

clean: ## remove everything that was made
	rm -rf $(VENV) build dist demo .mypy_cache .ruff_cache .pytest_cache .hypothesis
