#!/usr/bin/env bash
# What cmake --install leaves works by itself: program, cases, man page, completions, Python package.
# Usage: installed.sh CMAKE BUILD PYTHON
set -eu
cmake=$1
build=$2
python=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
"$cmake" --install "$build" --prefix "$scratch/usr" >install.log
n_failed=0
expect() # NAME COMMAND...: the command succeeds
{
  local name=$1
  shift
  if "$@" >out.txt 2>&1; then
    echo "passed $name"
  else
    echo "FAILED $name"
    sed 's/^/    /' out.txt | head -n 20
    n_failed=$((n_failed + 1))
  fi
}
program=$scratch/usr/bin/birdstrike
expect "version" "$program" --version
expect "an installed case" "$program" validate usr/share/birdstrike/prm/own-blade.prm
expect "an installed case of certification" "$program" validate "$(ls usr/share/birdstrike/prm/certification/*.prm | head -n 1)"
expect "the manual" test -s usr/share/birdstrike/prm/manual/README.md
broken_links() # of the installed documents: what their links name is there
{
  local file link
  find usr/share/birdstrike -name '*.md' | while read -r file; do
    grep -oE '\]\([^)#]+' "$file" | sed 's/^](//' | grep -v '^https\?:' | while read -r link; do
      [ -e "$(dirname "$file")/$link" ] || echo "$file: $link"
    done
  done
}
expect "links of the installed documents" test -z "$(broken_links)"
broken_links
expect "the man page" grep -q "materials" usr/share/man/man1/birdstrike.1
for command in $("$program" --help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\)  *.*/\1/p'); do
  expect "the man page of $command" grep -qx ".B $command" usr/share/man/man1/birdstrike.1
done
# As a shell does it: the words so far, then the function.
complete_words() { # WANTED WORD...
  local wanted=$1
  shift
  PATH="$scratch/usr/bin:$PATH" bash -c 'source usr/share/bash-completion/completions/birdstrike
    COMP_WORDS=("${@:2}") COMP_CWORD=$(($# - 2)); _birdstrike; printf "%s\n" "${COMPREPLY[@]}" | grep -qxF -- "$1"' _ "$wanted" "$@"
}
expect "completion of a command" complete_words explain birdstrike exp
expect "completion of an option" complete_words --strict birdstrike run --str
touch case.prm other.txt
expect "completion of a file" complete_words case.prm birdstrike run c
no_words() { ! complete_words "$@"; }
expect "no completion of another file" no_words other.txt birdstrike run o
expect "the Python package" env PYTHONPATH="$scratch/usr/lib/python3/dist-packages" "$python" -c 'import birdstrike'
[ "$n_failed" -eq 0 ]
