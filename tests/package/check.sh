#!/usr/bin/env bash
# Builds README's example as a user would, with find_package and with add_subdirectory, and runs it.
# Usage: check.sh SOURCE-FOLDER BUILD-FOLDER
set -euo pipefail
source=$1
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The first C++ block of README is the example.
awk '/^```cpp$/ && !done { inside = 1; next } /^```$/ && inside { inside = 0; done = 1 } inside' "$source/README.md" >"$work/example.cpp"
grep -q sturnus "$work/example.cpp" || { echo "README.md has no C++ example" >&2; exit 1; }

# try NAME CMAKE-OPTIONS...: builds and runs both programs; each prints the hash of its flock.
try() {
  local name=$1
  shift
  cmake -S "$source/tests/package" -B "$work/$name" -G Ninja "-DEXAMPLE=$work/example.cpp" "$@" >"$work/log" 2>&1 &&
    cmake --build "$work/$name" --parallel "$(nproc)" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  for program in example core_example; do
    "$work/$name/$program" >"$work/$name.$program"
    grep -Eq '[0-9a-f]{16}' "$work/$name.$program" || { echo "$name $program printed no hash" >&2; exit 1; }
    echo "$name $program: $(tail -n 1 "$work/$name.$program")"
  done
}

cmake --install "$build" --prefix "$work/prefix" >/dev/null
try find_package "-DCMAKE_PREFIX_PATH=$work/prefix"
# Embedded without optimisation: quicker to build, and the hashes must be the same all the same.
try add_subdirectory "-DSTURNUS_SOURCE=$source" -DCMAKE_BUILD_TYPE=None
cmp "$work/find_package.example" "$work/add_subdirectory.example"
cmp "$work/find_package.core_example" "$work/add_subdirectory.core_example"
"$work/prefix/bin/sturnus" list >/dev/null
[ ! -x "$build/prog06" ] || "$work/prefix/bin/prog06" --help >/dev/null
