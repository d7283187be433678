# shellcheck shell=bash
# Sourced by cases/run and tests/run: installs what is missing, configures and builds. Costs nothing when all is there.
# Exit status 4: the environment failed, as for the program itself.

mortise_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
mortise_build=$mortise_root/build/release

mortise_packages=(
  g++ cmake ninja-build pkg-config git libopenmpi-dev openmpi-bin libp4est-dev libcgal-dev libhdf5-openmpi-dev
  libeigen3-dev libtomlplusplus-dev libcli11-dev libpng-dev nlohmann-json3-dev libmuparser-dev
  libfftw3-dev libhypre-dev
  libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev python3-matplotlib
)

mortise_fail() {
  printf '%s: %s\n' "$0" "$1" >&2
  exit 4
}

# Prints the packages that dpkg does not know as installed, one a line.
mortise_missing_packages() {
  local installed
  installed=$(dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' "${mortise_packages[@]}" 2>/dev/null | sed -n 's/^ii //p' || true)
  comm -23 <(printf '%s\n' "${mortise_packages[@]}" | sort -u) <(sort -u <<<"$installed")
}

# The same question where there is no dpkg: prints programs and headers that cannot be found.
mortise_missing_tools() {
  local tool header
  for tool in g++ cmake ninja pkg-config git mpicc mpiexec h5pcc python3; do
    command -v "$tool" >/dev/null || printf 'program %s\n' "$tool"
  done
  command -v g++ >/dev/null || return 0
  for header in p4est.h CGAL/version.h toml++/toml.h CLI/CLI.hpp png.h nlohmann/json.hpp muParser.h fftw3.h hypre/HYPRE_struct_ls.h \
    gtest/gtest.h gmock/gmock.h rapidcheck.h benchmark/benchmark.h; do
    printf '#if !__has_include(<%s>)\nheader %s\n#endif\n' "$header" "$header"
  done | g++ -E -P -x c++ - | grep '^header' || true
}

mortise_install() {
  local missing as_root=()
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    missing=$(mortise_missing_tools)
    [ -z "$missing" ] || mortise_fail "this is not a Debian system; please install: $(paste -sd, <<<"$missing" | sed 's/,/, /g')"
    return 0
  fi
  missing=$(mortise_missing_packages)
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || mortise_fail "packages are missing and there is no sudo; please install: ${missing//$'\n'/ }"
    as_root=(sudo)
  fi
  printf 'installing: %s\n' "${missing//$'\n'/ }"
  as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o Dpkg::Use-Pty=0)
  # shellcheck disable=SC2086  # one word a package
  { "${as_root[@]}" update && "${as_root[@]}" install -y --no-install-recommends $missing; } </dev/null ||
    mortise_fail "apt-get could not install: ${missing//$'\n'/ }"
}

# Configures once; afterwards the build itself notices changed CMake files. A build folder that was moved or copied
# from elsewhere starts afresh.
mortise_configure() {
  local cache=$mortise_build/CMakeCache.txt
  if [ -f "$mortise_build/build.ninja" ] && [ ! "$mortise_root/CMakePresets.json" -nt "$cache" ] &&
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$mortise_root" "$cache" &&
    grep -qxF "CMAKE_CACHEFILE_DIR:INTERNAL=$mortise_build" "$cache"; then
    return 0
  fi
  (cd "$mortise_root" && cmake --fresh --preset release) || mortise_fail "CMake could not configure $mortise_build"
}

# mortise_build_target TARGET: everything up to a built TARGET in build/release.
mortise_build_target() {
  mortise_install
  mortise_configure
  cmake --build "$mortise_build" --target "$1" --parallel "$(nproc)" || mortise_fail "the build of $1 failed"
}

# Open MPI in containers: root is allowed, more ranks than cores too.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
