#!/usr/bin/env bash
# Runs every line of README's shell examples that begins with `sturnus` or `sturnus-shadertoy`, in order, in an empty folder.
# Usage: readme.sh SOURCE-FOLDER PROGRAM
set -euo pipefail
source=$1
program=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
ln -s "$program" "$work/bin/sturnus"
shadertoy="$(dirname "$program")/sturnus-shadertoy"
pattern="^sturnus "
if [ -x "$shadertoy" ]; then
  ln -s "$shadertoy" "$work/bin/sturnus-shadertoy"
  pattern="^sturnus(-shadertoy)? "
fi
export PATH="$work/bin:$PATH"
cd "$work"

count=0
while IFS= read -r line; do
  if ! bash -c "$line" >output 2>&1 </dev/null; then
    echo "README's command failed: $line" >&2
    cat output >&2
    exit 1
  fi
  count=$((count + 1))
done < <(awk -v pattern="$pattern" '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside && $0 ~ pattern' "$source/README.md")
[ "$count" -ge 10 ] || { echo "README has only $count commands" >&2; exit 1; }
echo "$count commands of README work"
