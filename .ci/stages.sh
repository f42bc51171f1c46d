# What .ci/run and .ci/full have in common: the stages of the gate, timed, and the verdict at the end.
failed=()
verdicts=()
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT

# stage <name> <command...>: run, time, remember; the next one runs even if this one fails.
stage() {
  local name=$1 start=$SECONDS verdict=passed log
  log=$logs/${#verdicts[@]}
  shift
  printf '\n######## %s\n' "$name"
  "$@" 2>&1 | tee "$log"
  if [[ ${PIPESTATUS[0]} -ne 0 ]]; then
    verdict=FAILED
    failed+=("$name")
  fi
  verdicts+=("$(printf '%-7s %5d s  %s' "$verdict" $((SECONDS - start)) "$name")")
  # The closing lines of ctest, to be repeated.
  verdicts+=("$(grep -E '^[0-9]+% tests passed|^Total Test time|\((Failed|Timeout|SEGFAULT|Not Run)\)' \
    "$log" | sed 's/^/                 /')")
}

# Ends the script: the verdicts of all stages.
verdict() {
  printf '\n######## verdict after %d s\n' "$SECONDS"
  printf '%s\n' "${verdicts[@]}" | sed '/^ *$/d'
  [[ ${#failed[@]} -eq 0 ]] || { printf 'failed: %s\n' "${failed[@]}"; exit 1; }
}

jobs=${LIESL_JOBS:-$(nproc)}
export CXX=clang++  # all but the engine without Ipopt, which is GCC's part

cpp_files() {
  find liegroup mbs esl optim apps python tests -name '*.cpp' -o -name '*.hpp' | sort
}

check_format() {
  if ! cpp_files | xargs clang-format --dry-run --Werror; then
    echo "fix with: clang-format -i FILES"
    return 1
  fi
  echo "every source is formatted"
}

check_layers() {
  /usr/bin/python3 tests/architecture/check_layers.py . &&
    /usr/bin/python3 tests/architecture/check_links.py .
}

# Where what is asked is whether sources compile, install and link: without optimisation, and without
# precompiled headers, so that no group of sources leans on them.
plain=(-DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON)

# Builds and installs without Ipopt and NLopt, by the other compiler.
engine_alone() {
  CXX=g++ cmake --preset engine "${plain[@]}" >/dev/null && cmake --build --preset engine -j "$jobs" &&
    tests/install/run.sh "$PWD/build/engine" "$PWD"
}

# OpenBLAS takes its kernel by the processor; what it computes differs in the last bits, and what must
# hold at an optimum holds with each. Those of this processor's own run with all other tests.
# another_kernel <kernel>
another_kernel() {
  local kernel=$1
  if [[ $kernel == "$(own_kernel)" ]]; then echo "this processor's own: they have run with it above"; return; fi
  OPENBLAS_CORETYPE=$kernel ctest --test-dir build/release --output-on-failure --no-tests=error -j2 \
    -L shape
}

# The kernel beside Haswell that this processor can run.
wide_kernel() {
  if grep -qw avx512f /proc/cpuinfo; then echo SkylakeX; else echo Zen; fi
}

# The kernel that every other test runs with. That of Cooper Lake is SkylakeX's for doubles: connecting_rod ends
# alike to the last bit with both, and not with Haswell's.
own_kernel() {
  OPENBLAS_VERBOSE=2 build/release/libexec/liesl-program --version 2>&1 | sed -n 's/^Core: //p' |
    sed 's/^Cooperlake$/SkylakeX/'
}

# The groups alone: a build of all with sanitizers takes longer than the rest of the gate.
groups_sanitized() {
  cmake --preset asan >/dev/null &&
    cmake --build --preset asan -j "$jobs" --target test_liegroup && ctest --preset asan-groups -j2
}

# The stages of .ci/run, with which .ci/full begins.
gate() {
  stage "release build and the tests of the gate (./bootstrap test)" env LIESL_PRESET=ci \
    LIESL_PACKAGES="g++ slurmctld slurmd munge chromium chromium-driver python3-jsonschema python3-dev python3-numpy pybind11-dev python3-pytest python3-scipy calculix-ccx python3-sphinx python3-myst-parser furo" LIESL_CTEST_ARGS="-LE full|sanitize" ./bootstrap test
  stage "format (clang-format)" check_format
  stage "layers, sizes and links" check_layers
  stage "groups under ASan and UBSan" groups_sanitized
}
