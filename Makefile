# Each target is a line or two that a person could type. tools/set_up.py makes .venv where it is missing, and keeps it
# up to date: each target installs what it needs, and no more.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
export PIP_DISABLE_PIP_VERSION_CHECK = 1

# Without PYTHON=… on the command line, an environment that is there keeps its Python.
KEEP := $(if $(filter file,$(origin PYTHON)),--keep-python)
set_up = @$(PYTHON) -c 'import sys; v = sys.version_info; \
	sys.exit(v < (3, 10) and "set-up: tfloom needs Python 3.10 or newer, and $(PYTHON) is %d.%d: make PYTHON=python3.12 …" % v[:2])' \
	&& $(PYTHON) tools/set_up.py --venv "$(VENV)" $(KEEP) $(SET_UP)

.PHONY: setup demo test test-slow test-all check stub api bench matrix wheels clean

setup:
	$(set_up) check

demo:
	$(set_up) demo
	@"$(BIN)/tfloom" demo $(ARGS)

# All that the README promises, in some minutes.
test:
	$(set_up) test
	@"$(BIN)/python" tools/run_tests.py $(ARGS)

# What is slow by nature: sanitizers, wheels, type checks of users' programs, bare machines, soak.
test-slow:
	$(set_up) check
	@"$(BIN)/python" tools/run_tests.py --slow $(ARGS)

test-all: test test-slow

check:
	$(set_up) check
	"$(BIN)/ruff" check .
	"$(BIN)/ruff" format --check .
	"$(BIN)/mypy"
	"$(BIN)/mypy" tools
	"$(BIN)/basedpyright" --pythonpath "$(BIN)/python"

# The typed face of the extension, after a change in native/bindings.
stub:
	$(set_up) demo
	"$(BIN)/python" -m nanobind.stubgen -m tfloom._native -q -o src/tfloom/_native.pyi

# docs/rclpy_api.md, after a change in what is there of ROS's names.
api:
	$(set_up) demo
	"$(BIN)/python" docs/rclpy_api.py

# A library to be measured beside that can't be installed is named, and left out.
bench:
	$(set_up) test
	-$(set_up) bench
	"$(BIN)/python" -m benchmarks $(ARGS)

# The core tests on each Python 3.10 to 3.14 that this machine has, free-threaded ones too.
matrix:
	.ci/matrix $(ARGS)

# All that set-up, tests and checks download, in the folder wheels/: for a machine without a network.
wheels:
	$(set_up) wheels

clean:
	rm -rf "$(VENV)" build dist
