# What one types. Each target prints what it runs; what needs more than the Rust toolchain installs
# it itself, or says what is missing and stops.

CARGO ?= cargo
PYTHON ?= python3
SCENE ?= scenes/re35.toml
FLAGS ?= --locked
TIMES ?= 20
SOLVERS = target/smt
BIN = $(CARGO) run --quiet --release $(FLAGS) -p passivity-cli --
# What `check` and `explain` need, built in a hurry: no pictures, no Parquet, no safety case.
QUICK = $(CARGO) run --quiet $(FLAGS) -p passivity-cli --no-default-features --features simulate --
# What only the benches need.
BENCH = --features passivity-bench/criterion
# Builds that leave something out.
LEAN = "passivity-cli" "passivity-cli --features simulate" "passivity-cli --features identify" "passivity-cli --features audit,oracle,vectors" \
    "passivity-cli --features audit,plot,simulate" passivity-capi passivity-audit "passivity-audit --features mcap" passivity-monitor passivity-plot passivity-sim
# The crates that are published, each after those that it needs.
PUBLISHED = core scene audit oracle vectors plot sim identify capi monitor monitor-capi evidence case command cli

# Nothing is built twice here that was not changed: no traces of what was built are kept, nor lines for debuggers.
export CARGO_INCREMENTAL ?= 0
export CARGO_PROFILE_DEV_DEBUG ?= 0
# In sixteen units at once the compiler takes a seventh more time of the processor.
export CARGO_PROFILE_DEV_CODEGEN_UNITS ?= 2

.PHONY: help setup run test size check fmt clippy doc features package bench figures same-figures case prove prove-smt prove-kani prove-rocq prove-prusti mutate test-python soak fuzz

help: ## list the targets
	@awk -F':.*## ' '/^[a-z-]+:.*## / {printf "  make %-14s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

setup:
	@$(CARGO) --version >/dev/null 2>&1 || rustup toolchain install stable --profile minimal --component rustfmt,clippy

run: setup ## check and explain the default scene: the main job, by the smallest build that can
	@echo "== passivity check $(SCENE)"
	@$(QUICK) check $(SCENE)
	@echo "== passivity explain $(SCENE)"
	@$(QUICK) explain $(SCENE)

test: setup ## run all tests, and ask the solvers all their queries
	@echo "== cargo test --workspace"
	$(CARGO) test $(FLAGS) --workspace
	@$(MAKE) --no-print-directory prove-smt

size: setup ## build the program as it is released, and show that it is under 20 MB
	@echo "== cargo build --release -p passivity-cli"
	$(CARGO) build --release $(FLAGS) -p passivity-cli
	@bytes=$$(wc -c < $${CARGO_TARGET_DIR:-target}/release/passivity); \
	    echo "the program has $$bytes bytes; fewer than 20000000 are wanted"; test $$bytes -lt 20000000

check: fmt clippy doc test ## format, lints, documentation and all tests

fmt:
	@echo "== cargo fmt --check"
	$(CARGO) fmt --all --check

clippy:
	@echo "== cargo clippy, warnings denied"
	$(CARGO) clippy $(FLAGS) --workspace --all-targets $(BENCH) -- -D warnings

doc:
	@echo "== cargo doc, warnings denied"
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc $(FLAGS) --workspace --no-deps

features: ## lint and test the builds that leave something out: no pictures, no Parquet, no simulator …
	@set -e; for build in $(LEAN); do \
	    echo "== cargo clippy --no-default-features -p $$build, warnings denied"; \
	    $(CARGO) clippy --quiet $(FLAGS) --no-default-features -p $$build -- -D warnings; \
	done
	@echo "== cargo test: what is left out says which feature has it"
	$(CARGO) test --quiet $(FLAGS) --no-default-features --features simulate -p passivity-command --lib

package: ## pack every crate that is published, and build each from its package
	@echo "== cargo package: $(PUBLISHED)"
	$(CARGO) package $(FLAGS) $(PUBLISHED:%=-p passivity-%)

bench: ## measure: verdicts, ledger, motion, sweep
	@echo "== cargo bench"
	$(CARGO) bench $(FLAGS) --workspace $(BENCH)

