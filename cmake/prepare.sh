# Sourced by tests/run and examples/run, from the repository's root: installs what is missing from
# Debian packages, configures and builds into build/release.

# What the build, the tests and `mixcmp verify` need, on Debian 12 and 13.
packages="g++ cmake ninja-build ccache pkg-config make git ca-certificates
  libmpfr-dev libgmp-dev libfmt-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev
  tao-pegtl-dev libgtest-dev libbenchmark-dev libhwy-dev zlib1g-dev libsqlite3-dev coinor-libcbc-dev verilator iverilog yosys nextpnr-ice40 gappa glpk-utils
  gnuplot-nox gtkwave jq"

say() { printf '== %s\n' "$*"; }

missing_packages() {
  for package in $packages; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || echo "$package"
  done
}

# Runs a command with its output in a log; shows the log's end where it fails.
logged() {
  log=$1
  shift
  mkdir -p "$(dirname "$log")"
  "$@" >"$log" 2>&1 || { status=$?; tail -n 40 "$log" >&2; say "failed, see $log" >&2; exit $status; }
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

# build_release TARGET [OPTION]: OPTION goes to the configuration. Warnings are errors in CI alone.
build_release() {
  say "building into build/release"
  [ "${CI:-}" = true ] && warnings=ON || warnings=OFF
  logged build/log/configure.txt \
    cmake --preset release -DMIXCMP_WARNINGS_AS_ERRORS=$warnings ${2:+"$2"}
  logged build/log/build.txt cmake --build --preset release --target "$1"
}
