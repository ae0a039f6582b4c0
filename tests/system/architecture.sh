#!/usr/bin/env bash
# The structure, checked over #include lines and sizes. Usage: architecture.sh TOP
#   arrows    between rooms
#   headers   include/ holds what another room includes (or such a header), nothing else; what stands in source/ is its
#             room's own
#   mirror    of rooms and unit tests
#   sizes     a file, a folder, a function (code_rules.py)
#   choices   are values, compared as texts where files are read alone (code_rules.py)
set -u
rules=$(realpath "$0")
cd "$1" || exit 1
fail=0
complain() {
  echo "$1"
  fail=1
}

declare -A allowed=(
  [core]="core"
  [material]="core material"
  [mesh]="core mesh"
  [structure]="core material mesh structure"
  [bird]="core material bird"
  [contact]="core contact"
  [time_control]="core time_control"
  [io]="core material mesh structure bird contact time_control io"
  [report]="core material mesh structure bird contact time_control io report"
  [simulation]="core material mesh structure bird contact time_control io report simulation"
)

for room in "${!allowed[@]}"; do
  while IFS=: read -r file line; do
    target=$(sed -E 's|.*birdstrike/([a-z_]+)/.*|\1|' <<<"$line")
    case " ${allowed[$room]} " in
      *" $target "*) ;;
      *) complain "$file includes the room '$target'; '$room' may include: ${allowed[$room]}" ;;
    esac
  done < <(grep -rHoE '#include <birdstrike/[a-z_]+/' "include/birdstrike/$room" "source/$room" | sed -E 's/$/x/')
  while IFS=: read -r file line; do
    target=$(sed -E 's|.*"([a-z_]+)/.*|\1|' <<<"$line")
    [ "$target" = "$room" ] || complain "$file includes a header of '$target' that is that room's own"
  done < <(grep -rHoE '#include "[a-z_]+/' "include/birdstrike/$room" "source/$room" | sed -E 's/$/x/')
done

# A header of include/ is there for another room, directly or through another such header.
declare -A needed
mapfile -t public < <(cd include && find birdstrike -name '*.h')
changed=1
for header in "${public[@]}"; do
  room=$(cut -d/ -f2 <<<"$header")
  grep -rqF "#include <$header>" source include --include='*.h' --include='*.cc' --exclude-dir="$room" && needed[$header]=1
done
while [ $changed = 1 ]; do
  changed=0
  for header in "${public[@]}"; do
    [ -n "${needed[$header]:-}" ] && continue
    for user in $(cd include && grep -rlF "#include <$header>" birdstrike); do
      [ -n "${needed[$user]:-}" ] && needed[$header]=1 && changed=1 && break
    done
  done
done
for header in "${public[@]}"; do
  [ -n "${needed[$header]:-}" ] || complain "include/$header: no other room includes it; it belongs beside its sources"
done

# core and contact never speak of the parts; material never of meshes or particles (as identifiers, not in prose).
if grep -rnE '#include <deal.II/(grid|dofs|fe)/' {include/birdstrike,source}/{core,contact,bird,material,time_control}; then
  complain "finite elements outside the rooms of the blade"
fi

# The mirror: every tested room is a room, every room with sources has tests.
for room in tests/unit/*/; do
  [ -d "source/$(basename "$room")" ] || complain "$room mirrors no room"
done
for room in source/*/; do
  ls "$room"/*.cc >/dev/null 2>&1 || continue
  ls "tests/unit/$(basename "$room")"/*_test.cc >/dev/null 2>&1 || complain "no unit test mirrors $room"
done

# Sizes.
while read -r lines file; do
  [ "$lines" -le 300 ] || complain "$file has $lines lines; at most 300"
done < <(find source include -name '*.h' -o -name '*.cc' | xargs wc -l | grep -v ' total$')
while read -r folder; do
  n=$(find "$folder" -maxdepth 1 -type f | wc -l)
  [ "$n" -le 30 ] || complain "$folder holds $n files; at most 30"
done < <(find source include -type d)

# Functions, and choices.
python3 "$(dirname "$rules")/code_rules.py" . || complain "see the list above"

# Exactly the agreed top level.
odd=$(git ls-tree --name-only HEAD 2>/dev/null | grep -vxE 'CMakeLists\.txt|source|include|tests|prm|meshes|findings|README\.md|LICENSE|CHANGELOG\.md|CMakePresets\.json|\..*')
[ -z "$odd" ] || complain "top level holds more than it should: $odd"

[ $fail -eq 0 ] && echo "architecture: all arrows allowed"
exit $fail
