#!/usr/bin/env bash
# dependency_rules.sh ROOT: which room may include which, and where third-party headers may appear.
# dependency_rules.sh --self-test: breaks every rule in a throw-away tree and expects to be told.
set -euo pipefail

problems=0

# forbid PATHS PATTERN SENTENCE: no file matching the globs PATHS may include a header matching PATTERN.
forbid() {
  local files found
  # shellcheck disable=SC2206  # the globs are meant to expand
  files=($1)
  [ ${#files[@]} -gt 0 ] || return 0
  found=$(grep -nE "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($2)" "${files[@]}" /dev/null || true)
  [ -n "$found" ] || return 0
  printf '%s:\n%s\n' "$3" "$found"
  problems=$((problems + 1))
}

# confine PATTERN NAME: headers matching PATTERN are included by at most two files, all of them .cpp.
confine() {
  local files=({grids,fluid,solid,coupler,cases}/**/*.{hpp,cpp}) found count
  [ ${#files[@]} -gt 0 ] || return 0
  found=$(grep -lE "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($1)" "${files[@]}" || true)
  count=$(grep -c . <<<"$found" || true)
  if [ "$count" -gt 2 ] || grep -q '\.hpp$' <<<"$found"; then
    printf '%s belongs in one or two .cpp files, but is included by:\n%s\n' "$2" "$found"
    problems=$((problems + 1))
  fi
}

check() {
  cd "$1"
  shopt -s globstar nullglob
  problems=0
  forbid 'grids/**/*.[hc]pp' 'mortise/(fluid|solid|coupler|cases)/' 'grids/ knows no physics'
  forbid 'fluid/**/*.[hc]pp' 'mortise/(solid|coupler|cases)/' 'fluid/ sees only grids/'
  forbid 'solid/**/*.[hc]pp' 'mortise/(fluid|coupler|cases)/' 'solid/ sees only grids/'
  forbid 'coupler/**/*.[hc]pp' 'mortise/cases/' 'coupler/ does not see cases/'
  forbid 'coupler/interface*.[hc]pp coupler/interface*/**/*.[hc]pp coupler/schemes*.[hc]pp coupler/schemes*/**/*.[hc]pp
    coupler/acoustic_line.[hc]pp coupler/amplification.[hc]pp' \
    'mortise/(fluid|solid)/' 'the core of the coupler sees neither side'
  forbid '[gfsc]*/**/*.[hc]pp' '\.\./' 'no way around the rooms'
  confine 'p4est|p8est|sc\.h' 'p4est'
  confine 'CGAL/' 'CGAL'
  confine 'hdf5' 'HDF5'
  confine 'toml\+\+/' 'the TOML reader'
  [ "$problems" -eq 0 ]
}

# breaks FILE INCLUDE...: a tree with only FILE, which includes these headers, must be refused.
breaks() {
  local tree=$1 file=$2 header
  rm -rf "$tree" && mkdir -p "$tree/$(dirname "$file")"
  for header in "${@:3}"; do printf '#include "%s"\n' "$header" >>"$tree/$file"; done
  if (check "$tree") >/dev/null; then
    printf '%s may include %s, and should not\n' "$file" "${*:3}"
    return 1
  fi
}

self_test() {
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  local tree=$scratch/tree
  breaks "$tree" grids/deep/a.hpp mortise/fluid/state.hpp
  breaks "$tree" grids/a.cpp mortise/cases/scene.hpp
  breaks "$tree" fluid/a.hpp mortise/solid/body.hpp
  breaks "$tree" solid/deep/a.hpp mortise/fluid/state.hpp
  breaks "$tree" coupler/a.cpp mortise/cases/scene.hpp
  breaks "$tree" coupler/interface.hpp mortise/fluid/state.hpp
  breaks "$tree" coupler/schemes/rigid.cpp mortise/solid/body.hpp
  breaks "$tree" coupler/amplification.cpp mortise/fluid/state.hpp
  breaks "$tree" fluid/a.cpp ../solid/body.hpp
  breaks "$tree" grids/a.hpp p4est.h
  breaks "$tree" cases/input/a.hpp toml++/toml.h
  rm -rf "$tree" && mkdir -p "$tree/coupler/interface" "$tree/fluid"
  echo '#include "mortise/grids/core/types.hpp"' | tee "$tree/coupler/interface/a.hpp" >"$tree/fluid/a.hpp"
  check "$tree"
}

if [ "${1-}" = --self-test ]; then self_test; else check "${1:?usage: dependency_rules.sh ROOT}"; fi
