# Sourced by tests/run: the selection of tests for a commit, and the inputs that all tests read.

# The commit's hash; an archive made by `git archive` says it in cmake/commit.txt.
commit_hash() {
  git rev-parse HEAD 2>/dev/null || grep -oE '^[0-9a-f]+' cmake/commit.txt || echo 0
}

# turn N: a number below N that the commit chooses.
turn() {
  hash=$(commit_hash | cut -c1-7)
  echo "$((0x$hash % $1))"
}

# one_in N: ctest's selection of every N-th test, from the commit's turn on.
one_in() { echo "$(($(turn "$1") + 1)),,$1"; }

# changed_lately FILES...: succeeds if a commit within a day before HEAD changed more of FILES than
# comments of C++ and Verilog, if something is not committed, or if git cannot tell.
changed_lately() {
  changed=$(git log -1 --format=%ct -G'^[[:space:]]*[^/[:space:]]' -- "$@" 2>/dev/null) || changed=
  now=$(git log -1 --format=%ct 2>/dev/null) || now=
  [ -z "$changed" ] || [ $((now - changed)) -lt 86400 ] || [ -n "$(git status --porcelain -- "$@")" ]
}

# template_stride HEAVY: for tests of templates, of every how many one runs. All after a change of the
# templates, their benches and tables; a quarter after one of the sources that say what a unit must give
# and in how many cycles, since any format tells them wrong; else an eighth.
template_stride() {
  if [ "$1" = ON ] || changed_lately rtl_templates tests/rtl_templates ':!rtl_templates/*.md' \
    ':!tests/rtl_templates/CMakeLists.txt'; then
    echo 1
  elif changed_lately model/base/number model/judge/golden model/lane/error generator/hardware/datapath
  then
    echo 4
  else
    echo 8
  fi
}

# quarter HEAVY FILES...: for tests that try FILES on many values, of every how many one runs. All
# after a change of FILES, else a quarter.
quarter() {
  heavy=$1
  shift
  if [ "$heavy" = ON ] || changed_lately "$@"; then echo 1; else echo 4; fi
}

# tuple_stride HEAVY: for tests of the analysis, of its judges and of profiles: on every tuple of
# operands, and in many formats.
tuple_stride() {
  quarter "$1" model/lane model/judge/golden model/judge/emulator model/base/number \
    model/comparison/expression model/plan/profile tests/model/lane tests/model/judge \
    tests/model/plan/profile tests/extremes tests/support
}

# synthesis_stride HEAVY: for tests that call Yosys and nextpnr, on many devices.
synthesis_stride() {
  quarter "$1" generator/synthesis model/cost/devices tests/generator/synthesis
}

# Prints the dependencies of any test beside its inputs: the tools, and the files that programs read.
# Tests of templates name their files as inputs, and so do scripts.
common_inputs() {
  dpkg-query -W 2>/dev/null || true
  for tool in verilator iverilog yosys gappa coqc ghdl nextpnr-ice40 nextpnr-ecp5 python3; do
    "$tool" --version 2>&1 | head -n 1
  done || true
  find examples model/cost/devices docs/scene_file.md tests/*/ -type f ! -name '*.cpp' ! -name '*.hpp' \
    ! -name '*.v' ! -name CMakeLists.txt ! -path 'tests/mutant_results/*' ! -path 'tests/rtl_templates/*' |
    LC_ALL=C sort | xargs cat
}

# Sets `seconds` to the processor time of this shell's children so far; a subshell would have none.
read_clock() {
  mkdir -p build/log
  times > build/log/clock.txt
  seconds=$(tail -n 1 build/log/clock.txt | tr 'ms' '  ' |
    awk '{printf "%d", 60 * $1 + $2 + 60 * $3 + $4}')
}
