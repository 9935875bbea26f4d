#!/usr/bin/env bash
# The plain way, to the letter: a fresh clone, mkdir build, cd build, cmake .., make; then the programs run.
# Usage: plain.sh SOURCE-FOLDER
set -euo pipefail
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Where there is no repository, as in an unpacked archive, the folder is copied without its builds.
if git -C "$source" rev-parse --verify --quiet HEAD >/dev/null 2>&1; then
  git clone --quiet "$source" "$work/sturnus"
else
  mkdir "$work/sturnus"
  tar -C "$source" --exclude='./build*' --exclude=./out --exclude=./.git -cf - . | tar -C "$work/sturnus" -xf -
fi
cd "$work/sturnus"

# Only the machine's speed is ours to choose: the words are the user's, and so is everything that cmake finds.
unset CMAKE_GENERATOR CMAKE_BUILD_TYPE
export MAKEFLAGS="-j$(nproc)"
# What another build has compiled already is taken from there: it knows the compiler by this name.
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR="$PWD" CXX=g++
fi
{
  mkdir build
  cd build
  cmake ..
  make
} >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cd ..
if grep -i 'warning:' "$work/log" >&2; then
  echo "the plain build has warnings" >&2
  exit 1
fi

for program in prog06 sturnus sturnus-shadertoy; do
  [ -x "build/$program" ] || { grep "$program" "$work/log" >&2; echo "there is no build/$program" >&2; exit 1; }
done
# Who only builds the programs needs none of the tests' packages, and hears nothing of them.
if compgen -G 'build/tests/*-tests' >&2 || grep 'the tests' "$work/log" >&2 ||
  grep -E '^(GTest|RAPIDCHECK)_' build/CMakeCache.txt >&2; then
  echo "the plain build has to do with tests" >&2
  exit 1
fi
SDL_VIDEODRIVER=offscreen build/prog06 300 0.4 0.1 0.3 1.0 out.ppm --keys "ssw q"
[ "$(head -c 2 out.ppm)" = P6 ] || { echo "prog06 wrote no PPM" >&2; exit 1; }
build/sturnus run prog06 --steps 10
[ -z "$(git status --porcelain --ignored=no 2>/dev/null | grep -v ' out.ppm$')" ] || { git status --short >&2; exit 1; }