figures: ## draw every figure of the documentation into target/figures
	@mkdir -p target/figures
	@echo "== passivity plane, simulate, sweep and accuracy"
	@$(BIN) plane scenes/re35*.toml --plot target/figures/plane.svg
	@$(BIN) plane $(SCENE) --axes stiffness,rate --log both --plot target/figures/borders.svg
	@$(BIN) simulate $(SCENE) --speed 4 --plot target/figures/motion.svg
	@$(BIN) sweep scenes/dimensionless.toml --beta 0:1:41 --sigma 0:1.5:61 --speed 1/2,1,2,5 \
	    --out target/figures/fig5.csv --plot target/figures/sweep.png
	@$(BIN) accuracy $(SCENE) --speed 4 --plot target/figures/accuracy.svg

# Times differ from run to run, and with them the picture of accuracy.
same-figures: figures ## draw every figure, and show that those of the documentation are the same
	@set -e; for figure in $$(cd docs/figures && ls); do test $$figure = accuracy.svg || \
	    cmp target/figures/$$figure docs/figures/$$figure || \
	    { echo "look at target/figures/$$figure, and copy it to docs/figures"; exit 1; }; done

prove: ## every engine on the claims that it is for; writes target/evidence.json
	@echo "== proofs/prove: every engine that is here; the others are recorded as not run"
	@CARGO="$(CARGO)" PASSIVITY_SMT="$(CURDIR)/$(SOLVERS)" proofs/prove

case: ## write the safety case of the default scene into target/case
	@echo "== passivity case $(SCENE) --out target/case"
	@$(BIN) case $(SCENE) --out target/case

prove-smt: ## z3 and cvc5 on the claims that they are for, for all real numbers
	@echo "== z3 and cvc5 on proofs/smt/queries"
	@proofs/smt/install $(SOLVERS)
	@# With the features of the whole workspace nothing is built again that the tests have built.
	$(CARGO) build --quiet $(FLAGS) --workspace --bin passivity-smt
	$${CARGO_TARGET_DIR:-target}/debug/passivity-smt check $(SOLVERS)

# REPORT=FILE COMMIT=HASH takes a report made elsewhere, of the sources of that commit, into the
# evidence; CBMC=VERSION and SOLVER=NAME say what the report does not.
prove-kani: ## the model checker on every harness, where `cargo kani` is installed
ifeq ($(REPORT)$(COMMIT),)
	@echo "== cargo kani on proofs/kani"
	$(CARGO) run --quiet $(FLAGS) -p passivity-prove-kani
else
	@echo "== the report $(REPORT) of commit $(COMMIT)"
	$(CARGO) run --quiet $(FLAGS) -p passivity-prove-kani -- --report "$(REPORT)" --commit "$(COMMIT)" \
	    $(if $(CBMC),--cbmc "$(CBMC)") $(if $(SOLVER),--solver "$(SOLVER)")
	$(CARGO) run --quiet $(FLAGS) -p passivity-collect -- import
endif

prove-rocq: ## the whole theorem in Rocq, installing it where apt-get can
	@echo "== Rocq on proofs/rocq"
	$(MAKE) --no-print-directory -C proofs/rocq

prove-prusti: ## the contracts on the kernel, where `cargo prusti` is installed
	@echo "== Prusti on crates/passivity-core"
	@proofs/prusti

mutate: ## change what decides a verdict in one place after the other; a test must notice each (JOBS=N)
	@echo "== what cargo-mutants changes, and swaps of our own, in crates/passivity-core and crates/passivity-scene"
	@proofs/mutate $(if $(JOBS),--jobs $(JOBS))

test-python: ## build the Python wheel and test it from a fresh virtual environment
	@echo "== the Python wheel"
	@crates/passivity-python/test.sh

soak: ## the tests again, on TIMES times as many random inputs (20 unless given)
	@echo "== cargo test --workspace, on $(TIMES) times as many random inputs"
	PASSIVITY_TIMES=$(TIMES) $(CARGO) test $(FLAGS) --workspace

fuzz: ## ten minutes of libFuzzer on each of six readers; needs cargo-fuzz and a nightly
	@echo "== fuzz/run 600"
	@fuzz/run 600
