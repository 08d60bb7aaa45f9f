# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the scripts that build: installs the Debian packages that are missing, and keeps the build folder for one run.

# What both need to configure and build.
# shellcheck disable=SC2034
build_packages=(
  g++ cmake ninja-build
  libeigen3-dev libgsl-dev libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  libfftw3-dev liblapacke-dev libarpack2-dev libsuitesparse-dev libssl-dev zlib1g-dev pkgconf libpugixml-dev libflint-arb-dev libflint-dev help2man
)

# What draws a figure; the tests draw some.
# shellcheck disable=SC2034
figure_packages=(gnuplot-nox fonts-dejavu-core)

# What feeds the fuzz targets.
# shellcheck disable=SC2034
fuzz_packages=(clang libclang-rt-14-dev)

# What the CI needs besides.
# shellcheck disable=SC2034
check_packages=(clang clang-tidy gcovr)

# What the tests need besides: their framework, what typesets the manual page, what checks the traceability, fills in the templates of the
# report, tests the Python package, and makes the Debian package.
# shellcheck disable=SC2034
test_packages=(libgtest-dev groff-base python3 python3-jinja2 python3-jsonschema python3-pip python3-pytest python3-venv dpkg-dev file)

# Ninja would work on two sources more than there are processors, which takes longer.
CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CMAKE_BUILD_PARALLEL_LEVEL

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 2
}

# git_here ARGUMENT...: git, asked of this tree alone. A repository above it may be somebody else's, and its configuration names programs
# that git runs.
git_here() { git --git-dir=.git --work-tree=. "$@"; }

# Keeps build/release for this run and what it starts. Another run waits; a place where the build cannot be made is refused.
claim_build_folder() {
  [[ "$PWD" != *[\"#\;\\[]* ]] || fail "the path $PWD holds one of \" # ; \\ [, but must hold none of them, since CMake takes it apart"
  mkdir -p build/release 2>/dev/null && touch build/release/.lock 2>/dev/null || fail "$PWD/build/release cannot be written, but must be"
  exec {build_lock}>>build/release/.lock
  if ! flock --nonblock "$build_lock"; then
    say "Another run works in build/release; this one waits for its end."
    flock "$build_lock"
  fi
  local made_in
  made_in=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' build/release/CMakeCache.txt 2>/dev/null) || return 0
  [[ -z "$made_in" || "$made_in" -ef . ]] || fail "build/release was made in $made_in, which is not this folder; remove it: rm -r $PWD/build/release"
}

# say TEXT...: what is being done now, with the time.
say() { echo "[$(date +%H:%M:%S)] $*"; }

# compile ARGUMENT...: builds in Release, with the count of steps and the seconds on a terminal; in a pipe it tells warnings and errors only.
compile() {
  local quiet=()
  [[ -t 1 ]] || quiet=(-- --quiet)
  NINJA_STATUS='[%f of %t, %e s] ' cmake --build --preset release "$@" "${quiet[@]}"
}

is_installed() {
  [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

# install_missing PACKAGE...: says what it will install and installs it; silent when all is there.
install_missing() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this is no Debian system (dpkg-query or apt-get is missing); install the counterparts of: $*"
  fi
  local package missing=()
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  ((${#missing[@]} > 0)) || return 0

  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      fail "packages are missing, and there is neither root nor sudo to install them; run as root: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  echo "Installing with apt-get: ${missing[*]}"
  "${as_root[@]}" apt-get --quiet update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get --quiet --yes --no-install-recommends install "${missing[@]}"
}
