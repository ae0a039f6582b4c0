# What the scripts share that ask a subcommand of the program from outside. Usage, first of all: . from_outside.sh SUBCOMMAND PROGRAM TOP
# Works in a folder of its own that goes with the script; the script ends with `[ $n_failed -eq 0 ]`.
set -u
subcommand=$1
program=$2
top=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
n_failed=0

fail() { echo "FAILED $1"; sed 's/^/    /' out.txt | tail -n 20; n_failed=$((n_failed + 1)); }

# ask NAME EXPECTED_EXIT PATTERN... -- ARGUMENTS: every pattern must occur in the output
ask() {
  local name=$1 expected=$2; shift 2
  local patterns=()
  while [ "$1" != "--" ]; do patterns+=("$1"); shift; done
  shift
  "$program" "$subcommand" "$@" >out.txt 2>&1
  local code=$?
  [ $code -eq "$expected" ] || { fail "$name: exit code $code, expected $expected"; return; }
  for pattern in ${patterns[@]+"${patterns[@]}"}; do
    grep -qE -- "$pattern" out.txt || { fail "$name: no '$pattern' in the output"; return; }
  done
  echo "passed $name"
}
require() { if ! eval "$2"; then fail "$1"; else echo "passed $1"; fi; }
refuse() {
  ask "$1" 2 "${@:2}"
  [ "$(wc -l <out.txt)" -le 6 ] || fail "$1: more than six lines"
}
