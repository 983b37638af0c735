# Sourced by tests/run and examples/run, from the repository's root: installs what is missing from
# Debian packages, configures and builds into build/release.

# What the build, the tests and `mixcmp verify` need, on Debian 12 and 13. tests/release writes into
# a release's SBOM what each package is for.
build_tools="g++ cmake ninja-build ccache pkg-config make git ca-certificates"
libraries="libmpfr-dev libmpfi-dev libgmp-dev libfmt-dev libcli11-dev libtomlplusplus-dev
  nlohmann-json3-dev tao-pegtl-dev libhwy-dev zlib1g-dev libsqlite3-dev coinor-libcbc-dev"
test_packages="libgtest-dev libbenchmark-dev jq python3"
called_tools="verilator iverilog yosys nextpnr-ice40 gappa glpk-utils gnuplot-nox gtkwave"
packages="$build_tools $libraries $test_packages $called_tools"
# The Python module is built where these are installed, and always for Debian packages.
python_packages="pybind11-dev python3-dev python3-numpy"

say() { printf '== %s\n' "$*"; }

missing_packages() {
  for package in $packages; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || echo "$package"
  done
}

# Ends with the status of a command that failed, and shows the end of its log.
failed() {
  tail -n 40 "$1" >&2
  say "failed, see $1" >&2
  exit "$2"
}

# Runs a command with its output in a log.
logged() {
  log=$1
  shift
  mkdir -p "$(dirname "$log")"
  "$@" >"$log" 2>&1 || failed "$log" $?
}

# Runs a build with its output in a log, and says every half minute which step ninja is at.
logged_build() {
  log=$1
  shift
  mkdir -p "$(dirname "$log")"
  "$@" >"$log" 2>&1 &
  build=$!
  seconds=0
  while kill -0 "$build" 2>/dev/null; do
    sleep 1
    seconds=$((seconds + 1))
    [ $((seconds % 30)) -ne 0 ] ||
      say "step $(sed -n 's,^\[\([0-9]*\)/\([0-9]*\)\].*,\1 of \2,p' "$log" | tail -n 1)"
  done
  wait "$build" || failed "$log" $?
}

install_packages() {
  absent=$(missing_packages)
  [ -z "$absent" ] && return
  say "installing" $absent
  as_root=""
  [ "$(id -u)" = 0 ] || as_root=sudo
  logged build/log/apt-update.txt $as_root apt-get update
  logged build/log/apt-install.txt $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y --no-install-recommends $absent
}

# build_release TARGET [OPTION ...]: the options go to the configuration. Warnings are errors only in CI.
build_release() {
  target=$1
  shift
  say "building into build/release"
  [ "${CI:-}" = true ] && warnings=ON || warnings=OFF
  logged build/log/configure.txt \
    cmake --preset release -DMIXCMP_WARNINGS_AS_ERRORS=$warnings "$@"
  logged_build build/log/build.txt cmake --build --preset release --target "$target"
}
