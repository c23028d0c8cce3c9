#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tests/run.sh [--full]: every test but the long ones, on a bare Debian 12. Installs the packages that
# are missing, builds, and runs each test once: those labelled `sanitized` (unit tests, readers of
# hostile input, bundle, plugin, scenes, replays of fuzzers) with the address and undefined-behaviour
# sanitizers, all others optimized. With --full all tests run both ways, but for cases tagged
# [large], which run optimized only; and so do tests labelled `full`, statistics over many held-back
# pictures.
# The last lines say what was left out and count the tests of both runs; exit status 1 when one
# failed. A test that is skipped has failed too, since all that tests need is installed here, a
# software Vulkan device included; LICHEN_ALLOW_SKIPPED=1 lets them pass where that cannot be.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/samples/install_packages.sh"

full=0
case ${1:-} in
  '') ;;
  --full) full=1 ;;
  *) echo "usage: tests/run.sh [--full]" >&2 && exit 2 ;;
esac

passed=0
skipped=()
failed=()

# count_results PRESET JUNIT: adds what CTest wrote to the three sums. A test whose program is
# absent is "not run" to CTest, like a skipped one; here it failed.
count_results() {
  local status name
  while read -r status name; do
    case $status in
      run) passed=$((passed + 1)) ;;
      skipped | disabled) skipped+=("$1: $name") ;;
      *) failed+=("$1: $name") ;;
    esac
  done < <(awk -F '"' '
    /^\t<testcase / { name = $2; status = $8 }
    /^\t\t<skipped message="SKIP_/ { status = "skipped" }
    /^\t<\/testcase>/ { print status, name }' "$2")
}

# run_suite PRESET SECONDS TARGET [OPTION...]: builds TARGET and runs the tests that these options
# of ctest select. No test may take longer than SECONDS; a build that fails counts as one failed test.
run_suite() {
  local preset=$1 timeout=$2 target=$3 results=$root/build/$1/ctest.xml
  shift 3
  step "Build: $preset"
  if ! { cmake --preset "$preset" && cmake --build --preset "$preset" --target "$target"; }; then
    failed+=("$preset: the build (the reason is above; if build/ came from elsewhere, remove it)")
    return
  fi
  step "Tests: $preset"
  rm -f "$results"
  # The exit status says only that something failed; the file says what.
  ctest --preset "$preset" --parallel "$(nproc)" --timeout "$timeout" --output-junit "$results" "$@" ||
    true
  if [[ -f $results ]]; then
    count_results "$preset" "$results"
  else
    failed+=("$preset: ctest (the reason is above)")
  fi
}

step 'Packages'
install_packages "${build_packages[@]}" "${test_packages[@]}"
install_node

cd "$root"
if [[ $full -eq 1 ]]; then
  run_suite release 600 all
  run_suite asan-ubsan 1800 all # about ten times slower
else
  run_suite release 600 lichen_optimized_tests --label-exclude 'full|sanitized'
  run_suite asan-ubsan 1800 lichen_sanitized_tests --label-regex sanitized
fi

step 'Result'
if [[ $full -eq 0 ]]; then
  count_tests() { ctest --preset release --show-only "$@" | sed -n 's/^Total Tests: //p'; }
  echo "left to --full: $(count_tests --label-regex full) tests of statistics over held-back pictures," \
    "sanitizers for $(count_tests --label-exclude 'full|sanitized') tests, and" \
    "$(count_tests --label-regex sanitized) tests optimized (docs/decisions/015-one-source.md)"
fi
for test in "${skipped[@]}"; do
  if [[ ${LICHEN_ALLOW_SKIPPED:-} == 1 ]]; then
    echo "skipped: $test"
  else
    failed+=("$test (skipped; LICHEN_ALLOW_SKIPPED=1 allows it)")
  fi
done
[[ ${#failed[@]} -eq 0 ]] || printf 'FAILED: %s\n' "${failed[@]}"
printf '%d passed, %d failed\n' "$passed" "${#failed[@]}"
[[ $passed -gt 0 && ${#failed[@]} -eq 0 ]]
