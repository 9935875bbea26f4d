#!/usr/bin/env bash
# Draws README's gallery and the figures of docs/living-world.md small and for a few steps into an empty folder:
# each picture that the pages show must come of it, and none that they don't.
# Usage: gallery.sh SOURCE-FOLDER PROGRAM
set -euo pipefail
source=$1
program=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# check SCRIPT PAGE FOLDER: what SCRIPT draws is what PAGE shows from docs/images/FOLDER.
check() {
  local script=$1 page=$2 folder=$3
  STURNUS_PROGRAM="$program" "$source/script/$script" --quick --into "$work/$folder" >"$work/log" 2>&1 ||
    { cat "$work/log" >&2; exit 1; }
  find "$work/$folder" -type f -size +0 -printf '%f\n' | sort >"$work/drawn"
  grep -oE "images/$folder/[a-z0-9-]+\.png" "$source/$page" | sed 's,.*/,,' | sort -u >"$work/shown"
  diff "$work/drawn" "$work/shown" >"$work/log" ||
    { echo "script/$script draws (<) what $page does not show (>):" >&2; cat "$work/log" >&2; exit 1; }
  head -c 4 "$work/$folder/$(head -n 1 "$work/drawn")" | tail -c 3 | grep -q PNG || { echo "no PNG" >&2; exit 1; }
  echo "$(wc -l <"$work/drawn") pictures by script/$script"
}

check gallery README.md gallery
check figures docs/living-world.md living-world
if "$source/script/gallery" --nonsense >"$work/log" 2>&1; then
  echo "script/gallery takes an option that it does not have" >&2
  exit 1
fi
